"""What a student may see before the deadline, and what never."""

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

import pytest

from gripcourse.course.quantity import Kind, Quantity
from gripcourse.grading.self_check import AnswerCheck, SectionState, State, self_check
from gripcourse.policy.model import Tells
from gripcourse.submission.model import Answer
from gripcourse.text.number_text import format_number
from gripcourse.text.words import LANGUAGES, Words

if TYPE_CHECKING:
    from conftest import Case, Written

JUDGED = {State.CONSISTENT, State.INCONSISTENT}


def checks(
    case: "Case",
    answers: "Mapping[str, Written]",
    tells: Tells = Tells.ANSWERS,
    **changes: object,
) -> dict[str, AnswerCheck]:
    done = self_check(case.submission(answers, **changes), case.plan, case.policy, tells)
    return {one.quantity: one for one in done.answers}


def sections(case: "Case", answers: "Mapping[str, Written]") -> dict[str, SectionState]:
    done = self_check(case.submission(answers), case.plan, case.policy, Tells.SECTIONS)
    return {one.section: one.state for one in done.sections}


def possible(quantity: Quantity, value: float) -> float:
    """The nearest value that the cell lets through: every other one is named as impossible."""
    low, high = quantity.bounds
    return min(max(value, low), high)


def states(case: "Case", answers: "Mapping[str, Written]", **changes: object) -> dict[str, State]:
    return {name: one.state for name, one in checks(case, answers, **changes).items()}


def earlier(case: "Case", name: str) -> list[str]:
    return [one for one in case.plan.inputs[name] if case.plan.quantities[one].kind.answered]


def test_everything_is_checked_in_the_order_of_the_assignment(case: "Case") -> None:
    assert list(checks(case, {})) == [one.id for one in case.plan.answered]


def test_right_answers_are_consistent_where_they_rest_on_own_ones(case: "Case") -> None:
    for name, state in states(case, case.answers).items():
        assert state is (State.CONSISTENT if earlier(case, name) else State.READ), name


def test_wrong_answers_that_fit_each_other_are_consistent_too(hydraulic: "Case") -> None:
    answers = hydraulic.following(lifting_load=3 * hydraulic.reference["lifting_load"])
    assert states(hydraulic, answers) == states(hydraulic, hydraulic.answers)


def test_what_rests_on_given_values_alone_is_never_judged(hydraulic: "Case") -> None:
    alone = [one.id for one in hydraulic.plan.answered if not earlier(hydraulic, one.id)]
    assert "lifting_load" in alone
    right = states(hydraulic, hydraulic.answers)
    wrong = states(hydraulic, dict.fromkeys(alone, 123.0))
    assert {right[name] for name in alone} == {State.READ}
    assert {wrong[name] for name in alone} == {State.READ}


def test_a_number_that_does_not_follow_is_named(hydraulic: "Case") -> None:
    answers = {**hydraulic.answers, "grip_force": 1.2 * hydraulic.reference["grip_force"]}
    assert states(hydraulic, answers)["grip_force"] is State.INCONSISTENT


@pytest.mark.parametrize("written", [None, "около 900"])
def test_without_the_earlier_answer_nothing_is_judged(
    hydraulic: "Case", written: str | None
) -> None:
    answers = {**hydraulic.answers, "lifting_load": written}
    assert states(hydraulic, answers)["grip_force"] is State.READ


@pytest.mark.parametrize("impossible", [-1.0, 1e12])
@pytest.mark.parametrize("guess", [1.0, 1.5])
def test_an_impossible_earlier_answer_is_no_way_to_ask_for_the_right_later_one(
    hydraulic: "Case", impossible: float, guess: float
) -> None:
    """Were it replaced by what the given values lead to, "consistent" would say "correct"."""
    force = guess * hydraulic.reference["grip_force"]
    asked = states(hydraulic, {"lifting_load": impossible, "grip_force": force})
    assert asked["grip_force"] is State.READ


def test_neither_is_an_earlier_answer_with_a_wrong_unit(
    hydraulic: "Case", read_answer: Callable[..., Answer]
) -> None:
    load = read_answer("lifting_load", 900.0, unit="kg", unit_fits=False)
    asked = states(hydraulic, {"lifting_load": load, "grip_force": 3900.0})
    assert asked["lifting_load"] is State.WRONG_UNIT
    assert asked["grip_force"] is State.READ


