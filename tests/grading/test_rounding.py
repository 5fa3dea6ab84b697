"""How finely a typed number is known, and what may follow from it."""

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
import pytest

from gripcourse.course.quantity import Kind
from gripcourse.grading.follow_through import range_of
from gripcourse.grading.model import Outcome
from gripcourse.grading.rounding import figure_half_unit, kept_figures, reach_of, typed_half_unit
from gripcourse.policy.model import Policy
from gripcourse.solver.solve import evaluate, from_si, to_si
from gripcourse.submission.model import Answer

if TYPE_CHECKING:
    from conftest import Case

Typed = Callable[[str, float, int], Answer]
ReadAnswer = Callable[..., Answer]


@pytest.mark.parametrize(
    ("value", "figures", "rounded", "cut"),
    [
        (355.35, 4, 355.4, 355.3),
        (-0.028451, 3, -0.0285, -0.0284),
        (0.3, 3, 0.3, 0.3),
        (1048.0, 2, 1000.0, 1000.0),
        (9.996, 3, 10.0, 9.99),
        (0.0, 3, 0.0, 0.0),
    ],
)
def test_figures_are_kept_as_people_write_them_down(
    value: float, figures: int, rounded: float, cut: float
) -> None:
    """Halfway goes away from zero."""
    assert kept_figures(value, figures, cut=False) == pytest.approx(rounded, rel=1e-12)
    assert kept_figures(value, figures, cut=True) == pytest.approx(cut, rel=1e-12)


class TestTypedNumbers:
    @pytest.mark.parametrize(
        ("value", "figures", "half_unit"), [(1843.0, 4, 0.5), (0.0372, 3, 0.00005), (5.0, 3, 0.005)]
    )
    def test_half_a_unit_of_the_last_figure(
        self, value: float, figures: int, half_unit: float
    ) -> None:
        assert figure_half_unit(value, figures) == pytest.approx(half_unit)

    def test_a_short_number_counts_as_written_with_the_figures_that_are_asked(
        self, policy: Policy, read_answer: ReadAnswer
    ) -> None:
        """A spreadsheet shows 5 where 5.00 was typed."""
        five = replace(read_answer("jaw_travel", 5.0), half_unit=0.5)
        assert typed_half_unit(five, policy) == pytest.approx(0.005)

    def test_zeros_that_end_a_whole_number_may_stand_for_anything(
        self, policy: Policy, read_answer: ReadAnswer
    ) -> None:
        whole = replace(read_answer("grip_force", 102000.0), half_unit=0.5, figures=3)
        assert reach_of(whole, replace(policy, last_digit=0.5)) == pytest.approx((500, 500))
        exact = replace(read_answer("grip_force", 102345.0), half_unit=0.5, figures=6)
        assert reach_of(exact, replace(policy, last_digit=0.5)) == pytest.approx((0.5, 0.5))

    def test_a_number_may_have_been_cut_off(self, policy: Policy, typed: Typed) -> None:
        answer = typed("jaw_travel", 12.345, 4)
        below, above = reach_of(answer, replace(policy, last_digit=1.0))
        assert (below, above) == pytest.approx((0.005, 0.01))
        negative = typed("jaw_travel", -12.345, 4)
        assert reach_of(negative, replace(policy, last_digit=1.0)) == (above, below)
        rounded = reach_of(answer, replace(policy, last_digit=0.5))
        assert rounded == pytest.approx((0.005, 0.005))


class TestRanges:
    def test_the_moves_of_all_inputs_add_up(self) -> None:
        low, high = range_of(np.array([10.0, 9.0, 11.5, 10.2, 9.9]))
        assert (low, high) == pytest.approx((8.9, 11.7))

    def test_a_move_out_of_the_domain_does_not_count(self) -> None:
        assert range_of(np.array([10.0, np.nan, 11.0])) == pytest.approx((10.0, 11.0))

    def test_what_no_typed_number_moves_is_one_point(self) -> None:
        assert range_of(np.asarray(3.0)) == (3.0, 3.0)


class TestHonestStudents:
    @pytest.mark.parametrize("figures", [3, 4, 5])
    @pytest.mark.parametrize("cut", [False, True], ids=["rounded", "cut off"])
    def test_who_slips_early_and_rounds_loses_only_the_slip(
        self, drawn: "tuple[Case, ...]", typed: Typed, figures: int, *, cut: bool
    ) -> None:
        """The calculator keeps all digits; only what is typed is short, however ill conditioned."""
        for case in drawn[::2]:
            wrong = 1.371 * case.reference["lifting_load"]
            values = case.following(lifting_load=wrong)
            answers = {
                one.id: _shortened(typed, one.id, values[one.id], figures, cut=cut)
                if one.kind is Kind.FORMULA and not one.integer
                else values[one.id]
                for one in case.plan.answered
            }
            assert case.lost(answers) <= {"lifting_load"}, case.label

    def test_the_range_of_an_answer_is_reported(self, hydraulic: "Case", typed: Typed) -> None:
        force = typed("grip_force", hydraulic.reference["grip_force"], 3)
        found = hydraulic.findings({**hydraulic.answers, "grip_force": force})["drive_force"]
        assert found.low is not None
        assert found.high is not None
        assert found.expected is not None
        assert found.low < found.expected < found.high

    def test_the_range_is_no_wider_than_the_policy_allows(
        self, hydraulic: "Case", typed: Typed
    ) -> None:
        narrow = hydraulic.with_policy(widest=0.1)
        force = typed("grip_force", narrow.reference["grip_force"], 3)
        found = narrow.findings({**narrow.answers, "grip_force": force})["drive_force"]
        assert found.expected is not None
        assert found.high is not None
        assert found.high - found.expected <= 0.1 * found.band * (1 + 1e-9)

    def test_a_size_is_judged_by_what_is_needed_as_finely_as_that_is_known(
        self, hydraulic: "Case", typed: Typed
    ) -> None:
        """63.04 mm are needed, 63.0 was typed: 63 mm is not too small."""
        series = hydraulic.plan.columns["bore_hydraulic.bore"].sizes * 1000
        size = float(series[np.searchsorted(series, hydraulic.reference["bore_required"])])
        answers = {
            **hydraulic.answers,
            "bore_required": typed("bore_required", size * 1.0005, 3),
            "bore": size,
        }
        found = hydraulic.findings(answers)["bore"]
        assert found.outcome in {Outcome.CORRECT, Outcome.CARRIED}


def _shortened(typed: Typed, name: str, value: float, figures: int, *, cut: bool) -> Answer:
    if not cut or value == 0:
        return typed(name, value, figures)
    unit = 2 * figure_half_unit(value, figures)
    return typed(name, float(np.trunc(value / unit) * unit), figures)


def test_following_is_evaluating_with_the_typed_numbers(hydraulic: "Case") -> None:
    """What is expected after a wrong answer is what the solver computes from it."""
    wrong = 1.5 * hydraulic.reference["grip_force"]
    known = to_si(hydraulic.plan, {**hydraulic.given, "grip_force": wrong})
    expected = from_si(hydraulic.plan, evaluate(hydraulic.plan, known).values)["drive_force"]
    found = hydraulic.findings(hydraulic.following(grip_force=wrong))["drive_force"]
    assert found.expected == pytest.approx(expected)
