"""Withdrawing from the register: who left the course, who was issued to twice, and back again."""

from dataclasses import replace
from pathlib import Path

from gripcourse.course.read import course_id
from gripcourse.gradebook.model import latest_marks
from gripcourse.gradebook.store import open_gradebook
from gripcourse.issuing.allotment import Extended
from gripcourse.issuing.register import Register
from gripcourse.issuing.store import extend_register, read_register
from gripcourse.issuing.withdrawal import Withdrawal, checked
from gripcourse.machine.database.home import exists
from gripcourse.text.words import Message, counted


def withdraw(wanted: Withdrawal, root: Path, place: str) -> tuple[Message, ...]:
    """Keep a withdrawal, or that one is taken back; nothing that was issued is removed.

    Args:
        wanted: whose, why and by whom.
        root: folder of the course.
        place: of the gradebook: a path or a database URL.

    Returns:
        What it comes to, and what is left to do.

    Raises:
        UsageError: with everything that is wrong with it; nothing was kept.
        RegisterError: the register cannot be used.
        GradebookError: the database cannot be used.
    """
    course = course_id(root)

    def change(register: Register) -> Extended:
        said = checked(wanted, register.by_student(), register.withdrawals)
        withdrawals = (*register.withdrawals, wanted)
        return Extended(replace(register, withdrawals=withdrawals), (said,))

    # What is refused leaves no database where there was none.
    change(read_register(root, course))
    extended = extend_register(root, course, change)
    if not wanted.same_as or not exists(place):
        return extended.notes
    return (*extended.notes, *_left_behind(wanted, place))


def _left_behind(wanted: Withdrawal, place: str) -> tuple[Message, ...]:
    """Say which marks by hand were given under the id that was joined: they are of that work."""
    marks = latest_marks(open_gradebook(place).entries({wanted.student}))
    if not marks:
        return ()
    said = counted(
        "{count} mark by hand was given to {student}; once the work is graded as that of {person},"
        " give it again.",
        "{count} marks by hand were given to {student}; once the work is graded as that of"
        " {person}, give them again.",
        len(marks),
        student=wanted.student,
        person=wanted.same_as,
    )
    return (said,)
