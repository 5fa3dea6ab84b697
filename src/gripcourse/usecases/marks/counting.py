"""Which work of a student counts by the course's rules of today."""

from collections.abc import Collection

from gripcourse.access.desk.store import Desk
from gripcourse.batch.context import GradingContext
from gripcourse.gradebook.counted import CountedWork, counted_work
from gripcourse.gradebook.deadlines import course_deadlines, deadline_by_rule
from gripcourse.gradebook.journal import waivers
from gripcourse.gradebook.model import latest_marks
from gripcourse.gradebook.works import latest_judged, works_of
from gripcourse.usecases.marks.mark import existing_gradebook
from gripcourse.usecases.serving.taken import order_of_works


def works_that_count(
    place: str, students: Collection[str], context: GradingContext
) -> dict[str, CountedWork]:
    """Return the work of each student that counts; without whom nothing was judged of.

    Args:
        place: of the gradebook: a path or a database URL.
        students: ids.
        context: of the course, by whose policy and deadlines of today it is counted.

    Raises:
        GradebookError: there is no gradebook, or it cannot be used.
        TableError: the table of deadlines cannot be used.
    """
    book, rule = existing_gradebook(place, context.joins), context.policy.late
    deadlines = course_deadlines(context.course.root, rule)
    taken = order_of_works(Desk(book.engine, context.course.id), context.joins)
    works, waived = works_of(book.standing(set(students)), taken), waivers(book)
    found = {
        student: counted_work(
            context.policy,
            works.get(student, ()),
            latest_marks(book.entries({student})),
            deadline_by_rule(context.register.get(student), deadlines, rule),
            waived.get(student, ()),
        )
        for student in students
    }
    return {student: counted for student, counted in found.items() if counted is not None}


def counting_instead(
    place: str, students: Collection[str], context: GradingContext
) -> dict[str, CountedWork]:
    """Return the work of those students of whom another one counts than the last."""
    if context.policy.attempts is None or not students:
        return {}
    last = latest_judged(existing_gradebook(place, context.joins).standing(set(students)))
    return {
        student: counted
        for student, counted in works_that_count(place, students, context).items()
        if student in last and counted.attempt.digest != last[student].digest
    }
