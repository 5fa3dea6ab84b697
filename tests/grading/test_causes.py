"""Root causes are told from consequences; one wrong number behind several answers costs once."""

import math
from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

from gripcourse.grading.causes import causes_of, spoiled_first, spoiled_later
from gripcourse.grading.misreading import misreadings
from gripcourse.grading.model import Outcome
from gripcourse.grading.substitution import Substitution
from gripcourse.solver.solve import solve_variant
from gripcourse.submission.model import Answer

if TYPE_CHECKING:
    from conftest import Case, Written

Typed = Callable[[str, float, int], Answer]


class TestRoots:
    def test_what_follows_a_wrong_answer_names_it(self, hydraulic: "Case") -> None:
        answers = hydraulic.following(lifting_load=1.37 * hydraulic.reference["lifting_load"])
        findings = hydraulic.findings(answers)
        assert findings["lifting_load"].roots == ()
        assert findings["grip_force"].roots == ("lifting_load",)
        assert findings["drive_force"].roots == ("lifting_load",)

    def test_the_report_counts_what_a_root_explains(self, hydraulic: "Case") -> None:
        answers = hydraulic.following(lifting_load=1.37 * hydraulic.reference["lifting_load"])
        report = hydraulic.judge(answers)
        cause = report.causes[0]
        carried = {one.quantity for one in report.findings if one.outcome is Outcome.CARRIED}
        assert cause.quantity == "lifting_load"
        # A size that is sound for the right numbers too is no fault, nor is what follows from it.
        assert carried > set(cause.explains) > {"grip_force", "drive_force", "pin_force"}
        assert f"explains {len(cause.explains)} later answers" in str(cause.message)

    def test_a_step_that_was_left_out_passes_the_root_on(self, hydraulic: "Case") -> None:
        answers = hydraulic.following(lifting_load=1.37 * hydraulic.reference["lifting_load"])
        findings = hydraulic.findings({**answers, "grip_force": None})
        assert findings["drive_force"].roots == ("lifting_load",)

    def test_two_wrong_answers_may_be_at_the_root(self, hydraulic: "Case") -> None:
        answers = hydraulic.following(
            grip_force=1.37 * hydraulic.reference["grip_force"],
            force_ratio=1.21 * hydraulic.reference["force_ratio"],
        )
        assert set(hydraulic.findings(answers)["drive_force"].roots) == {
            "grip_force",
            "force_ratio",
        }

    def test_right_answers_have_no_root(self, hydraulic: "Case") -> None:
        report = hydraulic.judge(hydraulic.answers)
        assert report.causes == ()
        assert {one.roots for one in report.findings} == {()}