def test_the_same_is_said_whatever_the_answer_is_worth(case: "Case") -> None:
    """A check of one answer alone says the same for the right number and for any other."""
    for quantity in case.plan.answered:
        value = case.reference[quantity.id]
        other = 0.0 if quantity.kind is Kind.VERDICT else possible(quantity, 1.3 * value)
        right, wrong = checks(case, {quantity.id: value}), checks(case, {quantity.id: other})
        assert right[quantity.id].state not in JUDGED
        assert right[quantity.id].message == wrong[quantity.id].message
        assert right[quantity.id].remarks == wrong[quantity.id].remarks


@pytest.mark.parametrize("language", LANGUAGES)
def test_no_reference_value_is_in_anything_that_is_said(hydraulic: "Case", language: str) -> None:
    words = Words(language)
    wrong = {name: 1.37 * value + 1 for name, value in hydraulic.answers.items()}
    for answers in (wrong, {}, dict.fromkeys(wrong, "много")):
        done = checks(hydraulic, answers).values()
        said = " ".join(words.say(part) for one in done for part in (one.message, *one.remarks))
        shown = {format_number(value, language, 4) for value in hydraulic.answers.values()}
        assert {number for number in shown if len(number) > 1 and number in said} == set()


def test_a_workbook_without_given_values_is_only_read(hydraulic: "Case") -> None:
    answers = dict(hydraulic.answers)
    found = states(hydraulic, answers, givens={})
    assert found["lifting_load"] is State.READ
    assert JUDGED.isdisjoint({found["grip_force"], found["gear_torque"]})


def test_the_workbooks_own_given_values_are_used(hydraulic: "Case") -> None:
    """The self-check knows nothing that the workbook does not hold."""
    givens = {**hydraulic.given, "friction": 2 * hydraulic.given["friction"]}
    halved = {**hydraulic.answers, "grip_force": hydraulic.reference["grip_force"] / 2}
    assert states(hydraulic, halved, givens=givens)["grip_force"] is State.CONSISTENT


def test_a_number_outside_what_is_possible_is_named(hydraulic: "Case") -> None:
    low, high = hydraulic.plan.quantities["grip_force"].bounds
    for value in (low - 1, 10 * high):
        assert states(hydraulic, {"grip_force": value})["grip_force"] is State.IMPLAUSIBLE


def test_reading_alone_tells_nothing_of_any_number(case: "Case") -> None:
    """Not one bit: whatever is possible is read, whatever else stands in the workbook."""
    wrong = {
        one.id: possible(one, 1.37 * case.reference[one.id])
        for one in case.plan.answered
        if one.kind is Kind.FORMULA
    }
    right = checks(case, case.answers, Tells.READING)
    changed = checks(case, {**case.answers, **wrong}, Tells.READING)
    assert {one.state for one in right.values()} == {State.READ}
    assert [one.message for one in right.values()] == [one.message for one in changed.values()]


def test_a_section_is_told_as_a_whole(hydraulic: "Case") -> None:
    found = sections(hydraulic, hydraulic.answers)
    assert SectionState.FITS in found.values()
    assert SectionState.DOES_NOT_FIT not in found.values()
    wrong = {**hydraulic.answers, "grip_force": 1.2 * hydraulic.reference["grip_force"]}
    own = hydraulic.plan.quantities["grip_force"].section
    assert sections(hydraulic, wrong)[own] is SectionState.DOES_NOT_FIT
    read = self_check(
        hydraulic.submission(wrong), hydraulic.plan, hydraulic.policy, Tells.SECTIONS
    ).answers
    assert {one.state for one in read} == {State.READ}


def test_a_section_with_a_blank_is_not_told(case: "Case") -> None:
    for section, state in sections(case, case.answers).items():
        if state is SectionState.OPEN:
            continue
        own = next(one.id for one in case.plan.answered if one.section == section)
        left = {name: value for name, value in case.answers.items() if name != own}
        assert sections(case, left)[section] is SectionState.OPEN


def test_two_wrong_numbers_of_a_section_hide_each_other(hydraulic: "Case") -> None:
    """Who knows all answers of a section but two cannot find them one after the other."""
    fits = [one for one, state in sections(hydraulic, hydraulic.answers).items()
            if state is SectionState.FITS]  # fmt: skip
    for section in fits:
        names = [
            one.id
            for one in hydraulic.plan.answered
            if one.section == section and one.kind is Kind.FORMULA and earlier(hydraulic, one.id)
        ][:2]
        wrong = {
            name: possible(hydraulic.plan.quantities[name], 1.4 * hydraulic.reference[name])
            for name in names
        }
        for name in names:
            tried = {**hydraulic.answers, **wrong, name: hydraulic.reference[name]}
            assert sections(hydraulic, tried)[section] is SectionState.DOES_NOT_FIT
