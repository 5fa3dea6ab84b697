"""A term comes to the same, byte for byte, in a file and in PostgreSQL, which may go away in it."""

import importlib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from datetime import UTC, date, datetime
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING, Final

import pytest
from sqlalchemy import Connection, Engine, Table, event

from gripcourse.batch.graded import Graded
from gripcourse.batch.one_file import grade_file
from gripcourse.cli.demo.students import correct
from gripcourse.errors import GradebookError
from gripcourse.gradebook import store
from gripcourse.gradebook.enter import Draft
from gripcourse.gradebook.journal import Signed
from gripcourse.gradebook.timing import Waiver
from gripcourse.machine.database.adding import add_many
from gripcourse.text.words import Words
from gripcourse.usecases.grading.batch_tables import FILES_CSV, GRADES_CSV, GRADES_JSON, json_text
from gripcourse.usecases.grading.grade import write_results
from gripcourse.usecases.marks.gradebook import keep
from gripcourse.usecases.marks.history import history
from gripcourse.usecases.marks.mark import enter_mark
from gripcourse.usecases.marks.regrade import publish
from gripcourse.usecases.marks.waive import waive
from support.classroom import forget_one_jaw

if TYPE_CHECKING:
    from support.classroom import Classroom
    from support.postgres import Server

NOW: Final = datetime(2026, 12, 9, 9, 0, 0, 1, UTC)


@pytest.fixture(scope="module")
def graded(issued: "Classroom", tmp_path_factory: pytest.TempPathFactory) -> Sequence[Graded]:
    """Works of two students, graded and not kept."""
    folder = tmp_path_factory.mktemp("works")
    files = [
        issued.hand_in("s02", forget_one_jaw, folder / "s02.xlsx"),
        issued.hand_in("s01", correct, folder / "s01.xlsx"),
    ]
    return [Graded(grade_file(one, issued.context), "") for one in files]


@pytest.fixture
def away(postgresql: "Server") -> Iterator[str]:
    with postgresql.database() as place:
        yield place


def term(place: str, graded: Sequence[Graded], classroom: "Classroom", out: Path) -> list[bytes]:
    """Keep, mark, waive, publish; return all that is exported of it."""
    context = classroom.context
    keep(graded, context, place, NOW)
    said = "Розріз А—А: «ні» штрихування \0 ?"
    draft = Draft("s01", "kinematic_diagram", {}, points=1.0, comment=said)
    enter_mark(draft, context, place, "Петров", NOW)
    waive(Waiver("s02", 0, NOW, withdrawn=False, person="Петров", done_at=NOW, why="хвороба"),
          place, context.register)  # fmt: skip
    publish(place, (), Signed("Петров", NOW))
    kept = keep(graded, context, place, NOW)
    fake = importlib.import_module("fake_documents")
    write_results(kept, context, out, date(2026, 12, 9), 0, lambda _: None, lay_out=fake.page)
    told = [repr(one) for student in ("s01", "s02") for one in history(place, student)]
    files = [(out / name).read_bytes() for name in (GRADES_CSV, GRADES_JSON, FILES_CSV)]
    assert files[1].decode() == json_text(
        [one.report for one in kept],
        Words(context.course.language),
        scales=context.policy.scales,
        missing=[one.student for name, one in sorted(context.register.items())
                 if name not in {report.report.student for report in kept}],
    )  # fmt: skip
    return [*files, "\n".join(told).encode()]


def test_all_exports_are_the_same(
    away: str,
    graded: Sequence[Graded],
    issued: "Classroom",
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.syspath_prepend(str(Path(__file__).parent / "grading"))
    fake = importlib.import_module("fake_documents")
    monkeypatch.setattr("gripcourse.usecases.grading.cohort_print.cohort_pdf", fake.cohort_page)
    in_file = term(str(tmp_path / "gradebook.sqlite"), graded, issued, tmp_path / "file")
    assert in_file == term(away, graded, issued, tmp_path / "server")
    assert "Петров" in in_file[-1].decode()


class Killed(BaseException):
    """Ends what runs, wherever it is; nobody catches it."""


@contextmanager
def killed_at_commit(moment: int) -> Iterator[None]:
    """Let the commit of that number, of any database, end everything before it happens."""
    commits = count(1)

    def commit(_: object) -> None:
        if next(commits) == moment:
            raise Killed

    event.listen(Engine, "commit", commit)
    try:
        yield
    finally:
        event.remove(Engine, "commit", commit)


def test_a_batch_that_is_killed_at_any_commit_ends_as_one_that_is_not(
    graded: Sequence[Graded],
    issued: "Classroom",
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.syspath_prepend(str(Path(__file__).parent / "grading"))
    fake = importlib.import_module("fake_documents")
    monkeypatch.setattr("gripcourse.usecases.grading.cohort_print.cohort_pdf", fake.cohort_page)
    monkeypatch.setattr("gripcourse.usecases.marks.gradebook._STUDENTS_AT_ONCE", 1)
    whole = term(str(tmp_path / "whole.sqlite"), graded, issued, tmp_path / "whole")
    place = str(tmp_path / "killed.sqlite")
    for moment in count(1):
        with killed_at_commit(moment), suppress(Killed):
            keep(graded, issued.context, place, NOW)
            break
        assert term(place, graded, issued, tmp_path / "killed") == whole
        Path(place).unlink()
    # The tables, and a portion for each student.
    assert moment > len(graded)


def test_a_batch_that_loses_the_server_is_kept_whole_when_it_is_back(
    away: str,
    postgresql: "Server",
    graded: Sequence[Graded],
    issued: "Classroom",
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    tables: list[str] = []

    def stop_after_attempts(
        connection: Connection, table: Table, rows: Iterable[Mapping[str, object]]
    ) -> None:
        if tables:  # in the middle of the transaction
            postgresql.stop()
        tables.append(table.name)
        add_many(connection, table, rows)

    store.open_gradebook(away)
    with monkeypatch.context() as patch:
        patch.setattr(store, "add_many", stop_after_attempts)
        with pytest.raises(GradebookError, match="gone away"):
            keep(graded, issued.context, away, NOW)
    assert tables == ["gradebook_attempt", "gradebook_result"]
    postgresql.start()
    assert store.open_gradebook(away).attempts() == ()
    for _ in range(2):
        kept = keep(graded, issued.context, away, NOW)
    reports = [json_text([one.report for one in some], Words("en")) for some in (kept, graded)]
    assert reports[0] == reports[1]
    assert len(store.open_gradebook(away).attempts()) == 2