class TestOneWrongNumber:
    def test_a_given_value_read_wrongly_explains_the_answers_that_use_it(
        self, table: "tuple[Case, ...]", typed: Typed
    ) -> None:
        found = 0
        for case in table[:24]:
            shared = _shared_given(case)
            if shared is None:
                continue
            wrong = solve_variant(case.plan, {**case.given, shared: 1.37 * case.given[shared]})
            if not all(math.isfinite(wrong[one.id]) for one in case.plan.answered):
                continue  # no size of a series is large enough: nobody could type these answers
            answers = {
                one.id: typed(one.id, wrong[one.id], 5) if one.kind == "formula" else wrong[one.id]
                for one in case.plan.answered
            }
            report = case.judge(answers)
            causes = [one for one in report.causes if one.quantity == shared]
            if not causes:
                continue
            found += 1
            first, *others = causes[0].explains
            findings = {one.quantity: one for one in report.findings}
            assert findings[first].outcome is Outcome.SLIP
            assert {findings[name].outcome for name in others} == {Outcome.CARRIED}
            assert all(first in findings[name].roots for name in others)
            assert first not in {one.quantity for one in report.causes}, "one cause, said once"
        assert found >= 5

    def test_a_decimal_sign_read_elsewhere_costs_once_whatever_each_answer_looks_like(
        self, table: "tuple[Case, ...]", typed: Typed
    ) -> None:
        """Each answer by itself looks like a slip of units; together they have one number."""
        lost, works = 0, 0
        for case in table[:14:2]:
            shared = _shared_given(case)
            if shared is None:
                continue
            works += 1
            report = case.judge(_with_given(case, typed, {shared: 10 * case.given[shared]}))
            mistakes = [one for one in report.findings if one.outcome.traits.mistake]
            lost += len(mistakes) > 1
            blamed = {cause.quantity for cause in report.causes} - {
                one.quantity for one in report.findings
            }
            assert blamed <= {shared}
        assert works >= 4
        assert lost <= 1

    def test_of_two_numbers_that_explain_as_well_the_one_with_exchanged_digits_is_named(
        self, hydraulic: "Case", typed: Typed
    ) -> None:
        """Pressure and efficiency stand in one product; only one has such digits."""
        plan = hydraulic.plan
        one = next(one for one in plan.givens if "pressure" in one.id)
        number = hydraulic.given[one.id]
        taken = next(iter(misreadings(number)))
        report = hydraulic.judge(_with_given(hydraulic, typed, {one.id: taken}))
        assert {cause.quantity for cause in report.causes} <= {one.id} | {
            one.quantity for one in report.findings
        }

    def test_a_number_that_may_be_rounded_far_is_explained_with_the_others(
        self, hydraulic: "Case", typed: Typed
    ) -> None:
        """A cell shows 1 for what was 1.00, and 0.83 is right: by itself it is too rough."""
        case = hydraulic.without_errata
        wrong = {
            one.id: _with_given(case, typed, {one.id: 1.2 * case.given[one.id]})
            for one in case.plan.givens
            if not one.integer
        }
        given, moved = max(
            ((name, _far_off(case, name, answers)) for name, answers in wrong.items()),
            key=lambda pair: len(pair[1]),
        )
        answers = wrong[given]
        assert len(moved) > 1
        spoiled, last = list(moved), list(moved.values())[-1]
        away = abs((last.value or 0) - case.reference[last.quantity])
        coarse = replace(last, half_unit=1.1 * away)
        alone = case.findings({**case.answers, last.quantity: coarse})[last.quantity]
        assert (alone.outcome, alone.points) == (Outcome.ROUGH, 0.0)
        report = case.judge({**answers, last.quantity: coarse})
        lost = {one.quantity for one in report.findings if one.points < one.max_points}
        assert lost & set(spoiled) == {spoiled[0]}
        assert given in {one.quantity for one in report.causes}

    def test_what_cannot_be_told_is_not_named(self, hydraulic: "Case") -> None:
        plan = hydraulic.plan
        explains = ("lifting_load", "grip_force")
        found = Substitution(plan.givens[0].id, math.nan, explains, 2.0, "", named=False)
        (cause,) = causes_of(plan, (), (found,))
        assert cause.quantity == "lifting_load"
        title = plan.givens[0].title.of("en")
        for said in (cause.message, spoiled_first(plan, found), spoiled_later(plan, found)):
            assert title not in str(said)

    def test_a_number_used_for_a_given_value_is_told_and_one_used_for_an_answer_is_not(
        self, hydraulic: "Case"
    ) -> None:
        plan = hydraulic.plan
        given = Substitution(plan.givens[0].id, 77.77, ("lifting_load", "grip_force"), 99.0, "")
        answer = replace(given, quantity="lifting_load")
        tied = replace(given, tied=plan.givens[1].id)
        for found, is_told in ((given, True), (answer, False), (tied, False)):
            (cause,) = causes_of(plan, (), (found,))
            said = (cause.message, spoiled_first(plan, found), spoiled_later(plan, found))
            assert {"77.77" in str(one) for one in said} == {is_told}

    def test_two_inputs_that_explain_as_well_are_both_named(self, hydraulic: "Case") -> None:
        plan = hydraulic.plan
        one, other = plan.givens[:2]
        found = Substitution(one.id, 77.77, ("lifting_load", "grip_force"), 99.0, other.id)
        (cause,) = causes_of(plan, (), (found,))
        for said in (cause.message, spoiled_first(plan, found)):
            assert one.title.of("en") in str(said)
            assert other.title.of("en") in str(said)

    def test_answers_that_are_wrong_each_in_its_own_way_have_no_common_cause(
        self, hydraulic: "Case", typed: Typed
    ) -> None:
        wrong = {
            name: typed(name, factor * hydraulic.reference[name], 4)
            for name, factor in {
                "jaw_travel": 1.3137,
                "gear_torque": 0.7719,
                "tooth_force": 1.0911,
            }.items()
        }
        report = hydraulic.judge({**hydraulic.answers, **wrong})
        assert report.causes == ()

    def test_nothing_is_explained_in_another_students_workbook(self, hydraulic: "Case") -> None:
        identity = replace(hydraulic.submission({}).identity, student="s02")
        answers = hydraulic.following(lifting_load=1.37 * hydraulic.reference["lifting_load"])
        report = hydraulic.judge(answers, identity=identity)
        assert report.causes == ()


