"""With which keys a platform signs: fetched from it, and kept for a while."""

import logging
import threading
import time
from collections.abc import Callable, Mapping
from contextlib import AbstractContextManager
from dataclasses import dataclass, field, replace
from typing import Final

from joserfc.errors import JoseError
from joserfc.jwk import RSAKey

from gripcourse.access.lti.refused import LaunchRefusal, LaunchRefusedError, PlatformFailedError
from gripcourse.access.lti.web_client import PlatformClient, PlatformQuestion, ask

_log = logging.getLogger(__name__)

KEPT_SECONDS: Final = 3600.0
_APART_SECONDS: Final = 20.0
"""Whoever sends tokens that no known key signed makes us ask the platform no more often."""

ALGORITHM: Final = "RS256"
"""The one that the standard asks of everybody; no other is accepted, whatever a token says."""

_MOST_KEYS: Final = 50
_BITS: Final = range(2048, 8193)
_LONGEST_NUMBER: Final = 2000
"""Letters of a number of a key: the largest has 1366."""


@dataclass(frozen=True, slots=True)
class _Kept:
    """The keys of one platform, as they came last.

    Attributes:
        keys: none where the platform never answered, or not for an hour.
        came: when they came.
        tried: when they were asked for last.
    """

    keys: Mapping[str, RSAKey] | None
    came: float
    tried: float


@dataclass(slots=True, eq=False)
class _KeyPlace:
    """What is kept of one address; whoever asks there keeps nobody from another one."""

    lock: threading.Lock = field(default_factory=threading.Lock)
    kept: _Kept | None = None


class KeySets:
    """The keys of platforms; safe between threads."""

    def __init__(
        self,
        make: Callable[[], AbstractContextManager[PlatformClient]],
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._make = make  # when it is asked, which is once an hour
        self._clock = clock
        self._lock = threading.Lock()
        self._places: dict[str, _KeyPlace] = {}

    def key(self, url: str, key_id: str, wrong: RSAKey | None = None) -> RSAKey:
        """Return a key of the set at an address.

        Args:
            url: address of the set; only declared ones come here.
            key_id: its name.
            wrong: what this returned before, and did not sign what it should have: there may be
                another key of that name by now.

        Raises:
            LaunchRefusedError: the set cannot be had, or has no such key.
        """
        with self._lock:
            place = self._places.setdefault(url, _KeyPlace())
        with place.lock:
            kept, now = place.kept, self._clock()
            known = None if kept is None or kept.keys is None else kept.keys.get(key_id)
            doubted = known is None or known is wrong
            limit = _APART_SECONDS if doubted else KEPT_SECONDS
            if kept is None or now - (kept.tried if doubted else kept.came) > limit:
                kept = place.kept = self._renewed(url, kept, now)
        if kept.keys is None:
            raise LaunchRefusedError(LaunchRefusal.KEYS)
        if key_id not in kept.keys:
            raise LaunchRefusedError(LaunchRefusal.KEY)
        return kept.keys[key_id]

    def _renewed(self, url: str, kept: _Kept | None, now: float) -> _Kept:
        """Ask for the keys; where they do not come, the former stay as long as they would have."""
        found = self._fetched(url)
        if found is not None:
            return _Kept(found, now, now)
        if kept is None or now - kept.came > KEPT_SECONDS:
            return _Kept(None, now, now)
        return replace(kept, tried=now)

    def _fetched(self, url: str) -> Mapping[str, RSAKey] | None:
        try:
            with self._make() as client:
                content = ask(client, PlatformQuestion(url)).content
        except PlatformFailedError as fault:
            # Who comes is told to come later; what is wrong only the administrator can see.
            _log.warning("no keys from %s: %s", url, fault)
            return None
        match content:
            case {"keys": list(found)}:
                keys = dict(filter(None, map(_signing_key, found[:_MOST_KEYS])))
                if not keys:
                    _log.warning("no keys from %s: none of %d can be used", url, len(found))
                return keys
        _log.warning("no keys from %s: the answer is no set of keys", url)
        return None


def _signing_key(found: object) -> tuple[str, RSAKey] | None:
    """Read a key that verifies signatures; None for one of another kind, or too short."""
    match found:
        case {"kty": "RSA", "kid": str(key_id), "n": str(n), "e": str(e), **more}:
            if more.get("use", "sig") != "sig" or more.get("alg", ALGORITHM) != ALGORITHM:
                return None
            if max(len(n), len(e)) > _LONGEST_NUMBER:
                return None
            try:
                key = RSAKey.import_key({"kty": "RSA", "n": n, "e": e})
            except (JoseError, ValueError):
                return None
            return (key_id, key) if key.public_key.key_size in _BITS else None
    return None
