"""With which keys a platform signs: fetched from it, and kept for a while."""

import threading
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Final

import httpx2
from joserfc.errors import JoseError
from joserfc.jwk import RSAKey

from gripcourse.access.lti.refused import LaunchRefusal, LaunchRefusedError, PlatformFailedError
from gripcourse.access.lti.web_client import PlatformQuestion, ask

KEPT_SECONDS: Final = 3600.0
_APART_SECONDS: Final = 20.0
"""Whoever sends tokens of unknown keys makes us ask the platform no more often than that."""

ALGORITHM: Final = "RS256"
"""The one that the standard asks of everybody; no other is accepted, whatever a token says."""

_MOST_KEYS: Final = 50
_LEAST_BITS: Final = 2048


@dataclass(frozen=True, slots=True)
class _Kept:
    keys: Mapping[str, RSAKey] | None  # None where the platform did not answer
    at: float


class KeySets:
    """The keys of platforms; safe between threads."""

    def __init__(
        self, make: Callable[[], httpx2.Client], clock: Callable[[], float] = time.monotonic
    ) -> None:
        self._client = lru_cache(maxsize=1)(make)  # made when somebody comes
        self._clock = clock
        self._lock = threading.Lock()
        self._kept: dict[str, _Kept] = {}

    def key(self, url: str, key_id: str) -> RSAKey:
        """Return a key of the set at an address.

        Raises:
            LaunchRefusedError: the set cannot be had, or has no such key.
        """
        with self._lock:
            kept, now = self._kept.get(url), self._clock()
            if kept is None or self._is_due(kept, key_id, now):
                kept = self._kept[url] = _Kept(self._fetched(url), now)
        if kept.keys is None:
            raise LaunchRefusedError(LaunchRefusal.KEYS)
        if key_id not in kept.keys:
            raise LaunchRefusedError(LaunchRefusal.KEY)
        return kept.keys[key_id]

    def _is_due(self, kept: _Kept, key_id: str, now: float) -> bool:
        age = now - kept.at
        known = kept.keys is not None and key_id in kept.keys
        return age > (KEPT_SECONDS if known else _APART_SECONDS)

    def _fetched(self, url: str) -> Mapping[str, RSAKey] | None:
        try:
            content = ask(self._client(), PlatformQuestion(url)).content
        except PlatformFailedError:
            return None
        match content:
            case {"keys": list(found)}:
                return dict(filter(None, map(_signing_key, found[:_MOST_KEYS])))
        return None


def _signing_key(found: object) -> tuple[str, RSAKey] | None:
    """Read a key that verifies signatures; None for one of another kind, or too short."""
    match found:
        case {"kty": "RSA", "kid": str(key_id), "n": str(n), "e": str(e), **more}:
            if more.get("use", "sig") != "sig" or more.get("alg", ALGORITHM) != ALGORITHM:
                return None
            try:
                key = RSAKey.import_key({"kty": "RSA", "n": n, "e": e})
            except (JoseError, ValueError):
                return None
            return (key_id, key) if key.public_key.key_size >= _LEAST_BITS else None
    return None
