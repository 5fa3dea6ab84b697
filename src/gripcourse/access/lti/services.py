"""What a platform is asked to do: to take a score, to make a column for it, to name its members."""

import json
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any, Final
from urllib.parse import urlencode, urlsplit, urlunsplit

from gripcourse.access.lti.given_access import Access, ask_with_access
from gripcourse.access.lti.launch import (
    LINE_ITEM_SCOPE,
    MEMBERS_SCOPE,
    SCORE_SCOPE,
    Person,
    PlatformRole,
    role_of,
)
from gripcourse.access.lti.platforms import is_of_platform, origin_of
from gripcourse.access.lti.refused import (
    LaunchRefusedError,
    PlatformFailedError,
    PlatformFailure,
)
from gripcourse.access.lti.web_client import PlatformAnswer, PlatformQuestion
from gripcourse.text.words import Message, message

_SCORE: Final = "application/vnd.ims.lis.v1.score+json"
_LINE_ITEM: Final = "application/vnd.ims.lis.v2.lineitem+json"
_LINE_ITEMS: Final = "application/vnd.ims.lis.v2.lineitemcontainer+json"
_MEMBERS: Final = "application/vnd.ims.lti-nrps.v2.membershipcontainer+json"
_MOST_PAGES: Final = 1000
_MOST_PEOPLE: Final = 50_000
"""Of a course; a platform that always names others must not fill the memory."""

_ENDLESS: Final = message("The pages of the platform do not end.")
_NOT_TAKEN: Final = message(
    "The platform takes no score of this student: look whether it still has the student in its"
    " course"
)
# Moodle answers 400 and Canvas 422 for who is no student of the course; 409 is of the standard.
_NO_SCORE: Final[Mapping[int, Message]] = {
    400: _NOT_TAKEN,
    422: _NOT_TAKEN,
    403: message("The platform does not let us send scores"),
    404: message("The platform has this column or this student no more"),
    409: message(
        "The platform has a later score of this student already; look whether both clocks are right"
    ),
}


@dataclass(frozen=True, slots=True)
class Score:
    """A result as a platform takes it.

    Attributes:
        points, maximum: earned and possible.
        comment: for the student.
        final: False while something of it waits for a person.
    """

    points: float
    maximum: float
    comment: str
    final: bool


def send_score(access: Access, line_item: str, user: str, score: Score) -> None:
    """Put a score into a column of the platform's gradebook.

    Raises:
        PlatformFailedError: it was not taken, or nobody knows whether it was.
    """

    def sent() -> dict[str, Any]:
        return {
            "userId": user,
            "scoreGiven": score.points,
            "scoreMaximum": score.maximum,
            "comment": score.comment,
            # A platform keeps what is later; the same again would not be.
            "timestamp": access.clock().isoformat(timespec="milliseconds"),
            "activityProgress": "Completed",
            "gradingProgress": "FullyGraded" if score.final else "PendingManual",
        }

    try:
        _post(access, SCORE_SCOPE, _below(line_item, "scores"), _SCORE, sent)
    except PlatformFailedError as fault:
        why = _NO_SCORE.get(fault.status)
        if why is None or fault.failure is PlatformFailure.BUSY:
            raise
        said = message("{why} ({status}).", why=why, status=str(fault.status))
        raise PlatformFailedError(said, fault.failure, fault.status, fault.pause) from fault


def line_item_of(access: Access, line_items: str, resource: str, label: str, total: float) -> str:
    """Return our column among those of a course; make it where there is none.

    Args:
        access: to columns.
        line_items: address of the course's columns.
        resource: our name of it, by which it is found again.
        label: how it is shown.
        total: points at most.

    Raises:
        PlatformFailedError: it can neither be found nor made.
    """
    wanted = _with_query(line_items, {"resource_id": resource})
    for page in _pages(access, LINE_ITEM_SCOPE, wanted, _LINE_ITEMS):
        for one in page.content if isinstance(page.content, list) else ():
            match one:
                case {"id": str(address), "resourceId": str(named)} if named == resource:
                    return address
    made = {"label": label, "scoreMaximum": total, "resourceId": resource}
    match _post(access, LINE_ITEM_SCOPE, line_items, _LINE_ITEM, lambda: made).content:
        case {"id": str(address)}:
            return address
    raise PlatformFailedError(message("The platform made no column."))


def students_of(access: Access, members: str) -> tuple[Person, ...]:
    """Return the students of a platform's course, as far as it names them.

    Raises:
        PlatformFailedError: it names nobody.
    """
    found: list[Person] = []
    for page in _pages(access, MEMBERS_SCOPE, members, _MEMBERS):
        match page.content:
            case {"members": list(listed)}:
                found += [one for one in map(_student, listed) if one is not None]
                if len(found) > _MOST_PEOPLE:
                    raise PlatformFailedError(_ENDLESS)
            case _:
                raise PlatformFailedError(message("The platform named no members."))
    return tuple(found)


def _student(member: object) -> Person | None:
    match member:
        case {"user_id": str(user), "roles": roles, **more}:
            if more.get("status", "Active") != "Active":
                return None
            try:
                if role_of(roles) is not PlatformRole.STUDENT:
                    return None
            except LaunchRefusedError:
                return None
            said = (more.get(key) for key in ("name", "email", "lis_person_sourcedid"))
            name, email, sourcedid = (one if isinstance(one, str) else "" for one in said)
            return Person(user, name, email, sourcedid)
    return None


def _pages(access: Access, scope: str, address: str, kind: str) -> Iterable[PlatformAnswer]:
    """Return page by page; all of them, or it fails.

    Raises:
        PlatformFailedError: the pages come from elsewhere, go round in a circle, or never end.
    """
    home, seen = origin_of(address), set[str]()
    while address:
        # The address of a page is signed by nobody, and whoever is asked there gets our access.
        if not is_of_platform(access.platform, address) or origin_of(address) != home:
            raise PlatformFailedError(message("The platform named a page on another machine."))
        if address in seen or len(seen) == _MOST_PAGES:
            raise PlatformFailedError(_ENDLESS)
        seen.add(address)
        page = _page(access, scope, address, kind)
        yield page
        address = page.next_page


def _page(access: Access, scope: str, address: str, kind: str) -> PlatformAnswer:
    question = PlatformQuestion(address, "GET", {"Accept": kind})
    return ask_with_access(access, scope, lambda: question)


def _post(
    access: Access, scope: str, address: str, kind: str, sent: Callable[[], Mapping[str, Any]]
) -> PlatformAnswer:
    if not is_of_platform(access.platform, address):
        raise PlatformFailedError(message("The platform named an address that is not by https."))

    def made() -> PlatformQuestion:
        body = json.dumps(sent(), ensure_ascii=False, allow_nan=False).encode()
        headers = {"Accept": kind, "Content-Type": kind}
        return PlatformQuestion(address, "POST", headers, body=body)

    return ask_with_access(access, scope, made)


def _below(address: str, name: str) -> str:
    """Return the address of something below another one, whose query stays."""
    parts = urlsplit(address)
    return urlunsplit(parts._replace(path=f"{parts.path.rstrip('/')}/{name}", fragment=""))


def _with_query(address: str, fields: Mapping[str, str]) -> str:
    parts = urlsplit(address)
    query = "&".join(filter(None, [parts.query, urlencode(fields)]))
    return urlunsplit(parts._replace(query=query, fragment=""))
