"""The application: all routes, and a page for everything that goes wrong."""

import logging
import secrets
import traceback
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from http import HTTPStatus
from typing import Final

from starlette.applications import Starlette
from starlette.exceptions import HTTPException
from starlette.requests import ClientDisconnect, Request
from starlette.responses import FileResponse, Response
from starlette.routing import Route
from starlette.types import ASGIApp

from gripcourse.errors import GradebookError, system_problem
from gripcourse.machine.resources import template_file
from gripcourse.text.words import message
from gripcourse.web.guard import Guard, TooMuchError
from gripcourse.web.instructor import instructor_routes
from gripcourse.web.pages import NOT_FOUND, TOO_LARGE, TOO_OFTEN, notice, visitor_words
from gripcourse.web.site import Site
from gripcourse.web.student import student_routes

_log = logging.getLogger(__name__)

_WELCOME: Final = message("Open the personal link that you were sent.")
_SAID: Final = {
    HTTPStatus.NOT_FOUND: NOT_FOUND,
    HTTPStatus.REQUEST_ENTITY_TOO_LARGE: TOO_LARGE,
    HTTPStatus.TOO_MANY_REQUESTS: TOO_OFTEN,
}
_NO_REQUEST: Final = message("The browser sent something that cannot be used here.")
_AWAY: Final = message(
    "The course's records cannot be reached now. Try again in a minute; nothing is kept twice."
)
_GONE: Final = 499  # nobody hears it: who asked has closed the connection


def make_app(site: Site) -> ASGIApp:
    """Make the application of a server."""

    async def welcome(request: Request) -> Response:
        words = visitor_words(site, request)
        return notice(site, request, words, _WELCOME, HTTPStatus.OK)

    async def style(_: Request) -> Response:
        sheet = template_file(site.context.course.root / "templates", "style/web.css")
        headers = {"Cache-Control": "max-age=300"}
        return FileResponse(sheet, media_type="text/css", headers=headers)

    async def refused(request: Request, fault: Exception) -> Response:
        status = HTTPStatus(fault.status_code if isinstance(fault, HTTPException) else 413)
        said = _SAID.get(status, _NO_REQUEST)
        response = notice(site, request, visitor_words(site, request), said, status)
        response.headers.update(getattr(fault, "headers", None) or {})
        return response

    async def gone(_: Request, _fault: Exception) -> Response:
        return Response(status_code=_GONE)

    async def system(request: Request, fault: Exception) -> Response:
        assert isinstance(fault, OSError)  # noqa: S101 (what it is registered for)
        problem = system_problem(fault)
        _log.error("%s", problem.what)
        said = message("{what} Nothing was recorded. Try again later.", what=problem.what)
        words = visitor_words(site, request)
        return notice(site, request, words, said, HTTPStatus.SERVICE_UNAVAILABLE)

    async def away(request: Request, fault: Exception) -> Response:
        # What it says names the server, which is nobody's business here.
        _log.error("%s", fault)
        words = visitor_words(site, request)
        return notice(site, request, words, _AWAY, HTTPStatus.SERVICE_UNAVAILABLE)

    async def ours(request: Request, fault: Exception) -> Response:
        incident = secrets.token_hex(4)
        trace = "".join(traceback.format_exception(fault))
        _log.error("incident %s\n%s", incident, trace)
        said = message(
            "This is our mistake, not yours. Tell your instructor the number {number}.",
            number=incident,
        )
        words = visitor_words(site, request)
        return notice(site, request, words, said, HTTPStatus.INTERNAL_SERVER_ERROR)

    @asynccontextmanager
    async def alive(_: Starlette) -> AsyncIterator[None]:
        yield
        site.checkers.close()

    routes = [
        Route("/", welcome, methods=["GET"]),
        Route("/style.css", style, methods=["GET"]),
        *student_routes(site),
        *instructor_routes(site),
    ]
    handlers = {
        HTTPException: refused,
        TooMuchError: refused,
        ClientDisconnect: gone,
        OSError: system,
        GradebookError: away,
        Exception: ours,
    }
    return Guard(
        Starlette(routes=routes, exception_handlers=handlers, lifespan=alive), secure=site.secure
    )
