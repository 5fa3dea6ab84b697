"""Published results go to the gradebook of the platform: each once, and again where it changed."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from enum import StrEnum
from typing import Final

from gripcourse.access.lti.given_access import Access, open_access
from gripcourse.access.lti.launch import LINE_ITEM_SCOPE, SCORE_SCOPE
from gripcourse.access.lti.model import Bond, PlatformPlace, SentScore
from gripcourse.access.lti.platforms import Platform
from gripcourse.access.lti.refused import PlatformFailedError, PlatformFailure
from gripcourse.access.lti.services import Score, line_item_of, send_score
from gripcourse.access.lti.store import LtiStore
from gripcourse.course.model import Course
from gripcourse.errors import Problem, UsageError
from gripcourse.exports.platforms.comment import late_lines
from gripcourse.exports.report_result import ReportResult
from gripcourse.text.words import Message, Words, message
from gripcourse.usecases.publishing.publish import current, published_to
from gripcourse.usecases.serving.desk import DeskContext
from gripcourse.usecases.serving.lti import store_of
from gripcourse.variants.model import Issued

_DECIMALS: Final = 4  # more of them are noise of the last bits, and would count as a change

_MOST_UNANSWERED: Final = 3
"""Students in a row of whom a platform does not answer; each has been waited for a minute."""

_NO_ANSWER: Final = frozenset({PlatformFailure.AWAY, PlatformFailure.BUSY})


class ScoreFate(StrEnum):
    """What became of a student's result."""

    SENT = "sent"
    UNCHANGED = "unchanged"  # the platform has it
    NO_RESULT = "no_result"  # nothing is published, or the file was not judged or counts not
    NOT_SEEN = "not_seen"  # nobody came by the platform who is this student
    FAILED = "failed"
    NOT_TRIED = "not_tried"  # the platform had stopped answering


NOT_SENT: Final = frozenset({ScoreFate.FAILED, ScoreFate.NOT_TRIED})
"""Fates after which a result is missing on the platform though it should be there."""


@dataclass(frozen=True, slots=True)
class Sending:
    """What became of a student's result.

    Attributes:
        student: id.
        fate: what became of it.
        why: it failed; else None.
        answered: whether the platform answered, where it was asked.
    """

    student: str
    fate: ScoreFate
    why: Message | None = None
    answered: bool = True


@dataclass(frozen=True, slots=True)
class ScoreOrder:
    """What an instructor wants to be sent.

    Attributes:
        line_item: address of the column; empty where there is only one.
        by: who does it.
    """

    line_item: str
    by: str


def send_grades(context: DeskContext, access: Access, wanted: ScoreOrder) -> Iterator[Sending]:
    """Send what is published and is not there yet, student by student.

    What the platform took is kept at once, so who stops this loses nothing, and the next time sends
    what is missing.

    Args:
        context: the course.
        access: to the platform; nothing is granted yet.
        wanted: what to send.

    Raises:
        UsageError: nothing is published, nobody opened the assignment there, or several columns
            are known.
        PlatformFailedError: the platform gives no access at all.
    """
    if current(context) is None:
        what, remedy = message("Nothing is published."), message("Publish the results first.")
        raise UsageError([Problem("", "", what, remedy)])
    store = store_of(context)
    column = _column(store, access.platform, wanted.line_item)
    open_access(access, [SCORE_SCOPE] if column.line_item else [SCORE_SCOPE, LINE_ITEM_SCOPE])
    address = column.line_item or _made(access, column, context)
    bonds, unanswered = _bonds(context, store, access.platform), 0
    # The same column and the same user: what was sent last is what stands there.
    last = {(one.line_item, one.user): one for one in store.sent()}
    for student, issued in context.register().items():
        published = published_to(context, student)
        score = None if published is None else score_of(published.report, issued, context.course)
        if score is None:
            yield Sending(student, ScoreFate.NO_RESULT)
            continue
        match bonds.get(student, []):
            case []:
                yield Sending(student, ScoreFate.NOT_SEEN)
            case [bond] if _is_there(last.get((address, bond.user)), score):
                yield Sending(student, ScoreFate.UNCHANGED)
            case [bond] if unanswered == _MOST_UNANSWERED:
                yield Sending(bond.student, ScoreFate.NOT_TRIED)
            case [bond]:
                done = _sent(store, access, bond, _Sent(address, score, wanted.by))
                unanswered = 0 if done.answered else unanswered + 1
                yield done
            case _:
                said = message("Several users of the platform are this student.")
                yield Sending(student, ScoreFate.FAILED, said)


