"""Keeping what was graded, and letting the marks of persons enter the reports."""

from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import replace
from datetime import datetime

from gripcourse.batch.one_file import GradingContext
from gripcourse.batch.run import Graded
from gripcourse.gradebook.apply import as_it_stands, with_marks
from gripcourse.gradebook.fingerprint import fingerprints
from gripcourse.gradebook.journal import published_works
from gripcourse.gradebook.model import Attempt, GradebookEntry, attempt_of
from gripcourse.gradebook.store import open_gradebook
from gripcourse.gradebook.works import works_of
from gripcourse.grading.model import Report
from gripcourse.machine.database.home import exists


def check_gradebook(place: str) -> None:
    """Refuse a gradebook that cannot be used before a batch is graded for nothing.

    Raises:
        GradebookError: it is there already and cannot be used.
    """
    if exists(place):
        open_gradebook(place)


def keep(
    graded: Sequence[Graded], context: GradingContext, place: str, now: datetime
) -> tuple[Graded, ...]:
    """Keep a batch in the gradebook, and return it with the marks of persons.

    A work that its student was told about stands as it was told; only a regrade changes that.

    Args:
        graded: what the program found by itself.
        context: the course.
        place: of the gradebook: a path or a database URL; made where there is none yet.
        now: when the batch was graded.

    Raises:
        GradebookError: the gradebook cannot be used.
    """
    of_course = fingerprints(context.course.root)
    found = [attempt_of(one.report, now, of_course) for one in graded]
    attempts = [one for one in found if one is not None]
    if not attempts:
        # Nobody's file: a gradebook is not made for nothing.
        return tuple(graded)
    book = open_gradebook(place)
    told = published_works(book)
    book.add_attempts([one for one in attempts if (one.student, one.digest) not in told])
    students = {one.student for one in attempts}
    entries: dict[str, list[GradebookEntry]] = defaultdict(list)
    for entry in book.entries(students):
        entries[entry.mark.student].append(entry)
    stands = {
        (work.student, work.digest): work.attempt
        for works in works_of(book.standing({student for student, _ in told})).values()
        for work in works
        if (work.student, work.digest) in told
    }
    return tuple(
        replace(one, report=_entered(one.report, stands, entries[one.report.student]))
        for one in graded
    )


def _entered(
    report: Report,
    stands: Mapping[tuple[str, str], Attempt],
    entries: Sequence[GradebookEntry],
) -> Report:
    """Return a report as the gradebook says: what was published stands, marks of persons count."""
    attempt = stands.get((report.student, report.digest))
    if attempt is not None and report.judged:
        report = as_it_stands(report, attempt)
    return with_marks(report, entries)
