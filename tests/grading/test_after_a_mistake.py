"""What follows from a mistake costs nothing, by whichever honest way it was computed on."""

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING

import pytest

from gripcourse.grading.model import Outcome

if TYPE_CHECKING:
    from conftest import Case


def _of_scheme(table: "tuple[Case, ...]", scheme: str, quantity: str) -> "Case":
    return next(
        one for one in table if one.plan.scheme.id == scheme and quantity in one.answers
    ).without_errata


def test_a_stroke_is_written_without_the_sign_of_its_difference(
    table: "tuple[Case, ...]",
) -> None:
    """An arm that stands wrongly moves the rod the other way; a stroke is a length."""
    case = _of_scheme(table, "plain_lever", "drive_arm_angle_at_min")
    answers = case.following(drive_arm_angle_at_min=case.reference["drive_arm_angle_open"] - 30)
    assert answers["stroke_required"] < 0
    stroke = abs(answers["stroke_required"])
    findings = case.findings({**case.answers, **answers, "stroke_required": stroke})
    assert findings["drive_arm_angle_at_min"].outcome.traits.mistake
    assert findings["stroke_required"].outcome is Outcome.CARRIED


@pytest.mark.parametrize(
    ("quantity", "wrong", "later"),
    [("wedge_efficiency", 1.4, "total_efficiency"), ("jaw_travel", 1.6, "velocity_ratio_range")],
)
def test_either_way_from_an_earlier_mistake_costs_once(
    table: "tuple[Case, ...]", quantity: str, wrong: float, later: str
) -> None:
    """The losses as a product; the path between both ends by the diameters of the sheet."""
    case = _of_scheme(table, "wedge_slide", later)
    own = {**case.given, **case.following(**{quantity: wrong * case.reference[quantity]})}
    written = {**case.answers, **{name: own[name] for name in case.answers}}
    for way in (own[later], _by_another_way(own)[later]):
        assert case.lost({**written, later: way}) == {quantity}


@pytest.mark.parametrize(("wrap", "factor"), [(314.0, 1.0), (35.0, 0.56), (12.6, 0.56)])
def test_what_lies_beyond_a_table_is_read_from_its_last_row(
    v_belt: "Case", wrap: float, factor: float
) -> None:
    """Of an angle that can be and of one that cannot; another row is a mistake of its own."""
    answers = v_belt.following(wrap_angle=wrap, wrap_factor=factor)
    assert v_belt.lost(answers) == {"wrap_angle"}
    assert "wrap_factor" in v_belt.lost({**answers, "wrap_factor": 0.73})


def _by_another_way(own: Mapping[str, float]) -> dict[str, float]:
    apart = own["stroke_required"] - own["rod_path_at_max"]
    losses = ("mechanism_efficiency", "screw_efficiency", "drive_efficiency")
    return {
        "velocity_ratio_range": (own["diameter_max"] - own["diameter_min"]) / 2 / apart,
        "total_efficiency": own["wedge_efficiency"] * math.prod(own.get(one, 1) for one in losses),
    }
