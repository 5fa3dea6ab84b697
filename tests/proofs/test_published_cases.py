"""Published cases: read with every fault at its key; a course may have none."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from gripcourse.course.model import Course
from gripcourse.errors import CourseError
from gripcourse.proofs.published_cases import FILE, load_published_cases, read_published_cases

CASE = """
[[case]]
id = "fabco"
scheme = "rack_parallelogram"
source = { work = "fabco" }
options = { drive = "pneumatic" }
given = { mass = 0.6 }
expected = { grip_force = [76.4, 0.05] }
"""


def test_a_course_without_published_cases_has_none(course: Course, tmp_path: Path) -> None:
    assert load_published_cases(replace(course, root=tmp_path)) == ()


def test_what_a_case_does_not_say_is_the_worked_examples(
    with_file: Callable[[str, str], Course],
) -> None:
    [case] = load_published_cases(with_file(FILE, CASE))
    assert case.options["drive"] == "pneumatic"
    assert case.options["mounting"] == "flange"
    assert case.given["mass"] == 0.6
    assert case.given["friction"] == 0.15
    assert case.expected == {"grip_force": (76.4, 0.05)}


@pytest.mark.parametrize(
    ("old", "new", "key", "what"),
    [
        ('"rack_parallelogram"', '"rack"', "case[1].scheme", "no scheme 'rack'"),
        ('work = "fabco"', 'work = "fabko"', "case[1].source.work", "cites no work 'fabko'"),
        ('"pneumatic"', '"steam"', "case[1].options.drive", "no choice 'steam'"),
        ("{ drive", "{ drives", "case[1].options.drives", "no option 'drives'"),
        ("mass = 0.6", "maas = 0.6", "case[1].given.maas", "no given 'maas'"),
        ("{ grip_force", "{ grip_farce", "case[1].expected.grip_farce", "computes no 'grip_farce'"),
        ("[76.4, 0.05]", "76.4", "case[1].expected.grip_force", "wrong type"),
        ("given =", "givens =", "case[1].givens", "means nothing here"),
    ],
)
def test_a_fault_of_a_case_is_one_problem_with_its_key(
    with_file: Callable[[str, str], Course], old: str, new: str, key: str, what: str
) -> None:
    assert old in CASE
    cases, [problem] = read_published_cases(with_file(FILE, CASE.replace(old, new)))
    assert (problem.file, problem.key) == ("variants/published_cases.toml", key)
    assert what in str(problem.what)
    assert str(problem.remedy)
    assert cases == ()


def test_two_cases_of_one_name_are_refused(with_file: Callable[[str, str], Course]) -> None:
    with pytest.raises(CourseError, match="Two cases are named 'fabco'"):
        load_published_cases(with_file(FILE, CASE * 2))
