"""A number that is asked for in several cells and was computed wrongly once is one mistake."""

import math
from typing import TYPE_CHECKING

import numpy as np
import pytest

from gripcourse.formula.evaluate import evaluate
from gripcourse.grading.model import Outcome
from gripcourse.policy.slips import SlipKind
from gripcourse.slips.candidates import candidates_of
from gripcourse.solver.solve import to_si
from gripcourse.text.units import factor

if TYPE_CHECKING:
    from conftest import Case

POINTS = tuple(f"contact_binormal_{point}" for point in (1, 2, 3, 4))


@pytest.fixture(scope="module")
def at_four_points(table: "tuple[Case, ...]") -> "Case":
    """A variant in which the load along the object's axis presses four like points."""
    return next(
        one
        for one in table
        if set(POINTS) <= set(one.reference)
        and len({round(one.reference[name], 6) for name in POINTS}) == 1
    )


def with_half_of_the_points(case: "Case") -> dict[str, float]:
    """N = Q_B/(2f) at each of four points, where Q_B/(4f) is right."""
    number = case.reference["load_binormal"] / (2 * case.given["friction"])
    return case.following(**dict.fromkeys(POINTS, number))


class TestOneForceAtFourPoints:
    def test_it_costs_the_first_point_alone(self, at_four_points: "Case") -> None:
        lost = at_four_points.lost(with_half_of_the_points(at_four_points))
        assert lost == {POINTS[0]}

    def test_its_own_method_is_named_and_no_other_number_is_blamed(
        self, at_four_points: "Case"
    ) -> None:
        report = at_four_points.judge(with_half_of_the_points(at_four_points))
        findings = {one.quantity: one for one in report.findings}
        assert str(findings[POINTS[0]].slip) == "two_points_only"
        assert "load_binormal" not in {one.quantity for one in report.causes}

    def test_the_others_say_where_it_has_cost(self, at_four_points: "Case") -> None:
        findings = at_four_points.findings(with_half_of_the_points(at_four_points))
        for name in POINTS[1:]:
            assert findings[name].outcome is Outcome.CARRIED
            assert findings[name].roots == (POINTS[0],)
            assert str(findings[name].message).startswith(
                "The same wrong number as in normal force"
            )

    def test_two_mistakes_at_like_points_cost_twice(self, at_four_points: "Case") -> None:
        right = at_four_points.reference[POINTS[0]]
        answers = at_four_points.following(**{POINTS[0]: 1.37 * right, POINTS[1]: 1.61 * right})
        assert at_four_points.lost(answers) == {POINTS[0], POINTS[1]}

    def test_a_work_that_calculates_nothing_earns_nothing_by_repeating(
        self, at_four_points: "Case"
    ) -> None:
        nothing = dict.fromkeys(at_four_points.answers, 7.0)
        findings = at_four_points.findings(nothing)
        assert {findings[name].points for name in POINTS} == {0.0}


class TestWhatGoverns:
    def test_of_two_wrong_forces_only_the_larger_explains_what_follows(
        self, at_four_points: "Case"
    ) -> None:
        # F_min is the larger of both fingers: 0.9 of the smaller one changes nothing.
        right, left = (
            at_four_points.reference[f"finger_force_{side}"] for side in ("right", "left")
        )
        assert right > left
        answers = at_four_points.following(
            finger_force_right=1.37 * right, finger_force_left=0.9 * left
        )
        report = at_four_points.judge(answers)
        findings = {one.quantity: one for one in report.findings}
        assert findings["grip_force_min"].roots == ("finger_force_right",)
        assert {one.quantity for one in report.causes} == {"finger_force_right"}


class TestANumberThatCannotBeBesideABlankOne:
    def test_what_follows_is_put_to_the_number_that_was_written(
        self, table: "tuple[Case, ...]"
    ) -> None:
        """Degrees taken for radians make N_1b negative; N_3b, which is like it, was not written.

        X_13 takes N_1b·(sin φ + f·cos φ): it shows either slip alike.
        """
        told = set()
        for case in table:
            if not {"contact_normal_1", "contact_normal_3"} <= set(case.answers):
                continue
            angle = math.radians(case.given["contact_angle_1"])
            share = math.sin(angle) + case.given["friction"] * math.cos(angle)
            right = case.reference["contact_normal_1"]
            for wrong in _of_radians(case, "contact_normal_1"):
                if not -3 * right < wrong < -0.3 * right:
                    continue
                opening = case.reference["finger_opening_right"] + (wrong - right) * share
                answers = {
                    **case.answers,
                    "contact_normal_1": wrong,
                    "contact_normal_3": None,
                    "finger_opening_right": opening,
                }
                told.add(case.findings(answers)["finger_opening_right"].roots)
        assert told == {("contact_normal_1",)}


def _of_radians(case: "Case", name: str) -> list[float]:
    """What the formula of an answer gives if degrees are taken for radians in it."""
    known = {one: np.asarray(v) for one, v in to_si(case.plan, case.reference).items()}
    unit = case.plan.quantities[name].unit
    return [
        float(evaluate(one.formula, unit, known, case.plan.columns)) / factor(unit)
        for one in candidates_of(case.plan, name, case.policy.slips)
        if one.kind == SlipKind.ANGLE_UNIT
    ]
