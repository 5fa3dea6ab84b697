"""What a whole workbook earns: right, rounded, wrong at one place, blank, unreadable."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gripcourse.course.quantity import Kind
from gripcourse.grading.judge import judge
from gripcourse.grading.model import Outcome
from gripcourse.policy.bands import band
from gripcourse.submission.model import Answer

if TYPE_CHECKING:
    from conftest import Case


def rounded(value: float, figures: int) -> float:
    return float(f"{value:.{figures}g}")


def computed_on(case: "Case", figures: int) -> dict[str, float]:
    """Round every computed step, and compute the next ones from what was written."""
    known: dict[str, float] = {}
    for name, quantity in case.plan.quantities.items():
        if quantity.kind is Kind.FORMULA:
            known[name] = rounded(case.following(**known)[name], figures)
    return case.following(**known)


class TestRightAnswers:
    def test_reference_answers_earn_everything(self, case: "Case") -> None:
        report = case.judge(case.answers)
        assert report.score == pytest.approx(report.max_score)
        assert {one.outcome for one in report.findings} <= {Outcome.CORRECT, Outcome.MANUAL}
        assert report.flags == ()

    def test_reference_answers_of_every_issued_or_drawn_variant_earn_everything(
        self, table: "tuple[Case, ...]", drawn: "tuple[Case, ...]"
    ) -> None:
        for case in (*table, *drawn):
            report = case.judge(case.answers)
            assert report.score == pytest.approx(report.max_score), case.label

    def test_rounding_every_step_to_three_figures_and_computing_on_costs_nothing(
        self, table: "tuple[Case, ...]", drawn: "tuple[Case, ...]"
    ) -> None:
        for case in (*table[::20], *drawn[::10]):
            assert case.lost(computed_on(case, 3)) == set(), case.label

    def test_typing_three_figures_of_exact_numbers_costs_nothing(
        self, table: "tuple[Case, ...]", drawn: "tuple[Case, ...]", typed: Callable[..., Answer]
    ) -> None:
        for case in (*table[::4], *drawn[::2]):
            kinds = {one.id: one.kind for one in case.plan.answered}
            answers = {
                name: typed(name, value, 3) if kinds[name] is Kind.FORMULA else value
                for name, value in case.answers.items()
            }
            assert case.lost(answers) == set(), case.label

    def test_manual_items_wait_for_a_person_and_count_in_neither_sum(self, case: "Case") -> None:
        report = case.judge(case.answers)
        manual = [one for one in report.findings if one.outcome is Outcome.MANUAL]
        assert {one.quantity for one in manual} == {one.id for one in case.plan.manual}
        assert report.open_points == pytest.approx(sum(one.max_points for one in manual))
        assert report.open_points + report.max_score == pytest.approx(case.policy.total)

    def test_findings_stand_in_the_order_of_the_assignment(self, case: "Case") -> None:
        sections = [one.section for one in case.judge({}).findings]
        ranks = [one.id for one in case.plan.course.sections]
        assert sections == sorted(sections, key=ranks.index)


class TestOneAnswerMoved:
    def test_just_outside_its_band_it_costs_that_item_only(
        self, case: "Case", computed: tuple[str, ...]
    ) -> None:
        """Below it and above it by turns; tests of contracts ask it of all schemes."""
        strict = case.without_errata
        lost = {
            name: strict.lost(moved(strict, name, (-1.1, 1.1)[number % 2]))
            for number, name in enumerate(computed)
        }
        assert lost == {name: {name} for name in computed}

    @pytest.mark.parametrize("direction", [-0.999999, 0.999999])
    def test_just_inside_its_band_it_costs_nothing(
        self, case: "Case", computed: tuple[str, ...], direction: float
    ) -> None:
        assert lost_one_by_one(case, computed, direction) == set()

    @pytest.mark.parametrize("direction", [-1.0, 1.0])
    def test_exactly_on_the_edge_it_counts_as_inside(
        self, case: "Case", computed: tuple[str, ...], direction: float
    ) -> None:
        assert lost_one_by_one(case, computed, direction) == set()

    @settings(max_examples=15)
    @given(near=st.floats(0, 3), far=st.floats(0, 3), data=st.data())
    def test_marks_never_fall_when_an_answer_gets_closer(
        self, hydraulic: "Case", near: float, far: float, data: st.DataObject
    ) -> None:
        strict = hydraulic.without_errata
        names = [one.id for one in strict.plan.answered if one.kind is Kind.FORMULA]
        name = data.draw(st.sampled_from(names))
        sign = data.draw(st.sampled_from([-1, 1]))
        near, far = sorted((near, far))
        closer = strict.judge(moved(strict, name, sign * near)).score
        farther = strict.judge(moved(strict, name, sign * far)).score
        assert closer >= farther

    def test_the_wrong_sign_is_wrong(self, case: "Case", computed: tuple[str, ...]) -> None:
        strict = case.without_errata
        names = [name for name in computed if strict.reference[name] > 1][::2]
        lost = {
            name: strict.lost({**strict.answers, name: -strict.reference[name]}) for name in names
        }
        assert lost == {name: {name} for name in names}


def lost_one_by_one(case: "Case", names: Sequence[str], bands: float) -> set[str]:
    """What is lost where every third answer is away from its reference, one at a time."""
    return set().union(*(case.lost(moved(case, name, bands)) for name in names[::3]))


def moved(case: "Case", name: str, bands: float) -> dict[str, float]:
    """The reference answers, one of them away from its own by so many bands."""
    value = case.reference[name]
    width = band(case.plan.quantities[name], value, case.policy)
    return {**case.answers, name: value + bands * width}


class TestBlankUnreadableWrong:
    def test_a_workbook_without_answers_earns_nothing_and_is_blank_everywhere(
        self, case: "Case"
    ) -> None:
        report = case.judge({})
        assert report.score == 0
        assert report.judged
        outcomes = outcomes_of(report.findings)
        assert outcomes == {Outcome.BLANK, Outcome.MANUAL}

    def test_blank_unreadable_and_wrong_are_three_things(self, hydraulic: "Case") -> None:
        answers = {
            **hydraulic.answers,
            "lifting_load": None,
            "gear_torque": "около 600",
            "jaw_travel": 7.0,
        }
        findings = hydraulic.findings(answers)
        assert findings["lifting_load"].outcome is Outcome.BLANK
        assert findings["gear_torque"].outcome is Outcome.UNREADABLE
        assert findings["jaw_travel"].outcome is Outcome.WRONG
        assert findings["gear_torque"].typed == "около 600"
        assert findings["gear_torque"].given is None
        assert "A number is needed here." in {str(one) for one in findings["gear_torque"].remarks}

    @pytest.mark.parametrize("written", [None, "примерно 900"])
    def test_missing_early_answers_do_not_cost_later_ones(
        self, case: "Case", written: str | None
    ) -> None:
        early = ["lifting_load", "jaw_travel", "gear_torque", "module_required"]
        assert case.lost({**case.answers, **dict.fromkeys(early, written)}) == set(early)

    def test_a_blank_between_wrong_and_later_is_computed_from_the_wrong_one(
        self, hydraulic: "Case"
    ) -> None:
        answers = hydraulic.following(lifting_load=1.5 * hydraulic.reference["lifting_load"])
        assert hydraulic.lost({**answers, "grip_force": None}) == {"lifting_load", "grip_force"}

    def test_a_cell_that_is_gone_is_blank(self, hydraulic: "Case") -> None:
        whole = hydraulic.submission(hydraulic.answers)
        kept = {name: one for name, one in whole.answers.items() if name != "rod"}
        report = judge(
            replace(whole, answers=kept), hydraulic.issued, hydraulic.plan, hydraulic.policy
        )
        finding = next(one for one in report.findings if one.quantity == "rod")
        assert finding.outcome is Outcome.BLANK
        assert finding.cell == ""

    def test_an_answer_of_exactly_zero_is_an_answer(self, case: "Case") -> None:
        assert case.reference["arm_angle_at_min"] == pytest.approx(0, abs=1e-9)
        right = case.findings({"arm_angle_at_min": 0.0})["arm_angle_at_min"]
        assert right.outcome is Outcome.CORRECT
        assert right.given == 0.0
        wrong = case.findings({"jaw_travel": 0.0})["jaw_travel"]
        assert wrong.outcome is Outcome.WRONG
        assert wrong.given == 0.0

    def test_a_zero_is_carried_on_where_its_guard_allows_it(self, hydraulic: "Case") -> None:
        answers = {**hydraulic.answers, "arm_angle_at_max": 0.0}
        finding = hydraulic.findings(answers)["force_ratio_at_max"]
        assert finding.inputs["arm_angle_at_max"] == 0.0
        assert finding.outcome is Outcome.CORRECT


class TestVerdicts:
    def test_yes_is_right_by_the_reference(self, hydraulic: "Case") -> None:
        assert hydraulic.reference["bearing_ok"] == 1.0
        assert hydraulic.findings(hydraulic.answers)["bearing_ok"].outcome is Outcome.CORRECT

    def test_yes_beside_numbers_that_say_no_is_wrong(self, hydraulic: "Case") -> None:
        answers = {**hydraulic.answers, "bearing_stress": 95.0}
        assert hydraulic.findings(answers)["bearing_ok"].outcome is Outcome.WRONG

    def test_no_against_all_numbers_is_wrong(self, hydraulic: "Case") -> None:
        finding = hydraulic.findings({**hydraulic.answers, "bearing_ok": 0.0})["bearing_ok"]
        assert finding.outcome is Outcome.WRONG
        assert str(finding.message) == "Your numbers say the opposite."

    def test_no_is_right_where_the_students_own_numbers_say_so(self, hydraulic: "Case") -> None:
        answers = {**hydraulic.answers, "bearing_stress": 95.0, "bearing_ok": 0.0}
        findings = hydraulic.findings(answers)
        assert findings["bearing_ok"].outcome is Outcome.CARRIED
        assert findings["bearing_ok"].points == findings["bearing_ok"].max_points
        assert findings["bearing_stress"].outcome is Outcome.WRONG


def outcomes_of(findings: Iterable[object]) -> set[Outcome]:
    return {one.outcome for one in findings}  # type: ignore[attr-defined]
