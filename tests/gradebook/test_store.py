"""What was kept once stays: attempts and marks are added, never changed, never lost."""

import sqlite3
import subprocess
import sys
from collections.abc import Callable, Sequence
from contextlib import closing
from dataclasses import replace
from datetime import datetime, timedelta, timezone
from pathlib import Path

import pytest
from sqlalchemy import event

from gripcourse.errors import GradebookError
from gripcourse.gradebook.model import Attempt, Mark
from gripcourse.gradebook.store import Gradebook, open_gradebook
from gripcourse.grading.model import Outcome, Report

MakeReport = Callable[..., Report]
MakeMark = Callable[..., Mark]
MakeAttempts = Callable[..., Sequence[Attempt]]


class TestAttempts:
    def test_what_is_kept_is_read_back(
        self, book: Gradebook, report: MakeReport, attempts: MakeAttempts
    ) -> None:
        (given,) = attempts(report())
        (kept,) = book.add_attempts([given])
        assert kept == replace(given, number=1)
        assert book.attempts() == (kept,)
        assert book.attempts({"s01"}) == (kept,)
        assert book.attempts({"s02"}) == ()

    def test_the_same_bytes_with_the_same_results_are_no_second_attempt(
        self, book: Gradebook, report: MakeReport, attempts: MakeAttempts, morning: datetime
    ) -> None:
        book.add_attempts(attempts(report()))
        moved = replace(report(), file="elsewhere/s01.xlsx")
        (later,) = attempts(moved)
        assert book.add_attempts([replace(later, graded_at=morning + timedelta(days=9))]) == ()
        assert [one.file for one in book.attempts()] == ["inbox/s01.xlsx"]

    def test_a_file_that_is_twice_in_a_batch_is_one_attempt(
        self, book: Gradebook, report: MakeReport, attempts: MakeAttempts
    ) -> None:
        assert len(book.add_attempts(attempts(report(), report()))) == 1

    def test_other_bytes_are_another_attempt_even_with_the_same_results(
        self, book: Gradebook, report: MakeReport, attempts: MakeAttempts
    ) -> None:
        book.add_attempts(attempts(report(), report(digest="b" * 64)))
        assert [(one.number, one.digest[0]) for one in book.attempts()] == [(1, "a"), (2, "b")]

    def test_the_same_bytes_with_other_results_are_another_attempt(
        self, book: Gradebook, report: MakeReport, attempts: MakeAttempts
    ) -> None:
        mended = report(bore=(Outcome.CORRECT, 2.0, 2.0))
        for one in (report(), mended, mended, report()):
            book.add_attempts(attempts(one))
        outcomes = [one.by_quantity["bore"].outcome for one in book.attempts()]
        assert outcomes == [Outcome.WRONG, Outcome.CORRECT, Outcome.WRONG]

    def test_two_files_of_a_student_graded_again_add_nothing(
        self, book: Gradebook, report: MakeReport, attempts: MakeAttempts
    ) -> None:
        both = attempts(report(), report(digest="b" * 64))
        assert len(book.add_attempts(both)) == 2
        assert book.add_attempts(both) == ()

    def test_the_last_bits_of_points_are_no_other_result(
        self, book: Gradebook, report: MakeReport, attempts: MakeAttempts
    ) -> None:
        book.add_attempts(attempts(report(bore=(Outcome.SLIP, 0.3, 2.0))))
        again = attempts(report(bore=(Outcome.SLIP, 0.1 + 0.2, 2.0)))
        assert book.add_attempts(again) == ()

    def test_each_student_is_numbered_apart(
        self, book: Gradebook, report: MakeReport, attempts: MakeAttempts
    ) -> None:
        kept = book.add_attempts(attempts(report("s01"), report("s02")))
        assert [(one.student, one.number) for one in kept] == [("s01", 1), ("s02", 1)]

    def test_a_file_that_could_not_be_judged_is_an_attempt_without_results(
        self, book: Gradebook, report: MakeReport, attempts: MakeAttempts
    ) -> None:
        book.add_attempts(attempts(replace(report(), judged=False, findings=())))
        (kept,) = book.attempts()
        assert (kept.judged, kept.results) == (False, ())

    def test_nobodys_file_and_a_file_without_bytes_are_not_kept(
        self, report: MakeReport, attempts: MakeAttempts
    ) -> None:
        assert attempts(replace(report(), student=""), replace(report(), digest="")) == []

    def test_more_students_than_a_database_takes_at_once_are_found(
        self, book: Gradebook, report: MakeReport, attempts: MakeAttempts
    ) -> None:
        names = [f"s{number:04d}" for number in range(1200)]
        book.add_attempts(attempts(*map(report, names)))
        assert [one.student for one in book.attempts(set(names))] == names


