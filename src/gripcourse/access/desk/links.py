"""Personal links: who opens one is the student it was made for, without a password.

A link carries the student, when it ends and how often the student's links were revoked before it,
under an HMAC with the course's key. Nobody without the key can make or change one; the server
keeps nothing of it but the count of revocations.
"""

import hashlib
import hmac
import json
import re
from base64 import urlsafe_b64encode
from dataclasses import dataclass
from datetime import UTC, datetime
from enum import StrEnum
from typing import Final

# Said before everything that is signed here: a signature of a variant is never one of a link.
_PURPOSE: Final = b"gripcourse personal link 1\n"
_BYTES: Final = 18  # 144 bits, 24 letters
_TEXT: Final = re.compile(
    r"(?P<student>[\w-][\w.-]{0,199})~(?P<expires>\d{1,12})~(?P<number>\d{1,6})~(?P<mac>[\w-]{24})"
)


class Refused(StrEnum):
    """Why a link opens nothing."""

    FORGED = "forged"  # or damaged, or of another course
    EXPIRED = "expired"
    REVOKED = "revoked"


@dataclass(frozen=True, slots=True)
class SignedLink:
    """What a link says.

    Attributes:
        student: id.
        expires: until when it opens anything; whole seconds, UTC.
        number: how often the student's links had been revoked when it was made.
    """

    student: str
    expires: datetime
    number: int


def link_text(link: SignedLink, key: bytes, course_id: str) -> str:
    """Write a link as one segment of a web address."""
    seconds = int(link.expires.timestamp())
    return f"{link.student}~{seconds}~{link.number}~{_mac(link, key, course_id)}"


def read_link(text: str, key: bytes, course_id: str) -> SignedLink | None:
    """Read what `link_text` wrote with the same key; None for anything else."""
    found = _TEXT.fullmatch(text)
    if found is None:
        return None
    expires = datetime.fromtimestamp(min(int(found["expires"]), _LAST), UTC)
    link = SignedLink(found["student"], expires, int(found["number"]))
    # One spelling only: digits of other scripts and leading zeros are no part of it.
    written = link_text(link, key, course_id)
    return link if hmac.compare_digest(written.encode(), text.encode()) else None


def refusal_of(link: SignedLink | None, revoked: int, now: datetime) -> Refused | None:
    """Tell why a link opens nothing; None where it opens.

    Args:
        link: as it was read.
        revoked: how often the student's links have been revoked by now.
        now: with its zone.
    """
    if link is None:
        return Refused.FORGED
    if link.number != revoked:
        return Refused.REVOKED
    return Refused.EXPIRED if now >= link.expires else None


_LAST: Final = int(datetime(9999, 1, 1, tzinfo=UTC).timestamp())


def _mac(link: SignedLink, key: bytes, course_id: str) -> str:
    signed = json.dumps(
        [course_id, link.student, int(link.expires.timestamp()), link.number], ensure_ascii=True
    )
    made = hmac.new(key, _PURPOSE + signed.encode(), hashlib.sha256).digest()
    return urlsafe_b64encode(made[:_BYTES]).decode()
