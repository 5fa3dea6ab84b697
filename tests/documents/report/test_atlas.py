"""The papers' curves and cases come out of the course's own formulas."""

import math

import numpy as np
import pytest

from gripcourse.course.atlas import Atlas, AtlasRow, load_atlas
from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.documents.report.atlas import atlas_pdf, case_values, curve_values, plates
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
    return load_atlas(the_course.root, "lever-arms", the_course.schemes)


@pytest.fixture(scope="module")
def lever_plan(the_course: Course, atlas: Atlas) -> Plan:
    return make_plan(the_course, atlas.scheme, default_options(the_course.schemes[atlas.scheme]))


def test_a_scheme_that_the_course_does_not_have_is_named(the_course: Course) -> None:
    with pytest.raises(CourseError, match=r"lever_arms\.toml: scheme: The course has no scheme"):
        load_atlas(the_course.root, "lever-arms", ["another_scheme"])


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
