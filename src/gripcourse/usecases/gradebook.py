"""Keeping what was graded, and letting the marks of persons enter the reports."""

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import replace
from datetime import datetime

from gripcourse.batch.one_file import GradingContext
from gripcourse.batch.run import Graded
from gripcourse.gradebook.apply import with_marks
from gripcourse.gradebook.fingerprint import fingerprints
from gripcourse.gradebook.model import GradebookEntry, attempt_of
from gripcourse.gradebook.store import open_gradebook
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
    book.add_attempts(attempts)
    entries: dict[str, list[GradebookEntry]] = defaultdict(list)
    for entry in book.entries({one.student for one in attempts}):
        entries[entry.mark.student].append(entry)
    return tuple(
        replace(one, report=with_marks(one.report, entries[one.report.student])) for one in graded
    )
