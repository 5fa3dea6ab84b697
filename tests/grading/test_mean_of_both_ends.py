"""Who takes the mean where the larger of two counts is told so."""

from typing import TYPE_CHECKING

import pytest

from gripcourse.grading.model import Outcome

if TYPE_CHECKING:
    from conftest import Case

APART = 1.1  # ends so near to each other have a mean that no band tells from the larger


@pytest.mark.parametrize(
    ("name", "ends"),
    [
        ("force_ratio", ("force_ratio_at_max", "force_ratio_at_min")),
        ("torque_ratio", ("torque_ratio_at_max", "torque_ratio_at_min")),
        ("joint_force", ("joint_force_at_max", "joint_force_at_min")),
        ("grip_force_min", ("finger_force_right", "finger_force_left")),
    ],
)
def test_the_mean_of_two_is_named(
    drawn: "tuple[Case, ...]", table: "tuple[Case, ...]", name: str, ends: tuple[str, str]
) -> None:
    case = next(
        one
        for one in (*drawn, *table)
        if {name, *ends} <= one.answers.keys()
        and one.plan.inputs[name] == ends
        and max(map(one.reference.__getitem__, ends))
        > APART * min(map(one.reference.__getitem__, ends))
    )
    mean = sum(case.reference[end] for end in ends) / 2
    answers = {**case.answers, **case.following(**{name: mean}), name: mean}
    finding = case.findings(answers)[name]
    assert finding.outcome is Outcome.SLIP
    assert "mean_of_both" in str(finding.slip)
