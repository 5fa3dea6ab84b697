"""What the gradebook knows of one student: every attempt, mark and regrade, in order of time."""

from collections.abc import Callable, Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from datetime import datetime
from itertools import accumulate
from pathlib import Path

from gripcourse.access.desk.model import GradedBatch
from gripcourse.access.desk.store import Desk, batches_by_time
from gripcourse.batch.context import GradingContext
from gripcourse.errors import Problem, UsageError
from gripcourse.gradebook.joined import family
from gripcourse.gradebook.journal import publications, regrades, waivers
from gripcourse.gradebook.model import Attempt, GradebookEntry
from gripcourse.gradebook.policy_changes import PolicyLine
from gripcourse.gradebook.timing import Waiver
from gripcourse.gradebook.works import in_order, points_of, works_of
from gripcourse.issuing.withdrawal import Withdrawal, joins_of, persons_of
from gripcourse.text.shown import shown
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import Message, message
from gripcourse.usecases.marks.counting import works_that_count
from gripcourse.usecases.marks.kept_policies import changed_by_attempt
from gripcourse.usecases.marks.mark import existing_gradebook
from gripcourse.usecases.marks.policy_said import changed_since_said
from gripcourse.usecases.serving.taken import order_of_works

_DECIMALS = 2


@dataclass(frozen=True, slots=True)
class Event:
    """One thing that happened to a student's grade.

    Attributes:
        at: when.
        person: who did it; empty where files were graded and nobody said by whom.
        what: happened.
        why: in the words of the person; empty for none.
    """

    at: datetime
    person: str
    what: Message
    why: str


def history(  # noqa: PLR0913 (what a gradebook does not know by itself)
    place: str,
    student: str,
    known: Container[str] = (),
    called: Callable[[str], str] = str,
    withdrawals: Iterable[Withdrawal] = (),
    course_id: str = "",
    *,
    root: Path | None = None,
) -> tuple[Event, ...]:
    """Return what happened to a student's grade, oldest first.

    Args:
        place: of the gradebook: a path or a database URL.
        student: id.
        known: students of the register; of these nothing may have happened yet.
        called: what people call the quantity of an id.
        withdrawals: of the course.
        course_id: of the course; empty where nothing was handed in at its desk.
        root: folder of the course, which has the policies of then; None for none.

    Raises:
        GradebookError: there is no gradebook, or it cannot be used.
        UsageError: nobody knows the student.
    """
    withdrawals = tuple(withdrawals)
    joins = joins_of(withdrawals)
    ids = sorted(family({student}, joins))
    # Of an id that was joined with another it tells what is kept under it.
    book = existing_gradebook(place, () if student in persons_of(joins) else joins)
    attempts = book.attempts({student})
    as_kept = existing_gradebook(place)
    waived = waivers(as_kept)
    taken = order_of_works(Desk(book.engine, course_id), joins) if course_id else {}
    withdrawn = tuple(_of_withdrawals(student, withdrawals))
    if not (attempts or student in known or student in waived or withdrawn):
        everybody = {one.student for one in book.attempts()}
        what = message("The register has no student '{student}'.", student=student)
        remedy = did_you_mean(student, everybody)
        raise UsageError([Problem("", "", what, remedy, parameter="student")])
    touched = {one.regrade for one in attempts} - {None}
    regraded: list[Event] = []
    for one in regrades(book):
        if one.number in touched or one.undoes in touched:
            what = (
                message("Regrade {number} was applied.", number=one.number)
                if one.undoes is None
                else message("Regrade {number} was taken back.", number=one.undoes)
            )
            regraded.append(Event(one.signed.done_at, one.signed.person, what, one.signed.why))
    batches = batches_by_time(book.engine)
    changed = {} if root is None else changed_by_attempt(root, attempts, book.undone())
    numbers = _numbers(attempts, taken)
    published: list[Event] = []
    for told in publications(book):
        if told.student == student:
            said = message(
                "Points published to the student: {points} of {most} (attempt {number}).",
                points=round(told.points, _DECIMALS),
                most=round(told.max_points, _DECIMALS),
                number=numbers.get(told.key, told.attempt),
            )
            if told.kept_as:
                said = message("{event} (As {student}.)", event=said, student=told.kept_as)
            published.append(Event(told.signed.done_at, told.signed.person, said, ""))
    marks: dict[tuple[str, str], list[Event]] = {}
    for entry in as_kept.entries(ids):
        given_to = entry.mark.student
        told_of = _of_mark(entry, called, "" if given_to == student else given_to)
        marks.setdefault((given_to, entry.mark.quantity), []).append(told_of)
    given = [tuple(_of_waiver(one, student) for one in waived.get(id_, ())) for id_ in ids]
    return _by_time(
        regraded,
        *_of_attempts(attempts, numbers, batches, changed),
        *marks.values(),
        published,
        *given,
        withdrawn,
    )


def _by_time(*series: Sequence[Event]) -> tuple[Event, ...]:
    """Put events in order of time, and those of one series always as they were kept.

    Of a series the last one counts, also where the clock was set back before it.
    """
    placed: list[tuple[datetime, Event]] = []
    for events in series:
        times = accumulate((one.at for one in events), max)
        placed += zip(times, events, strict=True)
    return tuple(one for _, one in sorted(placed, key=lambda pair: pair[0]))


