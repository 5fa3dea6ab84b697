"""Keeping what was graded, and letting the marks of persons enter the reports."""

from collections import defaultdict
from collections.abc import Container, Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import datetime
from itertools import chain, islice
from types import MappingProxyType
from typing import Final

from gripcourse.access.desk.store import Desk
from gripcourse.batch.context import GradingContext
from gripcourse.batch.graded import Changes, Graded, reports_of, with_reports
from gripcourse.gradebook.apply import as_it_stands, with_marks
from gripcourse.gradebook.deadlines import Deadline, course_deadlines, deadline_by_rule
from gripcourse.gradebook.fingerprint import fingerprints
from gripcourse.gradebook.journal import Published, publications, told_works, waivers
from gripcourse.gradebook.model import (
    Attempt,
    Fingerprints,
    GradebookEntry,
    attempt_of,
    latest_marks,
)
from gripcourse.gradebook.results import digest_is_known
from gripcourse.gradebook.store import Gradebook, open_gradebook
from gripcourse.gradebook.timing import Waiver, is_settled, timings_by_policy
from gripcourse.gradebook.works import StudentWork, standing_of, works_of
from gripcourse.grading.model import FlagCode, Report
from gripcourse.machine.database.home import exists
from gripcourse.machine.database.opening import demand_writing
from gripcourse.policy.time_rules import Counts
from gripcourse.usecases.marks.answered import keep_said
from gripcourse.usecases.marks.attempt_times import doubts_about_time, to_keep
from gripcourse.usecases.marks.handed_in import HandingTime
from gripcourse.usecases.marks.kept_policies import keep_policy
from gripcourse.usecases.serving.taken import order_of_works

# What the gradebook knows of all at once is large: attempts take some ten kilobytes each.
_STUDENTS_AT_ONCE: Final = 200

_NO_TIMES: Mapping[str, HandingTime] = MappingProxyType({})


def check_gradebook(place: str) -> None:
    """Refuse a gradebook that cannot be used before a batch is graded for nothing.

    Raises:
        GradebookError: it is there already and cannot be used, or not be written.
    """
    if exists(place):
        demand_writing(open_gradebook(place).engine)


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
) -> Sequence[Graded]:
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
    places: dict[str, tuple[int, ...]] = {}
    for number, report in enumerate(reports_of(graded)):
        if report.student and report.digest:
            places[report.student] = (*places.get(report.student, ()), number)
    if not places:
        # Nobody's file: a gradebook is not made for nothing.
        return graded
    deadlines = course_deadlines(context.course.root, context.policy.late)
    keep_policy(context.course.root)
    book = open_gradebook(place, context.joins)
    keeping = _Keeping(
        context=context,
        book=book,
        now=now,
        fingerprints=fingerprints(context.course.root),
        times=times,
        deadlines=deadlines,
        told=publications(book),
        waived=waivers(book),
        marked=book.marked_students(),
        taken=order_of_works(Desk(book.engine, context.course.id), context.joins),
    )
    keep_said(graded, context, book, now)
    left = iter(places)
    portions = iter(lambda: tuple(islice(left, _STUDENTS_AT_ONCE)), ())
    changes = (_kept(keeping, students, places, graded) for students in portions)
    return with_reports(graded, chain.from_iterable(changes))


@dataclass(frozen=True, slots=True)
class _Keeping:
    """What is the same for all students of a batch.

    Attributes:
        context: the course.
        book: the gradebook.
        now: when the batch was graded.
        fingerprints: of what graded.
        times: when files were handed in, by name.
        deadlines: of the course's table.
        told: what students were told so far.
        waived: the waivers of each student.
        marked: students of whom anything was ever marked.
        taken: by student and digest, the place of a work among what the desk took of the student.
    """

    context: GradingContext
    book: Gradebook
    now: datetime
    fingerprints: Fingerprints
    times: Mapping[str, HandingTime]
    deadlines: tuple[Deadline, ...]
    told: Sequence[Published]
    waived: Mapping[str, tuple[Waiver, ...]]
    marked: Container[str]
    taken: Mapping[tuple[str, str], int]


