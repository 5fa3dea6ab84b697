"""What a platform is asked to do: to take a score, to make a column for it, to name its members."""

import json
import secrets
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from datetime import datetime
from typing import Any, Final
from urllib.parse import urlencode, urlsplit, urlunsplit

from joserfc import jwt
from joserfc.jwk import KeySet

from gripcourse.access.lti.key_sets import ALGORITHM
from gripcourse.access.lti.launch import (
    LINE_ITEM_SCOPE,
    MEMBERS_SCOPE,
    SCORE_SCOPE,
    Person,
    PlatformRole,
    role_of,
)
from gripcourse.access.lti.platforms import Platform, is_of_platform, origin_of
from gripcourse.access.lti.refused import LaunchRefusedError, PlatformFailedError
from gripcourse.access.lti.web_client import PlatformAnswer, PlatformClient, PlatformQuestion, ask
from gripcourse.text.words import message

_ASSERTION: Final = "urn:ietf:params:oauth:client-assertion-type:jwt-bearer"
_SCORE: Final = "application/vnd.ims.lis.v1.score+json"
_LINE_ITEM: Final = "application/vnd.ims.lis.v2.lineitem+json"
_LINE_ITEMS: Final = "application/vnd.ims.lis.v2.lineitemcontainer+json"
_MEMBERS: Final = "application/vnd.ims.lti-nrps.v2.membershipcontainer+json"
_ASSERTION_SECONDS: Final = 60
_MOST_PAGES: Final = 1000


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


@dataclass(frozen=True, slots=True)
class Access:
    """What a platform lets us do for a while, by the scope that was asked for."""

    client: PlatformClient
    platform: Platform
    tokens: Mapping[str, str]

    def __repr__(self) -> str:
        """Leave the tokens out: this may stand in a log."""
        return f"Access({self.platform.name})"


def open_access(
    client: PlatformClient,
    platform: Platform,
    keys: KeySet,
    scopes: Iterable[str],
    now: datetime,
) -> Access:
    """Ask a platform for access; it knows us by our key.

    Raises:
        PlatformFailedError: it refuses.
    """
    key, seconds = keys.keys[0], int(now.timestamp())
    key.ensure_kid()
    claims: dict[str, Any] = {
        "iss": platform.client_id,
        "sub": platform.client_id,
        "aud": platform.token_audience,
        "iat": seconds,
        "exp": seconds + _ASSERTION_SECONDS,
        "jti": secrets.token_urlsafe(),
    }
    tokens = {}
    for scope in scopes:
        header = {"alg": ALGORITHM, "kid": key.kid}
        fields = {
            "grant_type": "client_credentials",
            "client_assertion_type": _ASSERTION,
            "client_assertion": jwt.encode(header, {**claims, "jti": secrets.token_urlsafe()}, key),
            "scope": scope,
        }
        asked = PlatformQuestion(platform.token_url, "POST", {"Accept": "application/json"}, fields)
        match ask(client, asked).content:
            case {"access_token": str(token)} if token.isascii() and token.isprintable():
                tokens[scope] = token
            case _:
                raise PlatformFailedError(message("The platform gave no access."))
    return Access(client, platform, tokens)


def send_score(access: Access, line_item: str, user: str, score: Score, now: datetime) -> None:
    """Put a score into a column of the platform's gradebook.

    Raises:
        PlatformFailedError: it was not taken.
    """
    sent = {
        "userId": user,
        "scoreGiven": score.points,
        "scoreMaximum": score.maximum,
        "comment": score.comment,
        "timestamp": now.isoformat(timespec="milliseconds"),
        "activityProgress": "Completed",
        "gradingProgress": "FullyGraded" if score.final else "PendingManual",
    }
    _post(access, SCORE_SCOPE, _below(line_item, "scores"), _SCORE, sent)


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
    match _post(access, LINE_ITEM_SCOPE, line_items, _LINE_ITEM, made).content:
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
            raise PlatformFailedError(message("The pages of the platform do not end."))
        seen.add(address)
        page = ask(access.client, PlatformQuestion(address, "GET", _headers(access, scope, kind)))
        yield page
        address = page.next_page


def _post(access: Access, scope: str, address: str, kind: str, sent: object) -> PlatformAnswer:
    if not is_of_platform(access.platform, address):
        raise PlatformFailedError(message("The platform named an address that is not by https."))
    headers = {**_headers(access, scope, kind), "Content-Type": kind}
    body = json.dumps(sent, ensure_ascii=False, allow_nan=False).encode()
    return ask(access.client, PlatformQuestion(address, "POST", headers, body=body))


def _headers(access: Access, scope: str, kind: str) -> dict[str, str]:
    return {"Authorization": f"Bearer {access.tokens[scope]}", "Accept": kind}


def _below(address: str, name: str) -> str:
    """Return the address of something below another one, whose query stays."""
    parts = urlsplit(address)
    return urlunsplit(parts._replace(path=f"{parts.path.rstrip('/')}/{name}", fragment=""))


def _with_query(address: str, fields: Mapping[str, str]) -> str:
    parts = urlsplit(address)
    query = "&".join(filter(None, [parts.query, urlencode(fields)]))
    return urlunsplit(parts._replace(query=query, fragment=""))
