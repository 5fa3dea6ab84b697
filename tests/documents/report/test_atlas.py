"""The papers' curves and cases come out of the course's own formulas."""

import math
import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from gripcourse.course.atlas import Atlas, AtlasRow
from gripcourse.course.check_atlas import load_atlas
from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.documents.report.atlas import (
    atlas_pdf,
    atlas_values,
    case_values,
    curve_values,
    plates,
)
from gripcourse.errors import CourseError
from gripcourse.machine.resources import course_root
from gripcourse.solver.plan import Plan, default_options, make_plan
from gripcourse.text.words import Words
from support.pages import not_laid_out


@pytest.fixture(scope="module")
def the_course() -> Course:
    return load_course(course_root())


@pytest.fixture(scope="module")
def atlas(the_course: Course) -> Atlas:
    return load_atlas(the_course, "lever-arms")


@pytest.fixture(scope="module")
def lever_plan(the_course: Course, atlas: Atlas) -> Plan:
    return make_plan(the_course, atlas.scheme, default_options(the_course.schemes[atlas.scheme]))


def test_a_scheme_that_the_course_does_not_have_is_named(the_course: Course) -> None:
    schemes = {name: one for name, one in the_course.schemes.items() if name != "prism_lever"}
    only = replace(the_course, schemes=schemes)
    with pytest.raises(CourseError, match=r"lever_arms\.toml: scheme: The name 'prism_lever' is"):
        load_atlas(only, "lever-arms")


@pytest.fixture
def copied(the_course: Course, tmp_path: Path) -> Callable[[str, str], Course]:
    """Return what makes a course whose atlas says something else."""

    def changed(old: str, new: str) -> Course:
        file = Path("variants/atlas/lever_arms.toml")
        text = (the_course.root / file).read_text(encoding="utf-8")
        assert old in text
        (tmp_path / file).parent.mkdir(parents=True)
        (tmp_path / file).write_text(text.replace(old, new, 1), encoding="utf-8")
        return replace(the_course, root=tmp_path)

    return changed


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ('work = "arms_paper"', 'work = "arm_paper"', "work: The name 'arm_paper' is not known"),
        ('against = "lever_length"', 'against = "len"', r"figure\[1\]\.against: The name 'len'"),
        ('"arm_far_at_max"', '"arm_far_atmax"', r"curves\[1\]\.quantity: The name 'arm_far_atmax'"),
        ("at = { diameter_max", "at = { diameter", r"at\.diameter: The name 'diameter'"),
        ("prism_angle/2 - at", "tilted/2 - at", r"row\[2\]\.size\.inclination: The name 'tilted'"),
        ("tilt = 0 }", "tile = 0 }", r"row\[1\]\.example\.tile: .* Did you mean 'tilt'"),
    ],
)  # fmt: skip
def test_a_name_that_means_nothing_in_an_atlas_is_told(
    copied: Callable[[str, str], Course], old: str, new: str, told: str
) -> None:
    with pytest.raises(CourseError, match=rf"lever_arms\.toml: .*{told}"):
        load_atlas(copied(old, new), "lever-arms")


def test_an_atlas_is_written_in_the_languages_of_its_course(
    copied: Callable[[str, str], Course],
) -> None:
    course = copied('ru = "Плечи сил зажимных рычагов", ', "")
    with pytest.raises(CourseError, match=r"title\.ru: The text in this language is missing"):
        load_atlas(course, "lever-arms")
    without_russian = replace(course, languages=("en", "uk"))
    assert load_atlas(without_russian, "lever-arms").title.of("en") == (
        "Arms of the forces of clamping levers"
    )


def ordinate(atlas: Atlas, plan: Plan, figure: int, curve: int, abscissa: float) -> float:
    example = plan.scheme.example
    assert example is not None
    known = {name: value for name, value in example.given.items() if name in plan.quantities}
    chosen = next(one for one in atlas.figures if one.number == figure)
    along, curves = curve_values(chosen, plan, known)
    return float(np.interp(abscissa, along, curves[curve]))


