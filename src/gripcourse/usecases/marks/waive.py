"""Waivers: that somebody's lateness is not counted, with a reason, kept for good."""

from collections.abc import Container
from dataclasses import replace

from gripcourse.errors import Problem, UsageError
from gripcourse.gradebook.joined import not_before_joining
from gripcourse.gradebook.journal import keep_waiver, waivers
from gripcourse.gradebook.store import open_gradebook
from gripcourse.gradebook.timing import Waiver
from gripcourse.issuing.withdrawal import Join, persons_of
from gripcourse.text.words import message


def waive(
    waiver: Waiver, place: str, known: Container[str], joins: tuple[Join, ...] = ()
) -> Waiver:
    """Keep a waiver; the next grading lets it count.

    Args:
        waiver: whose, until when, by whom and why.
        place: of the gradebook; made where there is none yet.
        known: students of the register.
        joins: which ids stand for one person, oldest first; either names the person.

    Raises:
        GradebookError: the gradebook cannot be used.
        UsageError: nobody knows the student, no reason is given, or there is nothing to withdraw.
    """
    person = persons_of(joins).get(waiver.student, waiver.student)
    at = not_before_joining(person, joins, waiver.done_at)
    waiver = replace(waiver, student=person, done_at=at)
    problems = []
    if waiver.student not in known:
        what = message("The register has no student '{student}'.", student=waiver.student)
        problems.append(Problem("", "", what, message("Check the id."), parameter="student"))
    if not waiver.why.strip():
        what = message("A waiver needs a reason.")
        remedy = message("Say why: whoever asks in a year reads it.")
        problems.append(Problem("", "", what, remedy, parameter="why"))
    if problems:
        raise UsageError(problems)
    book = open_gradebook(place, joins)
    before = waivers(book).get(waiver.student, ())
    if waiver.withdrawn and (not before or before[-1].withdrawn):
        what = message("{student} has no waiver that counts.", student=waiver.student)
        remedy = message("Leave it: lateness is counted already.")
        raise UsageError([Problem("", "", what, remedy, parameter="withdraw")])
    return keep_waiver(book, waiver)