class TestMarks:
    @pytest.fixture
    def graded(self, book: Gradebook, report: MakeReport, attempts: MakeAttempts) -> Gradebook:
        book.add_attempts(attempts(report()))
        return book

    def test_what_is_kept_is_read_back_with_its_attempt(
        self, graded: Gradebook, mark: MakeMark
    ) -> None:
        given = mark(
            lines={"sizes": 0.5, "standards": 1 / 3}, comment="Разрез А—А: «нет» штриховки"
        )
        (kept,) = graded.add_marks([given])
        assert kept == replace(given, number=1)
        (entry,) = graded.entries()
        assert entry.mark == kept
        assert (entry.attempt,) == graded.attempts()

    def test_a_later_mark_supersedes_and_removes_nothing(
        self, graded: Gradebook, mark: MakeMark
    ) -> None:
        for credit in (0.5, 0.75, 0.5):
            graded.add_marks([mark(credit=credit)])
        kept = [entry.mark for entry in graded.entries()]
        assert [(one.number, one.credit, one.supersedes) for one in kept] == [
            (1, 0.5, None),
            (2, 0.75, 1),
            (3, 0.5, 2),
        ]

    def test_the_mark_that_counts_already_is_not_kept_twice(
        self, graded: Gradebook, mark: MakeMark, morning: datetime
    ) -> None:
        graded.add_marks([mark()])
        assert graded.add_marks([mark(marked_at=morning + timedelta(days=5))]) == ()
        assert len(graded.add_marks([mark(marker="Сидоров")])) == 1

    def test_a_moment_is_the_same_in_every_time_zone(
        self, graded: Gradebook, mark: MakeMark
    ) -> None:
        kyiv = datetime(2026, 12, 2, 23, 30, tzinfo=timezone(timedelta(hours=2)))
        graded.add_marks([mark(marked_at=kyiv)])
        (entry,) = graded.entries()
        assert entry.mark.marked_at == kyiv

    def test_marks_come_whole_or_not_at_all(self, graded: Gradebook, mark: MakeMark) -> None:
        """The second mark has no place in the table; the first must not stay alone."""
        whole, broken = mark(), mark("bore", marker=None)
        with pytest.raises(GradebookError):
            graded.add_marks([whole, broken])
        assert graded.entries() == ()


class TestManyGraders:
    def test_two_who_read_the_same_state_both_keep_their_marks(
        self, book: Gradebook, report: MakeReport, attempts: MakeAttempts, mark: MakeMark
    ) -> None:
        """The other grader gets in between reading and writing, once."""
        book.add_attempts(attempts(report()))
        other, rivals = open_gradebook(book.place), [mark(credit=0.25, marker="Rival")]

        @event.listens_for(book.engine, "before_cursor_execute")
        def get_in_between(
            _connection: object, _cursor: object, statement: str, *_: object
        ) -> None:
            if rivals and statement.startswith(("BEGIN", "SET LOCAL")):
                other.add_marks([rivals.pop()])

        book.add_marks([mark(credit=0.75)])
        assert [(one.mark.number, one.mark.credit) for one in book.entries()] == [
            (1, 0.25),
            (2, 0.75),
        ]

    def test_opening_it_again_finds_what_was_kept(
        self,
        book: Gradebook,
        report: Callable[..., Report],
        attempts: Callable[..., Sequence[Attempt]],
    ) -> None:
        book.add_attempts(attempts(report()))
        assert open_gradebook(book.place).attempts() == book.attempts()

    def test_processes_that_write_at_once_lose_nothing(self, tmp_path: Path) -> None:
        """They make the gradebook together, too."""
        place, times = str(tmp_path / "gradebook.sqlite"), 12
        script = Path(__file__).with_name("writer.py")
        markers = ("Петров", "Carter", "Шевченко")
        running = [
            subprocess.Popen(  # noqa: S603 (our own interpreter)
                [sys.executable, str(script), place, marker, str(times)], stderr=subprocess.PIPE
            )
            for marker in markers
        ]
        said = [one.communicate()[1].decode() for one in running]
        assert [one.returncode for one in running] == [0, 0, 0], said
        book = open_gradebook(place)
        assert [one.number for one in book.attempts()] == list(range(1, 3 * times + 1))
        marks = [entry.mark for entry in book.entries()]
        assert [one.number for one in marks] == list(range(1, 3 * times + 1))
        for marker in markers:
            own = [one for one in marks if one.marker == marker]
            assert [one.comment for one in own] == [str(number) for number in range(times)]
            assert all(one.lines == {"sizes": one.credit} for one in own)


class TestDamage:
    """A file whose bytes changed on the disk may open all the same."""

    @pytest.mark.parametrize(
        ("column", "kept"),
        [
            ("student", "CAST(x'80ff30' AS TEXT)"),
            ("graded_at", "'2026-12-0x 09:00:00.000000'"),
        ],
    )
    def test_a_damaged_cell_is_said_with_the_place(
        self,
        tmp_path: Path,
        report: MakeReport,
        attempts: MakeAttempts,
        column: str,
        kept: str,
    ) -> None:
        place = tmp_path / "gradebook.sqlite"
        open_gradebook(str(place)).add_attempts(attempts(report()))
        with closing(sqlite3.connect(place)) as connection:
            connection.execute("PRAGMA foreign_keys = off")
            connection.execute(f"UPDATE gradebook_attempt SET {column} = {kept}")  # noqa: S608 (above)
            connection.commit()
        with pytest.raises(GradebookError, match="restore a damaged file") as caught:
            open_gradebook(str(place)).attempts()
        assert caught.value.problems[0].file == str(place)

    def test_a_word_that_is_no_outcome_is_damage_too(
        self, tmp_path: Path, report: MakeReport, attempts: MakeAttempts
    ) -> None:
        place = tmp_path / "gradebook.sqlite"
        open_gradebook(str(place)).add_attempts(attempts(report()))
        with closing(sqlite3.connect(place)) as connection:
            connection.execute("UPDATE gradebook_result SET outcome = 'wron$'")
            connection.commit()
        with pytest.raises(GradebookError, match=r"wron\$"):
            open_gradebook(str(place)).attempts()

    def test_a_damaged_name_of_a_table_is_said_with_the_place(self, tmp_path: Path) -> None:
        place = tmp_path / "gradebook.sqlite"
        open_gradebook(str(place))
        content = place.read_bytes()
        place.write_bytes(content.replace(b"gripcourse_revision", b"gripcourse_revisio\xff"))
        with pytest.raises(GradebookError, match="restore a damaged file"):
            open_gradebook(str(place)).attempts()
