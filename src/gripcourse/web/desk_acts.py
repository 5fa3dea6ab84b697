"""What pages of the desk and programs of instructors do alike, by one call of the library."""

import hashlib
import logging
from dataclasses import dataclass
from pathlib import Path, PurePath

from gripcourse.gradebook.enter import Draft
from gripcourse.gradebook.joined import family
from gripcourse.gradebook.journal import Regrade, Signed
from gripcourse.gradebook.model import Attempt
from gripcourse.gradebook.store import Gradebook
from gripcourse.machine.content import NamedBytes
from gripcourse.machine.database.home import home_of
from gripcourse.text.words import message
from gripcourse.usecases.grading.progress import BatchProgress, batch_progress
from gripcourse.usecases.marks.mark import Marking, enter_mark
from gripcourse.usecases.marks.opening import grading_of
from gripcourse.usecases.marks.regrade import Regrading, apply_regrade, regrade, undo_regrade
from gripcourse.usecases.serving.begin_grading import begin_grading
from gripcourse.usecases.serving.desk import DeskContext
from gripcourse.usecases.serving.hand_in import kept_path, may_count
from gripcourse.usecases.serving.taken import hand_ins_by_person
from gripcourse.web.acts import reason
from gripcourse.web.batch import LastBatch
from gripcourse.web.refusals import (
    NOT_FOUND,
    Code,
    WebRefusal,
    refusal_until_mended,
    unless_in_conflict,
)
from gripcourse.web.site import Site

_log = logging.getLogger(__name__)

_RUNS: WebRefusal = WebRefusal(
    Code.CONFLICT, message("A batch is being graded already. Wait until it has ended.")
)
_OTHER_BY_NOW: WebRefusal = WebRefusal(
    Code.CONFLICT,
    message("It comes to something else than was shown by now. Look at it again."),
)
_MARKED_MEANWHILE: WebRefusal = WebRefusal(
    Code.CONFLICT, message("Somebody marked this item since you opened it. Look at it again.")
)


def begin_batch(site: Site, by: str, why: str) -> WebRefusal | None:
    """Begin to grade the workbooks of everybody that may count; None where it has begun."""
    if site.graded is None:
        return NOT_FOUND
    if (refused := unless_usable(site)) is not None:
        return refused
    with site.own_batch.lock:
        now = grading_now(site, site.graded)
        if site.own_batch.runs or (now.runs and not now.silent):
            return _RUNS
        wanted = site.context, site.graded, site.checkers.workers, by, reason(why)
        process = unless_in_conflict(lambda: begin_grading(*wanted))
        if isinstance(process, WebRefusal):
            return process
        site.own_batch.began(process)
    return None


@dataclass(frozen=True, slots=True)
class GradingNow:
    """The batch that is being graded, and what the next one would grade.

    Attributes:
        runs: whether one is at work.
        silent: whether nothing was heard of it for minutes: it may be begun again.
        failed: whether the one that was begun here last did not come to its end.
        progress: how far it is; None where none has begun, or it is about to begin or to end.
        last: what was graded last; None for nothing.
        waiting: workbooks that a batch would grade.
    """

    runs: bool
    silent: bool
    failed: bool
    progress: BatchProgress | None
    last: LastBatch | None
    waiting: int


def grading_now(site: Site, graded: Path) -> GradingNow:
    """Tell how far a batch is that writes into a folder, whoever began it.

    Raises:
        OSError: the folder cannot be read.
    """
    context = site.context
    progress, hand_ins = (
        batch_progress(graded),
        hand_ins_by_person(context.desk, context.joins()),
    )
    return GradingNow(
        runs=progress is not None or site.own_batch.runs,
        silent=progress is not None and progress.is_silent(site.clock()),
        failed=site.own_batch.failed,
        progress=progress,
        last=site.batches.read(graded),
        waiting=sum(map(len, may_count(site.context, hand_ins).values())),
    )


def marks_seen(site: Site, student: str, item: str) -> str:
    """Say which marks of an item there are: who marks meanwhile changes it."""
    # All that were ever kept: of a person who had two ids, under either.
    ids = family({student}, site.context.joins())
    entries = Gradebook(site.context.desk.engine).entries(ids)
    return str(sum(one.mark.quantity == item for one in entries))


def keep_mark(site: Site, by: str, draft: Draft, seen: str | None) -> Marking | WebRefusal:
    """Keep the mark of a person, if nobody else marked the item since it was seen.

    Raises:
        UsageError: with all that is wrong with the draft.
    """
    if seen != marks_seen(site, draft.student, draft.quantity):
        return _MARKED_MEANWHILE
    context = site.context
    place, grading = home_of(context.course.root), grading_of(context.course, context.policy)
    return enter_mark(draft, grading, place, by, site.clock())


def unless_usable(site: Site) -> WebRefusal | None:
    """Refuse to grade by files that cannot be used now; None where they can.

    A batch reads them itself, and what is graded is kept with their fingerprints.
    """
    return None if not site.living.faults else refusal_until_mended(site.living.faults[0])


def regrading_now(site: Site) -> Regrading | WebRefusal:
    """Grade everything that was handed in by today's course and policy; nothing counts yet."""
    if (refused := unless_usable(site)) is not None:
        return refused
    context = site.context
    grading, place = grading_of(context.course, context.policy), home_of(context.course.root)
    # A file is never opened by the server itself, but where a test wants everything in one process.
    workers = 0 if site.checkers.pool is None else site.checkers.workers
    found = regrade(works_handed_in(context), grading, place, workers, site.clock())
    for trace in found.incidents:
        _log.error("%s", trace)
    return found


def digest_of_changes(found: Regrading) -> str:
    """Return a name for what would change, the same for the same."""
    changes = [
        (one.work.student, one.work.digest, one.items, one.before, one.after, one.published)
        for one in found.to_apply
    ]
    return hashlib.sha256(repr(changes).encode()).hexdigest()


def apply_shown(
    site: Site, signed: Signed, seen: str | None, *, allow_lower: bool
) -> tuple[Attempt, ...] | WebRefusal:
    """Let a regrade count, if it still comes to what was shown."""
    found = regrading_now(site)
    if isinstance(found, WebRefusal):
        return found
    if seen != digest_of_changes(found):
        return _OTHER_BY_NOW
    place = home_of(site.context.course.root)
    return unless_in_conflict(lambda: apply_regrade(found, place, signed, allow_lower=allow_lower))


def take_last_back(site: Site, signed: Signed, *, allow_lower: bool) -> Regrade | WebRefusal:
    """Take the last regrade that stands back."""
    place, joins = home_of(site.context.course.root), site.context.joins()
    return unless_in_conflict(lambda: undo_regrade(place, signed, joins, allow_lower=allow_lower))


def signed_by(site: Site, by: str, why: str) -> Signed:
    """Say who does something now, and why."""
    return Signed(by, site.clock(), reason(why))


def works_handed_in(context: DeskContext) -> list[NamedBytes]:
    """Return every workbook that was handed in, called like its student, each once.

    Raises:
        OSError: one cannot be read.
    """
    files = {
        (student, one.digest): one
        for student, all_ in hand_ins_by_person(context.desk, context.joins()).items()
        for one in all_
        if not one.is_drawing
    }
    return [
        NamedBytes(
            f"{student}{PurePath(one.name).suffix.lower()}", kept_path(context, digest).read_bytes()
        )
        for (student, digest), one in files.items()
    ]
