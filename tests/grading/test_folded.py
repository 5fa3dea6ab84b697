"""A folded report says what it said, in a fraction of the room."""

import json
import pickle
from dataclasses import replace
from pathlib import Path

import pytest

from gripcourse.course.model import Course
from gripcourse.exports.grades import FOUND
from gripcourse.exports.make_report_result import report_result
from gripcourse.exports.report_json import report_json, said_in
from gripcourse.gradebook.results import RESULTS
from gripcourse.grading.folded import (
    Derivation,
    Folded,
    ReportShelf,
    derived,
    digest_of_report,
    folded,
)
from gripcourse.grading.model import Report
from gripcourse.likeness.works import TYPED
from gripcourse.machine.shelf import Shelf
from gripcourse.policy.model import Policy
from gripcourse.simulation.cohort import make_classroom
from gripcourse.simulation.in_memory import judge_one
from gripcourse.simulation.mix import load_mix
from gripcourse.simulation.student import Classroom
from gripcourse.text.words import LANGUAGES, Words


@pytest.fixture(scope="module")
def room(course: Course, policy: Policy) -> Classroom:
    """Of one student."""
    return make_classroom(course, policy, load_mix(course), 1, 3, "rack_parallelogram")


@pytest.fixture(scope="module")
def report(room: Classroom) -> Report:
    """Of a work that was judged."""
    return judge_one(next(iter(room.behaviours)), room).report


def put(report: Report) -> Report:
    """The same from a shelf."""
    shelf = ReportShelf()
    return shelf.report(shelf.plain(report))


def test_nothing_is_lost_and_little_is_kept(report: Report) -> None:
    small = folded(report)
    assert isinstance(small.findings, Folded)
    assert small == report
    assert repr(small) == repr(report)
    assert len(small.findings) == len(report.findings)
    assert all(one in small.findings for one in tuple(report.findings)[:2])
    assert folded(small) is small
    assert pickle.loads(pickle.dumps(small)) == report  # noqa: S301 (ours)
    assert len(small.findings.packed) < 10_000
    shelf = ReportShelf()
    asked = (small, report, replace(small, file="another"))
    held = [shelf.report(shelf.plain(one)) for one in asked]
    assert held == [small, small, replace(small, file="another")]
    assert {digest_of_report(one) for one in held[:2]} == {digest_of_report(small)}
    assert digest_of_report(held[2]) != digest_of_report(small)
    # It lies there already: only what is beside the findings is put there once more.
    assert shelf.plain(held[0]) == shelf.plain(held[0])
    assert pickle.loads(pickle.dumps(held)) == held  # noqa: S301 (ours)
    assert len(pickle.dumps(held[0])) == len(pickle.dumps(small))


def test_without_room_for_a_file_findings_stay_in_memory(report: Report) -> None:
    with Path("/dev/full").open("r+b", buffering=0) as full:
        shelves = [ReportShelf(Shelf(file)) for file in (None, full)]
        assert [one.report(one.plain(report)) for one in shelves] == [report, report]


def test_what_will_be_wanted_of_findings_lies_beside_them(report: Report) -> None:
    asked: list[int] = []
    counted = Derivation("counted", lambda found: asked.append(len(found)) or f"{len(found)} found")
    small = folded(report, [counted])
    on_shelf = put(small)
    travelled = pickle.loads(pickle.dumps(on_shelf))  # noqa: S301 (ours)
    for one in (small, on_shelf, travelled):
        assert one == report
        assert derived(one.findings, counted) == f"{len(report.findings)} found"
    assert asked == [len(report.findings)]
    another = Derivation("another", len)
    assert derived(travelled.findings, another) == derived(report.findings, another)


def test_whatever_a_batch_asks_of_findings_is_the_same_whoever_derived_it(report: Report) -> None:
    wanted: tuple[Derivation[object], ...] = (RESULTS, TYPED, FOUND)
    small, plain = put(folded(report, wanted)), put(folded(report))
    for one in wanted:
        assert derived(small.findings, one) == derived(report.findings, one)
        assert derived(plain.findings, one) == derived(report.findings, one)


def test_a_report_is_the_same_line_of_json_whoever_said_its_findings(
    report: Report, course: Course, policy: Policy
) -> None:
    small = put(folded(report, [said_in(course.language)]))
    for language in LANGUAGES:
        words = Words(language)
        line = report_json(small, words, policy.scales)
        assert line == report_json(report, words, policy.scales)
        assert json.loads(line) == report_result(report, words, policy.scales).to_dict()
