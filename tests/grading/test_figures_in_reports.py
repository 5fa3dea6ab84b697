"""Significant figures cost what the policy says, beside the value and never instead of it."""

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

import pytest

from gripcourse.grading.model import Outcome
from gripcourse.policy.model import FigureRule
from gripcourse.submission.model import Answer

if TYPE_CHECKING:
    from conftest import Case

Typed = Callable[[str, float, int], Answer]


def test_too_many_figures_cost_the_policys_share_of_a_right_answer(
    hydraulic: "Case", typed: Typed
) -> None:
    strict = hydraulic.with_policy(figure_rule=FigureRule(least=0, most=4, credit=0.5))
    force = typed("drive_force", strict.reference["drive_force"], 6)
    answers = {**strict.answers, "drive_force": replace(force, figures=6)}
    found = strict.findings(answers)["drive_force"]
    assert found.outcome is Outcome.CORRECT
    assert found.points == pytest.approx(found.max_points / 2)
    assert "at most 4" in str(found.remarks[-1])


def test_the_course_does_not_judge_figures_by_itself(hydraulic: "Case", typed: Typed) -> None:
    force = typed("drive_force", hydraulic.reference["drive_force"], 6)
    answers = {**hydraulic.answers, "drive_force": replace(force, figures=6)}
    found = hydraulic.findings(answers)["drive_force"]
    assert found.points == pytest.approx(found.max_points)
