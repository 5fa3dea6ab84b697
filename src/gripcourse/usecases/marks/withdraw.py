"""Withdrawing from the register: who left the course, who was issued to twice, and back again."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from gripcourse.course.read import course_id
from gripcourse.gradebook.joined import family, joining_after, marks_of_persons
from gripcourse.gradebook.model import GradebookEntry, latest_marks, share_given
from gripcourse.gradebook.store import open_gradebook
from gripcourse.issuing.allotment import Extended
from gripcourse.issuing.register import Register
from gripcourse.issuing.store import extend_register, read_register
from gripcourse.issuing.withdrawal import Join, Withdrawal, checked, joins_of, standing
from gripcourse.machine.database.home import exists
from gripcourse.text.words import Message, counted, message


@dataclass(frozen=True, slots=True)
class Withdrawn:
    """What a withdrawal, or taking one back, comes to.

    Attributes:
        notes: what it comes to, and what is left to do.
        disputed: quantities of the person that were marked by hand, otherwise, under both ids.
    """

    notes: tuple[Message, ...]
    disputed: tuple[str, ...] = ()


def withdraw(wanted: Withdrawal, root: Path, place: str) -> Withdrawn:
    """Keep a withdrawal, or that one is taken back; nothing that was issued is removed.

    Marks by hand stay as they were kept. Whose they are follows from who is joined with whom.

    Args:
        wanted: whose, why and by whom.
        root: folder of the course.
        place: of the gradebook: a path or a database URL.

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
    before = read_register(root, course)
    change(before)
    last = standing(before.withdrawals).get(wanted.student)
    person = last.same_as if wanted.undone and last is not None else wanted.same_as
    entries = _entries(place, (wanted.student, person), before.joins) if person else ()
    if not wanted.undone:
        # What was decided of either before is not a decision between both.
        wanted = replace(wanted, at=joining_after(entries, wanted.at))
    extended = extend_register(root, course, change)
    if not person:
        return Withdrawn(extended.notes)
    joins = joins_of((*before.withdrawals, wanted))
    marks = marks_of_persons(entries, joins)
    if wanted.undone:
        given = latest_marks(one for one in marks if one.mark.student == wanted.student)
        return Withdrawn((*extended.notes, *_given_back(wanted.student, given)))
    counting = latest_marks(one for one in marks if one.mark.student == person)
    of_this = family({wanted.student}, joins)
    carried = [name for name, one in counting.items() if one.given_to in of_this]
    disputed = tuple(
        name
        for name, one in counting.items()
        if any(other.given_to in of_this for other in one.rivals)
    )
    return Withdrawn(
        (
            *extended.notes,
            *_carried(wanted, carried),
            *(_dispute(counting[name]) for name in disputed),
        ),
        disputed,
    )


def _entries(
    place: str, students: Sequence[str], joins: Sequence[Join]
) -> tuple[GradebookEntry, ...]:
    """Return the marks by hand of some persons, as they were kept."""
    if not exists(place):
        return ()
    return open_gradebook(place).entries(family(students, joins))


def _carried(wanted: Withdrawal, names: Sequence[str]) -> tuple[Message, ...]:
    if not names:
        return ()
    said = counted(
        "{count} mark by hand that was given to {student} is that of {person} now: {names}.",
        "{count} marks by hand that were given to {student} are those of {person} now: {names}.",
        len(names),
        student=wanted.student,
        person=wanted.same_as,
        names=", ".join(names),
    )
    return (said,)


def _dispute(entry: GradebookEntry) -> Message:
    return message(
        "{quantity} was marked under both ids: {given}. Until you mark it again, also the same way,"
        " the first of these counts.",
        quantity=entry.mark.quantity,
        given=", ".join(map(share_given, (entry, *entry.rivals))),
    )


def _given_back(student: str, given: dict[str, GradebookEntry]) -> tuple[Message, ...]:
    if not given:
        return ()
    said = counted(
        "{count} mark by hand is that of {student} again: {names}.",
        "{count} marks by hand are those of {student} again: {names}.",
        len(given),
        student=student,
        names=", ".join(given),
    )
    return (said,)
