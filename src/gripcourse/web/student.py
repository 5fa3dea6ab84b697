"""A student's pages: all below the personal link, and nothing of anybody else."""

from collections.abc import Awaitable, Callable
from dataclasses import dataclass, replace
from http import HTTPStatus
from pathlib import Path
from typing import Final, TypeAlias

from anyio import to_thread
from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import FileResponse, RedirectResponse, Response
from starlette.routing import Route

from gripcourse.access.desk.links import Refused
from gripcourse.access.desk.model import DRAWINGS, HandIn, is_drawing
from gripcourse.api.results import CheckedAnswerResult, CheckResult
from gripcourse.documents.assignment_sheet import given_data
from gripcourse.policy.model import Tells
from gripcourse.solver.plan import plan_of
from gripcourse.text.amounts import NO_BREAK_SPACE
from gripcourse.text.moments import zone_name
from gripcourse.text.units import stands_close
from gripcourse.text.words import Words, message
from gripcourse.usecases.issuing.handout import sheet_path, workbook_path
from gripcourse.usecases.publishing.publish import ShownResult, published_to
from gripcourse.usecases.serving.counted import which_counts
from gripcourse.usecases.serving.hand_in import is_late, kept_path, receipt_of
from gripcourse.usecases.serving.links import open_link, signed_for
from gripcourse.usecases.serving.taken import hand_ins_of, requests_of
from gripcourse.variants.model import Issued
from gripcourse.web import acts
from gripcourse.web.pages import (
    hour_of,
    notice,
    page,
    remember_visitor,
    student_words,
    visitor_words,
)
from gripcourse.web.rates import REFUSED_LINKS
from gripcourse.web.refusals import (
    LINK_SAID,
    NO_FILE,
    NOT_FOUND,
    TOO_MANY_AT_ONCE,
    Code,
    WebRefusal,
)
from gripcourse.web.site import Site
from gripcourse.web.uploads import Sent, address_of, count, read_form

_REFUSED_STATUS: Final = {
    Refused.FORGED: HTTPStatus.NOT_FOUND,
    Refused.EXPIRED: HTTPStatus.GONE,
    Refused.REVOKED: HTTPStatus.GONE,
}
_NOTHING_TO_CHECK: Final = WebRefusal(
    Code.NOT_USABLE, message("This is a drawing, and a person looks at it: hand it in.")
)
_FIGURES: Final = 7  # of a number that was understood
_BINARY: Final = "application/octet-stream"


@dataclass(frozen=True, slots=True)
class Visit:
    """Somebody at a personal link.

    Attributes:
        site: the server.
        request: what is asked.
        issued: the student whose link it is, with what was issued.
        sent: the form that came; empty where only a page is asked for.
    """

    site: Site
    request: Request
    issued: Issued
    sent: Sent

    @property
    def student(self) -> str:
        """The student's id."""
        return self.issued.student.id

    @property
    def words(self) -> Words:
        """The student's language."""
        return student_words(self.site, self.issued)

    @property
    def home(self) -> str:
        """The path of the student's page."""
        root = str(self.request.scope.get("root_path", ""))
        return f"{root}/s/{self.request.path_params['token']}/"

    def refuse(self, why: WebRefusal) -> Response:
        """Say why something is not done, with a way back."""
        return notice(self.site, self.request, self.words, why.said, why.status, self.home)


Answer: TypeAlias = Callable[[Visit], Response]


def student_routes(site: Site) -> list[Route]:
    """Return the routes of students; each of them opens the link first."""

    def route(path: str, answer: Answer, method: str = "GET") -> Route:
        endpoint = _opened(site, answer)
        return Route(f"/s/{{token}}/{path}", endpoint, methods=[method], name=answer.__name__)

    return [
        route("", home),
        route("assignment.pdf", sheet),
        route("workbook.xlsx", workbook),
        route("check", check, "POST"),
        route("hand-in", handed_in, "POST"),
        route("receipt/{number:int}", receipt),
        route("file/{number:int}", own_file),
        route("report.pdf", report),
        route("request", regrade_request, "POST"),
    ]


