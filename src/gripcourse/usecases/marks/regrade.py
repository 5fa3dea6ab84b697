"""Regrading as a change that can be reviewed: shown first, applied with a reason, taken back."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import datetime
from pathlib import Path

from gripcourse.batch.comparing import Comparing
from gripcourse.batch.context import GradingContext
from gripcourse.batch.graded import Graded
from gripcourse.batch.kept_reports import KeptReports
from gripcourse.batch.read_ahead import WorksAhead
from gripcourse.batch.run import grade_files
from gripcourse.errors import NextStep, Problem, UsageError
from gripcourse.gradebook.fingerprint import fingerprints
from gripcourse.gradebook.journal import (
    Published,
    Regrade,
    Signed,
    applied,
    keep_publication,
    keep_regrade,
    keep_undoing,
    publications,
    published_works,
    regrades,
    told_works,
)
from gripcourse.gradebook.model import Attempt, GradebookEntry, attempt_of, latest_marks_of_all
from gripcourse.gradebook.regrade import Shift, WorkChange, change_of, direction_of
from gripcourse.gradebook.results import RESULTS, RESULTS_DIGEST
from gripcourse.gradebook.store import Gradebook
from gripcourse.gradebook.works import StudentWork, points_of, standing_of, works_of
from gripcourse.grading.model import PointSums
from gripcourse.issuing.withdrawal import Join, persons_of
from gripcourse.machine.content import Readable
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import Message, message
from gripcourse.usecases.marks.answered import with_answers
from gripcourse.usecases.marks.batch_wish import BatchWish
from gripcourse.usecases.marks.gradebook import with_kept_versions
from gripcourse.usecases.marks.kept_policies import PolicyChange, keep_policy, policy_changes
from gripcourse.usecases.marks.mark import existing_gradebook
from gripcourse.usecases.marks.opening import by_word


@dataclass(frozen=True, slots=True)
class Regrading:
    """What the files of a batch come to now, beside what stands in the gradebook.

    Attributes:
        changes: one for each work that the gradebook knows, by student.
        strangers: files that it does not know, and files that belong to nobody.
        failed: files that could not be read at all, or failed on our side.
        missing: works of the gradebook whose file is not in the batch.
        incidents: what failed on our side, each with its trace.
        joins: which ids stood for one person, oldest first.
        policies: that works were graded by, each with what differs today.
        root: folder of the course; None where there is nothing to apply.
    """

    changes: tuple[WorkChange, ...]
    strangers: tuple[str, ...]
    failed: tuple[str, ...]
    missing: tuple[StudentWork, ...]
    incidents: tuple[str, ...]
    joins: tuple[Join, ...] = ()
    policies: tuple[PolicyChange, ...] = ()
    root: Path | None = None

    @property
    def to_apply(self) -> tuple[WorkChange, ...]:
        """Works that would get other results."""
        return tuple(one for one in self.changes if one.changes)

    @property
    def lost(self) -> tuple[WorkChange, ...]:
        """Works that were judged and cannot be any more; what stands for them is kept."""
        return tuple(one for one in self.changes if one.is_lost)

    def going(self, direction: Shift) -> tuple[WorkChange, ...]:
        """Works whose points go one way, without those that cannot be judged any more."""
        return tuple(one for one in self.changes if one.direction is direction and not one.is_lost)


def as_decided(
    context: GradingContext,
    files: Sequence[Readable],
    place: str,
    wish: BatchWish,
) -> GradingContext:
    """Return what works are graded again with, where a person decides what only a person can.

    Args:
        context: of the course.
        files: the works, as they were handed in.
        place: of the gradebook: a path or a database URL.
        wish: whose files are, and which versions count.

    Raises:
        UsageError: a file or a student that is named is not there, or a pattern says nothing.
        GradebookError: there is no gradebook, or it cannot be used.
    """
    decided = by_word(wish, files, context)
    existing_gradebook(place)
    return with_answers(with_kept_versions(decided, place), place, files)


def regrade(  # noqa: PLR0913 (the last ones are what everybody leaves as they are)
    files: Sequence[Readable],
    context: GradingContext,
    place: str,
    workers: int,
    now: datetime,
    on_done: Callable[[Readable], None] = lambda _: None,
    *,
    kept: KeptReports | None = None,
    ahead: WorksAhead | None = None,
) -> Regrading:
    """Grade works again by today's course, policy and engine, and change nothing.

    Args:
        files: the works, as they were handed in.
        context: the course.
        place: of the gradebook: a path or a database URL.
        workers: how many processes; 0 for none but this one.
        now: when it is done.
        on_done: called with each file when it is graded.
        kept: what a regrade by the very same found out of single files; new reports are added.
        ahead: what was read of the works before; None for nothing.

    Raises:
        GradebookError: there is no gradebook, or it cannot be used.
    """
    book = existing_gradebook(place, context.joins)
    context = with_kept_versions(context, place)
    graded = grade_files(
        files, context, min(workers, len(files)), on_done, kept=kept, ahead=ahead,
        wanted=(RESULTS, RESULTS_DIGEST),
        comparing=Comparing(context),  # begun, and not entered: no result hangs on it
    )  # fmt: skip
    by_student = works_of(book.standing())
    works = {(one.student, one.digest): one for all_ in by_student.values() for one in all_}
    root = context.course.root
    versions = fingerprints(root)
    fresh = {
        # Read once: they are looked at again and again.
        (one.student, one.digest): replace(one, results=tuple(one.results))
        for one in (attempt_of(done.report, now, versions) for done in graded)
        if one is not None
    }
    marked, told = _marked(book, {student for student, _ in works}), published_works(book)
    graded_by = (work.attempt.fingerprints.policy for key, work in works.items() if key in fresh)
    return Regrading(
        changes=tuple(
            change_of(
                work,
                fresh[key],
                marked.get(work.student, {}),
                published=key in told,
            )
            for key, work in sorted(works.items(), key=lambda pair: _place(pair[1]))
            if key in fresh
        ),
        strangers=tuple(_strangers(graded, works)),
        failed=tuple(one.report.file for one in graded if not one.report.digest),
        missing=tuple(work for key, work in works.items() if key not in fresh),
        incidents=tuple(one.incident for one in graded if one.incident),
        joins=context.joins,
        policies=policy_changes(root, graded_by),
        root=root,
    )


def apply_regrade(
    regrading: Regrading, place: str, signed: Signed, *, allow_lower: bool = False
) -> tuple[Attempt, ...]:
    """Let what a regrade came to stand from now on.

    Args:
        regrading: as it was shown.
        place: of the gradebook.
        signed: who applies it, when and why.
        allow_lower: whether results that students were told may get worse.

    Returns:
        The attempts that stand now.

    Raises:
        GradebookError: the gradebook cannot be used; nothing was kept.
        UsageError: no reason is given, or a published result would get worse.
    """
    _demand_reason(signed)
    lowered = [
        one for one in regrading.to_apply if one.published and one.direction is Shift.LOWERED
    ]
    if lowered and not allow_lower:
        remedy = message("Nothing was changed. Leave this work out, or say that it may get worse.")
        raise UsageError(_worse(one.work.student, one.before, one.after, remedy) for one in lowered)
    book = existing_gradebook(place, regrading.joins)
    if regrading.root is not None:
        keep_policy(regrading.root)
    return keep_regrade(book, [one.new for one in regrading.to_apply], signed)


def undo_regrade(
    place: str, signed: Signed, joins: tuple[Join, ...] = (), *, allow_lower: bool = False
) -> Regrade:
    """Take the last regrade that stands back, by a new entry.

    Args:
        place: of the gradebook.
        signed: who takes it back, when and why.
        joins: which ids stand for one person, oldest first.
        allow_lower: whether results that students were told since it was applied may get worse.

    Raises:
        GradebookError: the gradebook cannot be used.
        UsageError: no reason is given, there is nothing to take back, or a published result would
            get worse.
    """
    _demand_reason(signed)
    book = existing_gradebook(place, joins)
    lowered = [] if allow_lower else _lowered_without_the_last(book)
    if lowered:
        remedy = message(
            "Nothing was changed. Let the regrade stand, or say that it may get worse."
        )
        raise UsageError(_worse(*one, remedy) for one in lowered)
    done = keep_undoing(book, signed)
    if not done:
        what = message("No regrade stands that could be taken back.")
        remedy = message("Leave it: what was graded counts already.")
        raise UsageError([Problem("", "", what, remedy)])
    return done[0]


def _lowered_without_the_last(book: Gradebook) -> list[tuple[str, PointSums, PointSums]]:
    """Return what gets worse of what students were told, where the last regrade is taken back.

    Students, with their points as they stand and as they would: of those works alone of which they
    were told what this regrade had come to.
    """
    stands, told = applied(regrades(book)), publications(book)
    if not stands or not told:
        return []
    last, undone = stands[-1].number, book.undone()
    attempts = book.attempts({one.student for one in told})
    kept_by_it = {one.key for one in attempts if one.regrade == last}
    keys = told_works((one for one in told if one.key in kept_by_it), attempts)
    if not keys:
        return []
    marked = _marked(book, {student for student, _ in keys})
    now, then = (
        {
            (one.student, one.digest): points_of(one.attempt.results, marked.get(one.student, {}))
            for works in works_of(standing_of(attempts, numbers)).values()
            for one in works
        }
        for numbers in (undone, undone | {last})
    )
    return [
        (key[0], now[key], then[key])
        for key in sorted(keys)
        if key in then and direction_of(now[key], then[key]) is Shift.LOWERED
    ]


def _worse(student: str, before: PointSums, after: PointSums, remedy: Message) -> Problem:
    what = message(
        "{before} points were published to {student}, who would get {after}.",
        student=student,
        before=round(before.score, 2),
        after=round(after.score, 2),
    )
    return Problem("", "", what, remedy, parameter="allow_lower", step=NextStep.ALLOW_LOWER)


def publish(
    place: str, students: Iterable[str], signed: Signed, joins: tuple[Join, ...] = ()
) -> tuple[Published, ...]:
    """Record that students know their results: from now on only a regrade changes them.

    Args:
        place: of the gradebook.
        students: ids; none for everybody.
        signed: who publishes, and when.
        joins: which ids stand for one person, oldest first.

    Returns:
        What is told now and was not told before.

    Raises:
        GradebookError: the gradebook cannot be used.
        UsageError: with every student of whom nothing has been graded.
    """
    book, persons = existing_gradebook(place, joins), persons_of(joins)
    works = works_of(book.standing())
    named = (persons.get(one, one) for one in students)
    wanted = tuple(dict.fromkeys(named)) or tuple(sorted(works))
    unknown = [one for one in wanted if one not in works]
    if unknown:
        raise UsageError(
            Problem(
                "",
                "",
                message("No file of {student} has been graded yet.", student=one),
                did_you_mean(one, works),
                parameter="student",
            )
            for one in unknown
        )
    marked = _marked(book, set(wanted))
    told = {
        work: points_of(work.attempt.results, marked.get(student, {}))
        for student in wanted
        for work in works[student]
        if work.attempt.judged
    }
    return keep_publication(book, told, signed)


def _demand_reason(signed: Signed) -> None:
    if not signed.why.strip():
        what = message("A regrade needs a reason.")
        remedy = message("Say why: whoever asks in a year reads it.")
        raise UsageError([Problem("", "", what, remedy, parameter="why")])


def _marked(book: Gradebook, students: set[str]) -> Mapping[str, Mapping[str, GradebookEntry]]:
    return latest_marks_of_all(book.entries(students))


def _strangers(graded: Sequence[Graded], works: Mapping[tuple[str, str], StudentWork]) -> list[str]:
    reports = [one.report for one in graded]
    return [one.file for one in reports if one.digest and (one.student, one.digest) not in works]


def _place(work: StudentWork) -> tuple[str, int]:
    return work.student, work.number
