"""What a platform says of somebody who opens the assignment: believed after every test of it."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime
from enum import StrEnum
from typing import Any, Final

from joserfc import jws, jwt
from joserfc.errors import BadSignatureError, JoseError
from joserfc.jwk import RSAKey

from gripcourse.access.lti.key_sets import ALGORITHM, KeySets
from gripcourse.access.lti.platforms import Platform, is_of_platform
from gripcourse.access.lti.refused import LaunchRefusal, LaunchRefusedError

SCORE_SCOPE: Final = "https://purl.imsglobal.org/spec/lti-ags/scope/score"
LINE_ITEM_SCOPE: Final = "https://purl.imsglobal.org/spec/lti-ags/scope/lineitem"
MEMBERS_SCOPE: Final = "https://purl.imsglobal.org/spec/lti-nrps/scope/contextmembership.readonly"
_CLAIM: Final = "https://purl.imsglobal.org/spec/lti/claim/"
_GRADES: Final = "https://purl.imsglobal.org/spec/lti-ags/claim/endpoint"
_MEMBERS: Final = "https://purl.imsglobal.org/spec/lti-nrps/claim/namesroleservice"
_MEMBERSHIP: Final = "http://purl.imsglobal.org/vocab/lis/v2/membership#"
_LONGEST_TOKEN: Final = 60_000
_LONGEST_TEXT: Final = 255
_LONGEST_ADDRESS: Final = 2000
_SKEW_SECONDS: Final = 60
_OLDEST_SECONDS: Final = 600


class PlatformRole(StrEnum):
    """What somebody is in the platform's course."""

    STUDENT = "student"
    INSTRUCTOR = "instructor"


@dataclass(frozen=True, slots=True)
class Person:
    """Somebody of a platform, in its words; all but the id may be empty.

    Attributes:
        user: the platform's id of the person.
        name: as it is shown.
        email: as the platform has it.
        sourcedid: the office's number of the person.
    """

    user: str
    name: str
    email: str
    sourcedid: str


@dataclass(frozen=True, slots=True)
class Services:
    """Where the platform takes grades and names members; empty for nowhere.

    Attributes:
        line_item: the column of the gradebook that belongs to what was opened.
        line_items: all columns of the course.
        members: the members of the course.
    """

    line_item: str
    line_items: str
    members: str


@dataclass(frozen=True, slots=True)
class Launch:
    """Somebody opens the assignment in a platform.

    Attributes:
        platform: which.
        person: who.
        role: as what.
        context: id of the platform's course.
        link: id of what was opened there.
        services: what the platform offers for it.
    """

    platform: Platform
    person: Person
    role: PlatformRole
    context: str
    link: str
    services: Services


def read_launch(token: str, platform: Platform, keys: KeySets, nonce: str, now: datetime) -> Launch:
    """Read what a platform signed.

    Args:
        token: the `id_token` as it came.
        platform: that was asked.
        keys: of platforms.
        nonce: that has to stand in it.
        now: with its zone.

    Raises:
        LaunchRefusedError: it is not to be believed, or is no launch of a student or instructor.
    """
    try:
        claims = _signed(token, platform, keys)
        _check_envelope(claims, platform, nonce, now.timestamp())
        _check_message(claims, platform)
        return Launch(
            platform=platform,
            person=person_of(claims),
            role=role_of(claims.get(f"{_CLAIM}roles")),
            context=_context(claims, platform),
            link=_text(_table(claims, f"{_CLAIM}resource_link"), "id", required=True),
            services=_services(claims, platform),
        )
    except LaunchRefusedError as fault:
        raise LaunchRefusedError(fault.refused, platform.name, fault.context) from fault


def role_of(roles: object) -> PlatformRole:
    """Tell what somebody is in the course; roles in the whole institution count for nothing.

    Raises:
        LaunchRefusedError: neither student nor instructor.
    """
    if not isinstance(roles, list):
        raise LaunchRefusedError(LaunchRefusal.CLAIMS)
    # The bare words are an older spelling of the same.
    short = {str(one).removeprefix(_MEMBERSHIP) for one in roles}
    if "Instructor" in short:
        return PlatformRole.INSTRUCTOR
    if "Learner" in short:
        return PlatformRole.STUDENT
    raise LaunchRefusedError(LaunchRefusal.ROLE)


def person_of(claims: Mapping[str, Any]) -> Person:
    """Read who it is.

    Raises:
        LaunchRefusedError: there is no id.
    """
    email = _text(claims, "email")
    return Person(
        user=_text(claims, "sub", required=True),
        name=_text(claims, "name"),
        # What the platform itself doubts tells nothing.
        email="" if claims.get("email_verified", True) is not True else email,
        sourcedid=_text(_table(claims, f"{_CLAIM}lis"), "person_sourcedid"),
    )


def _signed(token: str, platform: Platform, keys: KeySets) -> dict[str, Any]:
    """Return what is said in a token, after its signature was verified."""
    if not token or len(token) > _LONGEST_TOKEN:
        raise LaunchRefusedError(LaunchRefusal.FORM)
    key_id = _key_id(token)
    key = keys.key(platform.jwks_url, key_id)
    try:
        return _verified(token, key)
    except LaunchRefusedError as fault:
        if fault.refused is not LaunchRefusal.SIGNATURE:
            raise
        another = keys.key(platform.jwks_url, key_id, wrong=key)
        if another is key:
            raise
    return _verified(token, another)


