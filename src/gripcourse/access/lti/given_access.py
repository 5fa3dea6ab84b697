"""What a platform lets us do for a while: asked for, asked for again, and used with patience."""

import re
import secrets
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from datetime import datetime
from typing import Any, Final

from joserfc import jwt
from joserfc.jwk import KeySet

from gripcourse.access.lti.key_sets import ALGORITHM
from gripcourse.access.lti.platforms import Platform
from gripcourse.access.lti.refused import PlatformFailedError, PlatformFailure
from gripcourse.access.lti.web_client import PlatformAnswer, PlatformClient, PlatformQuestion, ask
from gripcourse.text.words import message

_ASSERTION: Final = "urn:ietf:params:oauth:client-assertion-type:jwt-bearer"
_ASSERTION_SECONDS: Final = 60
_TOKEN: Final = re.compile(r"[!-~]+")
_PASSES: Final = frozenset({PlatformFailure.AWAY, PlatformFailure.BUSY, PlatformFailure.BROKEN})


@dataclass(frozen=True, slots=True)
class Patience:
    """How often a platform is asked that is busy or away.

    Attributes:
        tries: of one question, in all.
        pause: seconds between two, where the platform names none. Not less than one: Moodle
            compares times by whole seconds, and refuses a second score of the same.
        longest: seconds that are waited at most because the platform asks for it.
        sleep: waits.
    """

    tries: int = 3
    pause: float = 2.0
    longest: float = 60.0
    sleep: Callable[[float], None] = time.sleep


@dataclass(frozen=True, slots=True, eq=False)
class Access:
    """What a platform lets us do for a while, by the scope that was asked for.

    Attributes:
        client: asks.
        platform: which.
        keys: ours; the first signs who we are.
        clock: tells the time now: it may be an hour later when access has to be renewed.
        patience: with a platform that is busy.
        tokens: by scope, as they are known now.
    """

    client: PlatformClient
    platform: Platform
    keys: KeySet
    clock: Callable[[], datetime]
    patience: Patience = field(default_factory=Patience)
    tokens: dict[str, str] = field(default_factory=dict)

    def __repr__(self) -> str:
        """Leave the tokens out: this may stand in a log."""
        return f"Access({self.platform.name})"


def open_access(access: Access, scopes: Iterable[str]) -> None:
    """Ask a platform for access; it knows us by our key.

    Raises:
        PlatformFailedError: it refuses.
    """
    for scope in scopes:
        access.tokens[scope] = _new_token(access, scope)


def ask_with_access(
    access: Access, scope: str, make: Callable[[], PlatformQuestion]
) -> PlatformAnswer:
    """Ask something that needs access, again where the platform is busy or no longer knows us.

    Args:
        access: what we may.
        scope: what it needs.
        make: makes the question; each time anew, for it may bear the time.

    Raises:
        PlatformFailedError: nothing came of it.
    """

    def asked() -> PlatformAnswer:
        question, token = make(), access.tokens[scope]
        try:
            return ask(access.client, _bearing(question, token))
        except PlatformFailedError as fault:
            if fault.failure is not PlatformFailure.UNKNOWN:
                raise
        # It was good for an hour, and a large course takes longer.
        access.tokens[scope] = _new_token(access, scope)
        return ask(access.client, _bearing(question, access.tokens[scope]))

    return _patiently(access.patience, asked)


def _bearing(question: PlatformQuestion, token: str) -> PlatformQuestion:
    headers = {**(question.headers or {}), "Authorization": f"Bearer {token}"}
    return PlatformQuestion(question.url, question.method, headers, question.fields, question.body)


def _new_token(access: Access, scope: str) -> str:
    answer = _patiently(access.patience, lambda: _asked_for(access, scope))
    match answer.content:
        case {"access_token": str(token)} if _TOKEN.fullmatch(token):
            return token
    raise PlatformFailedError(message("The platform gave no access."))


def _asked_for(access: Access, scope: str) -> PlatformAnswer:
    platform, key = access.platform, access.keys.keys[0]
    key.ensure_kid()
    seconds = int(access.clock().timestamp())
    claims: dict[str, Any] = {
        "iss": platform.client_id,
        "sub": platform.client_id,
        "aud": platform.token_audience,
        "iat": seconds,
        "exp": seconds + _ASSERTION_SECONDS,
        "jti": secrets.token_urlsafe(),
    }
    fields = {
        "grant_type": "client_credentials",
        "client_assertion_type": _ASSERTION,
        "client_assertion": jwt.encode({"alg": ALGORITHM, "kid": key.kid}, claims, key),
        "scope": scope,
    }
    accepts = {"Accept": "application/json"}
    return ask(access.client, PlatformQuestion(platform.token_url, "POST", accepts, fields))


def _patiently(patience: Patience, asked: Callable[[], PlatformAnswer]) -> PlatformAnswer:
    """Ask again what may be done later.

    Raises:
        PlatformFailedError: of the last time.
    """
    for left in reversed(range(patience.tries)):
        try:
            return asked()
        except PlatformFailedError as fault:
            pause = patience.pause if fault.pause is None else max(fault.pause, patience.pause)
            if not left or fault.failure not in _PASSES or pause > patience.longest:
                raise
        patience.sleep(pause)
    raise AssertionError(patience.tries)
