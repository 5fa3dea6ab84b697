"""Coming in by a learning platform, as a forger may bring it about, and what a page says."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from starlette.testclient import TestClient

from support.lti_course import LtiCourse
from support.platform import signed


@dataclass(slots=True)
class Attempt:
    """What a forger brings: claims and header to change, the state, and the key that signs."""

    school: LtiCourse
    asked: dict[str, str]
    claims: dict[str, Any]
    header: dict[str, Any]

    def token(self) -> str:
        return signed(self.header, self.claims, self.school.platform.key)


def attempt(school: LtiCourse, client: TestClient, hint: str = "anna") -> Attempt:
    asked = school.begin(client, hint)
    claims = school.platform.claims(hint, asked["nonce"])
    return Attempt(school, asked, claims, {"alg": "RS256", "kid": "k1"})


def says(text: str, code: str) -> bool:
    return f"({code})" in text


def with_header(**changes: object) -> Callable[[Attempt], str]:
    def token(one: Attempt) -> str:
        return signed({**one.header, **changes}, one.claims, one.school.platform.key)

    return token
