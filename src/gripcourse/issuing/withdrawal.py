"""Taking somebody out of the register without removing anything: left the course, or listed twice.

What was issued stays as it is. A withdrawal is an entry of its own, with a reason, and so is taking
it back; the last one of a student counts. Pure.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import datetime
from typing import Final

from gripcourse.errors import Problem, UsageError
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import Message, message
from gripcourse.variants.model import Issued, Student

_PARAMETER: Final = "student"


@dataclass(frozen=True, slots=True)
class Withdrawal:
    """That a student's entry is withdrawn, or is no longer.

    Attributes:
        student: id of the entry.
        same_as: id of the entry that stands for the same person; empty for who left the course.
        undone: whether it takes the last one of that student back.
        why: the reason, kept for good.
        person: who does it.
        at: when, with its zone.
    """

    student: str
    same_as: str
    undone: bool
    why: str
    person: str
    at: datetime


@dataclass(frozen=True, slots=True)
class Join:
    """That an id stands for the same person as another one, since a moment.

    Attributes:
        student: the id that was joined.
        person: the id with which it was joined.
        at: when.
    """

    student: str
    person: str
    at: datetime


def standing(withdrawals: Iterable[Withdrawal]) -> dict[str, Withdrawal]:
    """Return by student the withdrawal that counts; one that was undone does not."""
    last = {one.student: one for one in withdrawals}
    return {student: one for student, one in last.items() if not one.undone}


def joined_to(withdrawals: Sequence[Withdrawal]) -> dict[str, str]:
    """Return by each id that was joined with another the id that stands for the person now."""
    return persons_of(joins_of(withdrawals))


def joins_of(withdrawals: Sequence[Withdrawal]) -> tuple[Join, ...]:
    """Return which ids are joined now, in the order in which they were."""
    counting = standing(withdrawals)
    return tuple(
        Join(one.student, one.same_as, one.at)
        for one in withdrawals
        if one.same_as and counting.get(one.student) is one
    )


def persons_of(joins: Sequence[Join]) -> dict[str, str]:
    """Return by each id that was joined with another the id that stands for the person now.

    Args:
        joins: that stand, in the order in which they were joined.
    """
    found: dict[str, str] = {}
    for join in reversed(joins):
        # Each was joined with somebody who stood alone then, and may have been joined later.
        found[join.student] = found.get(join.person, join.person)
    return found


def why_left(withdrawals: Iterable[Withdrawal]) -> dict[str, str]:
    """Return by student why everybody left who is no longer in the course."""
    return {one.student: one.why for one in standing(withdrawals).values() if not one.same_as}


def as_of_person(entry: Issued, person: Student) -> Issued:
    """Return what was issued under an id that was joined with a person's as that person's."""
    return replace(entry, student=person, issued_as=entry.issued_as or entry.student.id)


def with_joined(entry: Issued, others: Iterable[Issued]) -> Issued:
    """Return a person's entry with the latest day that stands on any sheet of the person's.

    Args:
        entry: of the person.
        others: the last versions under the ids that were joined with it.
    """
    joined = tuple(others)
    days = [one.deadline for one in (entry, *joined)]
    latest = None if None in days else max(day for day in days if day is not None)
    return replace(
        entry,
        deadline=latest,
        own_deadline=None if entry.deadline == latest else entry.deadline,
        joined=tuple(one.student for one in joined),
    )


def checked(
    wanted: Withdrawal, known: Mapping[str, Issued], withdrawals: Iterable[Withdrawal]
) -> Message:
    """See that a withdrawal can be kept, and say what it comes to.

    Args:
        wanted: what somebody wants.
        known: entries that stand, by student; who left is among them, who was joined is not.
        withdrawals: what was kept before.

    Raises:
        UsageError: with everything that is wrong with it.
    """
    before = standing(withdrawals).get(wanted.student)
    problems = []
    if not wanted.why.strip():
        what = message("A withdrawal needs a reason.")
        remedy = message("Say why: whoever asks in a year reads it.")
        problems.append(_problem("why", what, remedy))
    if wanted.undone:
        problems += _faults_of_undoing(wanted, known, before)
    else:
        problems += _faults_of_withdrawing(wanted, known, withdrawals)
    if problems:
        raise UsageError(problems)
    if wanted.undone:
        return message("{student} is in the course again.", student=wanted.student)
    if not wanted.same_as:
        return message(
            "{student} has left the course: the variant stays as issued and nobody else gets it,"
            " works are graded, and nobody waits for one.",
            student=wanted.student,
        )
    return message(
        "{student} is {person} from now on, who keeps variant {variant} and the later of both"
        " deadlines. Works on what {student} was issued are those of {person} and are judged by the"
        " values on their sheet; lists with either name are understood.",
        student=wanted.student,
        person=wanted.same_as,
        variant=known[wanted.same_as].variant.id,
    )


def _faults_of_undoing(
    wanted: Withdrawal, known: Mapping[str, Issued], before: Withdrawal | None
) -> list[Problem]:
    if before is not None:
        return []
    if wanted.student not in known:
        return [_nobody(_PARAMETER, wanted.student, known)]
    what = message("{student} is not withdrawn.", student=wanted.student)
    return [_problem(_PARAMETER, what, message("Leave it: everything counts already."))]


def _faults_of_withdrawing(
    wanted: Withdrawal, known: Mapping[str, Issued], withdrawals: Iterable[Withdrawal]
) -> list[Problem]:
    problems, stands = [], standing(withdrawals)
    before = stands.get(wanted.student)
    if before is not None and (before.same_as or not wanted.same_as):
        said = (
            message("{student} was joined with {person} already: {why}",
                    student=wanted.student, person=before.same_as, why=before.why)
            if before.same_as
            else message("{student} has left already: {why}",
                         student=wanted.student, why=before.why)
        )  # fmt: skip
        remedy = message("Take that back first, if it was wrong.")
        problems.append(_problem(_PARAMETER, said, remedy))
    elif wanted.student not in known:
        problems.append(_nobody(_PARAMETER, wanted.student, known))
    if wanted.same_as == wanted.student:
        what = message("{student} cannot be joined with the same entry.", student=wanted.student)
        remedy = message("Name the id of the entry that the person keeps.")
        problems.append(_problem("same_as", what, remedy))
    elif (other := stands.get(wanted.same_as)) is not None and other.same_as:
        what = message("{student} was joined with {person} already: {why}",
                       student=wanted.same_as, person=other.same_as, why=other.why)  # fmt: skip
        remedy = message("Name the id of the entry that the person keeps.")
        problems.append(_problem("same_as", what, remedy))
    elif wanted.same_as and wanted.same_as not in known:
        problems.append(_nobody("same_as", wanted.same_as, known))
    return problems


def _nobody(parameter: str, student: str, known: Mapping[str, Issued]) -> Problem:
    what = message("The register has no student '{student}'.", student=student)
    return _problem(parameter, what, did_you_mean(student, known))


def _problem(parameter: str, what: Message, remedy: Message) -> Problem:
    return Problem("", "", what, remedy, parameter=parameter)
