"""What a student's program asks: the same as the student's page shows."""

from collections.abc import Callable
from http import HTTPStatus
from pathlib import Path
from typing import Final

from gripcourse.access.desk.model import HandIn, RegradeRequest
from gripcourse.api.results import CheckResult
from gripcourse.course.quantity import Quantity
from gripcourse.machine.content import NamedBytes
from gripcourse.policy.model import Tells
from gripcourse.solver.plan import plan_of
from gripcourse.text.units import unit_text
from gripcourse.text.words import Words
from gripcourse.usecases.issuing.handout import sheet_path, workbook_path
from gripcourse.usecases.publishing.publish import published_to
from gripcourse.usecases.serving.desk import DeskContext
from gripcourse.usecases.serving.hand_in import Receipt, kept_path, receipt_of
from gripcourse.usecases.serving.taken import hand_ins_of
from gripcourse.variants.model import Issued
from gripcourse.web import acts
from gripcourse.web.refusals import NOT_FOUND, NOT_PUBLISHED, Code, WebRefusal
from gripcourse.web.rest.declare import ApiOperation, SentFile, StudentCall, TokenRole
from gripcourse.web.rest.results import (
    GivenResult,
    ItemPointsResult,
    PublishedResult,
    ReceiptResult,
    RequestResult,
    StatusResult,
)
from gripcourse.web.rest.wishes import RegradeWish

PDF: Final = "application/pdf"
BINARY: Final = "application/octet-stream"


def status(call: StudentCall) -> StatusResult:
    """Your assignment, its deadline, how many checks are left and what was handed in."""
    site, issued, words = call.site, call.issued, call.words
    context, rule = site.context, site.context.policy.check
    plan = plan_of(context.course, issued.variant.composition)
    deadline = context.deadlines.of(issued)
    return StatusResult(
        course=context.course.title.of(words.language),
        student=issued.student.id,
        name=issued.student.name,
        group=issued.student.group,
        variant=issued.variant.id,
        scheme=plan.scheme.title.of(words.language),
        task=plan.scheme.task.of(words.language),
        deadline=None if deadline is None else deadline.date(),
        given=tuple(_given(one, issued.variant.given[one.id], words) for one in plan.givens),
        compares=rule.tells is not Tells.READING,
        checks_left=acts.checks_left(site, call.student),
        checks_most=rule.times,
        hand_ins=tuple(
            receipt_result(receipt_of(context, issued, one))
            for one in hand_ins_of(context.desk, call.student, context.joins())
        ),
        published=published_to(context, call.student) is not None,
    )


def check(call: StudentCall) -> CheckResult | WebRefusal:
    """Check a workbook: how each answer is read, never whether it is right."""
    return acts.check(call.site, call.student, call.body, call.words)


def hand_in(call: StudentCall) -> ReceiptResult | WebRefusal:
    """Hand a file in; the same file right after is the same hand-in."""
    made = acts.keep_file(call.site, call.issued, call.body)
    return made if isinstance(made, WebRefusal) else receipt_result(made)


def receipt(call: StudentCall) -> ReceiptResult | WebRefusal:
    """The receipt of a file, the same whenever it is asked for."""
    kept = _kept(call)
    if kept is None:
        return NOT_FOUND
    return receipt_result(receipt_of(call.site.context, call.issued, kept))


def own_file(call: StudentCall) -> SentFile | WebRefusal:
    """A file as it was handed in."""
    kept = _kept(call)
    if kept is None:
        return NOT_FOUND
    return SentFile(kept_path(call.site.context, kept.digest), kept.name)


def sheet(call: StudentCall) -> SentFile | WebRefusal:
    """The assignment sheet."""
    return _issued(call, sheet_path)


def workbook(call: StudentCall) -> SentFile | WebRefusal:
    """The answer workbook as it was issued."""
    return _issued(call, workbook_path)


def results(call: StudentCall) -> PublishedResult | WebRefusal:
    """Your points, when they are published."""
    return published_result(call.site.context, call.issued, call.words) or NOT_PUBLISHED


def report(call: StudentCall) -> SentFile | WebRefusal:
    """The printed report, when results are published."""
    published = published_to(call.site.context, call.student)
    if published is None or published.pdf is None:
        return NOT_PUBLISHED
    return SentFile(published.pdf, published.pdf.name)