def _key_id(token: str) -> str:
    """Return by which key a token says that it is signed; nothing of this is believed yet."""
    try:
        header: object = jws.extract_compact(token.encode()).headers()
    except (JoseError, ValueError) as fault:
        raise LaunchRefusedError(LaunchRefusal.FORM) from fault
    # What has to be understood beyond the standard is none of ours; the library stumbles over it.
    if not isinstance(header, dict) or "crit" in header:
        raise LaunchRefusedError(LaunchRefusal.FORM)
    # Before any key is looked for: a public key is no secret to compute a signature with.
    if header.get("alg") != ALGORITHM:
        raise LaunchRefusedError(LaunchRefusal.ALGORITHM)
    key_id = header.get("kid")
    if not isinstance(key_id, str):
        raise LaunchRefusedError(LaunchRefusal.KEY)
    return key_id


def _verified(token: str, key: RSAKey) -> dict[str, Any]:
    try:
        return jwt.decode(token, key, algorithms=[ALGORITHM]).claims
    except BadSignatureError as fault:
        raise LaunchRefusedError(LaunchRefusal.SIGNATURE) from fault
    except (JoseError, ValueError, RecursionError) as fault:
        raise LaunchRefusedError(LaunchRefusal.FORM) from fault


def _check_envelope(claims: Mapping[str, Any], platform: Platform, nonce: str, now: float) -> None:
    if claims.get("iss") != platform.issuer:
        raise LaunchRefusedError(LaunchRefusal.ISSUER)
    audience = claims.get("aud")
    audiences = audience if isinstance(audience, list) else [audience]
    party = claims.get("azp")
    # Nobody besides us is trusted: what is made for others too could be brought here by them.
    ours = audiences and all(one == platform.client_id for one in audiences)
    if not ours or party not in (None, platform.client_id):
        raise LaunchRefusedError(LaunchRefusal.AUDIENCE)
    issued, expires = _seconds(claims, "iat"), _seconds(claims, "exp")
    begins = _seconds(claims, "nbf") if "nbf" in claims else issued
    if expires + _SKEW_SECONDS <= now or issued + _OLDEST_SECONDS < now:
        raise LaunchRefusedError(LaunchRefusal.TIME)
    if max(issued, begins) > now + _SKEW_SECONDS:
        raise LaunchRefusedError(LaunchRefusal.TIME)
    if claims.get("nonce") != nonce:
        raise LaunchRefusedError(LaunchRefusal.NONCE)


def _check_message(claims: Mapping[str, Any], platform: Platform) -> None:
    deployment = claims.get(f"{_CLAIM}deployment_id")
    if not isinstance(deployment, str) or deployment not in platform.deployments:
        raise LaunchRefusedError(LaunchRefusal.DEPLOYMENT)
    if claims.get(f"{_CLAIM}version") != "1.3.0":
        raise LaunchRefusedError(LaunchRefusal.VERSION)
    if claims.get(f"{_CLAIM}message_type") != "LtiResourceLinkRequest":
        raise LaunchRefusedError(LaunchRefusal.MESSAGE)


def _context(claims: Mapping[str, Any], platform: Platform) -> str:
    context = _text(_table(claims, f"{_CLAIM}context"), "id", required=True)
    if context not in platform.contexts:
        raise LaunchRefusedError(LaunchRefusal.CONTEXT, context=context)
    return context


def _services(claims: Mapping[str, Any], platform: Platform) -> Services:
    grades, members = _table(claims, _GRADES), _table(claims, _MEMBERS)
    scopes = grades.get("scope")
    allowed = scopes if isinstance(scopes, list) else []
    return Services(
        line_item=_service(grades, "lineitem", platform) if SCORE_SCOPE in allowed else "",
        line_items=_service(grades, "lineitems", platform)
        if {SCORE_SCOPE, LINE_ITEM_SCOPE} <= {str(one) for one in allowed}
        else "",
        members=_service(members, "context_memberships_url", platform),
    )


def _service(table: Mapping[str, Any], name: str, platform: Platform) -> str:
    address = table.get(name)
    if not isinstance(address, str) or len(address) > _LONGEST_ADDRESS:
        return ""
    return address if is_of_platform(platform, address) else ""


def _seconds(claims: Mapping[str, Any], name: str) -> float:
    value = claims.get(name)
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise LaunchRefusedError(LaunchRefusal.TIME)
    try:
        seconds = float(value)
    except OverflowError as fault:  # a whole number of hundreds of digits
        raise LaunchRefusedError(LaunchRefusal.TIME) from fault
    if not math.isfinite(seconds):
        raise LaunchRefusedError(LaunchRefusal.TIME)
    return seconds


def _table(claims: Mapping[str, Any], name: str) -> Mapping[str, Any]:
    value = claims.get(name)
    if value is None:
        return {}
    if not isinstance(value, dict):
        raise LaunchRefusedError(LaunchRefusal.CLAIMS)
    return value


def _text(table: Mapping[str, Any], name: str, *, required: bool = False) -> str:
    value = table.get(name)
    if not isinstance(value, str):
        value = ""
    # An id is kept and looked up letter by letter.
    if (required and not (value and value.isprintable())) or len(value) > _LONGEST_TEXT:
        raise LaunchRefusedError(LaunchRefusal.CLAIMS)
    return value
