"""Why something is not done: a code for programs, a status for both, a sentence for people."""

import logging
import secrets
import traceback
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import StrEnum
from http import HTTPStatus
from typing import Final, TypeVar

from starlette.exceptions import HTTPException

from gripcourse.access.desk.links import Refused
from gripcourse.errors import GradebookError, GripcourseError, Problem, system_problem
from gripcourse.text.words import Message, message

_log = logging.getLogger(__name__)

Made = TypeVar("Made")


class Code(StrEnum):
    """What a refusal is, the same in every language."""

    BAD_REQUEST = "bad_request"
    NO_TOKEN = "no_token"  # noqa: S105 (a code, no token)
    LINK_FORGED = "link_forged"
    LINK_EXPIRED = "link_expired"
    LINK_REVOKED = "link_revoked"
    NOT_SIGNED_IN = "not_signed_in"
    NOT_FOUND = "not_found"
    NOT_PUBLISHED = "not_published"
    NOT_ALLOWED = "not_allowed"
    NO_FILE = "no_file"
    FILE_NOT_KEPT = "file_not_kept"
    NO_SENTENCE = "no_sentence"
    NOT_USABLE = "not_usable"
    BEYOND_LIMITS = "beyond_limits"
    TOO_LARGE = "too_large"
    TOO_OFTEN = "too_often"
    CONFLICT = "conflict"
    TROUBLE = "trouble"
    OUR_MISTAKE = "our_mistake"


STATUS: Final[Mapping[Code, HTTPStatus]] = {
    Code.BAD_REQUEST: HTTPStatus.BAD_REQUEST,
    Code.NO_TOKEN: HTTPStatus.UNAUTHORIZED,
    Code.LINK_FORGED: HTTPStatus.UNAUTHORIZED,
    Code.LINK_EXPIRED: HTTPStatus.UNAUTHORIZED,
    Code.LINK_REVOKED: HTTPStatus.UNAUTHORIZED,
    Code.NOT_SIGNED_IN: HTTPStatus.UNAUTHORIZED,
    Code.NOT_FOUND: HTTPStatus.NOT_FOUND,
    Code.NOT_PUBLISHED: HTTPStatus.NOT_FOUND,
    Code.NOT_ALLOWED: HTTPStatus.METHOD_NOT_ALLOWED,
    Code.NO_FILE: HTTPStatus.BAD_REQUEST,
    Code.FILE_NOT_KEPT: HTTPStatus.BAD_REQUEST,
    Code.NO_SENTENCE: HTTPStatus.BAD_REQUEST,
    Code.NOT_USABLE: HTTPStatus.UNPROCESSABLE_ENTITY,
    Code.BEYOND_LIMITS: HTTPStatus.UNPROCESSABLE_ENTITY,
    Code.TOO_LARGE: HTTPStatus.REQUEST_ENTITY_TOO_LARGE,
    Code.TOO_OFTEN: HTTPStatus.TOO_MANY_REQUESTS,
    Code.CONFLICT: HTTPStatus.CONFLICT,
    Code.TROUBLE: HTTPStatus.SERVICE_UNAVAILABLE,
    Code.OUR_MISTAKE: HTTPStatus.INTERNAL_SERVER_ERROR,
}


@dataclass(frozen=True, slots=True)
class WebRefusal:
    """Why something is not done.

    Attributes:
        code: for programs.
        said: for people.
    """

    code: Code
    said: Message

    @property
    def status(self) -> HTTPStatus:
        """The status of the answer."""
        return STATUS[self.code]


