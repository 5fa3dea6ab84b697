"""Works are compared by another process while this one keeps them; what comes of it is the same."""

from collections.abc import Callable, Iterator
from dataclasses import replace

import pytest

from gripcourse.batch import comparing as module
from gripcourse.batch.comparing import Comparing, comparing_apart
from gripcourse.batch.context import GradingContext
from gripcourse.batch.graded import Graded, reports_of, with_reports
from gripcourse.grading.model import Flag, FlagCode, Report
from gripcourse.grading.unjudged import unknown_student_report
from gripcourse.machine.jobs.lost import Lost
from gripcourse.machine.jobs.pools import FORKED
from gripcourse.machine.jobs.standing import StandingWorkers
from gripcourse.text.words import message

STUDENTS = ("s01", "s02", "s03", "s04")
SAID_BEFORE = Flag(FlagCode.SEVERAL_FILES, message("The student handed in more files."))
SAID_SINCE = Flag(FlagCode.TIME_DOUBTFUL, message("The time is doubtful."))


def work(student: str) -> Graded:
    """A judged work of which only the author says anything: two of four have the same one."""
    creator = "Petrov" if student in {"s01", "s03"} else ""
    blank = unknown_student_report(f"{student}.xlsx", student, student)
    flags = (SAID_BEFORE,)
    judged = replace(blank, student=student, judged=True, creator=creator, flags=flags)
    return Graded(judged, "")


@pytest.fixture
def comparing(context: GradingContext, monkeypatch: pytest.MonkeyPatch) -> Iterator[Comparing]:
    """A batch of few works, which are worth a process here."""
    monkeypatch.setattr(module, "_WORTH", len(STUDENTS))
    with comparing_apart(context, None) as found:
        yield found


def begun(comparing: Comparing) -> list[Graded]:
    """The works of the batch, which are being compared from now on."""
    assert not list(comparing.prepared(len(STUDENTS), workers=2))
    batch = comparing.batch.filled(len(STUDENTS), enumerate(map(work, STUDENTS)))
    comparing.begin(batch)
    return list(batch)


def codes(report: Report) -> list[str]:
    return [flag.code for flag in report.flags]


@pytest.mark.skipif(not FORKED, reason="another process has no part in this one's shelf")
def test_another_process_comes_to_what_this_one_would_come_to(
    comparing: Comparing, context: GradingContext, monkeypatch: pytest.MonkeyPatch
) -> None:
    here = Comparing(context)
    batch = begun(comparing)
    here.begin(batch)
    as_here = list(here.entered(batch))
    monkeypatch.setattr(module, "like_others", None)  # nobody looks for likeness here any more
    assert list(comparing.entered(batch)) == as_here
    assert [codes(one.report) for one in as_here] == [
        ["several_files", "same_creator"],
        ["several_files"],
        ["several_files", "same_creator"],
        ["several_files"],
    ]


def test_what_is_said_of_works_meanwhile_stands_after_what_they_have_in_common(
    comparing: Comparing,
) -> None:
    batch = begun(comparing)
    first = batch[0].report
    since = with_reports(batch, [(0, replace(first, flags=(*first.flags, SAID_SINCE)))])
    found = reports_of(comparing.entered(since))
    assert codes(found[0]) == ["several_files", "same_creator", "time_doubtful"]
    assert codes(found[2]) == ["several_files", "same_creator"]


def killed(*_: object) -> Lost:
    return Lost("killed")


def no_room(*_: object) -> None:
    raise OSError


def no_answer(*_: object) -> None:
    raise EOFError


@pytest.mark.parametrize("does", [killed, no_room, no_answer])
def test_where_the_other_process_comes_to_nothing_all_is_compared_here(
    comparing: Comparing, monkeypatch: pytest.MonkeyPatch, does: Callable[..., Lost | None]
) -> None:
    monkeypatch.setattr(StandingWorkers, "do", does)
    batch = begun(comparing)
    found = comparing.entered(batch)
    assert codes(found[0].report) == ["several_files", "same_creator"]
    assert not any(one.incident for one in found)


@pytest.mark.parametrize(("works", "workers"), [(4, 1), (4, 0), (3, 2)])
def test_few_works_and_a_single_worker_are_worth_no_other_process(
    comparing: Comparing, monkeypatch: pytest.MonkeyPatch, works: int, workers: int
) -> None:
    monkeypatch.setattr(module, "StandingWorkers", None)
    assert not list(comparing.prepared(works, workers))