def what_counts(place: str, student: str, context: GradingContext) -> Message | None:
    """Say which work of a student counts, and what lateness leaves of its points.

    Args:
        place: of the gradebook: a path or a database URL.
        student: id.
        context: of the course, by whose policy and deadlines of today it is counted.

    Returns:
        The sentence; None where no rule asks for one, or where nothing was judged.

    Raises:
        GradebookError: there is no gradebook, or it cannot be used.
        TableError: the table of deadlines cannot be used.
    """
    counted = works_that_count(place, {student}, context).get(student)
    if counted is None or counted.timing is None:
        return None
    number, earned, sums = counted.timing.number, counted.earned, counted.sums
    points, most = round(earned, _DECIMALS), round(sums.max_score, _DECIMALS)
    if earned == sums.score:
        return message(
            "What counts today: attempt {number}, {points} of {most} points.",
            number=number,
            points=points,
            most=most,
        )
    return message(
        "What counts today: attempt {number}, {points} of {most} points; before lateness (days"
        " late: {days}) {before}.",
        number=number,
        points=points,
        most=most,
        days=counted.timing.days_late,
        before=round(sums.score, _DECIMALS),
    )


def _of_waiver(waiver: Waiver, student: str) -> Event:
    if waiver.withdrawn:
        what = message("The waiver was withdrawn: lateness is counted.")
    elif waiver.until is None:
        what = message("Lateness is not counted.")
    else:
        until = f"{waiver.until:%Y-%m-%d %H:%M}Z"
        what = message("Lateness is not counted until {until}.", until=until)
    if waiver.student != student:
        what = message("{event} (Given to {student}.)", event=what, student=waiver.student)
    return Event(waiver.done_at, waiver.person, what, waiver.why)


def _of_withdrawals(student: str, withdrawals: Iterable[Withdrawal]) -> Iterator[Event]:
    """Yield where a student was withdrawn, joined with another, or another with this one."""
    standing: dict[str, str] = {}
    for one in withdrawals:
        same_as = standing.pop(one.student, "") if one.undone else one.same_as
        standing[one.student] = one.same_as
        if student not in {one.student, same_as}:
            continue
        if same_as and one.undone:
            what = message("{student} and {person} are two again.",
                           student=one.student, person=same_as)  # fmt: skip
        elif same_as:
            what = message("{student} was joined with {person}: works of both are those of"
                           " {person}.", student=one.student, person=same_as)  # fmt: skip
        elif one.undone:
            what = message("In the course again.")
        else:
            what = message("Left the course.")
        yield Event(one.at, one.person, what, one.why)


def versions_text(attempt: Attempt) -> str:
    """Write what graded an attempt: the first digits of each fingerprint."""
    used = attempt.fingerprints
    return "/".join(one[:7] or "—" for one in (used.engine, used.course, used.policy))


def _numbers(
    attempts: Sequence[Attempt], taken: Mapping[tuple[str, str], int]
) -> Mapping[tuple[str, int], int]:
    """Return the number that reports give to the work, by the key of each attempt."""
    works = [one for found in works_of(attempts, taken).values() for one in in_order(found)]
    of_work = {one.digest: number for number, one in enumerate(works, start=1)}
    return {one.key: of_work[one.digest] for one in attempts}


def _of_attempts(
    attempts: Sequence[Attempt],
    numbers: Mapping[tuple[str, int], int],
    batches: Mapping[datetime, GradedBatch],
    changed: Mapping[tuple[str, int], Sequence[PolicyLine]],
) -> Iterable[Sequence[Event]]:
    """Tell what was found of each work at first, and each time when it was graded otherwise.

    Returns:
        A series for each id under which works are kept.
    """
    known: set[str] = set()
    found: dict[str, list[Event]] = {}
    for one in attempts:
        batch = batches.get(one.graded_at)
        person, why = ("", "") if batch is None else (batch.by, batch.why)
        what = message(
            "{work}, {file}: {result}",
            work=_work(one, numbers[one.key], is_known=one.digest in known),
            file=" ".join(_parts(one)),
            result=_result(one),
        )
        known.add(one.digest)
        what = changed_since_said(what, changed.get(one.key, ()))
        if one.kept_as:
            what = message("{event} (As {student}.)", event=what, student=one.kept_as)
        found.setdefault(one.kept_as, []).append(Event(one.graded_at, person, what, why))
    return found.values()


def _work(attempt: Attempt, number: int, *, is_known: bool) -> Message:
    if attempt.regrade is not None:
        regrade = attempt.regrade
        return message("Attempt {number} in regrade {regrade}", number=number, regrade=regrade)
    if is_known:
        return message("Attempt {number} graded again", number=number)
    return message("Attempt {number}", number=number)


def _result(attempt: Attempt) -> Message:
    if not attempt.judged:
        return message("not judged.")
    sums = points_of(attempt.results, {})
    return message(
        "Points by the program: {points} of {most}.",
        points=round(sums.score, _DECIMALS),
        most=round(sums.max_score, _DECIMALS),
    )


def _parts(attempt: Attempt) -> Iterator[str]:
    yield shown(attempt.file)
    # Of what was issued, where it was issued anew: `v2` judged it, `v2*` as the better of several.
    version = f"; v{attempt.version}" if attempt.version > 1 or attempt.either_version else ""
    chosen = "*" if attempt.either_version else ""
    yield f"({attempt.digest[:7]}; {versions_text(attempt)}{version}{chosen})"


def _of_mark(entry: GradebookEntry, called: Callable[[str], str], given_to: str) -> Event:
    """Tell of a mark; `given_to` is the id that it was given to, where another one is asked of."""
    mark = entry.mark
    item = called(mark.quantity)
    if mark.credit is None:
        what = message("{item}: withdrawn.", item=item)
    else:
        result = entry.attempt.by_quantity.get(mark.quantity)
        possible = result.max_points if result else 0.0
        what = message(
            "{item}: points {points} of {most}.",
            item=item,
            points=round(mark.credit * possible, _DECIMALS),
            most=round(possible, _DECIMALS),
        )
    if given_to:
        what = message("{event} (Given to {student}.)", event=what, student=given_to)
    return Event(mark.marked_at, mark.marker, what, mark.comment)
