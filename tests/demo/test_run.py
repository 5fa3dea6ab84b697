"""The demo is the whole main job: everybody gets what the script says."""

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from gripcourse.cli.grading_text import demo_text
from gripcourse.demo.run import MARKED_STORY, Demo, run_demo
from gripcourse.demo.students import COPIED
from gripcourse.grading.model import Outcome, Report
from gripcourse.machine.resources import course_root
from gripcourse.text.words import Words


@pytest.fixture(scope="session")
def demo(tmp_path_factory: pytest.TempPathFactory) -> Demo:
    """The real thing, once: a dozen assignments, eight workbooks, eight reports (half a minute)."""
    out = tmp_path_factory.mktemp("demo")
    steps: list[object] = []

    def step(name: object, _total: int) -> Callable[[], None]:
        steps.append(name)
        return lambda: None

    done = run_demo(course_root(), out, Words("en"), 0, step)
    assert len(steps) == 3
    return done


@pytest.fixture(scope="session")
def by_story(demo: Demo) -> dict[str, Report]:
    """The report of each scripted student, by what was scripted."""
    reports = {Path(one.file).stem: one for one in demo.outcome.reports}
    return {story: reports[student] for student, story in demo.students.items()}


def lost(report: Report) -> set[str]:
    """The quantities that do not earn all their points."""
    return {
        one.quantity
        for one in report.findings
        if one.outcome is not Outcome.MANUAL and one.points < one.max_points - 1e-9
    }


@pytest.mark.parametrize("story", ["correct", "three_figures", "as_printed"])
def test_who_computes_soundly_gets_everything(by_story: dict[str, Report], story: str) -> None:
    report = by_story[story]
    assert report.score == pytest.approx(report.max_score)
    # Also of the first student, whose file somebody else hands in too.
    assert report.flags == ()


def test_an_early_slip_costs_one_item(by_story: dict[str, Report]) -> None:
    (item,) = lost(by_story["early_slip"])
    assert item


def test_the_drawing_of_one_student_is_marked_by_a_person(
    demo: Demo, by_story: dict[str, Report]
) -> None:
    decided = {
        story: [one.quantity for one in report.findings if one.decision is not None]
        for story, report in by_story.items()
    }
    assert demo.marking is not None
    (item,) = demo.marking.items
    assert {story: names for story, names in decided.items() if names} == {
        MARKED_STORY: [item.mark.quantity]
    }
    assert len(item.mark.lines) > 1
    report = by_story[MARKED_STORY]
    drawing = next(one for one in report.findings if one.quantity == item.mark.quantity)
    assert drawing.points == item.points
    assert 0 < drawing.points < drawing.max_points


def test_a_blank_workbook_gets_nothing_and_no_flag(by_story: dict[str, Report]) -> None:
    assert by_story["blank"].score == 0
    assert by_story["blank"].judged
    assert by_story["blank"].flags == ()


def test_numbers_with_units_count_and_what_is_no_number_costs_itself(
    by_story: dict[str, Report],
) -> None:
    unread = {
        one.quantity
        for one in by_story["text_and_units"].findings
        if one.outcome is Outcome.UNREADABLE
    }
    assert len(unread) == 2
    assert lost(by_story["text_and_units"]) == unread


def test_sizes_rounded_down_cost_themselves(by_story: dict[str, Report]) -> None:
    assert 1 <= len(lost(by_story["rounded_down"])) <= 3


def test_a_copied_workbook_waits_for_a_person(by_story: dict[str, Report]) -> None:
    report = by_story[COPIED]
    assert [flag.code for flag in report.flags] == ["who_handed_in", "same_bytes"]
    assert not report.judged


def test_everything_that_is_promised_is_there(demo: Demo) -> None:
    students = set(demo.students)
    copied = {student for student, story in demo.students.items() if story == COPIED}
    assert {path.stem for path in (demo.graded / "reports").iterdir()} == students - copied
    assert {path.name for path in demo.graded.iterdir()} == {
        "reports",
        "cohort.pdf",
        "files.csv",
        "grades.csv",
        "grades.json",
    }
    folders = {path.name for path in demo.assignments.iterdir()}
    assert students < folders
    assert len(folders) == 12
    assert all(len(list((demo.assignments / one).iterdir())) == 2 for one in folders)
    assert (demo.course / "private" / "gradebook.sqlite").exists()
    assert all(path.stat().st_size > 10_000 for path in demo.graded.rglob("*.pdf"))


def test_nothing_failed_on_our_side(demo: Demo) -> None:
    assert not (demo.graded / "incidents.log").exists()
    assert [one for one in demo.issuing.handouts if one.faults] == []


def test_the_grades_are_those_of_the_reports(demo: Demo) -> None:
    files = json.loads((demo.graded / "grades.json").read_text(encoding="utf-8"))
    written = {one["student"]: one["score"] for one in files["reports"]}
    judged = {one.student: one.score for one in demo.outcome.reports if one.judged}
    assert written == {**judged, "": None}


@pytest.mark.parametrize("language", ["en", "ru", "uk"])
def test_the_summary_names_everybody_and_every_place(demo: Demo, language: str) -> None:
    shown = demo_text(replace(demo), Words(language))
    assert all(student in shown for student in demo.students)
    places = (demo.course, demo.assignments, demo.submissions, demo.graded)
    assert all(str(place) in shown for place in places)


def test_the_reference_course_itself_is_untouched(demo: Demo) -> None:
    assert demo.course != course_root()
    assert not (Path(__file__).parents[2] / "private").exists()
