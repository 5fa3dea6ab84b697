"""What becomes of whatever goes wrong: the same for pages and for programs, said in two ways."""

from collections.abc import Callable, Mapping
from typing import Any, Final, TypeAlias

from starlette.exceptions import HTTPException
from starlette.requests import ClientDisconnect, Request
from starlette.responses import Response

from gripcourse.errors import CourseError, GradebookError
from gripcourse.web.guard import TooMuchError
from gripcourse.web.refusals import (
    WebRefusal,
    refusal_of_course,
    refusal_of_incident,
    refusal_of_request,
    refusal_of_system,
)

_GONE: Final = 499  # nobody hears it: who asked has closed the connection

Said: TypeAlias = Callable[[Request, WebRefusal], Response]
"""Says why something is not done: a page, or a body for a program."""


def fault_handlers(said: Said) -> Mapping[Any, Any]:
    """Return what an application does with each kind of exception."""

    async def refused(request: Request, fault: Exception) -> Response:
        response = said(request, refusal_of_request(fault))
        response.headers.update(getattr(fault, "headers", None) or {})
        return response

    async def gone(_: Request, _fault: Exception) -> Response:
        return Response(status_code=_GONE)

    async def system(request: Request, fault: Exception) -> Response:
        return said(request, refusal_of_system(fault))

    async def unusable(request: Request, fault: Exception) -> Response:
        return said(request, refusal_of_course(fault))

    async def ours(request: Request, fault: Exception) -> Response:
        return said(request, refusal_of_incident(fault))

    return {
        HTTPException: refused,
        TooMuchError: refused,
        ClientDisconnect: gone,
        OSError: system,
        GradebookError: system,
        CourseError: unusable,
        Exception: ours,
    }
