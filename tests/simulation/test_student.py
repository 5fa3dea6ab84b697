"""Each student does what the behaviour says, and the truth tells it."""

import math
from collections.abc import Callable, Sequence

import pytest

from gripcourse.course.quantity import Kind
from gripcourse.policy.bands import band
from gripcourse.simulation.confusion import JudgedWork
from gripcourse.simulation.model import Action, ActionKind, Conduct, SimulatedWork
from gripcourse.simulation.student import Classroom, work_of
from gripcourse.solver.plan import Plan, make_plan

WhoAll = Callable[..., tuple[Classroom, Sequence[SimulatedWork]]]


def plan_of(room: Classroom, work: SimulatedWork) -> Plan:
    variant = room.context.register[work.student].variant
    return make_plan(room.context.course, variant.scheme, variant.options)


def of_kind(work: SimulatedWork, done: ActionKind) -> list[Action]:
    return [action for action in work.actions if action.done is done]


def test_an_honest_student_answers_everything_rightly(who_all: WhoAll) -> None:
    room, works = who_all(Conduct.HONEST)
    for work in works:
        assert {action.done for action in work.actions} == {ActionKind.RIGHT}
        assert [action.quantity for action in work.actions] == [
            one.id for one in plan_of(room, work).answered
        ]


def test_a_student_works_the_same_way_each_time(room: Classroom) -> None:
    for student in list(room.behaviours)[:10]:
        assert work_of(student, room) == work_of(student, room)


def test_a_slip_is_made_once_where_it_can_be_seen(who_all: WhoAll) -> None:
    room, works = who_all(Conduct.SLIP, count=12)
    for work in works:
        [slip] = of_kind(work, ActionKind.SLIP)
        plan = plan_of(room, work)
        quantity = plan.quantities[slip.quantity]
        assert slip.slip
        assert slip.right is not None
        assert slip.value is not None
        if quantity.kind is not Kind.CHOICE:
            width = band(quantity, slip.right, room.context.policy)
            assert slip.value != slip.right
            assert abs(slip.value - slip.right) >= room.mix.apart * width


def test_after_a_slip_everything_that_needs_it_follows(who_all: WhoAll) -> None:
    room, works = who_all(Conduct.SLIP, count=12)
    for work in works:
        [slip] = of_kind(work, ActionKind.SLIP)
        follows = {action.quantity for action in of_kind(work, ActionKind.FOLLOWS)}
        needing = {slip.quantity}
        plan = plan_of(room, work)
        for name in plan.quantities:
            if needing.intersection(plan.inputs[name]):
                needing.add(name)
        answered = {
            action.quantity for action in work.actions if action.done is not ActionKind.BLANK
        }
        assert follows == (needing & answered) - {slip.quantity}


def test_two_slips_are_made_at_two_places(who_all: WhoAll) -> None:
    _, works = who_all(Conduct.TWO_SLIPS)
    assert any(len(of_kind(work, ActionKind.SLIP)) == 2 for work in works)
    assert all(1 <= len(of_kind(work, ActionKind.SLIP)) <= 2 for work in works)


def test_a_number_in_another_unit_stands_there_without_it(who_all: WhoAll) -> None:
    _, works = who_all(Conduct.BARE_UNIT)
    for work in works:
        [action] = of_kind(work, ActionKind.BARE_UNIT)
        assert action.kind == "unit"
        assert isinstance(action.typed, float) or not any(
            sign.isalpha() for sign in action.typed or ""
        )
        assert not of_kind(work, ActionKind.FOLLOWS)


def test_a_unit_that_does_not_fit_stands_behind_the_right_number(who_all: WhoAll) -> None:
    _, works = who_all(Conduct.WRONG_UNIT)
    for work in works:
        [action] = of_kind(work, ActionKind.WRONG_UNIT)
        assert isinstance(action.typed, str)
        assert any(sign.isalpha() or sign in "%°" for sign in action.typed)
        assert action.value == pytest.approx(action.right, rel=0.02)


def test_a_size_is_rounded_down(who_all: WhoAll) -> None:
    _, works = who_all(Conduct.ROUNDED_DOWN)
    for work in works:
        [action] = of_kind(work, ActionKind.ROUNDED_DOWN)
        assert action.value is not None
        assert action.right is not None
        assert action.value < action.right


def test_who_leaves_blanks_leaves_about_that_share(who_all: WhoAll) -> None:
    room, works = who_all(Conduct.BLANKS, count=12)
    actions = [action for work in works for action in work.actions]
    blank = [action for action in actions if action.done is ActionKind.BLANK]
    assert len(blank) / len(actions) == pytest.approx(room.mix.blank, abs=0.06)
    assert all(action.typed is None and action.value is None for action in blank)


def test_copied_answers_are_the_neighbours_in_the_students_own_workbook(who_all: WhoAll) -> None:
    room, works = who_all(Conduct.HONEST, Conduct.COPIED_ANSWERS, count=16)
    copiers = [one for one in works if one.behaviour.conduct is Conduct.COPIED_ANSWERS]
    assert copiers
    for work in copiers:
        assert work.owner == work.student
        theirs = {one.quantity: one for one in work_of(work.behaviour.neighbour, room).actions}
        copied = of_kind(work, ActionKind.COPIED)
        assert len(copied) >= len(work.actions) / 2
        assert all(theirs[one.quantity].typed == one.typed for one in copied)


def test_a_copied_workbook_is_the_neighbours(who_all: WhoAll) -> None:
    room, works = who_all(Conduct.HONEST, Conduct.COPIED_WORKBOOK, count=16)
    copiers = [one for one in works if one.behaviour.conduct is Conduct.COPIED_WORKBOOK]
    assert copiers
    for work in copiers:
        assert work.owner == work.behaviour.neighbour
        assert work.actions == work_of(work.owner, room).actions


def test_students_of_all_kinds_of_slips_are_met(judged: tuple[JudgedWork, ...]) -> None:
    kinds = {
        action.kind
        for one in judged
        for action in one.work.actions
        if action.done is ActionKind.SLIP
    }
    assert len(kinds) > 10
    assert "declared" in kinds


def test_places_whose_effect_nobody_could_see_are_counted(judged: tuple[JudgedWork, ...]) -> None:
    tried = sum(one.work.tried for one in judged)
    hidden = sum(one.work.hidden for one in judged)
    assert 0 <= hidden < tried
    assert math.isfinite(hidden / tried)
