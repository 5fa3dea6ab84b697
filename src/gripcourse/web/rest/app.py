"""The part of the application that programs ask; see `declare` for what there is."""

from collections.abc import Awaitable, Callable, Mapping
from contextlib import ExitStack
from itertools import groupby
from typing import Any, Final

from anyio import to_thread
from starlette.applications import Starlette
from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import FileResponse, JSONResponse, Response
from starlette.routing import Route

from gripcourse.access.desk.links import Refused
from gripcourse.exports.plain import to_plain
from gripcourse.text.words import Words, message
from gripcourse.usecases.serving.links import open_link, signed_for
from gripcourse.variants.model import Issued
from gripcourse.web.downloads import zip_response
from gripcourse.web.faults import fault_handlers
from gripcourse.web.pages import asked_language, remember_visitor, visitor_words
from gripcourse.web.rates import REFUSED_LINKS
from gripcourse.web.refusals import (
    LINK_SAID,
    SIGN_IN,
    TOO_MANY_AT_ONCE,
    Code,
    WebRefusal,
)
from gripcourse.web.rest.bodies import read_body, usable
from gripcourse.web.rest.declare import (
    ApiOperation,
    DeskCall,
    SentFile,
    SentZip,
    StudentCall,
    TokenRole,
)
from gripcourse.web.rest.desk import DESK_OPERATIONS
from gripcourse.web.rest.downloads import DOWNLOAD_OPERATIONS
from gripcourse.web.rest.marking import MARKING_OPERATIONS
from gripcourse.web.rest.openapi import description
from gripcourse.web.rest.problems import NotUsable, problem
from gripcourse.web.rest.student import STUDENT_OPERATIONS
from gripcourse.web.rest.work import WORK_OPERATIONS
from gripcourse.web.site import Site
from gripcourse.web.uploads import address_of, count

REST: Final = "/api/v1"
OPERATIONS: Final = (
    *STUDENT_OPERATIONS,
    *DESK_OPERATIONS,
    *WORK_OPERATIONS,
    *MARKING_OPERATIONS,
    *DOWNLOAD_OPERATIONS,
)
_NO_TOKEN: Final = WebRefusal(
    Code.NO_TOKEN, message("Send the token that you were given: Authorization: Bearer …")
)
_CODES: Final = {
    Refused.FORGED: Code.LINK_FORGED,
    Refused.EXPIRED: Code.LINK_EXPIRED,
    Refused.REVOKED: Code.LINK_REVOKED,
}


def rest_app(site: Site) -> Starlette:
    """Make what stands below `/api/v1`."""

    async def described(_: Request) -> Response:
        return JSONResponse(description(OPERATIONS, REST))

    def said(request: Request, why: WebRefusal) -> Response:
        return problem(why, visitor_words(site, request))

    routes = [Route("/openapi.json", described, methods=["GET"])]
    for path, same in groupby(OPERATIONS, key=lambda one: one.path):
        by_method = {one.method: one for one in same}
        routes.append(Route(path, _endpoint(site, by_method), methods=list(by_method)))
    app = Starlette(routes=routes, exception_handlers=fault_handlers(said))
    app.router.redirect_slashes = False
    return app


def _endpoint(
    site: Site, by_method: Mapping[str, ApiOperation]
) -> Callable[[Request], Awaitable[Response]]:
    async def endpoint(request: Request) -> Response:
        operation = by_method["GET" if request.method == "HEAD" else request.method]
        with ExitStack() as while_answering:
            call = await _call(site, operation, request, while_answering)
            if isinstance(call, WebRefusal | NotUsable):
                return problem(call, visitor_words(site, request))
            limiter = site.waiting if operation.waits else None
            made = await to_thread.run_sync(operation.answer, call, limiter=limiter)
        return _response(operation, made, call.words)

    return endpoint


async def _call(
    site: Site, operation: ApiOperation, request: Request, while_answering: ExitStack
) -> StudentCall | DeskCall | WebRefusal | NotUsable:
    """Find out who asks, and only then read what was sent."""
    scheme, _, token = request.headers.get("authorization", "").partition(" ")
    if scheme.lower() != "bearer" or not token.strip():
        return _NO_TOKEN
    if operation.role is TokenRole.STUDENT:
        return await _student_call(site, operation, request, token.strip(), while_answering)
    return await _desk_call(site, operation, request, token.strip())


async def _student_call(
    site: Site,
    operation: ApiOperation,
    request: Request,
    token: str,
    while_answering: ExitStack,
) -> StudentCall | WebRefusal | NotUsable:
    issued = await run_in_threadpool(open_link, site.context, token, site.clock())
    if isinstance(issued, Refused):
        owner = await run_in_threadpool(signed_for, site.context, token)
        if owner is not None:
            remember_visitor(request, _words(site, request, owner))
        count(site, REFUSED_LINKS, address_of(request))
        return WebRefusal(_CODES[issued], LINK_SAID[issued])
    words = _words(site, request, issued)
    remember_visitor(request, words)
    sends = operation.takes is not None
    if sends and not while_answering.enter_context(site.uploads.one_more(issued.student.id)):
        return TOO_MANY_AT_ONCE
    body = await read_body(operation, request)
    if isinstance(body, WebRefusal | NotUsable):
        return body
    return StudentCall(site, request, words, issued, body)


def _words(site: Site, request: Request, issued: Issued) -> Words:
    """Return the language that a student's program asks for, else the student's own."""
    language = asked_language(request) or issued.student.language or site.context.course.language
    return Words(language)


async def _desk_call(
    site: Site, operation: ApiOperation, request: Request, token: str
) -> DeskCall | WebRefusal | NotUsable:
    name = ""
    if operation.role is TokenRole.INSTRUCTOR:
        desk = site.context.desk
        known = await run_in_threadpool(desk.session_name, token, site.clock())
        if known is None:
            return SIGN_IN
        name = known
    query: Any = None
    if operation.searches is not None:
        query = usable(operation.searches, dict(request.query_params))
    body = await read_body(operation, request)
    for sent in (query, body):
        if isinstance(sent, WebRefusal | NotUsable):
            return sent
    return DeskCall(site, request, visitor_words(site, request), token, name, query, body)


def _response(operation: ApiOperation, made: object, words: Words) -> Response:
    if isinstance(made, WebRefusal | NotUsable):
        return problem(made, words)
    # What is described is what is sent: a declaration that lies is our mistake.
    if not isinstance(made, operation.gives):
        raise TypeError(operation.path)
    if made is None:
        return Response(status_code=operation.status)
    if isinstance(made, SentFile):
        return FileResponse(made.path, media_type=operation.media, filename=made.name)
    if isinstance(made, SentZip):
        return zip_response(made.name, made.files)
    headers = {"Content-Language": words.language}
    return JSONResponse(to_plain(made), operation.status, headers)
