"""A platform that is busy or away is asked again; nothing is sent twice, nothing is lost."""

import json
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from datetime import UTC, datetime, timedelta
from email.utils import format_datetime
from typing import Final

import httpx2
import pytest
from joserfc.jwk import KeySet, RSAKey

from gripcourse.access.lti.given_access import Access, Patience, open_access
from gripcourse.access.lti.launch import MEMBERS_SCOPE, SCORE_SCOPE
from gripcourse.access.lti.refused import PlatformFailedError, PlatformFailure
from gripcourse.access.lti.services import Score, send_score, students_of
from gripcourse.access.lti.web_client import make_client
from support.lti_course import declared_as
from support.platform import LEARNER, StandIn, new_key

BEGAN: Final = datetime(2026, 10, 1, 9, 30, tzinfo=UTC)
PLATFORM: Final = declared_as(StandIn(new_key(), BEGAN.timestamp, address="https://lms.example"))
KEYS: Final = KeySet([RSAKey.generate_key(2048, auto_kid=True)])
COLUMN: Final = "https://lms.example/lines/1"
SCORE: Final = Score(points=4, maximum=10, comment="", final=True)

Answer = Callable[[httpx2.Request], httpx2.Response]


@dataclass(slots=True)
class Busy:
    """A platform that answers scores one by one as it is told, and what it was sent.

    Attributes:
        answers: to what is asked with access, in turn; after the last one it takes everything.
        granted: tokens that it gave, oldest first.
        sent: bodies of what was asked with access.
        waited: seconds that were waited for it.
        now: time, which goes on while it is waited for.
    """

    answers: list[Answer | int]
    granted: list[str] = field(default_factory=list)
    sent: list[dict[str, object]] = field(default_factory=list)
    waited: list[float] = field(default_factory=list)
    now: datetime = BEGAN

    def __call__(self, request: httpx2.Request) -> httpx2.Response:
        if request.url.path == "/token":
            self.granted.append(f"t{len(self.granted)}")
            return httpx2.Response(200, json={"access_token": self.granted[-1]})
        self.sent.append(json.loads(request.content or b"{}"))
        if self.answers:
            answer = self.answers.pop(0)
            if isinstance(answer, int):
                return httpx2.Response(answer)
            return answer(request)
        if request.headers["Authorization"] != f"Bearer {self.granted[-1]}":
            return httpx2.Response(401)
        member = {"user_id": "u1", "roles": [LEARNER]}
        return httpx2.Response(200, json={"members": [member]})

    def wait(self, seconds: float) -> None:
        self.waited.append(seconds)
        self.now += timedelta(seconds=seconds)


@contextmanager
def access_to(platform: Busy, scope: str = SCORE_SCOPE) -> Iterator[Access]:
    with make_client(httpx2.MockTransport(platform)) as client:
        patience = Patience(sleep=platform.wait)
        access = Access(client, PLATFORM, KEYS, lambda: platform.now, patience)
        open_access(access, [scope])
        yield access


def away(request: httpx2.Request) -> httpx2.Response:
    raise httpx2.ReadTimeout("silent", request=request)


def come_again(when: str, status: int = 429) -> Answer:
    return lambda _: httpx2.Response(status, headers={"Retry-After": when})


def throttled(_: httpx2.Request) -> httpx2.Response:
    """Answer as Canvas does to who asks too much: no word of when to come again."""
    return httpx2.Response(403, text="403 Forbidden (Rate Limit Exceeded)\n")


def test_access_that_has_expired_is_asked_for_again() -> None:
    platform = Busy([])
    with access_to(platform) as access:
        send_score(access, COLUMN, "u1", SCORE)
        platform.granted.append("another; the first is unknown now")
        send_score(access, COLUMN, "u2", SCORE)
        send_score(access, COLUMN, "u3", SCORE)
    assert [one["userId"] for one in platform.sent] == ["u1", "u2", "u2", "u3"]
    assert len(platform.granted) == 3
    assert platform.waited == []


