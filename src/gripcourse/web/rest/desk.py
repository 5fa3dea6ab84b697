"""What an instructor's program asks: the same as the desk shows."""

from http import HTTPStatus
from types import NoneType
from typing import Final

from gripcourse.access.desk.model import Publication
from gripcourse.gradebook.store import Gradebook
from gripcourse.usecases.publishing.publish import current, published_grades, published_to
from gripcourse.usecases.serving.hand_in import kept_path, receipt_of
from gripcourse.usecases.serving.sign_in import SESSION_HOURS, sign_in
from gripcourse.usecases.serving.taken import checks_of, hand_ins_of, requests_of
from gripcourse.web import acts
from gripcourse.web.group import GroupMember, Wish, groups_of, row_of, rows_of
from gripcourse.web.rates import REFUSED_SIGN_INS
from gripcourse.web.refusals import NOT_FOUND, NOT_PUBLISHED, SIGN_IN, Code, WebRefusal
from gripcourse.web.rest.declare import ApiOperation, DeskCall, SentFile, TokenRole
from gripcourse.web.rest.desk_results import (
    AttemptResult,
    GroupResult,
    LoggedCheckResult,
    MarkResult,
    MemberResult,
    PublicationResult,
    SessionResult,
    StudentRecordResult,
)
from gripcourse.web.rest.results import PublishedResult, RequestsResult
from gripcourse.web.rest.student import (
    BINARY,
    PDF,
    published_result,
    receipt_result,
    request_result,
)
from gripcourse.web.rest.wishes import PublishingReason
from gripcourse.web.uploads import address_of, count


def begin_session(call: DeskCall) -> SessionResult | WebRefusal:
    """Sign in by a token of `gripcourse sign-in`; each is good once."""
    site = call.site
    session = sign_in(site.context, call.token, site.clock())
    if session is None:
        count(site, REFUSED_SIGN_INS, address_of(call.request))
        return SIGN_IN
    name = site.context.desk.session_name(session, site.clock())
    return SessionResult(session, name or "", SESSION_HOURS)


def end_session(call: DeskCall) -> None:
    """Sign out."""
    call.site.context.desk.end_session(call.token, call.site.clock())


def group(call: DeskCall) -> GroupResult:
    """The group, or those who are looked for, and what is published."""
    wish: Wish = call.query
    everybody = rows_of(call.site.context)
    published = current(call.site.context)
    return GroupResult(
        everybody=len(everybody),
        handed_in=sum(row.hand_in is not None for row in everybody),
        groups=tuple(groups_of(everybody)),
        members=tuple(_member(row) for row in everybody if wish.meets(row)),
        publication=None if published is None else _publication(published),
    )


def student(call: DeskCall) -> StudentRecordResult | WebRefusal:
    """What a student did, and what was found."""
    row = row_of(call.site.context, _student(call))
    if row is None:
        return NOT_FOUND
    context, id_ = call.site.context, row.issued.student.id
    book, published = Gradebook(context.desk.engine, context.joins()), published_to(context, id_)
    return StudentRecordResult(
        member=_member(row),
        hand_ins=tuple(
            receipt_result(receipt_of(context, row.issued, one))
            for one in hand_ins_of(context.desk, id_, context.joins())
        ),
        checks=tuple(
            LoggedCheckResult(number, one.digest, one.told, one.at)
            for number, one in enumerate(checks_of(context.desk, id_, context.joins()), start=1)
        ),
        attempts=tuple(
            AttemptResult(
                number=number,
                judged=one.judged,
                points=sum(result.points for result in one.results),
                max_points=sum(result.max_points for result in one.results),
                digest=one.digest,
                at=one.graded_at,
            )
            for number, one in enumerate(book.attempts({id_}), start=1)
        ),
        marks=tuple(
            MarkResult(one.quantity, one.credit, one.marker, one.comment, one.marked_at)
            for one in (entry.mark for entry in book.entries({id_}))
        ),
        requests=tuple(
            request_result(one) for one in requests_of(context.desk, id_, context.joins())
        ),
        report=published is not None and published.pdf is not None,
    )


def student_results(call: DeskCall) -> PublishedResult | WebRefusal:
    """What a student sees of the results."""
    issued = call.site.context.register().get(_student(call))
    if issued is None:
        return NOT_FOUND
    return published_result(call.site.context, issued, call.words) or NOT_PUBLISHED


