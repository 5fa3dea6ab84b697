"""What counts of the works of students, for their instructor's desk."""

from collections.abc import Collection, Mapping
from dataclasses import replace
from typing import Final

from gripcourse.gradebook.counted import CountedWork, counted_work
from gripcourse.gradebook.journal import waivers
from gripcourse.gradebook.model import latest_marks_of_all
from gripcourse.gradebook.store import Gradebook
from gripcourse.gradebook.works import works_of
from gripcourse.policy.time_rules import AttemptRule, Counts
from gripcourse.text.words import Message, message
from gripcourse.usecases.serving.desk import DeskContext
from gripcourse.usecases.serving.taken import order_of_works

__all__ = ["CountedWork", "counted_works"]


_WHICH: Final[Mapping[Counts, Message]] = {
    Counts.FIRST: message("The first workbook counts."),
    Counts.LAST: message("The last workbook counts."),
    Counts.BEST: message("The best workbook counts."),
}
_WHICH_OF: Final[Mapping[Counts, Message]] = {
    Counts.FIRST: _WHICH[Counts.FIRST],
    Counts.LAST: message("Of the first {most} workbooks the last one counts."),
    Counts.BEST: message("Of the first {most} workbooks the best one counts."),
}


def which_counts(rule: AttemptRule | None) -> Message:
    """Say which of several workbooks of a student counts."""
    if rule is None:
        return _WHICH[Counts.LAST]
    if rule.most == 1:
        return _WHICH[Counts.FIRST]
    if not rule.most:
        return _WHICH[rule.counts]
    return replace(_WHICH_OF[rule.counts], values={"most": rule.most})


def counted_works(
    context: DeskContext, students: Collection[str] | None = None
) -> dict[str, CountedWork]:
    """Return the work that counts of each student of the register who has one.

    Args:
        context: of the course.
        students: of whom alone; None for all.

    Raises:
        RegisterError: the register cannot be used.
        GradebookError: the gradebook cannot be used.
    """
    joins = context.joins()
    book, register = Gradebook(context.desk.engine, joins), context.register()
    names = None if students is None else set(students)
    marked, waived = latest_marks_of_all(book.entries(names)), waivers(book)
    found = {}
    taken = order_of_works(context.desk, joins)
    for student, works in works_of(book.standing(names), taken).items():
        if student not in register:
            continue
        deadline = context.deadlines.of(register[student])
        marks, others = marked.get(student, {}), waived.get(student, ())
        counted = counted_work(context.policy, works, marks, deadline, others)
        if counted is not None:
            found[student] = counted
    return found