def _opened(site: Site, answer: Answer) -> Callable[[Request], Awaitable[Response]]:
    async def endpoint(request: Request) -> Response:
        token = str(request.path_params["token"])
        issued = await run_in_threadpool(open_link, site.context, token, site.clock())
        if isinstance(issued, Refused):
            owner = await run_in_threadpool(signed_for, site.context, token)
            if owner is not None:
                remember_visitor(request, student_words(site, owner))
            count(site, REFUSED_LINKS, address_of(request))
            words, status = visitor_words(site, request), _REFUSED_STATUS[issued]
            return notice(site, request, words, LINK_SAID[issued], status)
        visit = Visit(site, request, issued, Sent({}, None))
        remember_visitor(request, visit.words, visit.home)
        if request.method != "POST":
            return await run_in_threadpool(answer, visit)
        with site.uploads.one_more(visit.student) as taken:
            if not taken:
                return visit.refuse(TOO_MANY_AT_ONCE)
            visit = replace(visit, sent=await read_form(request))
            # Checks wait for workers, which must not take the threads of those who hand in.
            limiter = site.waiting if answer is check else None
            return await to_thread.run_sync(answer, visit, limiter=limiter)

    return endpoint


def home(visit: Visit) -> Response:
    """Show the assignment, what was handed in, and the results where they are published."""
    context, issued, words = visit.site.context, visit.issued, visit.words
    plan = plan_of(context.course, issued.variant.composition)
    titles = {one.id: one.title.of(words.language) for one in plan.asked}
    published = published_to(context, visit.student)
    rule, deadline = context.policy.check, context.deadlines.of(issued)
    values: dict[str, object] = {
        "home": visit.home,
        "student": issued.student,
        "variant": issued.variant.id,
        "scheme": plan.scheme.title.of(words.language),
        "task": plan.scheme.task.of(words.language),
        "deadline": None if deadline is None else deadline.date(),
        "until": hour_of(deadline, words),
        "clock": zone_name(context.zone),
        "data": given_data(plan.givens, issued.variant.given, words),
        "over": is_late(context, issued, visit.site.clock()),
        "drawings": sorted(DRAWINGS) if plan.manual else (),
        "sheet": _issued_file(visit, sheet_path) is not None,
        "workbook": _issued_file(visit, workbook_path) is not None,
        "compares": rule.tells is not Tells.READING,
        "left": acts.checks_left(visit.site, visit.student),
        "times": rule.times,
        "hand_ins": hand_ins_of(context.desk, visit.student, context.joins()),
        "which_counts": words.say(which_counts(context.policy.attempts)),
        "published": None if published is None else _results(published, titles),
        "requests": [
            (titles.get(one.item, one.item), one.sentence, one.at)
            for one in requests_of(context.desk, visit.student, context.joins())
        ],
    }
    return page(visit.site, visit.request, "assignment", words, values)


def _results(published: ShownResult, titles: dict[str, str]) -> dict[str, object]:
    """Return what the page shows of results; numbers of the reference stay in the report."""
    report = published.report
    return {
        "judged": report.judged,
        "counts": report.points_that_count,
        "score": report.score,
        "late": report.points_lost > 0,
        "max_score": report.max_score,
        "open_points": report.open_points,
        "printed": published.pdf is not None,
        "items": [
            (
                one.quantity,
                titles.get(one.quantity, one.quantity),
                None if one.is_open else one.points,
                one.max_points,
            )
            for one in report.findings
        ],
    }


def sheet(visit: Visit) -> Response:
    """Send the assignment sheet."""
    return _sent(visit, _issued_file(visit, sheet_path), "application/pdf")


def workbook(visit: Visit) -> Response:
    """Send the answer workbook as it was issued."""
    return _sent(visit, _issued_file(visit, workbook_path), _BINARY)


