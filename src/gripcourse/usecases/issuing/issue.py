"""Issuing assignments: from a roster and a variant table to a folder per student."""

import logging
import secrets
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from datetime import UTC, date, datetime, time
from functools import partial
from pathlib import Path
from typing import TypeAlias

from gripcourse.access.desk.store import open_desk
from gripcourse.course.model import Course
from gripcourse.documents.assignment_sheet import STYLES
from gripcourse.errors import Problem, UsageError
from gripcourse.gradebook.fingerprint import fingerprints
from gripcourse.issuing.allotment import Terms, extend
from gripcourse.issuing.made_ids import Joined
from gripcourse.issuing.roster import read_roster
from gripcourse.issuing.signature import KEY_BYTES, key_of, key_path, make_key
from gripcourse.issuing.store import extend_register, read_register
from gripcourse.issuing.withdrawal import joined_to
from gripcourse.machine.alone import writing_into
from gripcourse.machine.content import Readable
from gripcourse.machine.database.home import home_of
from gripcourse.machine.files import discard_unfinished, make_private_folder
from gripcourse.machine.jobs.workers import Lost, in_order, run_each
from gripcourse.machine.resources import TEMPLATES
from gripcourse.policy.model import Policy
from gripcourse.solver.plan import plan_of
from gripcourse.text.words import Message, message
from gripcourse.usecases.authoring.styles import missing_fonts
from gripcourse.usecases.issuing.declarations import keep_declarations
from gripcourse.usecases.issuing.handout import (
    Handout,
    IssuingContext,
    issue_one,
    sheet_path,
    workbook_path,
)
from gripcourse.usecases.serving.desk import DeskContext
from gripcourse.usecases.serving.links import make_links, refuse_no_address
from gripcourse.variants.model import Issued
from gripcourse.variants.table import read_table

# A student's documents take about a second; a hundred times as much are no documents any more.
SECONDS_PER_STUDENT = 120.0

IssueOne: TypeAlias = Callable[[IssuingContext, Issued], Handout]
"""Writes one student's documents; it must be found by its name in another process."""

_log = logging.getLogger(__name__)


@dataclass(frozen=True, slots=True)
class Order:
    """What is to be issued.

    Attributes:
        roster, table: files, or their bytes.
        out: folder to write the students' folders to.
        today: day of the issue.
        deadline: last day for handing in, None for none.
        link_days: how many days from `today` the personal link on each sheet is good for; 0 for
            sheets without one.
    """

    roster: Readable
    table: Readable
    out: Path
    today: date
    deadline: date | None
    link_days: int = 0


@dataclass(frozen=True, slots=True)
class Issuing:
    """What was issued.

    Attributes:
        handouts: one per student.
        notes: for the instructor.
        outdated: students who keep numbers that the table has no longer.
        left: students of the list who have left the course; they got nothing.
        in_and_out: see `Extended`.
    """

    handouts: tuple[Handout, ...]
    notes: tuple[Message, ...]
    outdated: tuple[str, ...] = ()
    left: tuple[str, ...] = ()
    in_and_out: tuple[tuple[str, ...], tuple[str, ...]] = ((), ())


def issue_order(  # noqa: PLR0913 (the last two have usual values)
    course: Course,
    policy: Policy,
    order: Order,
    workers: int,
    on_done: Callable[[str], None],
    *,
    on_counted: Callable[[int], None] = lambda _: None,
    issue_one: IssueOne = issue_one,
) -> Issuing:
    """Issue variants to everybody on the roster and write their documents.

    The register is written before any document: nothing is handed out that it does not know.
    A course that has issued nothing gets its key now. Documents that cannot be made are named in
    the handout of their student; the others are made.

    Args:
        course: its folder holds the key and the register.
        policy: printed in the documents.
        order: what to issue.
        workers: how many processes lay out documents; 0 for none but this one.
        on_done: called with each student's id.
        on_counted: called before, with how many students there are.
        issue_one: writes one student's documents.

    Raises:
        GripcourseError: the deadline, the roster, the table, the register or the key cannot be
            used; nothing was written.
    """
    refuse_past(order.deadline, order.today)
    if order.link_days:
        refuse_no_address(course.address)
    before = read_register(course.root, course.id)
    roster = read_roster(
        order.roster,
        (entry.student for entry in before.entries),
        course.languages,
        Joined(before.joined, joined_to(before.withdrawals)),
    )
    students = roster.students
    variants = read_table(order.table, course)
    place = key_path(course.root)
    known = key_of(place, issued=bool(before.entries))
    terms = Terms(
        known or secrets.token_bytes(KEY_BYTES),
        order.today,
        order.deadline,
        fingerprints(course.root).course,
    )
    extend(before, students, variants, terms)  # what is refused makes neither key nor folder
    # Before anything is kept: a folder that cannot be written must not cost a variant.
    make_private_folder(order.out)
    if known is None:
        terms = replace(terms, key=make_key(place, terms.key))
    keep_declarations(course.root)
    extended = extend_register(
        course.root, course.id, lambda register: extend(register, students, variants, terms)
    )
    by_student = extended.register.by_student()
    listed = (by_student[student.id] for student in students)
    entries = [one for one in listed if not one.left]
    links = links_on_sheets(course, policy, terms.key, order.today, order.link_days)
    context = IssuingContext(course, policy, partial(plan_of, course), order.out, links)
    made_key = _key_notes(course) if known is None else ()
    on_counted(len(entries))
    handouts = write_handouts(context, entries, workers, on_done, issue_one)
    fonts = missing_fonts(course.root / TEMPLATES, STYLES)
    notes = (*made_key, *roster.notes, *extended.notes, *fonts)
    return Issuing(handouts, notes, extended.outdated, extended.left, extended.in_and_out)


