"""Mistakes that have a name of their own, each with the number that it makes by hand."""

from collections.abc import Callable
from math import cos, radians, sin, tan
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


def test_the_whole_angle_for_its_half(asking: Callable[..., "Case"]) -> None:
    case = asking("face_force", "jaw_chord_min")
    wrong = case.reference["grip_force"] / (2 * sin(radians(2 * case.given["jaw_angle"])))
    found = finding(case, "face_force", wrong)
    assert str(found.slip) == "doubled_angle:jaw_angle"
    said = {one: Words(one).say(found.message) for one in LANGUAGES}
    assert "twice as large" in said["en"]
    assert "вдвое больше" in said["ru"]
    assert "вдвічі більшим" in said["uk"]


def test_the_whole_angle_of_a_wedge(asking: Callable[..., "Case"]) -> None:
    case = asking("stroke_required", scheme="wedge_slide")
    wrong = case.reference["jaw_travel"] / tan(radians(2 * case.given["wedge_angle"]))
    assert str(finding(case, "stroke_required", wrong).slip) == "doubled_angle:wedge_angle"


def test_a_speed_of_a_worms_jaws_without_the_travel_that_frees_the_object(
    asking: Callable[..., "Case"],
) -> None:
    case = asking("jaw_speed", scheme="worm_sector")
    seconds = case.given["closing_time"]
    mean = (case.given["diameter_max"] - case.given["diameter_min"]) / 2 / seconds
    assert str(finding(case, "jaw_speed", mean).slip) == "release_left_out"
    swing = case.reference["grip_arm_tilt_at_max"] - case.reference["grip_arm_tilt_at_min"]
    worm = radians(swing) * case.given["sector_teeth"] / case.given["worm_starts"]
    fastest = case.reference["velocity_ratio"] * worm / seconds
    assert str(finding(case, "jaw_speed", fastest).slip) == "turns_from_the_largest_object"


def test_a_ratio_upside_down_at_both_ends_costs_once(asking: Callable[..., "Case"]) -> None:
    """F/P for P/F, of a mechanism whose course declares no such mistake."""
    case = asking("force_ratio_at_max", "force_ratio_at_min", scheme="plain_lever")
    ends = ("force_ratio_at_max", "force_ratio_at_min")
    turned = {name: float(f"{1 / case.reference[name]:.6g}") for name in ends}
    answers = case.following(**turned)
    found = case.findings(answers)[ends[0]]
    assert str(found.slip) == "upside_down:force_ratio_at_max"
    assert "the other way round" in Words("en").say(found.message)
    assert case.lost(answers) == {ends[0]}


def test_the_accepted_bore_for_the_first_one(table: tuple["Case", ...]) -> None:
    """The bore with the reserve stands above the question, though it is not needed for it."""
    case = next(
        one
        for one in table
        if {"grip_force_first", "bore_without_rod"} <= one.answers.keys()
        and one.issued.variant.options["drive"] == "hydraulic"
        and one.reference["bore"] > one.reference["bore_first"]
    )
    rod, first, bore = (case.reference[one] for one in ("rod", "bore_first", "bore"))
    wrong = case.reference["grip_force_first"] * (bore**2 - rod**2) / (first**2 - rod**2)
    assert str(finding(case, "grip_force_first", wrong).slip) == "wrong_end:bore_first,bore"


def test_a_band_of_contact_in_millimetres(asking: Callable[..., "Case"]) -> None:
    case = asking("contact_band")
    wrong = case.reference["contact_band"] / 1000
    assert str(finding(case, "contact_band", wrong).slip) == "unit:mm"


def test_of_a_power_of_ten_no_input_is_blamed_where_several_would_do(
    asking: Callable[..., "Case"],
) -> None:
    """Friction of 29 for 0.29, or K in hundredths: F is a hundredth of what it should be."""
    case = asking("grip_force", scheme="worm_sector")
    found = finding(case, "grip_force", case.reference["grip_force"] / 100)
    assert str(found.slip) == "power_of_ten:0.01"
    assert not found.tied


def test_a_single_digit_is_no_rounding_of_what_is_half_as_much(
    table: tuple["Case", ...], typed: "Typed"
) -> None:
    """540 mm are 0.54 m; who types 1 has not written metres."""
    case, name = next(
        (one, name)
        for one in table
        for name in ("overall_width", "overall_length", "frame_length")
        if 550 < one.reference.get(name, 0.0) < 900
    )
    alone = case.findings({**case.answers, name: typed(name, 1.0, 1)})[name]
    assert alone.slip is None
    written = typed(name, case.reference[name] / 1000, 3)
    assert str(case.findings({**case.answers, name: written})[name].slip) == "unit:m"
