"""What we give a browser to bring back: it shows that the launch began here, now, in that browser.

Nothing is kept of it until it comes back, so nobody can fill the database by beginning launches.
It is signed with the course's key; that it was used is kept, so it opens something once.
"""

import hashlib
import hmac
import json
import re
import secrets
from base64 import urlsafe_b64encode
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from typing import Final

from gripcourse.access.lti.platforms import Platform
from gripcourse.access.lti.refused import LaunchRefusal, LaunchRefusedError

MINUTES: Final = 10
"""How long somebody may take between opening the assignment and being let in: a login fits in."""

# Said before what is signed: neither is a signature of a link or a variant.
_PURPOSE: Final = b"gripcourse launch state 1\n"
_NONCE: Final = b"gripcourse launch nonce 1\n"
_BYTES: Final = 24
_TEXT: Final = re.compile(
    r"(?P<random>[\w-]{32})~(?P<expires>\d{1,11})~(?P<platform>[0-9a-f]{32})"
    r"~(?P<browser>[0-9a-f]{32})~(?P<mac>[\w-]{32})",
    re.ASCII,
)


@dataclass(frozen=True, slots=True)
class Signer:
    """Who signs states: a course, with its key."""

    key: bytes
    course: str

    def __repr__(self) -> str:
        """Leave the key out: this may stand in a log."""
        return f"Signer({self.course})"


def new_state(signer: Signer, platform: Platform, browser: str, now: datetime) -> str:
    """Make what the platform has to bring back.

    Args:
        signer: of the course.
        platform: that is asked.
        browser: what is known of the browser: a random text in a cookie.
        now: with its zone.
    """
    expires = int((now + timedelta(minutes=MINUTES)).timestamp())
    random = secrets.token_urlsafe(_BYTES)
    said = f"{random}~{expires}~{_platform_digest(platform)}~{_short_digest(browser)}"
    return f"{said}~{_mac(signer, _PURPOSE, said)}"


def nonce_of(signer: Signer, state: str) -> str:
    """Return what the platform has to repeat inside of what it signs, for this state alone."""
    return _mac(signer, _NONCE, state)


def check_state(signer: Signer, state: str, browser: str, now: datetime) -> str:
    """Return the digest of the platform that a state was made for.

    Raises:
        LaunchRefusedError: we did not make it, it is too old, or another browser began.
    """
    found = _TEXT.fullmatch(state)
    said = state.rpartition("~")[0]
    if found is None or not hmac.compare_digest(found["mac"], _mac(signer, _PURPOSE, said)):
        raise LaunchRefusedError(LaunchRefusal.STATE)
    if now >= datetime.fromtimestamp(int(found["expires"]), UTC):
        raise LaunchRefusedError(LaunchRefusal.LATE)
    if not browser or not hmac.compare_digest(found["browser"], _short_digest(browser)):
        raise LaunchRefusedError(LaunchRefusal.BROWSER)
    return found["platform"]


def is_of(platform: Platform, digest: str) -> bool:
    """Tell whether a state was made for this platform."""
    return _platform_digest(platform) == digest


def _platform_digest(platform: Platform) -> str:
    return _short_digest(json.dumps([platform.issuer, platform.client_id]))


def _short_digest(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()[:32]


def _mac(signer: Signer, purpose: bytes, said: str) -> str:
    signed = json.dumps([signer.course, said], ensure_ascii=True).encode()
    made = hmac.new(signer.key, purpose + signed, hashlib.sha256).digest()
    return urlsafe_b64encode(made[:_BYTES]).decode()
