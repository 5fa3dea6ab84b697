"""Marks given by hand and traces of numbers, as a program asks for them."""

from collections.abc import Iterable, Mapping
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING

from gripcourse.api.choices import a_text
from gripcourse.api.course import Course
from gripcourse.api.refusals import refusals_said
from gripcourse.api.sources import FileLike, place_of, readable
from gripcourse.api.withdrawing import joins_said_by

if TYPE_CHECKING:
    from gripcourse.gradebook.enter import Draft
    from gripcourse.gradebook.waiting import Waiting
    from gripcourse.usecases.issuing.trace import Traced
    from gripcourse.usecases.marks.mark import Marking

# Every call imports what it needs itself, as in `api.course`.
# ruff: noqa: PLC0415


@refusals_said
def what_waits(gradebook: str | Path, *, course: Course | None = None) -> "tuple[Waiting, ...]":
    """Return what waits for a person in a gradebook.

    Args:
        gradebook: path or database URL.
        course: that says which ids were joined as those of one person; None where none was.

    Raises:
        GradebookError: there is none, or it cannot be used.
    """
    from gripcourse.usecases.marks.mark import what_waits as ask

    return ask(place_of(gradebook), joins_said_by(course))


@refusals_said
def enter_mark(course: Course, draft: "Draft", gradebook: str | Path, marker: str) -> "Marking":
    """Enter the mark of one item; see `gripcourse.gradebook.enter.Draft`.

    Raises:
        GripcourseError: with all that is wrong with it.
    """
    from gripcourse.usecases.marks.mark import enter_mark as enter
    from gripcourse.usecases.marks.opening import grading_of

    context = grading_of(course.definition, course.policy)
    return enter(draft, context, place_of(gradebook), marker, datetime.now(UTC))


@refusals_said
def enter_marks(course: Course, table: FileLike, gradebook: str | Path, marker: str) -> "Marking":
    """Enter a table of marks, whole or not at all.

    Raises:
        GripcourseError: with all that is wrong, by row and column.
    """
    from gripcourse.usecases.marks.mark import enter_table
    from gripcourse.usecases.marks.opening import grading_of

    context = grading_of(course.definition, course.policy)
    source = readable(table, "marks")
    return enter_table(source, context, place_of(gradebook), marker, datetime.now(UTC))


@refusals_said
def trace(
    course: Course,
    numbers: str | Iterable[str],
    quantities: Mapping[str, str] | None = None,
    table: FileLike | None = None,
) -> "Traced":
    """Rank whose variant numbers may come from, with the odds; no verdict.

    Args:
        course: whose register is searched.
        numbers: as people type them, of unknown meaning; one text is one number.
        quantities: numbers whose meaning is known, by id.
        table: searched instead of the register; None for the register.

    Raises:
        GripcourseError: with every text that is no number or no quantity.
    """
    from gripcourse.usecases.issuing import trace as tracing

    sought = (
        tracing.in_register(course.root, course.definition)
        if table is None
        else tracing.in_table(course.table_source(table), course.definition)
    )
    named = [(name, a_text("quantities", one)) for name, one in (quantities or {}).items()]
    texts = [numbers] if isinstance(numbers, str) else [a_text("numbers", one) for one in numbers]
    return tracing.trace(texts, named, course.definition, sought)
