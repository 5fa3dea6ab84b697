"""Whatever is wrong with a file, it is refused with a reason, or read for what stands in it."""

import inspect
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from types import ModuleType
from typing import Final, TypeAlias

import pytest

from gripcourse.machine.jobs.pools import PROCESSES, Pool
from gripcourse.machine.jobs.workers import Lost, in_order, run_each
from gripcourse.machine.spreadsheet.refusals import WhyRefused
from gripcourse.submission.apart import READERS
from gripcourse.submission.model import Reading, Rejected
from gripcourse.submission.raw import RawWorkbook
from hostile import archives, disguises, foreign, harmless, parts, sheets
from hostile.provenance import invented
from hostile.reading import Outcome, as_student, as_table, faults_of
from hostile.small_workbook import ANSWERS, PARTS, archive, quantities

Made: TypeAlias = Mapping[str, bytes]

SECONDS: Final = 60.0  # of processor time: what would never end is lost, on a slow machine too
MEGABYTES: Final = 256
FEWEST: Final = 80


def kinds_in(module: ModuleType) -> Iterator[tuple[str, Callable[[], bytes]]]:
    for name, kind in inspect.getmembers(module, inspect.isfunction):
        if kind.__module__ == module.__name__ and not name.startswith("_"):
            yield name.replace("_", " "), kind


KINDS: Final = dict(
    pair
    for module in (archives, disguises, sheets, parts, harmless, foreign)
    for pair in kinds_in(module)
)


@pytest.fixture(scope="module")
def files() -> Made:
    return {name: kind() for name, kind in KINDS.items()}


def pool() -> Pool:
    return replace(PROCESSES, limits=replace(READERS, processor=SECONDS))


@pytest.fixture(scope="module")
def outcomes(files: Made) -> Mapping[str, Outcome | Lost]:
    """Read all of them in one worker; whoever takes too much is lost."""
    jobs = run_each(
        as_student, list(files.values()), quantities(), workers=1, seconds=60, pool=pool()
    )
    return dict(zip(files, in_order(jobs), strict=True))


def test_there_are_many_kinds_of_broken_workbooks() -> None:
    assert len(KINDS) >= FEWEST


def test_the_workbook_that_is_spoiled_is_sound() -> None:
    read = as_student(archive(PARTS), quantities())
    assert read.submission is not None
    assert not faults_of(read)
    answers = read.submission.answers
    assert {name: answers[name].value for name in ("force", "bore", "holds", "loss", "width")} == {
        "force": 22941.5,
        "bore": 63.0,
        "holds": 1.0,
        "loss": 5.5,
        "width": 40.0,
    }
    assert answers["stroke"].reading is Reading.BLANK
    assert set(answers) == set(ANSWERS)
    assert read.submission.identity.student == "s001"


@pytest.mark.parametrize("name", KINDS)
def test_a_file_is_refused_with_a_reason_or_read_for_what_stands_in_it(
    name: str, files: Made, outcomes: Mapping[str, Outcome | Lost]
) -> None:
    read = outcomes[name]
    assert isinstance(read, Outcome), read
    assert not faults_of(read)
    if isinstance(read.raw, RawWorkbook):
        assert not invented(files[name], read.raw)


def test_no_file_takes_much_memory(outcomes: Mapping[str, Outcome | Lost]) -> None:
    assert max(one.peak for one in outcomes.values() if isinstance(one, Outcome)) < MEGABYTES


def test_most_broken_files_are_refused(outcomes: Mapping[str, Outcome | Lost]) -> None:
    codes = {one.raw.code for one in outcomes.values() if _is_refused(one)}  # type: ignore[union-attr]
    assert codes >= set(WhyRefused) - {WhyRefused.GONE, WhyRefused.LOCK_FILE, WhyRefused.TOO_COSTLY}


def _is_refused(one: Outcome | Lost) -> bool:
    return isinstance(one, Outcome) and isinstance(one.raw, Rejected)


def test_the_same_files_as_tables_are_refused_or_read(
    files: Made, capfd: pytest.CaptureFixture[str]
) -> None:
    jobs = run_each(as_table, list(files.values()), None, workers=1, seconds=60, pool=pool())
    outcomes = dict(zip(files, in_order(jobs), strict=True))
    assert not {name: one for name, one in outcomes.items() if isinstance(one, Lost)}
    assert capfd.readouterr() == ("", "")
