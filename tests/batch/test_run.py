"""A batch is graded as a whole, whatever single files do to the process that reads them."""

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from types import ModuleType

import pytest

from gripcourse.batch.context import GradingContext
from gripcourse.batch.graded import Graded
from gripcourse.batch.run import grade_files

Inbox = Callable[..., list[Path]]

ALL_GOOD = {f"s0{number}": "good" for number in range(1, 9)}


def graded_by_name(files: Sequence[Path], graded: Sequence[Graded]) -> Mapping[str, Graded]:
    return {file.stem: one for file, one in zip(files, graded, strict=True)}


def test_the_result_is_in_the_order_of_the_files(
    context: GradingContext, fake: ModuleType, inbox: Inbox
) -> None:
    files = inbox(**{**ALL_GOOD, "s01": "slow", "s02": "slow"})
    done: list[Path] = []
    graded = grade_files(files, context, 2, done.append, grade_one=fake.obey)
    assert [one.report.file for one in graded] == [str(file) for file in files]
    assert [one.report.student for one in graded] == list(ALL_GOOD)
    assert sorted(done) == sorted(files)
    assert all(one.report.judged and not one.incident for one in graded)


def test_a_file_that_kills_its_worker_is_set_aside_alone(
    context: GradingContext, fake: ModuleType, inbox: Inbox
) -> None:
    files = inbox(**{**ALL_GOOD, "s03": "die"})
    graded = graded_by_name(files, grade_files(files, context, 2, grade_one=fake.obey))
    killer = graded.pop("s03")
    assert [flag.code for flag in killer.report.flags] == ["incident"]
    assert killer.report.student == "s03"
    assert not killer.report.judged
    assert "died" in killer.incident
    assert all(one.report.judged and not one.report.flags for one in graded.values())


def test_so_are_several_of_them_with_one_worker(
    context: GradingContext, fake: ModuleType, inbox: Inbox
) -> None:
    files = inbox(s01="die", s02="good", s03="die", s04="good", s05="good", s06="good")
    graded = graded_by_name(files, grade_files(files, context, 1, grade_one=fake.obey))
    assert {name for name, one in graded.items() if one.incident} == {"s01", "s03"}
    assert {name for name, one in graded.items() if one.report.judged} == {
        "s02",
        "s04",
        "s05",
        "s06",
    }


def test_a_file_that_was_only_taken_along_is_graded_after_all(
    context: GradingContext, fake: ModuleType, inbox: Inbox
) -> None:
    files = inbox(s01="die-once", s02="good")
    graded = grade_files(files, context, 2, grade_one=fake.obey)
    assert [one.report.judged for one in graded] == [True, True]


@pytest.mark.parametrize(("order", "workers"), [("raise", 1), ("exhaust", 1), ("raise", 0)])
def test_our_failure_is_an_incident_with_a_number_and_never_a_zero(
    context: GradingContext, fake: ModuleType, inbox: Inbox, order: str, workers: int
) -> None:
    files = inbox(s01=order, s02="good")
    failed, good = grade_files(files, context, workers, grade_one=fake.obey)
    assert good.report.judged
    assert not failed.report.judged
    assert failed.report.max_score == 0
    assert failed.report.student == "s01"
    number = str(failed.report.flags[0].message.values["number"])
    assert failed.incident.startswith(f"incident {number}: Traceback")
    assert (fake.REFUSED in failed.incident) == (order == "raise")


def test_a_file_that_hangs_is_stopped(
    context: GradingContext, fake: ModuleType, inbox: Inbox
) -> None:
    files = inbox(s01="hang", s02="good")
    hung, good = grade_files(files, context, 1, grade_one=fake.obey, seconds=2)
    assert good.report.judged
    assert [flag.code for flag in hung.report.flags] == ["incident"]
    assert "TookTooLong" in hung.incident


def test_several_files_of_a_student_and_equal_bytes_are_flagged(
    context: GradingContext, fake: ModuleType, inbox: Inbox
) -> None:
    again = {"s03/answers": "good xyz"}
    files = inbox(s01="good abc", s02="good abc", s03="good def", **again)
    graded = graded_by_name(files, grade_files(files, context, 0, grade_one=fake.obey))
    flags = {name: [flag.code for flag in one.report.flags] for name, one in graded.items()}
    assert flags == {
        "s01": ["same_bytes"],
        "s02": ["same_bytes"],
        "s03": ["several_files"],
        "answers": ["several_files"],
    }
    assert "s02" in str(graded["s01"].report.flags[0].message)


def test_nothing_is_graded_of_an_empty_batch(context: GradingContext) -> None:
    assert grade_files([], context, 2) == ()
