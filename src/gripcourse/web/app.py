"""The application: all routes, and a page for everything that goes wrong."""

from collections.abc import AsyncIterator, Sequence
from contextlib import asynccontextmanager
from http import HTTPStatus
from typing import Final

from starlette.applications import Starlette
from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import FileResponse, RedirectResponse, Response
from starlette.routing import Mount, Route
from starlette.types import ASGIApp, Receive, Scope, Send

from gripcourse.machine.resources import template_file
from gripcourse.text.words import message
from gripcourse.web.downloads import download_routes
from gripcourse.web.drawings import drawing_routes
from gripcourse.web.faults import fault_handlers
from gripcourse.web.guard import Guard
from gripcourse.web.instructor import instructor_routes
from gripcourse.web.marking import marking_routes
from gripcourse.web.overview import overview_routes
from gripcourse.web.pages import notice, visitor_words, way_back
from gripcourse.web.refusals import WebRefusal
from gripcourse.web.regrading import regrading_routes
from gripcourse.web.rest.app import REST, rest_app
from gripcourse.web.site import Site
from gripcourse.web.student import student_routes

_WELCOME: Final = message("Open the personal link that you were sent.")


def make_app(site: Site, further: Sequence[Route] = ()) -> ASGIApp:
    """Make the application of a server.

    Args:
        site: what its pages are made from.
        further: routes beside those that every server has.
    """

    async def welcome(request: Request) -> Response:
        words = visitor_words(site, request)
        return notice(site, request, words, _WELCOME, HTTPStatus.OK)

    async def style(_: Request) -> Response:
        sheet = template_file(site.context.course.root / "templates", "style/web.css")
        headers = {"Cache-Control": "max-age=300"}
        return FileResponse(sheet, media_type="text/css", headers=headers)

    async def with_its_end(request: Request) -> Response:
        # Below our own path, not at the host that a request names: a proxy that ends https may not
        # be believed as to what browsers see, and a link would go on in the open.
        return RedirectResponse(f"{request.scope['path']}/", HTTPStatus.PERMANENT_REDIRECT)

    def said(request: Request, why: WebRefusal) -> Response:
        words, back = visitor_words(site, request), way_back(request)
        return notice(site, request, words, why.said, why.status, back)

    @asynccontextmanager
    async def alive(_: Starlette) -> AsyncIterator[None]:
        yield
        site.own_batch.close()
        site.checkers.close()

    routes = [
        Route("/", welcome, methods=["GET"]),
        Route("/style.css", style, methods=["GET"]),
        *(Route(path, with_its_end, methods=["GET"]) for path in ("/s/{token}", "/desk")),
        *student_routes(site),
        *instructor_routes(site),
        *marking_routes(site),
        *regrading_routes(site),
        *drawing_routes(site),
        *overview_routes(site),
        *download_routes(site),
        Mount(REST, rest_app(site)),
        *further,
    ]
    app = Starlette(routes=routes, exception_handlers=fault_handlers(said), lifespan=alive)
    app.router.redirect_slashes = False
    return Guard(_following(app, site), secure=site.secure)


def _following(app: ASGIApp, site: Site) -> ASGIApp:
    """Let every request be answered by the course as its files say now."""

    async def followed(scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] == "http" and site.living.is_due:
            await run_in_threadpool(site.look)
        await app(scope, receive, send)

    return followed
