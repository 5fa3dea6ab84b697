"""Gradescope gets a test for each section, and nobody sees it before it is published."""

import json
from collections.abc import Callable
from dataclasses import replace

import pytest

from gripcourse.course.model import Course
from gripcourse.exports.platforms.comment import comment_lines
from gripcourse.exports.platforms.gradescope import gradescope_results
from gripcourse.exports.platforms.works import works_of
from gripcourse.exports.report_result import GradesResult
from gripcourse.grading.model import Flag, FlagCode
from gripcourse.text.words import Words, message

REFUSED = Flag(FlagCode.REJECTED, message("No workbook."))
Graded = Callable[..., GradesResult]


def test_the_tests_add_up_to_the_score(graded: Graded, course: Course) -> None:
    (report,) = graded({"s17.xlsx": "s17"}).reports
    plain = gradescope_results(report, course, Words("ru"), published=False)
    assert sum(one["score"] for one in plain["tests"]) == pytest.approx(report.score, abs=1e-3)
    most = sum(one["max_score"] for one in plain["tests"])
    assert report.max_score is not None
    assert most == pytest.approx(report.max_score + report.open_points, abs=1e-3)
    shown = {one["visibility"] for one in (plain, *plain["tests"])}
    assert shown <= {"after_published", "hidden"}
    assert json.loads(json.dumps(plain, allow_nan=False)) == plain


def test_lateness_costs_on_a_platform_what_it_costs_in_the_grades(
    graded: Graded, course: Course
) -> None:
    (report,) = graded({"s17.xlsx": "s17"}).reports
    assert report.score is not None
    late = replace(report, earned=report.score / 2, days_late=5)
    plain = gradescope_results(late, course, Words("ru"), published=False)
    assert plain["score"] == pytest.approx(report.score / 2, abs=1e-3)
    assert plain["output"].startswith("Сдано с опозданием (дней: 5), снято баллов:")
    earlier = replace(report, score=1.0, earned=1.0, counts=False)
    ((work,), notes) = works_of(GradesResult((earlier, late), needs_person=False), {})
    assert (work.points, notes) == (report.score / 2, ())
    assert "снято баллов" in list(comment_lines(work, course, Words("ru")))[1]


def test_what_is_published_is_seen_at_once(graded: Graded, course: Course) -> None:
    (report,) = graded({"s17.xlsx": "s17"}).reports
    plain = gradescope_results(report, course, Words("ru"), published=True)
    assert plain["visibility"] == "visible"


def test_what_was_not_judged_is_hidden(graded: Graded, course: Course) -> None:
    (report,) = graded({"s17.xlsx": "s17"}, judged=False, flags=(REFUSED,)).reports
    plain = gradescope_results(report, course, Words("ru"), published=True)
    assert (plain["visibility"], "tests" in plain) == ("hidden", False)