def check(visit: Visit) -> Response:
    """Say how a workbook is read, and by policy whether its numbers fit."""
    words, file = visit.words, visit.sent.file
    if file is not None and is_drawing(file.name):
        return visit.refuse(_NOTHING_TO_CHECK)
    result = acts.check(visit.site, visit.student, file, words)
    if isinstance(result, WebRefusal) or file is None:
        return visit.refuse(result if isinstance(result, WebRefusal) else NO_FILE)
    values: dict[str, object] = {
        "home": visit.home,
        "file": file.name,
        "result": _understood(result, words),
        "counts": _counts(result),
        "left": result.left,
        "times": visit.site.context.policy.check.times,
    }
    return page(visit.site, visit.request, "checked", words, values)


def _understood(result: CheckResult, words: Words) -> dict[str, object]:
    """Return what the page shows of a check, with numbers as the reader writes them."""
    return {
        "refusal": result.refusal,
        "remarks": result.remarks,
        "sections": result.sections,
        "answers": [(one, _value(one, words)) for one in result.answers],
    }


def _value(answer: CheckedAnswerResult, words: Words) -> str:
    """Return what was understood; empty for nothing."""
    if answer.value is None:
        return ""
    if answer.verdict:
        return words.say(message("yes") if answer.value else message("no"))
    joint = "" if stands_close(answer.unit) else NO_BREAK_SPACE
    return f"{words.number(answer.value, _FIGURES)}{joint}{answer.unit}"


def _counts(result: CheckResult) -> dict[str, int]:
    states = [one.state.value for one in result.answers]
    blank, unreadable = states.count("blank"), states.count("unreadable")
    doubtful = states.count("wrong_unit") + states.count("implausible")
    read = len(states) - blank - unreadable - doubtful
    return {"read": read, "doubtful": doubtful, "unreadable": unreadable, "blank": blank}


def handed_in(visit: Visit) -> Response:
    """Keep a file; the receipt is shown when it is safe."""
    made = acts.keep_file(visit.site, visit.issued, visit.sent.file)
    if isinstance(made, WebRefusal):
        return visit.refuse(made)
    number = made.hand_in.number
    return RedirectResponse(f"{visit.home}receipt/{number}", HTTPStatus.SEE_OTHER)


def receipt(visit: Visit) -> Response:
    """Show the receipt of a file."""
    kept = _kept(visit)
    if kept is None:
        return visit.refuse(NOT_FOUND)
    made = receipt_of(visit.site.context, visit.issued, kept)
    values: dict[str, object] = {
        "home": visit.home,
        "student": visit.issued.student,
        "variant": visit.issued.variant.id,
        "receipt": made,
        "of": "" if kept.student == visit.student else kept.student,
        "clock": zone_name(visit.site.context.zone),
    }
    return page(visit.site, visit.request, "receipt", visit.words, values)


def own_file(visit: Visit) -> Response:
    """Send back a file as it was handed in."""
    kept = _kept(visit)
    if kept is None:
        return visit.refuse(NOT_FOUND)
    return FileResponse(
        kept_path(visit.site.context, kept.digest), media_type=_BINARY, filename=kept.name
    )


def report(visit: Visit) -> Response:
    """Send the printed report where results are published."""
    published = published_to(visit.site.context, visit.student)
    return _sent(visit, None if published is None else published.pdf, "application/pdf")


def regrade_request(visit: Visit) -> Response:
    """Keep that the student asks for an item to be looked at again."""
    texts = visit.sent.texts
    item, sentence = texts.get("item", ""), texts.get("sentence", "")
    made = acts.ask_again(visit.site, visit.student, item, sentence)
    if isinstance(made, WebRefusal):
        return visit.refuse(made)
    return RedirectResponse(f"{visit.home}#requests", HTTPStatus.SEE_OTHER)


def _kept(visit: Visit) -> HandIn | None:
    number, of = visit.request.path_params["number"], visit.request.query_params.get("of", "")
    return acts.kept_file(visit.site, visit.student, int(number), of)


def _issued_file(visit: Visit, place: Callable[[Path, str], Path]) -> Path | None:
    if visit.site.assignments is None:
        return None
    path = place(visit.site.assignments, visit.student)
    return path if path.is_file() else None


def _sent(visit: Visit, path: Path | None, kind: str) -> Response:
    if path is None:
        return visit.refuse(NOT_FOUND)
    return FileResponse(path, media_type=kind, filename=path.name)
