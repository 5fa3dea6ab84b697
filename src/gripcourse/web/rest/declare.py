"""Operations, declared once: the routes and their description are both made from this."""

import re
from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from http import HTTPStatus
from pathlib import Path
from typing import Any, Final

from starlette.requests import Request

from gripcourse.machine.content import NamedBytes
from gripcourse.machine.packing import ToPack
from gripcourse.text.words import Words
from gripcourse.variants.model import Issued
from gripcourse.web.refusals import Code
from gripcourse.web.site import Site

PLACES: Final = re.compile(r"\{(\w+)(?::(int))?\}")
"""Of a path: a name, and `int` for a whole number."""


class TokenRole(StrEnum):
    """Whose token is wanted; the name of the scheme in the description."""

    STUDENT = "personal_link"
    SIGN_IN = "sign_in"
    INSTRUCTOR = "session"


@dataclass(frozen=True, slots=True)
class StudentCall:
    """A student asks.

    Attributes:
        site: the server.
        request: as it came.
        words: the language of the answer.
        issued: who asks, with what was issued.
        body: what was sent, of the type that the operation takes; None for nothing.
    """

    site: Site
    request: Request
    words: Words
    issued: Issued
    body: Any

    @property
    def student(self) -> str:
        """The student's id."""
        return self.issued.student.id


@dataclass(frozen=True, slots=True)
class DeskCall:
    """An instructor asks.

    Attributes:
        site: the server.
        request: as it came.
        words: the language of the answer.
        token: that came with it.
        name: who is signed in; empty where somebody is about to.
        query: what is looked for, of the type that the operation asks by; None for nothing.
        body: what was sent, of the type that the operation takes; None for nothing.
    """

    site: Site
    request: Request
    words: Words
    token: str
    name: str
    query: Any
    body: Any


@dataclass(frozen=True, slots=True)
class SentFile:
    """A file that is sent as it is."""

    path: Path
    name: str


@dataclass(frozen=True, slots=True)
class SentZip:
    """Files that are sent as a zip, which is made while it is sent."""

    files: tuple[ToPack, ...]
    name: str


FILES: Final = (SentFile, SentZip)
"""Types of results that are no JSON."""


@dataclass(frozen=True, slots=True)
class ApiOperation:
    """A call.

    Attributes:
        method, path: below `/api/v1`.
        role: who may.
        answer: does it; its docstring says what it does.
        gives: type of the result, one of `FILES` for a file, `NoneType` for nothing.
        takes: type of the body in JSON, `NamedBytes` for a file in a form, None for none.
        searches: type of the query; None for none.
        refuses: what it refuses besides what all of its kind do.
        media: media type of a file that it sends.
        status: of an answer that is no refusal.
        waits: whether it waits for a worker, see `Site.waiting`.
    """

    method: str
    path: str
    role: TokenRole
    answer: Callable[[Any], object]
    gives: type[Any]
    takes: type[Any] | None = None
    searches: type[Any] | None = None
    refuses: tuple[Code, ...] = ()
    media: str = "application/json"
    status: HTTPStatus = HTTPStatus.OK
    waits: bool = False

    @property
    def refusals(self) -> tuple[Code, ...]:
        """Every code that a caller may meet."""
        found = [*_OF_ROLE[self.role], *self.refuses, Code.NOT_ALLOWED]
        if PLACES.search(self.path) or self.gives in FILES:
            found.append(Code.NOT_FOUND)
        if self.takes is not None:
            found += [Code.BAD_REQUEST, Code.TOO_LARGE]
        if self.takes is NamedBytes:
            found += [Code.NO_FILE, Code.TOO_OFTEN]
        elif self.takes is not None or self.searches is not None:
            found.append(Code.NOT_USABLE)
        found += [Code.TROUBLE, Code.OUR_MISTAKE]
        return tuple(dict.fromkeys(found))


_OF_ROLE: Final = {
    TokenRole.STUDENT: (
        *(Code.NO_TOKEN, Code.LINK_FORGED, Code.LINK_EXPIRED, Code.LINK_REVOKED),
        Code.TOO_OFTEN,
    ),
    TokenRole.SIGN_IN: (Code.NO_TOKEN, Code.NOT_SIGNED_IN, Code.TOO_OFTEN),
    TokenRole.INSTRUCTOR: (Code.NO_TOKEN, Code.NOT_SIGNED_IN),
}
