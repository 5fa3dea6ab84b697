"""Keeping attempts and marks for good: rows are added, none is ever changed or removed.

A writer reads which number comes next and adds its rows in one transaction. Where somebody else was
faster, the primary key refuses the whole transaction, and it is tried again with the next numbers:
nothing is lost, and nothing is half-written.
"""

from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import groupby
from typing import TypeAlias, TypeVar

from sqlalchemy import Engine, Table, and_, select

from gripcourse.errors import GradebookError, Problem
from gripcourse.gradebook import rows, schema
from gripcourse.gradebook.joined import family, marks_of_persons
from gripcourse.gradebook.joined_works import attempts_of_persons
from gripcourse.gradebook.model import Attempt, GradebookEntry, Mark
from gripcourse.gradebook.numbering import new_attempts, new_marks
from gripcourse.gradebook.reading import (
    answers,
    read_attempts,
    read_files,
    read_heads,
    read_results,
    read_told,
)
from gripcourse.gradebook.results import Result, ResultsToRead
from gripcourse.gradebook.works import standing_of
from gripcourse.issuing.withdrawal import Join
from gripcourse.machine.database.adding import add_many
from gripcourse.machine.database.opening import (
    another_was_faster,
    open_engine,
    refusals_named,
    without_password,
    writing,
)
from gripcourse.machine.database.storable import in_code_order
from gripcourse.text.words import message

# Each refusal means that somebody else got through, so a few tries per rival are enough.
_TRIES = 50

_Kept = TypeVar("_Kept")
Writing: TypeAlias = list[tuple[Table, Iterable[rows.Row]]]
"""Rows to add, by table, in the order in which they must be there."""