def _kept(
    keeping: _Keeping,
    students: Sequence[str],
    places: Mapping[str, Sequence[int]],
    graded: Sequence[Graded],
) -> Changes:
    """Keep the works of some students; yield the reports of which the gradebook says more."""
    book, policy = keeping.book, keeping.context.policy
    reports = {name: [graded[number].report for number in places[name]] for name in students}
    found = (
        attempt_of(report, keeping.now, keeping.fingerprints)
        for mine in reports.values()
        for report in mine
    )
    attempts = [
        to_keep(one, keeping.times.get(one.file), keeping.context)
        for one in found
        if one is not None
    ]
    known, undone = _known(keeping, students), book.undone()
    told = told_works(keeping.told, known)
    before = works_of(standing_of(known, undone))
    to_add = _to_add(attempts, told, before)
    known = (*known, *book.add_attempts(to_add, known))
    if not {(one.student, one.digest) for one in to_add} <= {(a.student, a.digest) for a in known}:
        # Somebody else kept the same works since these were read.
        known = _known(keeping, students)
    entries: dict[str, list[GradebookEntry]] = defaultdict(list)
    for entry in book.entries(students, known):
        entries[entry.mark.student].append(entry)
    works = works_of(standing_of(known, undone), keeping.taken)
    for name in students:
        of_file = {one.digest: one for one in works[name]}
        entered = [
            _entered(
                one,
                of_file.get(one.digest),
                entries[name],
                is_told=(name, one.digest) in told,
            )
            for one in reports[name]
        ]
        issued, waived = keeping.context.register.get(name), keeping.waived.get(name, ())
        deadline = deadline_by_rule(issued, keeping.deadlines, policy.late)
        marks = latest_marks(entries[name])
        timings = timings_by_policy(policy, works[name], marks, deadline, waived)
        if timings:
            entered = [replace(one, timing=timings.get(one.digest)) for one in entered]
            doubts = [
                doubts_about_time(
                    of_file.get(one.digest),
                    keeping.times.get(one.file),
                    keeping.context,
                    deadline,
                    waived,
                )
                for one in entered
            ]
            entered = [
                replace(one, flags=(*one.flags, *doubt))
                for one, doubt in zip(entered, doubts, strict=True)
            ]
        if is_settled(policy.attempts, timings.values(), works[name]):
            entered = [_undisputed(one) for one in entered]
        for number, found_out, stands_now in zip(places[name], reports[name], entered, strict=True):
            if stands_now is not found_out:
                yield number, stands_now


def _known(keeping: _Keeping, students: Sequence[str]) -> tuple[Attempt, ...]:
    """Return all attempts of some students; results are read of those alone that are looked at.

    Of most it is enough to know that they are the same as now.
    """
    rule, told = keeping.context.policy.attempts, {one.student for one in keeping.told}
    compared = rule is not None and rule.counts is Counts.BEST
    to_read = {one for one in students if compared or one in told or one in keeping.marked}
    others = keeping.book.unread_attempts([one for one in students if one not in to_read])
    # Of what an earlier program kept nobody knows it without reading.
    to_read |= {one.student for one in others if not digest_is_known(one.results)}
    unread = (one for one in others if one.student not in to_read)
    return (*unread, *(keeping.book.attempts(to_read) if to_read else ()))


def _undisputed(report: Report) -> Report:
    """Return a report that asks nobody which of a student's works counts: the policy says it."""
    kept = tuple(flag for flag in report.flags if flag.code is not FlagCode.SEVERAL_FILES)
    return replace(report, flags=kept)


def _to_add(
    attempts: Sequence[Attempt],
    told: Container[tuple[str, str]],
    works: Mapping[str, Sequence[StudentWork]],
) -> list[Attempt]:
    """Return what is to be kept: of published works nothing but the time that a person says."""
    stands = {(one.student, one.digest): one for all_ in works.values() for one in all_}
    kept: list[Attempt] = []
    for one in attempts:
        key = one.student, one.digest
        if key not in told:
            kept.append(one)
        elif one.handed_in_said and one.handed_in != stands[key].handed_in:
            kept.append(
                replace(
                    stands[key].attempt,
                    graded_at=one.graded_at,
                    handed_in=one.handed_in,
                    handed_in_said=True,
                    other_time=None,
                )
            )
    return kept


def _entered(
    report: Report, work: StudentWork | None, entries: Sequence[GradebookEntry], *, is_told: bool
) -> Report:
    """Return a report as the gradebook says: what was published stands, marks of persons count."""
    if work is None:
        return with_marks(report, entries)
    if is_told and report.judged:
        report = as_it_stands(report, work.attempt)
    return with_marks(report, entries, work.first.key if work.first.judged else None)
