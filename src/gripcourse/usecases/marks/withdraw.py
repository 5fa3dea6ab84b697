"""Withdrawing from the register: who left the course, who was issued to twice, and back again."""

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from gripcourse.course.read import course_id
from gripcourse.gradebook.joined import family, joining_after, marks_of_persons
from gripcourse.gradebook.journal import publications, published_works
from gripcourse.gradebook.model import GradebookEntry, latest_marks, share_given
from gripcourse.gradebook.store import Gradebook, open_gradebook
from gripcourse.issuing.allotment import Extended
from gripcourse.issuing.register import Register
from gripcourse.issuing.store import extend_register, read_register
from gripcourse.issuing.withdrawal import Join, Withdrawal, checked, joins_of, standing
from gripcourse.machine.database.home import exists
from gripcourse.text.words import Message, counted, message
from gripcourse.usecases.marks.join_said import counted_now, counting_said, deadline_said


@dataclass(frozen=True, slots=True)
class Withdrawn:
    """What a withdrawal, or taking one back, comes to.

    Attributes:
        notes: what it comes to, and what is left to do.
        disputed: quantities of the person that were marked by hand, otherwise, under both ids.
        told_twice: whether the person was told results under both ids that differ.
    """

    notes: tuple[Message, ...]
    disputed: tuple[str, ...] = ()
    told_twice: bool = False


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
    book = open_gradebook(place) if person and exists(place) else None
    ids = family((wanted.student, person), before.joins)
    entries = () if book is None else book.entries(ids)
    attempts = () if book is None else book.attempts(ids)
    if not wanted.undone:
        # What was decided of either before is not a decision between both.
        wanted = replace(wanted, at=joining_after(entries, attempts, wanted.at))
    both = (wanted.student, person)
    counting_before = {} if book is None else counted_now(root, place, both)
    extended = extend_register(root, course, change)
    if not person:
        return Withdrawn(extended.notes)
    counting_now = {} if book is None else counted_now(root, place, both)
    others_count = counting_said(counting_before, counting_now)
    joins = joins_of((*before.withdrawals, wanted))
    marks = marks_of_persons(entries, joins)
    if wanted.undone:
        given = latest_marks(one for one in marks if one.mark.student == wanted.student)
        notes = (
            *deadline_said(wanted, person, before),
            *_given_back(wanted.student, given),
            *_told_of(book, wanted, "", joins),
        )
        return Withdrawn((*extended.notes, *notes, *others_count))
    counting = latest_marks(one for one in marks if one.mark.student == person)
    of_this = family({wanted.student}, joins)
    carried = [name for name, one in counting.items() if one.mark.kept_as in of_this]
    disputed = tuple(
        name
        for name, one in counting.items()
        if any(other.mark.kept_as in of_this for other in one.rivals)
    )
    twice = _told_twice(book, person, of_this, family({person}, before.joins))
    return Withdrawn(
        (
            *extended.notes,
            *_carried(wanted, carried),
            *_told_of(book, wanted, person, joins),
            *others_count,
            *twice,
            *(_dispute(counting[name]) for name in disputed),
        ),
        disputed,
        told_twice=bool(twice),
    )


def _told_of(
    book: Gradebook | None, wanted: Withdrawal, person: str, joins: Sequence[Join]
) -> tuple[Message, ...]:
    """Say of how many works that change hands their student was told; `person` is empty on undo."""
    if book is None:
        return ()
    ids = family({wanted.student}, joins)
    works = sum(student in ids for student, _ in published_works(book))
    if not works:
        return ()
    if not person:
        said = counted(
            "{count} published result is that of {student} again.",
            "{count} published results are those of {student} again.",
            works,
            student=wanted.student,
        )
        return (said,)
    said = counted(
        "{count} published result of {student} is that of {person} now: only a regrade changes it.",
        "{count} published results of {student} are those of {person} now: only a regrade changes"
        " them.",
        works,
        student=wanted.student,
        person=person,
    )
    return (said,)


def _told_twice(
    book: Gradebook | None, person: str, of_this: Collection[str], of_person: Collection[str]
) -> tuple[Message, ...]:
    """Say what a person was told last under each of two ids, where that differs."""
    told = () if book is None else publications(book)
    last = [[one for one in told if one.student in ids][-1:] for ids in (of_person, of_this)]
    both = [one for found in last for one in found]
    if len({(one.points, one.max_points) for one in both}) < len(last):
        return ()
    said = message(
        "{person} was told different results: {results}. Each stands as it was told; which of the"
        " works counts, the policy says.",
        person=person,
        results=", ".join(f"{one.student} {one.points:.4g} / {one.max_points:.4g}" for one in both),
    )
    return (said,)


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