# Points of the papers' equations 1 to 8, computed apart by vector geometry.
@pytest.mark.parametrize(
    ("figure", "curve", "abscissa", "value"),
    [
        (2, 1, 100, 88.15),
        (2, 2, 100, 76.60),
        (2, 3, 100, 82.42),
        (2, 4, 100, 93.97),
        (2, 5, 100, 105.47),
        (2, 6, 100, 65.10),
        (2, 7, 100, 70.00),
        (2, 9, 100, 66.60),
        (2, 10, 100, 93.92),
        (2, 11, 100, 76.65),
        (3, 1, 40, 88.15),
        (3, 8, 40, 70.00),
        (4, 5, 120, 93.92),
        (5, 5, 30, 70.00),
        (5, 6, 30, 39.28),
    ],
)
def test_a_curve_goes_through_the_points_of_the_paper(
    atlas: Atlas, lever_plan: Plan, figure: int, curve: int, abscissa: float, value: float
) -> None:
    assert ordinate(atlas, lever_plan, figure, curve, abscissa) == pytest.approx(value, abs=0.006)


def test_the_shift_does_not_depend_on_the_length_of_the_lever(
    atlas: Atlas, lever_plan: Plan
) -> None:
    short, long = (ordinate(atlas, lever_plan, 2, 8, length) for length in (50, 130))
    assert short == pytest.approx(long)


@pytest.mark.parametrize("number", range(1, 8))
def test_a_case_is_the_general_formula_without_signs(
    atlas: Atlas, lever_plan: Plan, number: int
) -> None:
    row: AtlasRow = next(one for one in atlas.rows if one.number == number)
    found = case_values(row, atlas, lever_plan)
    inclination, diameter = found["inclination"], found["diameter"]
    values = row.example
    prism, attached = (math.radians(values[n]) for n in ("prism_angle", "attachment_angle"))
    larger, smaller = number in {4, 5}, number in {6, 7}
    tilt = math.radians(values["tilt"]) * (larger - smaller)
    signed = math.pi / 2 + tilt - prism / 2 - attached
    apex = values["pivot_half_distance"] + values["lever_length"] * math.sin(signed)
    assert inclination == pytest.approx(abs(signed), abs=1e-12)
    assert diameter * 1000 == pytest.approx(2 * apex * math.sin(prism / 2) / math.cos(tilt))


def test_the_atlas_is_the_same_every_time(atlas: Atlas, the_course: Course) -> None:
    words = Words("en")
    drawn = plates(atlas, the_course, words)
    assert [one.number for one in drawn] == [2, 3, 4, 5]
    again = plates(atlas, the_course, words)
    assert [one.svg() for one in drawn] == [one.svg() for one in again]
    with not_laid_out():
        made = [atlas_pdf(atlas, one, the_course, words) for one in (drawn, again)]
    assert made[0] == made[1]


def test_a_legend_shows_the_subscripts_of_its_symbols(atlas: Atlas, the_course: Course) -> None:
    for plate in plates(atlas, the_course, Words("uk")):
        lines = re.findall(r"<text[^>]*>(\d+ — .*?)</text>", plate.svg())
        assert lines
        for line in lines:
            assert "_" not in line
            assert re.search(r' — l<tspan dy="1.6"[^>]*>\d+</tspan><tspan dy="-1.6">', line), line


def test_an_example_tells_every_number_that_its_formulas_take(
    atlas: Atlas, the_course: Course
) -> None:
    cases = atlas_values(atlas, (), the_course, Words("en"))["cases"]
    assert isinstance(cases, list)
    fourth = {symbol: value.replace("\u00a0", " ") for symbol, value in cases[3].known}
    assert fourth == {"a_E": "40 mm", "L_l": "100 mm", "α": "120°", "γ": "20°", "e": "5°"}
    assert dict(cases[3].found)["w"] == "15°"
    assert "L_l" not in dict(cases[0].known)