@dataclass(frozen=True, slots=True)
class Gradebook:
    """An open gradebook.

    Attributes:
        engine: of its database; each call takes a connection of its own.
        joins: which ids stand for one person, oldest first; works, marks, publications and waivers
            are read as those of the person.
    """

    engine: Engine
    joins: tuple[Join, ...] = ()

    @property
    def place(self) -> str:
        """Where it is, for a person."""
        return without_password(self.engine.url)

    def add_attempts(
        self, attempts: Sequence[Attempt], known: Sequence[Attempt] | None = None
    ) -> tuple[Attempt, ...]:
        """Keep attempts; the same bytes with the same results again are no new attempt.

        Args:
            attempts: of any students, in the order in which they were graded.
            known: all attempts of these students, where somebody has just read them.

        Returns:
            Those that are new, with their numbers.

        Raises:
            GradebookError: the database failed; nothing was kept.
        """
        students = {one.student for one in attempts}
        read = [] if known is None else [known]

        def fresh() -> tuple[Attempt, ...]:
            # Whoever was faster took the next number: then the primary key makes us read again.
            before = read.pop() if read else self.attempts(students)
            return new_attempts(attempts, before, self.undone())

        return self.add(fresh, attempt_rows)

    def add_marks(self, marks: Sequence[Mark]) -> tuple[Mark, ...]:
        """Keep marks, all or none; what already counts just so is not kept twice.

        What has a rival is: it says which of two counts.

        Args:
            marks: each against an attempt that is kept.

        Returns:
            Those that are new, with their numbers.

        Raises:
            GradebookError: the database failed; nothing was kept.
        """
        students = {one.student for one in marks}

        def fresh() -> tuple[Mark, ...]:
            kept = self._kept_entries(family(students, self.joins), None)
            counting = {
                (one.mark.student, one.mark.quantity): one
                for one in (marks_of_persons(kept, self.joins) if self.joins else kept)
            }
            return new_marks(
                marks,
                [one.mark for one in kept],
                {item: one.mark for item, one in counting.items()},
                {item for item, one in counting.items() if one.rivals},
            )

        return self.add(
            fresh,
            lambda fresh: [
                (schema.marks, [rows.mark_row(one) for one in fresh]),
                (schema.mark_lines, [row for one in fresh for row in rows.line_rows(one)]),
            ],
        )

    def attempts(self, students: Collection[str] | None = None) -> tuple[Attempt, ...]:
        """Return the attempts of these students (all where None), oldest first for each."""
        return self._of_persons(self._kept_attempts, students)

    def _kept_attempts(self, students: Collection[str] | None) -> tuple[Attempt, ...]:
        with refusals_named(self.place), self.engine.connect() as connection:
            return read_attempts(connection, students)

    def _of_persons(
        self,
        read: Callable[[Collection[str] | None], tuple[Attempt, ...]],
        students: Collection[str] | None,
    ) -> tuple[Attempt, ...]:
        """Return attempts of persons, of whatever ids they were kept under."""
        if not self.joins:
            return read(students)
        wanted = None if students is None else family(students, self.joins)
        kept = read(wanted)
        with refusals_named(self.place), self.engine.connect() as connection:
            told = read_told(connection, family((one.person for one in self.joins), self.joins))
        found = attempts_of_persons(kept, self.joins, told)
        return tuple(one for one in found if students is None or one.student in students)

    def unread_attempts(self, students: Collection[str]) -> tuple[Attempt, ...]:
        """Return the attempts of these students, the results of each read when somebody looks.

        Each is another question then: of whom it is clear that somebody will, ask `attempts`.
        """
        return self._of_persons(self._unread_attempts, students)

    def _unread_attempts(self, students: Collection[str] | None) -> tuple[Attempt, ...]:
        with refusals_named(self.place), self.engine.connect() as connection:
            return tuple(
                replace(one, results=ResultsToRead(digest, partial(self._results, one)))
                for one, digest in read_heads(connection, students)
            )

    def _results(self, attempt: Attempt) -> tuple[Result, ...]:
        with refusals_named(self.place), self.engine.connect() as connection:
            return read_results(connection, attempt)

    def marked_students(self) -> frozenset[str]:
        """Return the students of whom anything was ever marked."""
        question = select(schema.marks.c.student).distinct()
        with refusals_named(self.place), self.engine.connect() as connection:
            marked = set(connection.execute(question).scalars())
        for join in self.joins:
            if join.student in marked:
                marked.add(join.person)
        return frozenset(marked)

    def entries(
        self,
        students: Collection[str] | None = None,
        known: Sequence[Attempt] | None = None,
    ) -> tuple[GradebookEntry, ...]:
        """Return the marks of these students (all where None), oldest first for each item.

        Args:
            students: ids.
            known: all attempts of these students, where somebody has just read them.
        """
        if not self.joins:
            return self._kept_entries(students, known)
        wanted = None if students is None else family(students, self.joins)
        found = marks_of_persons(self._kept_entries(wanted, known), self.joins)
        return tuple(one for one in found if students is None or one.mark.student in students)

    def _kept_entries(
        self, students: Collection[str] | None, known: Sequence[Attempt] | None
    ) -> tuple[GradebookEntry, ...]:
        one, line = schema.marks.c, schema.mark_lines.c
        question = (
            select(schema.marks, line.line, line.credit.label("line_credit"))
            .outerjoin(
                schema.mark_lines,
                and_(
                    one.student == line.student,
                    one.quantity == line.quantity,
                    one.number == line.mark,
                ),
            )
            .order_by(*in_code_order(self.engine, one.student, one.quantity, one.number, line.line))
        )
        with refusals_named(self.place), self.engine.connect() as connection:
            found = answers(connection, question, schema.marks, students)
            marks = [
                rows.mark_of_rows(list(group))
                for _, group in groupby(
                    found, key=lambda row: (row.student, row.quantity, row.number)
                )
            ]
        kept = {one.key: one for one in known or ()}
        if any((mark.student, mark.attempt) not in kept for mark in marks):
            attempts = self._kept_attempts({mark.student for mark in marks})
            kept = {one.key: one for one in attempts}
        return tuple(GradebookEntry(mark, kept[mark.student, mark.attempt]) for mark in marks)

    def students_of_either_version(self) -> frozenset[str]:
        """Return the students of whose works any version was ever allowed to count."""
        column = schema.attempts.c
        question = select(column.student).where(column.either_version.is_(True)).distinct()
        with refusals_named(self.place), self.engine.connect() as connection:
            return frozenset(connection.execute(question).scalars())

    def files(self) -> tuple[tuple[str, str, str], ...]:
        """Return student, file and digest of every attempt, in the order of their grading."""
        with refusals_named(self.place), self.engine.connect() as connection:
            return tuple(read_files(connection))

    def undone(self) -> frozenset[int]:
        """Return the numbers of the regrades that were taken back."""
        column = schema.regrades.c.undoes
        question = select(column).where(column.is_not(None))
        with refusals_named(self.place), self.engine.connect() as connection:
            return frozenset(connection.execute(question).scalars())

    def standing(self, students: Collection[str] | None = None) -> tuple[Attempt, ...]:
        """Return the attempts of these students that stand; see `standing_of`."""
        return standing_of(self.attempts(students), self.undone())

    def add(
        self,
        fresh: Callable[[], tuple[_Kept, ...]],
        rows_of: Callable[[tuple[_Kept, ...]], Writing],
    ) -> tuple[_Kept, ...]:
        """Read what is new and add its rows; where somebody was faster, read again.

        Args:
            fresh: reads, and returns what is to be added, with its numbers.
            rows_of: the rows of that.

        Raises:
            GradebookError: the database failed; nothing was kept.
        """
        for _ in range(_TRIES):
            found = fresh()
            if not found:
                return ()
            try:
                with refusals_named(self.place), writing(self.engine) as connection:
                    for table, values in rows_of(found):
                        add_many(connection, table, values)
            except GradebookError as fault:
                if not another_was_faster(fault):
                    raise
                continue
            return found
        raise GradebookError(
            [
                Problem(
                    self.place,
                    "",
                    message("Others write to the gradebook all the time."),
                    message("Nothing was written; try again in a minute."),
                )
            ]
        )


def open_gradebook(place: str, joins: tuple[Join, ...] = ()) -> Gradebook:
    """Open a gradebook, made where there is none yet; see `database.opening`."""
    return Gradebook(open_engine(place), joins)


def attempt_rows(attempts: Sequence[Attempt]) -> Writing:
    """Return the rows of attempts with their results."""
    return [
        (schema.attempts, (rows.attempt_row(one) for one in attempts)),
        (schema.results, (row for one in attempts for row in rows.result_rows(one))),
    ]