def test_access_that_expires_between_two_pages_is_asked_for_again() -> None:
    second = {"Link": '<https://lms.example/members?page=2>; rel="next"'}
    body = {"members": [{"user_id": "u0", "roles": [LEARNER]}]}
    platform = Busy([lambda _: httpx2.Response(200, json=body, headers=second), 401])
    with access_to(platform, MEMBERS_SCOPE) as access:
        people = students_of(access, "https://lms.example/members")
    assert [one.user for one in people] == ["u0", "u1"]


def test_a_platform_that_knows_no_token_of_its_own_is_not_asked_without_end() -> None:
    platform = Busy([401] * 9)
    with access_to(platform) as access, pytest.raises(PlatformFailedError, match="401"):
        send_score(access, COLUMN, "u1", SCORE)
    assert len(platform.sent) == 2


@pytest.mark.parametrize(
    ("answer", "waited"),
    [
        (come_again("7"), 7.0),
        (come_again("7", 503), 7.0),
        (come_again("0"), 2.0),
        (come_again("soon"), 2.0),
        (come_again("nan"), 2.0),
        (come_again("Thu, 01 Oct 2026 09:30:00"), 2.0),
        (429, 2.0),
        (throttled, 2.0),
        (500, 2.0),
        (502, 2.0),
        (away, 2.0),
    ],
)
def test_a_busy_platform_is_asked_again_with_a_later_time(
    answer: Answer | int, waited: float
) -> None:
    platform = Busy([answer])
    with access_to(platform) as access:
        send_score(access, COLUMN, "u1", SCORE)
    assert platform.waited == [waited]
    first, second = (datetime.fromisoformat(str(one["timestamp"])) for one in platform.sent)
    # Moodle compares whole seconds, and may have taken the first before it fell silent.
    assert second - first >= timedelta(seconds=1)


def test_a_busy_platform_may_name_the_moment() -> None:
    later = datetime.now(UTC) + timedelta(seconds=40)
    platform = Busy([come_again(format_datetime(later, usegmt=True))])
    with access_to(platform) as access:
        send_score(access, COLUMN, "u1", SCORE)
    (waited,) = platform.waited
    assert 2 <= waited <= 40


@pytest.mark.parametrize(
    ("answers", "failure", "asked"),
    [
        ([come_again("3600")], PlatformFailure.BUSY, 1),
        ([429] * 9, PlatformFailure.BUSY, 3),
        ([throttled] * 9, PlatformFailure.BUSY, 3),
        ([403] * 9, PlatformFailure.REFUSED, 1),
        ([500] * 9, PlatformFailure.BROKEN, 3),
        ([away] * 9, PlatformFailure.AWAY, 3),
        ([404] * 9, PlatformFailure.REFUSED, 1),
    ],
)
def test_patience_ends(answers: list[Answer | int], failure: PlatformFailure, asked: int) -> None:
    platform = Busy(answers)
    with access_to(platform) as access, pytest.raises(PlatformFailedError) as caught:
        send_score(access, COLUMN, "u1", SCORE)
    assert caught.value.failure is failure
    assert len(platform.sent) == asked


@pytest.mark.parametrize(
    ("status", "said"),
    [
        (400, "takes no score of this student"),
        (403, "does not let us send scores"),
        (404, "has this column or this student no more"),
        (409, "has a later score of this student already"),
        (422, "takes no score of this student"),
        (418, "The platform answered 418."),
    ],
)
def test_why_a_score_is_not_taken_is_a_sentence(status: int, said: str) -> None:
    with access_to(Busy([status])) as access, pytest.raises(PlatformFailedError) as caught:
        send_score(access, COLUMN, "u1", SCORE)
    assert said in str(caught.value.said)
    assert str(status) in str(caught.value.said)


@pytest.mark.parametrize("answer", [429, throttled])
def test_a_platform_that_stays_busy_is_not_called_one_that_lets_us_do_nothing(
    answer: Answer | int,
) -> None:
    with access_to(Busy([answer] * 3)) as access, pytest.raises(PlatformFailedError) as caught:
        send_score(access, COLUMN, "u1", SCORE)
    assert "asked again later" in str(caught.value.said)
