"""What counts of the works of students, for their instructor's desk."""

from collections.abc import Collection

from gripcourse.gradebook.counted import CountedWork, counted_work
from gripcourse.gradebook.journal import waivers
from gripcourse.gradebook.model import latest_marks_of_all
from gripcourse.gradebook.store import Gradebook
from gripcourse.gradebook.works import works_of
from gripcourse.usecases.serving.desk import DeskContext

__all__ = ["CountedWork", "counted_works"]


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
    book, register = Gradebook(context.desk.engine), context.register()
    names = None if students is None else set(students)
    marked, waived = latest_marks_of_all(book.entries(names)), waivers(book)
    found = {}
    for student, works in works_of(book.standing(names)).items():
        if student not in register:
            continue
        deadline = context.deadlines.of(register[student])
        marks, others = marked.get(student, {}), waived.get(student, ())
        counted = counted_work(context.policy, works, marks, deadline, others)
        if counted is not None:
            found[student] = counted
    return found