def links_on_sheets(
    course: Course, policy: Policy, key: bytes, today: date, days: int
) -> Mapping[str, str]:
    """Return the personal links that stand on the sheets, by student; the same for the same day.

    Args:
        course: of everything that was issued.
        policy: of the course.
        key: of the course.
        today: day of the issue.
        days: that the links are good for; 0 for sheets without one.
    """
    if not days:
        return {}
    context = DeskContext(course, policy, key, open_desk(home_of(course.root), course.id))
    issued_at = datetime.combine(today, time(), UTC)
    links = make_links(context, "", days, issued_at)
    return {one.issued.student.id: one.address for one in links}


def refuse_past(deadline: date | None, today: date) -> None:
    """Refuse a deadline before the day of the issue: every work would be late.

    Raises:
        UsageError: it lies before.
    """
    if deadline is not None and deadline < today:
        what = message(
            "The deadline {deadline} lies before the day of the issue, {today}.",
            deadline=deadline.isoformat(),
            today=today.isoformat(),
        )
        remedy = message("Name a later deadline, or an earlier day of the issue.")
        raise UsageError([Problem("", "", what, remedy, parameter="deadline")])


def _key_notes(course: Course) -> tuple[Message, ...]:
    """Say that a key was made: who loses it can check no workbook any more."""
    place = str(key_path(course.root))
    said = message(
        "A key that signs the workbooks was made: {place}. Keep a copy of it.", place=place
    )
    return (said,)


def write_handouts(
    context: IssuingContext,
    entries: Sequence[Issued],
    workers: int,
    on_done: Callable[[str], None],
    issue_one: IssueOne,
) -> tuple[Handout, ...]:
    """Write the documents of entries of the register; a handout each, in the same order."""
    shared = (issue_one, context)
    jobs = run_each(_issue, entries, shared, workers=workers, seconds=SECONDS_PER_STUDENT)

    def written(number: int) -> None:
        _log.info("documents of %s: done", entries[number].student.id)
        on_done(entries[number].student.id)

    done = in_order(jobs, written)
    return tuple(
        _lost(context, entry, handout) if isinstance(handout, Lost) else handout
        for entry, handout in zip(entries, done, strict=True)
    )


def _issue(entry: Issued, shared: tuple[IssueOne, IssuingContext]) -> Handout:
    """Issue to one student, maybe once more: who dies takes other workers along, midway."""
    issue_one, context = shared
    with _without_unfinished(context, entry.student.id):
        return issue_one(context, entry)


@contextmanager
def _without_unfinished(context: IssuingContext, student: str) -> Iterator[None]:
    """Remove what the dead left in a student's folder, not what another process writes there."""
    paths = sheet_path(context.out, student), workbook_path(context.out, student)
    with writing_into(paths[0].parent) as alone:
        for path in paths if alone else ():
            discard_unfinished(path)
        yield


def _lost(context: IssuingContext, entry: Issued, lost: Lost) -> Handout:
    """Name what failed on our side; what was finished before stays, nothing half-written does."""
    student = entry.student.id
    with _without_unfinished(context, student):
        pass
    _log.error("documents of student %s: %s", student, lost.trace)
    said = message(
        "The documents of {student} could not be made: {reason}",
        student=student,
        reason=lost.reason,
    )
    return Handout(student, (), (said,))
