"""Reading what a program sends."""

import json
from collections.abc import Mapping
from typing import Any, Final

from starlette.requests import Request

from gripcourse.errors import Problem, UsageError
from gripcourse.exports.plain import from_plain
from gripcourse.machine.content import NamedBytes
from gripcourse.text.words import message
from gripcourse.web.guard import declares_too_much
from gripcourse.web.refusals import TOO_LONG, Code, WebRefusal
from gripcourse.web.rest.declare import ApiOperation
from gripcourse.web.rest.problems import NotUsable
from gripcourse.web.uploads import read_form

_MOST: Final = 20_000
"""Bytes of a body in JSON: a sentence has a hundred."""
_NO_JSON: Final = WebRefusal(Code.BAD_REQUEST, message("The body is no JSON object."))


async def read_body(operation: ApiOperation, request: Request) -> Any | WebRefusal | NotUsable:  # noqa: ANN401 (of the type that the operation takes)
    """Return the body of the type that an operation takes; None where it takes none.

    Raises:
        HTTPException: a form is too large or none.
        ClientDisconnect: whoever sent it has gone in the middle.
    """
    if operation.takes is None:
        return None
    if operation.takes is NamedBytes:
        return (await read_form(request)).file
    data = await _bytes_of(request)
    if data is None:
        return TOO_LONG
    try:
        plain = json.loads(data or b"{}")
    except (ValueError, RecursionError):
        return _NO_JSON
    return usable(operation.takes, plain) if isinstance(plain, dict) else _NO_JSON


def usable(kind: type[Any], plain: Mapping[str, object]) -> Any | NotUsable:  # noqa: ANN401 (of that kind)
    """Return a wish that a program sent; a name that nobody knows is refused too."""
    known = kind.__dataclass_fields__
    strange = [
        Problem("", name, message("Nothing is known of this."), message("Leave it out."))
        for name in plain
        if name not in known
    ]
    if strange:
        return NotUsable(tuple(strange))
    try:
        return from_plain(kind, plain)
    except UsageError as error:
        return NotUsable(tuple(error.problems))


async def _bytes_of(request: Request) -> bytes | None:
    """Return a short body; None where it is longer."""
    if declares_too_much(request.headers):
        return None
    data = b""
    async for part in request.stream():
        data += part
        if len(data) > _MOST:
            return None
    return data
