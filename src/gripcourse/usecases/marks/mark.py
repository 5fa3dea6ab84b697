"""Marks given by hand: entering one, a whole table, and showing what waits."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import datetime
from functools import cache
from pathlib import Path

from gripcourse.batch.context import GradingContext
from gripcourse.errors import GradebookError, NextStep, Problem, UsageError
from gripcourse.exports.marks_table import RowToMark, write_marks_table
from gripcourse.gradebook.enter import Draft, EntryFault, Standing, mark_of
from gripcourse.gradebook.joined import not_before_joining
from gripcourse.gradebook.model import Attempt, GradebookEntry, Mark, latest_marks
from gripcourse.gradebook.store import Gradebook, open_gradebook
from gripcourse.gradebook.table import read_marks
from gripcourse.gradebook.waiting import ItemNow, Waiting, item_now, waiting
from gripcourse.gradebook.works import latest_judged
from gripcourse.issuing.withdrawal import Join
from gripcourse.machine.content import Readable
from gripcourse.machine.database.home import exists
from gripcourse.policy.rubric import Rubric, lines_of
from gripcourse.solver.plan import plan_of
from gripcourse.text.words import Words, message
from gripcourse.usecases.marks.called import name_of, title_of
from gripcourse.variants.sheet import cell_place


@dataclass(frozen=True, slots=True)
class ManualItem:
    """A kept mark and the points of its item: what it came to."""

    mark: Mark
    max_points: float

    @property
    def points(self) -> float | None:
        """Points that the mark gives; None where it withdraws those before it."""
        return None if self.mark.credit is None else self.mark.credit * self.max_points


@dataclass(frozen=True, slots=True)
class Marking:
    """What was entered.

    Attributes:
        items: the marks that are new.
        unchanged: how many were just so already.
        empty: how many rows of a table gave nothing.
    """

    items: tuple[ManualItem, ...]
    unchanged: int
    empty: int


def existing_gradebook(place: str, joins: tuple[Join, ...] = ()) -> Gradebook:
    """Open a gradebook that must be there already.

    Args:
        place: a path or a database URL.
        joins: which ids stand for one person, oldest first.

    Raises:
        GradebookError: there is none, or it cannot be used.
    """
    if not exists(place):
        what = message("There is no gradebook here yet.")
        remedy = message("Grade first, or name another place.")
        raise GradebookError([Problem(place, "", what, remedy, step=NextStep.GRADE)])
    return open_gradebook(place, joins)


def what_waits(place: str, joins: tuple[Join, ...] = ()) -> tuple[Waiting, ...]:
    """Return what waits for a person.

    Args:
        place: of the gradebook: a path or a database URL.
        joins: which ids stand for one person, oldest first.

    Raises:
        GradebookError: there is no gradebook, or it cannot be used.
    """
    book = existing_gradebook(place, joins)
    return waiting(book.standing(), book.entries())


def item_of(
    place: str, student: str, quantity: str, joins: tuple[Join, ...] = ()
) -> ItemNow | None:
    """Return how an item of a student's last judged work stands; None where there is none.

    Raises:
        GradebookError: there is no gradebook, or it cannot be used.
    """
    book = existing_gradebook(place, joins)
    attempt = latest_judged(book.standing({student})).get(student)
    if attempt is None:
        return None
    return item_now(attempt, latest_marks(book.entries({student})), quantity)


def write_waiting(waits: Sequence[Waiting], context: GradingContext, place: str, out: Path) -> None:
    """Write what waits as a table to fill in, in the course's language; see `enter_table`.

    Args:
        waits: see `what_waits`.
        context: course, policy and register.
        place: of the gradebook.
        out: file to write, a workbook or CSV.

    Raises:
        GradebookError: the gradebook cannot be used.
        OSError: the file cannot be written.
    """
    words = Words(context.course.language)
    students = {one.student for one in waits}
    attempts = latest_judged(existing_gradebook(place, context.joins).standing(students))
    items = [_row_to_mark(one, attempts[one.student], context, words) for one in waits]
    write_marks_table(out, items, words)


def _row_to_mark(
    one: Waiting, attempt: Attempt, context: GradingContext, words: Words
) -> RowToMark:
    issued = context.register.get(one.student)
    title = title_of(one.student, one.quantity, context)
    return RowToMark(
        student=one.student,
        quantity=one.quantity,
        name=name_of(one.student, context),
        group="" if issued is None else issued.student.group,
        title="" if title is None else title.of(words.language),
        possible=attempt.by_quantity[one.quantity].max_points,
        rubric=_rubrics(one.student, attempt, context).get(one.quantity),
    )


def enter_mark(
    draft: Draft, context: GradingContext, place: str, marker: str, now: datetime
) -> Marking:
    """Enter one mark.

    Raises:
        GradebookError: the gradebook cannot be used.
        UsageError: with all that is wrong with the draft.
    """
    book = existing_gradebook(place, context.joins)
    marks, faults = _marks([draft], context, book, marker, now)
    if faults:
        raise UsageError(
            Problem("", "", fault.what, fault.remedy, parameter=_parameter(fault), step=fault.step)
            for _, fault in faults
        )
    return _kept(marks, book)


def enter_table(
    source: Readable, context: GradingContext, place: str, marker: str, now: datetime
) -> Marking:
    """Enter a table of marks, whole or not at all.

    Raises:
        TableError: the file is no table of marks.
        GradebookError: the gradebook cannot be used.
        UsageError: with all that is wrong, by row and column.
    """
    book = existing_gradebook(place, context.joins)
    table = read_marks(source, lines_of(context.policy.rubrics.values()))
    marks, faults = _marks([one.draft for one in table.rows], context, book, marker, now)
    if faults:
        raise UsageError(
            Problem(
                table.file,
                cell_place(table.rows[number].row, fault.field.removeprefix("line:")),
                fault.what,
                fault.remedy,
                step=fault.step,
            )
            for number, fault in faults
        )
    return _kept(marks, book, table.empty)


def _marks(
    drafts: Sequence[Draft], context: GradingContext, book: Gradebook, marker: str, now: datetime
) -> tuple[list[Mark], list[tuple[int, EntryFault]]]:
    """Make the marks of drafts, and what is wrong with them by number of the draft.

    Who is named by an id that was joined with another's is the person whom both stand for.
    """
    joined = context.joined
    of_persons = [replace(one, student=joined.get(one.student, one.student)) for one in drafts]
    standing = _standings({one.student for one in of_persons}, context, book)
    marks: list[Mark] = []
    faults: list[tuple[int, EntryFault]] = []
    for number, draft in enumerate(of_persons):
        stands = standing(draft.student)
        before = stands.marked.get(draft.quantity)
        at = not_before_joining(draft.student, context.joins, now, before)
        mark, found = mark_of(draft, stands, marker, at)
        faults += [(number, fault) for fault in found]
        if mark is not None:
            marks.append(mark)
    return marks, faults


def _standings(
    students: set[str], context: GradingContext, book: Gradebook
) -> Callable[[str], Standing]:
    attempts = latest_judged(book.standing(students))
    entries: dict[str, list[GradebookEntry]] = {}
    for entry in book.entries(students):
        entries.setdefault(entry.mark.student, []).append(entry)
    known = frozenset({*context.register, *attempts})

    @cache
    def standing(student: str) -> Standing:
        attempt = attempts.get(student)
        return Standing(
            known=known,
            attempt=attempt,
            marked=latest_marks(entries.get(student, ())),
            rubrics=_rubrics(student, attempt, context),
        )

    return standing


def _rubrics(
    student: str, attempt: Attempt | None, context: GradingContext
) -> Mapping[str, Rubric]:
    issued = context.register.get(student)
    if attempt is None or issued is None:
        return {}
    plan = plan_of(context.course, issued.variant.composition)
    return {one.id: context.policy.rubrics[one.rubric] for one in plan.manual}


def _kept(marks: Sequence[Mark], book: Gradebook, empty: int = 0) -> Marking:
    fresh = book.add_marks(marks)
    attempts = {one.key: one for one in book.attempts({mark.student for mark in fresh})}
    items = tuple(
        ManualItem(mark, attempts[mark.key].by_quantity[mark.quantity].max_points) for mark in fresh
    )
    return Marking(items, unchanged=len(marks) - len(fresh), empty=empty)


def _parameter(fault: EntryFault) -> str:
    """Name the field of a draft; a fault names a line of a rubric behind a colon."""
    return "lines" if fault.field.startswith("line:") else fault.field
