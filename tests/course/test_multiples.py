"""A choice among the multiples of a number: its series is made from the declaration."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gripcourse.course.load import load_course
from gripcourse.course.multiples import between
from gripcourse.errors import CourseError
from gripcourse.solver.plan import make_plan
from gripcourse.solver.solve import evaluate, to_si
from gripcourse.text.units import factor
from gripcourse.text.words import Words
from gripcourse.usecases.authoring.init import empty_course

PART = "variants/sections/tension.toml"


@given(
    step=st.sampled_from([0.05, 0.1, 0.25, 1.0, 2.0, 5.0, 10.0]),
    low=st.integers(-400, 400),
    count=st.integers(1, 400),
    unit=st.sampled_from(["", "mm", "kN"]),
)
def test_the_series_is_every_multiple_between_the_bounds_and_both_of_them(
    step: float, low: int, count: int, unit: str
) -> None:
    ends = (round(low * step, 6), round((low + count - 1) * step, 6))
    found = between(step, unit, ends)
    assert np.allclose(
        np.array(found.sizes) / factor(unit), step * np.arange(low, low + count), atol=1e-9
    )


def test_bounds_that_are_no_multiples_are_outside() -> None:
    assert between(10, "", (84, 126)).sizes == [90, 100, 110, 120]
    found = between(10, "", (91, 99))
    assert found.sizes == []


@pytest.mark.parametrize(
    ("step", "unit", "language", "title"),
    [
        (1, "", "en", "whole numbers"),
        (1, "", "uk", "цілі числа"),
        (10, "mm", "en", "multiples of 10 mm"),
        (0.5, "mm", "ru", "числа, кратные 0,5 мм"),
        (5, "", "uk", "числа, кратні 5"),
    ],
)
def test_students_are_told_what_the_series_is(
    step: float, unit: str, language: str, title: str
) -> None:
    assert between(step, unit, (0, 100)).title.of(language).replace("\u00a0", " ") == title


def rounded(tmp_path: Path, rule: str) -> Path:
    """Make the small course, its diameter chosen by another rule."""
    root = tmp_path / "course"
    empty_course(root, bytes(32), Words("en"))
    part = root / PART
    written = part.read_text(encoding="utf-8")
    assert 'series = "rod.size"' in written
    part.write_text(written.replace('series = "rod.size"', rule), encoding="utf-8")
    return root


def test_a_multiple_is_chosen_as_from_a_catalogue(tmp_path: Path) -> None:
    course = load_course(rounded(tmp_path, "multiple_of = 5"))
    (choice,) = (
        one.choice for one in course.parts["tension"].quantities.values() if one.choice is not None
    )
    catalogue = course.catalogues[choice.column.partition(".")[0]]
    assert catalogue.columns["size"][:3] == pytest.approx([0.005, 0.010, 0.015])
    assert len(catalogue.columns["size"]) == 200  # up to the bound of 1000 mm


def test_both_ways_round_a_required_size_to_the_same(tmp_path: Path) -> None:
    course = load_course(rounded(tmp_path, "multiple_of = 5"))
    example = course.schemes["rod"].example
    assert example is not None
    plan = make_plan(course, "rod", {})
    values = evaluate(plan, to_si(plan, example.given)).values
    # 19.757 mm are required
    assert float(values["diameter"]) == pytest.approx(0.020, rel=1e-12)


@pytest.mark.parametrize(
    ("rule", "said"),
    [
        ("multiple_of = 0", "Nothing is a multiple of 0."),
        ("multiple_of = -5", "Nothing is a multiple of"),
        ("multiple_of = 0.001", "999001 multiples"),
        ("multiple_of = 5000", "has 0 multiples"),
        ('multiple_of = 5\nseries = "rod.size"', "not both"),
        ('multiple_of = "5"', "wrong type"),
    ],
)
def test_what_gives_no_sizes_is_one_problem_of_its_key(
    tmp_path: Path, rule: str, said: str
) -> None:
    with pytest.raises(CourseError) as caught:
        load_course(rounded(tmp_path, rule))
    (problem,) = caught.value.problems
    assert (problem.file, str(problem.key)) == (PART, "quantity.diameter.multiple_of")
    assert said in str(problem.what)
    assert str(problem.remedy)
