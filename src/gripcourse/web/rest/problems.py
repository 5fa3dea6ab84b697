"""Refusals as programs read them: `application/problem+json` (RFC 9457), with a sentence."""

from dataclasses import dataclass
from http import HTTPStatus
from typing import Final

from starlette.responses import JSONResponse

from gripcourse.errors import Problem
from gripcourse.exports.plain import to_plain
from gripcourse.text.words import Words, message
from gripcourse.web.refusals import TOO_MANY_AT_ONCE, Code, WebRefusal

MEDIA: Final = "application/problem+json"
_SECONDS_OF_UPLOAD: Final = "5"
_NOT_USABLE: Final = WebRefusal(
    Code.NOT_USABLE, message("What was sent is not as the description of this call says.")
)


@dataclass(frozen=True, slots=True)
class PlaceResult:
    """What is wrong at a place of what was sent.

    Attributes:
        place: name of the value.
        what: what is wrong with it.
    """

    place: str
    what: str


@dataclass(frozen=True, slots=True)
class RefusalResult:
    """Why something was not done.

    Attributes:
        type: the code as a URN.
        status: of the answer.
        code: the same in every language.
        detail: a sentence for people.
        places: what is wrong where, in what was sent.
    """

    type: str
    status: int
    code: Code
    detail: str
    places: tuple[PlaceResult, ...] = ()


@dataclass(frozen=True, slots=True)
class NotUsable:
    """Values that cannot be used, each with its place."""

    problems: tuple[Problem, ...]


def problem(why: WebRefusal | NotUsable, words: Words) -> JSONResponse:
    """Answer with a refusal."""
    if isinstance(why, NotUsable):
        places = tuple(PlaceResult(str(one.key), words.say(one.what)) for one in why.problems)
        why = _NOT_USABLE
    else:
        places = ()
    made = RefusalResult(
        type=f"urn:gripcourse:{why.code.value}",
        status=why.status.value,
        code=why.code,
        detail=words.say(why.said),
        places=places,
    )
    headers = {"Content-Language": words.language}
    if why.status is HTTPStatus.UNAUTHORIZED:
        invalid = "" if why.code is Code.NO_TOKEN else ' error="invalid_token"'
        headers["WWW-Authenticate"] = f"Bearer{invalid}"
    if why is TOO_MANY_AT_ONCE:
        headers["Retry-After"] = _SECONDS_OF_UPLOAD
    return JSONResponse(to_plain(made), why.status, headers, MEDIA)
