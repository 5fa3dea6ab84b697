"""The instructor's desk: the group, a student's history, downloads, publishing."""

from http import HTTPStatus
from typing import Final

from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import FileResponse, RedirectResponse, Response
from starlette.routing import Route

from gripcourse.gradebook.store import Gradebook
from gripcourse.text.words import message
from gripcourse.usecases.publishing.publish import current, published_grades, published_to
from gripcourse.usecases.serving.hand_in import kept_path, receipt_of
from gripcourse.usecases.serving.sign_in import SESSION_HOURS, sign_in
from gripcourse.usecases.serving.taken import checks_of, hand_ins_of, requests_of
from gripcourse.web import acts
from gripcourse.web.group import (
    GroupMember,
    GroupState,
    Wish,
    groups_of,
    is_answered,
    newer_than,
    row_of,
    rows_of,
)
from gripcourse.web.overview import flags_of, titles_of
from gripcourse.web.pages import notice, page, visitor_words
from gripcourse.web.rates import REFUSED_SIGN_INS
from gripcourse.web.refusals import NOT_FOUND, SIGN_IN, WebRefusal
from gripcourse.web.seat import COOKIE, Answer, Seat, desk_route
from gripcourse.web.site import Site
from gripcourse.web.uploads import address_of, count

_BINARY: Final = "application/octet-stream"


def instructor_routes(site: Site) -> list[Route]:
    """Return the routes of the desk; all but signing in want a session."""

    def route(path: str, answer: Answer, method: str = "GET") -> Route:
        return desk_route(site, path, answer, method)

    async def offered(request: Request) -> Response:
        words = visitor_words(site, request)
        return page(site, request, "sign_in", words, {"token": request.path_params["token"]})

    async def signing_in(request: Request) -> Response:
        token = str(request.path_params["token"])
        session = await run_in_threadpool(sign_in, site.context, token, site.clock())
        if session is None:
            count(site, REFUSED_SIGN_INS, address_of(request))
            words = visitor_words(site, request)
            return notice(site, request, words, SIGN_IN.said, HTTPStatus.FORBIDDEN)
        root = str(request.scope.get("root_path", ""))
        response = RedirectResponse(f"{root}/desk/", HTTPStatus.SEE_OTHER)
        response.set_cookie(
            COOKIE,
            session,
            max_age=SESSION_HOURS * 3600,
            path=f"{root}/desk",
            secure=site.secure,
            httponly=True,
            samesite="strict",
        )
        return response

    return [
        Route("/desk/sign-in/{token}", offered, methods=["GET"], name="offered"),
        Route("/desk/sign-in/{token}", signing_in, methods=["POST"], name="signing_in"),
        route("", group),
        route("student/{student}", student),
        route("student/{student}/file/{number:int}", student_file),
        route("student/{student}/report.pdf", student_report),
        route("grades.csv", grades),
        route("publish", publishing, "POST"),
        route("withdraw", withdrawing, "POST"),
        route("sign-out", signing_out, "POST"),
    ]


def group(seat: Seat) -> Response:
    """Show everybody, or those who are looked for."""
    asked = seat.request.query_params
    state = asked.get("state", "")
    wish = Wish(
        asked.get("find", ""),
        asked.get("group", ""),
        GroupState(state) if state in list(GroupState) else GroupState.ANY,
    )
    everybody = rows_of(seat.site.context)
    batch = seat.site.batches.read(seat.site.graded)
    marks, files = (0, 0) if batch is None else newer_than(everybody, batch.at)
    values: dict[str, object] = {
        "newer": {"marks": marks, "files": files} if marks or files else None,
        "rows": [row for row in everybody if wish.meets(row)],
        "everybody": len(everybody),
        "handed_in": sum(row.hand_in is not None for row in everybody),
        "groups": groups_of(everybody),
        "wish": wish,
        "published": current(seat.site.context),
        "can_publish": seat.site.graded is not None,
        "flagged": [] if batch is None else sorted({one.student for one in batch.flagged}),
    }
    return seat.page("group", values)


def student(seat: Seat) -> Response:
    """Show what a student did, and what was found."""
    row = _row(seat)
    if row is None:
        return seat.refuse(NOT_FOUND)
    context, id_ = seat.site.context, row.issued.student.id
    book = Gradebook(context.desk.engine, context.joins())
    published = published_to(context, id_)
    values: dict[str, object] = {
        "row": row,
        "hand_ins": [
            receipt_of(context, row.issued, one)
            for one in hand_ins_of(context.desk, id_, context.joins())
        ],
        "checks": checks_of(context.desk, id_, context.joins()),
        "attempts": book.attempts({id_}),
        "results": [
            (one, seat.words.say(one.outcome.traits.word))
            for one in (() if row.work is None else row.work.attempt.results)
        ],
        "marks": [entry.mark for entry in book.entries({id_})],
        "requests": [
            (one, is_answered(one, row.marked))
            for one in requests_of(context.desk, id_, context.joins())
        ],
        "report": published is not None and published.pdf is not None,
        "flags": flags_of(seat.site, seat.words, id_),
        "titles": titles_of(context, seat.words),
    }
    return seat.page("student", values)


def student_file(seat: Seat) -> Response:
    """Send a file that a student handed in."""
    context, path = seat.site.context, seat.request.path_params
    kept = acts.kept_file(seat.site, str(path["student"]), int(path["number"]))
    if kept is None:
        return seat.refuse(NOT_FOUND)
    return FileResponse(kept_path(context, kept.digest), media_type=_BINARY, filename=kept.name)


def student_report(seat: Seat) -> Response:
    """Send the report that a student sees."""
    row = _row(seat)
    published = None if row is None else published_to(seat.site.context, row.issued.student.id)
    if published is None or published.pdf is None:
        return seat.refuse(NOT_FOUND)
    return FileResponse(published.pdf, media_type="application/pdf", filename=published.pdf.name)


def grades(seat: Seat) -> Response:
    """Send the table of grades that is published."""
    path = published_grades(seat.site.context)
    if path is None:
        return seat.refuse(NOT_FOUND)
    return FileResponse(path, media_type="text/csv", filename=path.name)


def publishing(seat: Seat) -> Response:
    """Let students see what was graded."""
    why = seat.sent.texts.get("why", "")
    return _done(seat, acts.let_see(seat.site, seat.name, why))


def withdrawing(seat: Seat) -> Response:
    """Let students see nothing any more."""
    why = seat.sent.texts.get("why", "")
    return _done(seat, acts.take_back(seat.site, seat.name, why))


def signing_out(seat: Seat) -> Response:
    """End the session."""
    seat.site.context.desk.end_session(seat.request.cookies[COOKIE], seat.site.clock())
    said = message("You are signed out.")
    response = notice(seat.site, seat.request, seat.words, said, HTTPStatus.OK)
    response.delete_cookie(COOKIE, path=f"{seat.request.scope.get('root_path', '')}/desk")
    return response


def _done(seat: Seat, made: object) -> Response:
    if isinstance(made, WebRefusal):
        return seat.refuse(made)
    return RedirectResponse(seat.home, HTTPStatus.SEE_OTHER)


def _row(seat: Seat) -> GroupMember | None:
    return row_of(seat.site.context, str(seat.request.path_params["student"]))
