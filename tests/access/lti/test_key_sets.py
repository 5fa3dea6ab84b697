"""Keys of platforms are kept and renewed; no platform stands in another's way."""

import json
import threading
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any, Final

import httpx2
import pytest
from cryptography.hazmat.primitives.asymmetric.rsa import RSAPrivateKey

from gripcourse.access.lti.key_sets import KEPT_SECONDS, KeySets
from gripcourse.access.lti.refused import LaunchRefusal, LaunchRefusedError
from gripcourse.access.lti.web_client import PlatformClient, make_client
from support.platform import base64url, new_key, public_jwk

HERE: Final = "https://lms.example/jwks"
ELSEWHERE: Final = "https://other.example/jwks"
FIRST: Final = new_key()
SECOND: Final = new_key()


@dataclass(slots=True)
class Published:
    """What platforms publish; the status is that of all of them."""

    keys: list[Mapping[str, Any]] = field(default_factory=lambda: [public_jwk(FIRST, "k1")])
    status: int = 200
    asked: int = 0
    now: float = 1000.0
    before: Callable[[str], None] = lambda _: None

    @contextmanager
    def client(self) -> Iterator[PlatformClient]:
        def answer(request: httpx2.Request) -> httpx2.Response:
            self.asked += 1
            self.before(str(request.url))
            return httpx2.Response(self.status, content=json.dumps({"keys": self.keys}).encode())

        with make_client(httpx2.MockTransport(answer)) as client:
            yield client

    def sets(self) -> KeySets:
        return KeySets(self.client, lambda: self.now)


def refusal(keys: KeySets, name: str) -> LaunchRefusal:
    with pytest.raises(LaunchRefusedError) as refused:
        keys.key(HERE, name)
    return refused.value.refused


def modulus(keys: KeySets, name: str = "k1") -> int:
    return keys.key(HERE, name).public_key.public_numbers().n


def number_of(key: RSAPrivateKey) -> int:
    return key.public_key().public_numbers().n


def test_a_platform_that_does_not_answer_keeps_nobody_from_another() -> None:
    waits, may_go_on = threading.Event(), threading.Event()
    published = Published()

    def before(url: str) -> None:
        if url == HERE:
            waits.set()
            may_go_on.wait()

    published.before = before
    keys, found = published.sets(), list[int]()
    slow = threading.Thread(target=lambda: found.append(modulus(keys)))
    slow.start()
    try:
        waits.wait()
        assert keys.key(ELSEWHERE, "k1").public_key.public_numbers().n == number_of(FIRST)
        assert found == []
    finally:
        may_go_on.set()
        slow.join()
    assert found == [number_of(FIRST)]


def test_keys_that_cannot_be_renewed_stay_for_their_hour() -> None:
    published = Published()
    keys = published.sets()
    modulus(keys)
    published.status, published.now = 503, published.now + 60
    assert refusal(keys, "k9") is LaunchRefusal.KEY
    assert published.asked == 2
    assert modulus(keys) == number_of(FIRST)
    published.now += KEPT_SECONDS
    assert refusal(keys, "k1") is LaunchRefusal.KEYS


def test_a_new_key_is_found_without_waiting_for_an_hour() -> None:
    published = Published()
    keys = published.sets()
    modulus(keys)
    published.keys.append(public_jwk(SECOND, "k2"))
    assert refusal(keys, "k2") is LaunchRefusal.KEY
    published.now += 21
    assert modulus(keys, "k2") == number_of(SECOND)
    assert published.asked == 2


def test_another_key_of_the_same_name_is_found_where_the_former_signed_nothing() -> None:
    published = Published()
    keys = published.sets()
    former = keys.key(HERE, "k1")
    published.keys = [public_jwk(SECOND, "k1")]
    assert keys.key(HERE, "k1", wrong=former) is former
    published.now += 21
    assert keys.key(HERE, "k1") is former
    found = keys.key(HERE, "k1", wrong=former)
    assert found.public_key.public_numbers().n == number_of(SECOND)
    assert keys.key(HERE, "k1", wrong=former) is found
    assert published.asked == 2


def test_a_flood_of_forged_signatures_asks_no_oftener_than_each_twenty_seconds() -> None:
    published = Published()
    keys = published.sets()
    for _ in range(90):
        keys.key(HERE, "k1", wrong=keys.key(HERE, "k1"))
        published.now += 1
    assert published.asked == 5


@pytest.mark.filterwarnings("ignore:Key size")
@pytest.mark.parametrize("bits", [1024, 16_384, 11_000_000])
def test_a_key_that_is_too_short_or_takes_long_to_compute_with_is_none(
    bits: int, caplog: pytest.LogCaptureFixture
) -> None:
    n = base64url(((1 << (bits - 1)) + 1).to_bytes(bits // 8, "big"))
    published = Published(keys=[{"kty": "RSA", "kid": "k1", "n": n, "e": "AQAB"}])
    assert refusal(published.sets(), "k1") is LaunchRefusal.KEY
    # Who opens the assignment cannot mend it; the administrator learns what the platform answers.
    assert "none of 1 can be used" in caplog.text