def score_of(report: ReportResult, issued: Issued, course: Course) -> Score | None:
    """Return what a platform is told of a result; None for a file not judged or not counting.

    The points are those that count: the platform knows nothing of our lateness and takes nothing
    off. The comment holds points alone: whatever explains them stands on the student's own page.
    """
    counted = report.points_that_count
    if not report.judged or counted is None or report.max_score is None or report.counts is False:
        return None
    words = Words(issued.student.language or course.language)
    points = round(counted, _DECIMALS)
    maximum = report.max_score + report.open_points
    said = message(
        "Points: {points} of {maximum}. The report stands on your page.",
        points=points,
        maximum=round(maximum, _DECIMALS),
    )
    if report.open_points:
        said = message(
            "Points: {points}; {open} of {maximum} wait for a person.",
            points=points,
            open=round(report.open_points, _DECIMALS),
            maximum=round(maximum, _DECIMALS),
        )
    return Score(
        points=points,
        maximum=round(maximum, _DECIMALS),
        comment=" ".join((words.say(said), *late_lines(report, words))),
        final=not report.open_points,
    )


@dataclass(frozen=True, slots=True)
class _Sent:
    line_item: str
    score: Score
    by: str


def _sent(store: LtiStore, access: Access, bond: Bond, one: _Sent) -> Sending:
    score = one.score
    try:
        send_score(access, one.line_item, bond.user, score)
    except PlatformFailedError as fault:
        answered = fault.failure not in _NO_ANSWER
        return Sending(bond.student, ScoreFate.FAILED, fault.said, answered)
    kept = SentScore(
        issuer=bond.issuer,
        client=bond.client,
        user=bond.user,
        student=bond.student,
        line_item=one.line_item,
        points=score.points,
        maximum=score.maximum,
        comment=score.comment,
        final=score.final,
        by=one.by,
        at=access.clock(),
    )
    store.add_sent(kept)
    return Sending(bond.student, ScoreFate.SENT)


def _bonds(context: DeskContext, store: LtiStore, platform: Platform) -> dict[str, list[Bond]]:
    """Return who of a platform each student is, under whatever id that was."""
    found: dict[str, list[Bond]] = {}
    for one in store.bonds().values():
        if (one.issuer, one.client) == (platform.issuer, platform.client_id):
            issued = context.find(one.student)
            student = one.student if issued is None else issued.student.id
            found.setdefault(student, []).append(replace(one, student=student))
    return found


def _is_there(last: SentScore | None, score: Score) -> bool:
    return last is not None and score == Score(last.points, last.maximum, last.comment, last.final)


def _column(store: LtiStore, platform: Platform, line_item: str) -> PlatformPlace:
    """Return the place whose column takes the results; its line item is empty where none is made.

    Only places in courses of the platform that are declared now count: who has another course there
    must not get these results into it.
    """
    known = [
        one
        for one in store.places()
        if (one.issuer, one.client) == (platform.issuer, platform.client_id)
        and one.context in platform.contexts
        and (one.line_item or one.line_items)
    ]
    if line_item:
        known = [one for one in known if one.line_item == line_item]
    if not known:
        what = message("No place in the platform is known that takes grades.")
        remedy = message("Let grades be accepted there, and open the assignment there once.")
        raise UsageError([Problem("", "", what, remedy)])
    columns = {one.line_item or one.line_items for one in known}
    if len(columns) > 1:
        what = message("The assignment stands in several places of the platform.")
        remedy = message("Name one column: {all}.", all=", ".join(sorted(columns)))
        raise UsageError([Problem("", "", what, remedy, parameter="line_item")])
    return known[-1]


def _made(access: Access, place: PlatformPlace, context: DeskContext) -> str:
    """Return our column in a course whose columns we may make."""
    course = context.course
    label = course.title.of(course.language)
    return line_item_of(access, place.line_items, course.id, label, context.policy.total)
