"""A scale calls every share of the points something, and owns up to what still waits."""

from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from gripcourse.course.toml_table import Table
from gripcourse.policy.keys import POLICY
from gripcourse.policy.model import Policy
from gripcourse.policy.scales import (
    CountedPoints,
    Scale,
    ScaleStep,
    certain_grade,
    grade_text,
    read_scales,
)
from gripcourse.text.words import LANGUAGES, Texts, Words

if TYPE_CHECKING:
    from gripcourse.errors import Problem

ENGLISH = Words("en")


def plain(text: str) -> Texts:
    return Texts(dict.fromkeys(LANGUAGES, text))


LETTERS = Scale(
    "letters",
    plain("Letters"),
    tuple(ScaleStep(start, plain(text)) for start, text in ((90, "A"), (60, "B"), (0, "F"))),
)


@pytest.mark.parametrize(
    ("earned", "letter"), [(100, "A"), (90, "A"), (89.999, "B"), (60, "B"), (59.9, "F"), (0, "F")]
)
def test_a_step_begins_at_its_percentage(earned: float, letter: str) -> None:
    assert grade_text(LETTERS, CountedPoints(earned, 100, 0), ENGLISH) == letter


def test_the_edge_of_a_step_is_inside_whatever_the_last_bit_says() -> None:
    assert grade_text(LETTERS, CountedPoints(0.1 + 0.2 + 0.6, 1, 0), ENGLISH) == "A"
    assert grade_text(LETTERS, CountedPoints(3 * 0.3 - 1e-16, 1.0, 0), ENGLISH) == "A"


def test_where_waiting_points_decide_both_ends_are_named_and_no_cell_is_filled() -> None:
    open_ = CountedPoints(55, 100, 10)
    assert grade_text(LETTERS, open_, ENGLISH) == "F…B"
    assert certain_grade(LETTERS, open_, ENGLISH) == ""
    assert certain_grade(LETTERS, CountedPoints(65, 100, 10), ENGLISH) == "B"


def test_without_steps_it_is_the_percentage() -> None:
    percent = Scale("share", plain("Share"), ())
    assert grade_text(percent, CountedPoints(12.5, 100, 0), ENGLISH) == "12.5%"


def test_without_any_points_there_is_no_grade() -> None:
    assert grade_text(LETTERS, CountedPoints(0, 0, 0), ENGLISH) == ""


def test_the_reference_course_has_marks_and_letters(policy: Policy) -> None:
    assert [one.id for one in policy.scales] == ["mark", "ects"]
    assert [grade_text(one, CountedPoints(84, 100, 0), ENGLISH) for one in policy.scales] == [
        "4",
        "B",
    ]


def faults(*scales: dict[str, object]) -> list[str]:
    problems: list[Problem] = []
    table = Table({"scale": list(scales)}, str(Path("policy.toml")), "", problems, POLICY)
    read_scales(table, {"grip": 100.0})
    return [str(one.what) for one in problems]


TOP, REST = {"from": 50, "text": "yes"}, {"from": 0, "text": "no"}


@pytest.mark.parametrize(
    ("scale", "said"),
    [
        ({"id": "pass", "title": "Pass", "step": [TOP]}, "Below 50 percent the scale has no step."),
        ({"id": "pass", "title": "Pass", "step": [REST, REST]}, "Two steps begin at 0 percent."),
        ({"id": "grip", "title": "Pass"}, "'grip' is a column of the table of grades."),
        ({"id": "score", "title": "Pass"}, "'score' is a column of the table of grades."),
        ({"id": "Оценка", "title": "Pass"}, "'Оценка' is no id."),
        ({"id": "pass", "title": "Pass", "step": [{**TOP, "from": 101}, REST]}, "The number is"),
        ({"id": "pass", "title": "Pass", "stap": []}, "This key means nothing here."),
    ],
)
def test_what_is_no_scale_is_named(scale: dict[str, object], said: str) -> None:
    assert any(one.startswith(said) for one in faults(scale)), faults(scale)


def test_two_scales_have_different_ids() -> None:
    one = {"id": "pass", "title": "Pass", "step": [TOP, REST]}
    assert faults(one) == []
    assert set(faults(one, one)) == {"Two scales have the id 'pass'."}