LINK_SAID: Final[Mapping[Refused, Message]] = {
    Refused.FORGED: message(
        "This link is not valid. Copy it whole, or ask your instructor for a new one."
    ),
    Refused.EXPIRED: message("This link has expired. Ask your instructor for a new one."),
    Refused.REVOKED: message("This link was replaced. Use the newest one that you were sent."),
}
NOT_FOUND: Final = WebRefusal(Code.NOT_FOUND, message("There is nothing at this address."))
TOO_LARGE: Final = WebRefusal(
    Code.TOO_LARGE, message("The file is too large; a workbook may have at most 20 MB.")
)
TOO_LONG: Final = WebRefusal(Code.TOO_LARGE, message("More was sent than is taken here."))
TOO_OFTEN: Final = WebRefusal(
    Code.TOO_OFTEN, message("That was too often. Wait ten minutes and try again.")
)
TOO_MANY_AT_ONCE: Final = WebRefusal(
    Code.TOO_OFTEN,
    message("Other files of yours are still on their way. Send this one when they have come."),
)
NO_FILE: Final = WebRefusal(
    Code.NO_FILE, message("No file came with it. Choose your workbook first.")
)
NOT_ALLOWED: Final = WebRefusal(
    Code.NOT_ALLOWED, message("What is at this address is not asked for in this way.")
)
NO_REQUEST: Final = WebRefusal(
    Code.BAD_REQUEST, message("The browser sent something that cannot be used here.")
)
NOT_PUBLISHED: Final = WebRefusal(Code.NOT_PUBLISHED, message("No results are published yet."))

SIGN_IN: Final = WebRefusal(
    Code.NOT_SIGNED_IN,
    message(
        "Sign in by a link from the command line of the server: gripcourse sign-in."
        " Each is good once."
    ),
)

_AWAY: Final = WebRefusal(
    Code.TROUBLE,
    message(
        "The course's records cannot be reached now. Try again in a minute; nothing is kept twice."
    ),
)

_BADLY_WRITTEN: Final = WebRefusal(
    Code.TROUBLE,
    message(
        "A file of the course cannot be used as it is written now. Tell your instructor: the log of"
        " the server says which, and where."
    ),
)

_BY_STATUS: Final[Mapping[int, WebRefusal]] = {
    one.status: one for one in (NOT_FOUND, NOT_ALLOWED, TOO_LARGE, TOO_OFTEN)
}


def refusal_of_request(fault: Exception) -> WebRefusal:
    """Say what is wrong with a request that the framework or `Guard` refused."""
    status = fault.status_code if isinstance(fault, HTTPException) else TOO_LARGE.status
    return _BY_STATUS.get(status, NO_REQUEST)


def refusal_of_problem(error: GripcourseError, code: Code) -> WebRefusal:
    """Say the first problem of an error with its remedy."""
    problem = error.problems[0]
    said = message("{what} {remedy}", what=problem.what, remedy=problem.remedy)
    return WebRefusal(code, said)


def refusal_until_mended(fault: Problem) -> WebRefusal:
    """Say that nothing is graded as long as a file of the course cannot be used."""
    place = message("{file}: {key}", file=fault.file, key=fault.key) if fault.key else fault.file
    said = message(
        "{place}: {what} {remedy} Nothing is graded until this is mended.",
        place=place,
        what=fault.what,
        remedy=fault.remedy,
    )
    return WebRefusal(Code.CONFLICT, said)


def unless_in_conflict(act: Callable[[], Made]) -> Made | WebRefusal:
    """Do what may not be possible as things stand; trouble with the database is another matter."""
    try:
        return act()
    except GradebookError:
        raise
    except GripcourseError as error:
        return refusal_of_problem(error, Code.CONFLICT)


def refusal_of_system(fault: Exception) -> WebRefusal:
    """Say, here and in the log, that the machine or the database could not."""
    if not isinstance(fault, OSError):
        # What a database says names the server, which is nobody's business here.
        _log.error("%s", fault)
        return _AWAY
    problem = system_problem(fault)
    _log.error("%s", problem.what)
    said = message("{what} Nothing was recorded. Try again later.", what=problem.what)
    return WebRefusal(Code.TROUBLE, said)


def refusal_of_course(fault: Exception) -> WebRefusal:
    """Say, in the log more closely, that a file cannot be used which was changed meanwhile."""
    _log.error("%s", fault)
    return _BADLY_WRITTEN


def refusal_of_incident(fault: Exception) -> WebRefusal:
    """Log our mistake under a number that can be told."""
    incident = secrets.token_hex(4)
    _log.error("incident %s\n%s", incident, "".join(traceback.format_exception(fault)))
    said = message(
        "This is our mistake, not yours. Tell your instructor the number {number}.",
        number=incident,
    )
    return WebRefusal(Code.OUR_MISTAKE, said)
