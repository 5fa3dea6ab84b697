"""Keeping what was graded, and letting the marks of persons enter the reports."""

from collections import defaultdict
from collections.abc import Container, Mapping, Sequence
from dataclasses import replace
from datetime import datetime
from types import MappingProxyType

from gripcourse.batch.one_file import GradingContext
from gripcourse.batch.run import Graded
from gripcourse.gradebook.apply import as_it_stands, with_marks
from gripcourse.gradebook.deadlines import Deadline, deadline_of, deadlines_path, read_deadlines
from gripcourse.gradebook.fingerprint import fingerprints
from gripcourse.gradebook.journal import published_works, waivers
from gripcourse.gradebook.model import Attempt, GradebookEntry, attempt_of, latest_marks
from gripcourse.gradebook.store import Gradebook, open_gradebook
from gripcourse.gradebook.timing import Rules, timings_of
from gripcourse.gradebook.works import works_of
from gripcourse.grading.folded import folded
from gripcourse.grading.model import Report
from gripcourse.machine.database.home import exists
from gripcourse.policy.time_rules import LateRule
from gripcourse.usecases.handed_in import HandingTime
from gripcourse.variants.model import Issued

_NO_TIMES: Mapping[str, HandingTime] = MappingProxyType({})


def check_gradebook(place: str) -> None:
    """Refuse a gradebook that cannot be used before a batch is graded for nothing.

    Raises:
        GradebookError: it is there already and cannot be used.
    """
    if exists(place):
        open_gradebook(place)


def with_kept_versions(context: GradingContext, place: str) -> GradingContext:
    """Return the context that knows for which files any version may count, as was said before.

    Raises:
        GradebookError: the gradebook is there and cannot be used.
    """
    if not exists(place):
        return context
    book = open_gradebook(place)
    works = works_of(book.standing(book.students_of_either_version())).values()
    said = (one.digest for all_ in works for one in all_ if one.attempt.either_version)
    return replace(context, either_for=frozenset(said))


def keep(
    graded: Sequence[Graded],
    context: GradingContext,
    place: str,
    now: datetime,
    times: Mapping[str, HandingTime] = _NO_TIMES,
) -> tuple[Graded, ...]:
    """Keep a batch in the gradebook, and return it with the marks of persons.

    A work that its student was told about stands as it was told; only a regrade changes that.

    Args:
        graded: what the program found by itself.
        context: the course.
        place: of the gradebook: a path or a database URL; made where there is none yet.
        now: when the batch was graded.
        times: when files were handed in, by name.

    Raises:
        GradebookError: the gradebook cannot be used.
        TableError: the table of deadlines cannot be used.
    """
    late = context.policy.late
    deadlines = _deadlines(context)
    of_course = fingerprints(context.course.root)
    found = [attempt_of(one.report, now, of_course) for one in graded]
    attempts = [_timed(one, times.get(one.file)) for one in found if one is not None]
    if not attempts:
        # Nobody's file: a gradebook is not made for nothing.
        return tuple(graded)
    book = open_gradebook(place)
    told = published_works(book)
    students = {one.student for one in attempts}
    book.add_attempts(_to_add(attempts, told, book))
    entries: dict[str, list[GradebookEntry]] = defaultdict(list)
    for entry in book.entries(students):
        entries[entry.mark.student].append(entry)
    works = works_of(book.standing(students))
    stands = {
        (one.student, one.digest): one.attempt
        for all_ in works.values()
        for one in all_
        if (one.student, one.digest) in told
    }
    entered = tuple(
        replace(one, report=_entered(one.report, stands, entries[one.report.student]))
        for one in graded
    )
    if late is None and context.policy.attempts is None:
        return entered
    waived = waivers(book)
    timings = {
        (student, digest): timing
        for student, all_ in works.items()
        for digest, timing in timings_of(
            all_,
            latest_marks(entries[student]),
            _deadline(context.register.get(student), deadlines, late),
            waived.get(student, (None,))[-1],
            Rules(late, context.policy.attempts),
        ).items()
    }
    return tuple(
        replace(
            one,
            report=replace(one.report, timing=timings.get((one.report.student, one.report.digest))),
        )
        for one in entered
    )


def _timed(attempt: Attempt, handed_in: HandingTime | None) -> Attempt:
    if handed_in is None:
        return attempt
    return replace(attempt, handed_in=handed_in.at, handed_in_said=handed_in.said)


def _to_add(
    attempts: Sequence[Attempt], told: Container[tuple[str, str]], book: Gradebook
) -> list[Attempt]:
    """Return what is to be kept: of published works nothing but the time that a person says."""
    published = {one.student for one in attempts if (one.student, one.digest) in told}
    stands = {
        (work.student, work.digest): work.attempt
        for works in works_of(book.standing(published)).values()
        for work in works
    }
    kept: list[Attempt] = []
    for one in attempts:
        key = one.student, one.digest
        if key not in told:
            kept.append(one)
        elif one.handed_in_said:
            kept.append(
                replace(
                    stands[key],
                    graded_at=one.graded_at,
                    handed_in=one.handed_in,
                    handed_in_said=True,
                )
            )
    return kept


def _deadlines(context: GradingContext) -> tuple[Deadline, ...]:
    path = deadlines_path(context.course.root)
    if context.policy.late is None or not path.is_file():
        return ()
    return read_deadlines(path, context.policy.late.time_zone)


def _deadline(
    issued: Issued | None, deadlines: tuple[Deadline, ...], late: LateRule | None
) -> datetime | None:
    if issued is None or late is None:
        return None
    return deadline_of(issued, deadlines, late.time_zone)


def _entered(
    report: Report,
    stands: Mapping[tuple[str, str], Attempt],
    entries: Sequence[GradebookEntry],
) -> Report:
    """Return a report as the gradebook says: what was published stands, marks of persons count."""
    attempt = stands.get((report.student, report.digest))
    if attempt is not None and report.judged:
        report = as_it_stands(report, attempt)
    return folded(with_marks(report, entries))
