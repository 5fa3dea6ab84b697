"""Mistakes that have a name of their own, each with the number that it makes by hand."""

from collections.abc import Callable
from math import cos, radians, sin
from typing import TYPE_CHECKING

import pytest

from gripcourse.grading.model import Finding
from gripcourse.text.words import LANGUAGES, Words

if TYPE_CHECKING:
    from conftest import Case, Typed


@pytest.fixture
def asking(table: tuple["Case", ...]) -> Callable[..., "Case"]:
    """Find the first issued variant whose sheet asks all of these, of a scheme where one counts."""

    def find(*names: str, scheme: str = "") -> "Case":
        ours = (one for one in table if scheme in {"", one.plan.scheme.id})
        return next(one for one in ours if set(names) <= one.answers.keys())

    return find


def finding(case: "Case", name: str, value: float) -> Finding:
    return case.findings({**case.answers, name: float(f"{value:.6g}")})[name]


def test_a_half_angle_that_is_halved_again(asking: Callable[..., "Case"]) -> None:
    case = asking("jaw_chord_min")
    wrong = case.given["diameter_max"] * cos(radians(case.given["jaw_angle"] / 2))
    assert str(finding(case, "jaw_chord_min", wrong).slip) == "halved_angle:jaw_angle"


def test_a_speed_of_the_jaws_without_the_travel_that_frees_the_object(
    asking: Callable[..., "Case"],
) -> None:
    case = asking("jaw_speed", "jaw_travel", scheme="wedge_slide")
    way = case.reference["jaw_travel"] - case.given["release_travel"]
    wrong = way / case.given["closing_time"]
    assert str(finding(case, "jaw_speed", wrong).slip) == "release_left_out"


def test_tonnes_force_for_kilonewtons(asking: Callable[..., "Case"]) -> None:
    """A tonne-force is 9.80665 kN."""
    case = asking("mount_axial")
    wrong = case.reference["mount_axial"] / 9.80665
    assert str(finding(case, "mount_axial", wrong).slip) == "unit:tf"


def test_both_tangents_taken_as_sines(asking: Callable[..., "Case"]) -> None:
    case = asking("stroke_required", "slot_angle_open", scheme="slot_lever")
    ends = (case.reference["slot_angle_at_min"], case.reference["slot_angle_open"])
    wrong = case.reference["slot_offset"] * (sin(radians(ends[0])) - sin(radians(ends[1])))
    assert str(finding(case, "stroke_required", wrong).slip) == "wrong_function:all,sin"


def test_a_cosine_that_counts_as_one_is_said_in_one_sentence(
    table: tuple["Case", ...], typed: "Typed"
) -> None:
    """Left out, or of an angle in radians: cos(0.44°) is 0.99997, in four figures 1."""
    case = next(one for one in table if one.issued.variant.id == "047")
    load, elevation = case.reference["load"], case.given["load_elevation"]
    wrong = load * cos(radians(elevation))
    assert wrong * cos(radians(radians(case.given["load_angle"]))) == pytest.approx(wrong, 5e-5)
    found = case.findings({**case.answers, "load_axial": typed("load_axial", wrong, 4)})
    said = {one: Words(one).say(found["load_axial"].message) for one in LANGUAGES}
    assert said["en"] == (
        "A known slip: cos(α_Q) counts as 1 in this number. It was left out, or the angle was "
        "typed in radians while the calculator was set to degrees."
    )
    assert "cos(α_Q) в этом числе равен 1" in said["ru"]
    assert "cos(α_Q) у цьому числі дорівнює 1" in said["uk"]