def student_report(call: DeskCall) -> SentFile | WebRefusal:
    """The report that a student sees."""
    if _student(call) not in call.site.context.register():
        return NOT_FOUND
    published = published_to(call.site.context, _student(call))
    if published is None or published.pdf is None:
        return NOT_PUBLISHED
    return SentFile(published.pdf, published.pdf.name)


def student_file(call: DeskCall) -> SentFile | WebRefusal:
    """A file that a student handed in."""
    kept = acts.kept_file(call.site, _student(call), int(call.request.path_params["number"]))
    if kept is None:
        return NOT_FOUND
    return SentFile(kept_path(call.site.context, kept.digest), kept.name)


def requests(call: DeskCall) -> RequestsResult:
    """Every answer that a student asked to be looked at again."""
    return RequestsResult(tuple(request_result(one) for one in call.site.context.desk.requests()))


def grades(call: DeskCall) -> SentFile | WebRefusal:
    """The table of grades that is published."""
    path = published_grades(call.site.context)
    return NOT_PUBLISHED if path is None else SentFile(path, path.name)


def publish(call: DeskCall) -> PublicationResult | WebRefusal:
    """Let students see what was graded last; it is kept with your name."""
    reason: PublishingReason = call.body
    made = acts.let_see(call.site, call.name, reason.why)
    return made if isinstance(made, WebRefusal) else _publication(made)


def withdraw(call: DeskCall) -> PublicationResult | WebRefusal:
    """Let students see no results any more; what was published is kept."""
    reason: PublishingReason = call.body
    made = acts.take_back(call.site, call.name, reason.why)
    return made if isinstance(made, WebRefusal) else _publication(made)


def _student(call: DeskCall) -> str:
    return str(call.request.path_params["student"])


def _publication(one: Publication) -> PublicationResult:
    return PublicationResult(one.number, one.published, one.by, one.why, one.at)


def _member(row: GroupMember) -> MemberResult:
    person = row.issued.student
    return MemberResult(
        student=person.id,
        name=person.name,
        group=person.group,
        variant=row.issued.variant.id,
        last=None if row.hand_in is None else row.hand_in.at,
        late=row.late,
        files=row.files,
        checks=row.checks,
        requests=row.requests,
        points=None if row.work is None else row.points,
        earned=None if row.work is None else row.earned,
    )


_DESK: Final = TokenRole.INSTRUCTOR
_ONE: Final = "/desk/students/{student}"
_UNPUBLISHED: Final = (Code.NOT_PUBLISHED,)
DESK_OPERATIONS: Final = (
    ApiOperation(
        *("POST", "/desk/session", TokenRole.SIGN_IN, begin_session, SessionResult),
        status=HTTPStatus.CREATED,
    ),
    ApiOperation(
        *("DELETE", "/desk/session", _DESK, end_session, NoneType), status=HTTPStatus.NO_CONTENT
    ),
    ApiOperation("GET", "/desk/group", _DESK, group, GroupResult, searches=Wish),
    ApiOperation("GET", _ONE, _DESK, student, StudentRecordResult),
    ApiOperation(
        *("GET", f"{_ONE}/results", _DESK, student_results, PublishedResult), refuses=_UNPUBLISHED
    ),
    ApiOperation(
        *("GET", f"{_ONE}/report.pdf", _DESK, student_report, SentFile),
        refuses=_UNPUBLISHED,
        media=PDF,
    ),
    ApiOperation(
        *("GET", f"{_ONE}/hand-ins/{{number:int}}/file", _DESK, student_file, SentFile),
        media=BINARY,
    ),
    ApiOperation("GET", "/desk/requests", _DESK, requests, RequestsResult),
    ApiOperation(
        *("GET", "/desk/grades.csv", _DESK, grades, SentFile),
        refuses=_UNPUBLISHED,
        media="text/csv",
    ),
    ApiOperation(
        *("POST", "/desk/publish", _DESK, publish, PublicationResult),
        takes=PublishingReason,
        refuses=(Code.NOT_FOUND, Code.CONFLICT),
        status=HTTPStatus.CREATED,
    ),
    ApiOperation(
        *("POST", "/desk/withdraw", _DESK, withdraw, PublicationResult),
        takes=PublishingReason,
        refuses=(Code.CONFLICT,),
        status=HTTPStatus.CREATED,
    ),
)