def ask_again(call: StudentCall) -> RequestResult | WebRefusal:
    """Ask for an answer of the published results to be looked at again."""
    wish: RegradeWish = call.body
    made = acts.ask_again(call.site, call.student, wish.item, wish.sentence)
    return made if isinstance(made, WebRefusal) else request_result(made)


def _kept(call: StudentCall) -> HandIn | None:
    request = call.request
    number, of = int(request.path_params["number"]), request.query_params.get("of", "")
    return acts.kept_file(call.site, call.student, number, of)


def receipt_result(made: Receipt) -> ReceiptResult:
    """Return a receipt as programs get it."""
    one = made.hand_in
    return ReceiptResult(
        student=one.student,
        number=one.number,
        name=one.name,
        size=one.size,
        digest=one.digest,
        received=one.at,
        late=made.late,
        workbook=made.is_workbook,
        code=made.code,
    )


def request_result(made: RegradeRequest) -> RequestResult:
    """Return a request as programs get it."""
    return RequestResult(made.student, made.item, made.sentence, made.at)


def published_result(context: DeskContext, issued: Issued, words: Words) -> PublishedResult | None:
    """Return what a student sees of the results; numbers of the reference stay in the report."""
    student = issued.student.id
    published = published_to(context, student)
    if published is None:
        return None
    plan = plan_of(context.course, issued.variant.composition)
    titles = {one.id: one.title.of(words.language) for one in plan.asked}
    told = published.report
    return PublishedResult(
        student=student,
        judged=told.judged,
        score=told.score,
        max_score=told.max_score,
        open_points=told.open_points,
        items=tuple(
            ItemPointsResult(
                one.quantity, titles.get(one.quantity, one.quantity), one.points, one.max_points
            )
            for one in told.findings
        ),
        report=published.pdf is not None,
        requests=tuple(request_result(one) for one in context.desk.requests(student)),
        earned=told.points_that_count if told.judged else None,
    )


def _given(quantity: Quantity, value: float, words: Words) -> GivenResult:
    return GivenResult(
        quantity=quantity.id,
        symbol=quantity.symbol.of(words.language),
        title=quantity.title.of(words.language),
        value=value,
        unit=unit_text(quantity.unit, words.language),
    )


def _issued(call: StudentCall, place: Callable[[Path, str], Path]) -> SentFile | WebRefusal:
    if call.site.assignments is None:
        return NOT_FOUND
    path = place(call.site.assignments, call.student)
    return SentFile(path, path.name) if path.is_file() else NOT_FOUND


_STUDENT: Final = TokenRole.STUDENT
STUDENT_OPERATIONS: Final = (
    ApiOperation("GET", "/status", _STUDENT, status, StatusResult),
    ApiOperation("GET", "/assignment.pdf", _STUDENT, sheet, SentFile, media=PDF),
    ApiOperation("GET", "/workbook.xlsx", _STUDENT, workbook, SentFile, media=BINARY),
    ApiOperation(
        *("POST", "/checks", _STUDENT, check, CheckResult),
        takes=NamedBytes,
        refuses=(Code.BEYOND_LIMITS,),
        waits=True,
    ),
    ApiOperation(
        *("POST", "/hand-ins", _STUDENT, hand_in, ReceiptResult),
        takes=NamedBytes,
        refuses=(Code.FILE_NOT_KEPT,),
        status=HTTPStatus.CREATED,
    ),
    ApiOperation("GET", "/hand-ins/{number:int}", _STUDENT, receipt, ReceiptResult),
    ApiOperation("GET", "/hand-ins/{number:int}/file", _STUDENT, own_file, SentFile, media=BINARY),
    ApiOperation(
        *("GET", "/results", _STUDENT, results, PublishedResult),
        refuses=(Code.NOT_PUBLISHED,),
    ),
    ApiOperation(
        *("GET", "/results/report.pdf", _STUDENT, report, SentFile),
        refuses=(Code.NOT_PUBLISHED,),
        media=PDF,
    ),
    ApiOperation(
        *("POST", "/requests", _STUDENT, ask_again, RequestResult),
        takes=RegradeWish,
        refuses=(Code.NOT_FOUND, Code.NO_SENTENCE),
        status=HTTPStatus.CREATED,
    ),
)
