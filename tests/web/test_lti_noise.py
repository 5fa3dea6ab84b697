"""Whatever comes in the place of a token, of keys or of members is understood or refused.

Requests are looked at in `test_lti`; here the parts that read what came are given noise.
"""

import json
from collections.abc import Callable
from contextlib import AbstractContextManager
from datetime import UTC, datetime
from typing import Any, Final

import httpx2
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from joserfc.jwk import KeySet

from gripcourse.access.lti.given_access import Access
from gripcourse.access.lti.key_sets import KeySets
from gripcourse.access.lti.launch import MEMBERS_SCOPE, PlatformRole, read_launch
from gripcourse.access.lti.platforms import Platform
from gripcourse.access.lti.refused import LaunchRefusedError, PlatformFailedError
from gripcourse.access.lti.services import students_of
from gripcourse.access.lti.web_client import PlatformClient, make_client
from support.lti_course import declared_as
from support.platform import CLAIM, StandIn, new_key, public_jwk, signed

NOW: Final = datetime(2026, 10, 1, 9, 30, tzinfo=UTC)
NONCE: Final = "n-1"
HEADER: Final = {"alg": "RS256", "kid": "k1"}
KEY: Final = new_key()
STAND_IN: Final = StandIn(KEY, NOW.timestamp, address="http://127.0.0.1:9")
PLATFORM: Final[Platform] = declared_as(STAND_IN)
CLAIMS: Final = STAND_IN.claims("anna", NONCE)
DECIDES: Final = (
    *("iss", "nonce", f"{CLAIM}version", f"{CLAIM}message_type", f"{CLAIM}deployment_id"),
    *("aud", f"{CLAIM}context"),
)
"""Claims without which nobody is let in."""

JSON: Final = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(), inner, max_size=3),
    max_leaves=6,
)
quick = settings(max_examples=25, derandomize=True, database=None, deadline=None)


def answering(body: Callable[[], bytes]) -> AbstractContextManager[PlatformClient]:
    """Return what asks a platform that answers always the same."""
    return make_client(httpx2.MockTransport(lambda _: httpx2.Response(200, content=body())))


def keys_of(found: object) -> KeySets:
    return KeySets(lambda: answering(lambda: json.dumps(found).encode()))


GOOD: Final = keys_of({"keys": [public_jwk(KEY, "k1")]})


def test_what_is_spoiled_below_opens_something_as_it_is() -> None:
    launch = read_launch(signed(HEADER, CLAIMS, KEY), PLATFORM, GOOD, NONCE, NOW)
    assert launch.role is PlatformRole.STUDENT


@quick
@given(st.text(max_size=200) | st.binary(max_size=200).map(lambda raw: raw.decode("latin-1")))
def test_no_noise_is_a_token(noise: str) -> None:
    good = signed(HEADER, CLAIMS, KEY).split(".")
    for token in (noise, *(".".join([*good[:n], noise, *good[n + 1 :]]) for n in range(3))):
        if token.split(".") == good:
            continue
        with pytest.raises(LaunchRefusedError):
            read_launch(token, PLATFORM, GOOD, NONCE, NOW)


@quick
@given(st.sampled_from(sorted(CLAIMS)), JSON)
def test_a_claim_of_any_kind_is_understood_or_refused(name: str, value: Any) -> None:  # noqa: ANN401 (whatever JSON holds)
    try:
        launch = read_launch(
            signed(HEADER, {**CLAIMS, name: value}, KEY), PLATFORM, GOOD, NONCE, NOW
        )
    except LaunchRefusedError:
        return
    assert name not in DECIDES or value == CLAIMS[name]
    assert launch.role is PlatformRole.STUDENT


@quick
@given(st.dictionaries(st.sampled_from(["alg", "kid", "typ", "crit", "b64", "jku", "zip"]), JSON))
def test_a_header_of_any_kind_opens_nothing_but_with_our_algorithm(header: dict[str, Any]) -> None:
    token = signed({**HEADER, **header}, CLAIMS, KEY)
    try:
        read_launch(token, PLATFORM, GOOD, NONCE, NOW)
    except LaunchRefusedError:
        return
    assert {**HEADER, **header}["alg"] == "RS256"


@quick
@given(JSON | st.builds(lambda part: {"keys": [{**public_jwk(KEY, "k1"), **part}]}, st.dictionaries(
    st.sampled_from(["kty", "kid", "n", "e", "alg", "use", "d"]), JSON, min_size=1)))  # fmt: skip
def test_a_set_of_keys_of_any_kind_is_understood_or_refused(found: object) -> None:
    try:
        read_launch(signed(HEADER, CLAIMS, KEY), PLATFORM, keys_of(found), NONCE, NOW)
    except LaunchRefusedError:
        return
    assert isinstance(found, dict)


@quick
@given(JSON | st.builds(lambda one: {"members": [one]}, JSON | st.dictionaries(
    st.sampled_from(["user_id", "roles", "status", "name", "email"]), JSON)))  # fmt: skip
def test_members_of_any_kind_are_named_or_refused(found: object) -> None:
    with answering(lambda: json.dumps(found).encode()) as client:
        access = Access(client, PLATFORM, KeySet([]), lambda: NOW, tokens={MEMBERS_SCOPE: "token"})
        try:
            people = students_of(access, f"{STAND_IN.address}/members")
        except PlatformFailedError:
            return
    assert all(isinstance(one.user, str) for one in people)
