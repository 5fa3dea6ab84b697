"""Each student does what the behaviour says, and the truth tells it."""

import math
from collections.abc import Callable, Sequence

import pytest

from gripcourse.course.model import Kind
from gripcourse.policy.bands import band
from gripcourse.simulation.confusion import Judged
from gripcourse.simulation.model import Conduct, Deed, Done, Work
from gripcourse.simulation.student import Classroom, work_of
from gripcourse.solver.plan import Plan, make_plan

WhoAll = Callable[..., tuple[Classroom, Sequence[Work]]]


def plan_of(room: Classroom, work: Work) -> Plan:
    variant = room.desk.register[work.student].variant
    return make_plan(room.desk.course, variant.scheme, variant.options)


def of_kind(work: Work, done: Done) -> list[Deed]:
    return [deed for deed in work.deeds if deed.done is done]


def test_an_honest_student_answers_everything_rightly(who_all: WhoAll) -> None:
    room, works = who_all(Conduct.HONEST)
    for work in works:
        assert {deed.done for deed in work.deeds} == {Done.RIGHT}
        assert [deed.quantity for deed in work.deeds] == [
            one.id for one in plan_of(room, work).answered
        ]


def test_a_student_works_the_same_way_each_time(room: Classroom) -> None:
    for student in list(room.behaviours)[:10]:
        assert work_of(student, room) == work_of(student, room)


def test_a_slip_is_made_once_where_it_can_be_seen(who_all: WhoAll) -> None:
    room, works = who_all(Conduct.SLIP, count=12)
    for work in works:
        [slip] = of_kind(work, Done.SLIP)
        plan = plan_of(room, work)
        quantity = plan.quantities[slip.quantity]
        assert slip.slip
        assert slip.right is not None
        assert slip.value is not None
        if quantity.kind is not Kind.CHOICE:
            width = band(quantity, slip.right, room.desk.policy)
            assert abs(slip.value - slip.right) >= room.mix.apart * width


def test_after_a_slip_everything_that_needs_it_follows(who_all: WhoAll) -> None:
    room, works = who_all(Conduct.SLIP, count=12)
    for work in works:
        [slip] = of_kind(work, Done.SLIP)
        follows = {deed.quantity for deed in of_kind(work, Done.FOLLOWS)}
        needing = {slip.quantity}
        plan = plan_of(room, work)
        for name in plan.quantities:
            if needing.intersection(plan.inputs[name]):
                needing.add(name)
        answered = {deed.quantity for deed in work.deeds if deed.done is not Done.BLANK}
        assert follows == (needing & answered) - {slip.quantity}


def test_two_slips_are_made_at_two_places(who_all: WhoAll) -> None:
    _, works = who_all(Conduct.TWO_SLIPS)
    assert any(len(of_kind(work, Done.SLIP)) == 2 for work in works)
    assert all(1 <= len(of_kind(work, Done.SLIP)) <= 2 for work in works)


def test_a_number_in_another_unit_stands_there_without_it(who_all: WhoAll) -> None:
    _, works = who_all(Conduct.BARE_UNIT)
    for work in works:
        [deed] = of_kind(work, Done.BARE_UNIT)
        assert deed.kind == "unit"
        assert isinstance(deed.typed, float) or not any(sign.isalpha() for sign in deed.typed or "")
        assert not of_kind(work, Done.FOLLOWS)


def test_a_unit_that_does_not_fit_stands_behind_the_right_number(who_all: WhoAll) -> None:
    _, works = who_all(Conduct.WRONG_UNIT)
    for work in works:
        [deed] = of_kind(work, Done.WRONG_UNIT)
        assert isinstance(deed.typed, str)
        assert any(sign.isalpha() or sign in "%°" for sign in deed.typed)
        assert deed.value == pytest.approx(deed.right, rel=0.02)


def test_a_size_is_rounded_down(who_all: WhoAll) -> None:
    _, works = who_all(Conduct.ROUNDED_DOWN)
    for work in works:
        [deed] = of_kind(work, Done.ROUNDED_DOWN)
        assert deed.value is not None
        assert deed.right is not None
        assert deed.value < deed.right


def test_who_leaves_blanks_leaves_about_that_share(who_all: WhoAll) -> None:
    room, works = who_all(Conduct.BLANKS, count=12)
    deeds = [deed for work in works for deed in work.deeds]
    blank = [deed for deed in deeds if deed.done is Done.BLANK]
    assert len(blank) / len(deeds) == pytest.approx(room.mix.blank, abs=0.06)
    assert all(deed.typed is None and deed.value is None for deed in blank)


def test_copied_answers_are_the_neighbours_in_the_students_own_workbook(who_all: WhoAll) -> None:
    room, works = who_all(Conduct.HONEST, Conduct.COPIED_ANSWERS, count=16)
    copiers = [one for one in works if one.behaviour.conduct is Conduct.COPIED_ANSWERS]
    assert copiers
    for work in copiers:
        assert work.owner == work.student
        theirs = {one.quantity: one for one in work_of(work.behaviour.neighbour, room).deeds}
        copied = of_kind(work, Done.COPIED)
        assert len(copied) >= len(work.deeds) / 2
        assert all(theirs[one.quantity].typed == one.typed for one in copied)


def test_a_copied_workbook_is_the_neighbours(who_all: WhoAll) -> None:
    room, works = who_all(Conduct.HONEST, Conduct.COPIED_WORKBOOK, count=16)
    copiers = [one for one in works if one.behaviour.conduct is Conduct.COPIED_WORKBOOK]
    assert copiers
    for work in copiers:
        assert work.owner == work.behaviour.neighbour
        assert work.deeds == work_of(work.owner, room).deeds


def test_students_of_all_kinds_of_slips_are_met(judged: tuple[Judged, ...]) -> None:
    kinds = {deed.kind for one in judged for deed in one.work.deeds if deed.done is Done.SLIP}
    assert len(kinds) > 10
    assert "declared" in kinds


def test_places_whose_effect_nobody_could_see_are_counted(judged: tuple[Judged, ...]) -> None:
    tried = sum(one.work.tried for one in judged)
    hidden = sum(one.work.hidden for one in judged)
    assert 0 < hidden < tried
    assert math.isfinite(hidden / tried)