def _with_given(case: "Case", typed: Typed, given: dict[str, float]) -> "dict[str, Written]":
    """What somebody writes with four figures who took other numbers for the given ones."""
    wrong = solve_variant(case.plan, {**case.given, **given})
    return {
        one.id: typed(one.id, wrong[one.id], 4)
        if one.kind == "formula" and wrong.get(one.id)
        else wrong[one.id]
        for one in case.plan.answered
        if math.isfinite(wrong.get(one.id, math.nan))
    }


def _far_off(case: "Case", given: str, answers: "dict[str, Written]") -> dict[str, Answer]:
    """The answers that use a given value directly and are far from the right ones."""
    return {
        one.quantity: one
        for one in answers.values()
        if isinstance(one, Answer)
        and given in case.plan.inputs[one.quantity]
        and one.value is not None
        and not math.isclose(one.value, case.reference[one.quantity], rel_tol=0.06)
    }


def _shared_given(case: "Case") -> str | None:
    """A given value that at least two computed answers use directly."""
    for given in case.plan.givens:
        users = [
            one.id
            for one in case.plan.answered
            if given.id in case.plan.inputs[one.id] and one.kind == "formula"
        ]
        if len(users) > 1 and not given.integer and case.given[given.id] > 0:
            return given.id
    return None


def test_a_given_number_left_out_of_two_sums_costs_once(
    drawn: "tuple[Case, ...]", typed: Typed
) -> None:
    """Whoever forgets the travel that frees the object forgets it in the open position too."""
    names = ("jaw_travel", "grip_arm_tilt_open")
    levers = [one for one in drawn if one.plan.scheme.id == "plain_lever"]
    assert levers
    for case in levers:
        forgotten = case.following(release_travel=0.0)
        off = {name: typed(name, forgotten[name], 5) for name in names}
        assert case.lost({**forgotten, **off}) == {names[0]}, case.label


def test_a_size_far_from_the_right_one_and_its_verdict_cost_once(
    belt_table: "tuple[Case, ...]",
) -> None:
    """A required ratio of 3.6 for 1.6 gives a pulley that nobody takes by chance, and suits it."""
    tried = 0
    for case in belt_table:
        ratio = case.given["ratio_wanted"]
        answers = case.following(ratio_wanted=ratio + (2 if ratio < 3 else -2))
        others = {name for name, value in answers.items() if value != case.reference[name]}
        if {"large_diameter", "ratio_ok"} <= others:
            tried += 1
            assert len(case.lost(answers)) <= 1, case.label
    assert tried >= 3
