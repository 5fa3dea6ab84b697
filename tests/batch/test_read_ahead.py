"""Works are read while the course is loaded; what comes of them is the same."""

from collections.abc import Iterator
from pathlib import Path
from time import sleep

import pytest

from gripcourse.batch import read_ahead
from gripcourse.batch.context import GradingContext
from gripcourse.batch.read_ahead import WorkRead, WorksAhead, reading_ahead
from gripcourse.batch.run import grade_files
from gripcourse.solver.plan import Plan
from gripcourse.text.words import Words
from gripcourse.workbook.write import answer_workbook


@pytest.fixture
def works(context: GradingContext, plan: Plan, tmp_path: Path) -> list[Path]:
    """Two works with a damaged one between them."""
    files = [tmp_path / f"{name}.xlsx" for name in ("s01", "s02", "s03")]
    for file in files:
        issued = context.register[file.stem]
        file.write_bytes(answer_workbook(plan, issued, context.course, Words("ru")))
    files[1].write_bytes(files[1].read_bytes()[:400])
    return files


def all_read(works: list[Path]) -> WorksAhead:
    with reading_ahead(works, 2) as ahead:
        for thread in ahead.reading:
            thread.join()
        return ahead.ended()


def test_whose_work_was_read_needs_its_file_no_more_and_the_report_is_the_same(
    context: GradingContext, works: list[Path]
) -> None:
    ahead = all_read(works)
    assert sorted(ahead.places) == [0, 2]
    assert isinstance(ahead.work(0), WorkRead)
    assert ahead.work(1) == works[1]
    as_usual = grade_files(works, context, 1)
    for file in (works[0], works[2]):
        file.unlink()
    assert grade_files(works, context, 1, ahead=ahead) == as_usual


def test_without_workers_nothing_is_read_ahead(works: list[Path]) -> None:
    with reading_ahead(works, 0) as ahead:
        assert not ahead.reading
        assert [ahead.work(number) for number in range(3)] == works


def test_nobody_waits_for_more_than_what_is_being_read(
    works: list[Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    given: list[int] = []

    def one_by_one(*_: object, **__: object) -> Iterator[tuple[int, bytes]]:
        for number in range(1000):
            sleep(0.001)
            given.append(number)
            yield number, b"read"

    monkeypatch.setattr(read_ahead, "run_each", one_by_one)
    with reading_ahead(works, 1) as ahead:
        read = ahead.ended()
    assert sorted(read.places) == given
    assert len(given) < 1000


@pytest.mark.parametrize("fault", [OSError("no room"), MemoryError("no room")])
def test_what_fails_meanwhile_is_left_to_who_judges(
    works: list[Path], monkeypatch: pytest.MonkeyPatch, fault: Exception
) -> None:
    def failing(*_: object, **__: object) -> Iterator[tuple[int, bytes]]:
        yield 0, b"read"
        raise fault

    monkeypatch.setattr(read_ahead, "run_each", failing)
    with reading_ahead(works, 1) as ahead:
        assert ahead.ended().work(2) == works[2]
