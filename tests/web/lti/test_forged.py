"""Whatever is forged, comes twice, late or by another opens nothing."""

import hashlib
import hmac
import json
import logging
from collections.abc import Callable
from dataclasses import replace
from datetime import timedelta

import pytest
from starlette.testclient import TestClient
from starlette.types import ASGIApp

from gripcourse.access.lti.states import MINUTES
from gripcourse.usecases.serving.lti import store_of
from gripcourse.web.rates import REFUSED_LINKS
from support.clock import BEGAN
from support.lti_attempt import Attempt, attempt, says, with_header
from support.lti_course import LtiCourse
from support.platform import (
    CLAIM,
    ELSEWHERE_TEACHER,
    TEACHER,
    TOOL,
    base64url,
    new_key,
    public_jwk,
    signed,
)

# ---- what is forged


def other_key(one: Attempt) -> str:
    return signed(one.header, one.claims, new_key())


def no_algorithm(one: Attempt) -> str:
    head, body, _ = one.token().split(".")
    assert head
    return ".".join([base64url(json.dumps({"alg": "none", "kid": "k1"}).encode()), body, ""])


def secret_of_public_key(one: Attempt) -> str:
    """Sign by a shared secret that everybody has: the public key."""
    header, public = {"alg": "HS256", "kid": "k1"}, public_jwk(one.school.platform.key, "k1")
    said = ".".join(base64url(json.dumps(part).encode()) for part in (header, one.claims))
    made = hmac.new(json.dumps(public).encode(), said.encode(), hashlib.sha256).digest()
    return f"{said}.{base64url(made)}"


def with_roles_changed(one: Attempt) -> str:
    head, _, signature = one.token().split(".")
    claims = {**one.claims, f"{CLAIM}roles": [TEACHER]}
    return ".".join([head, base64url(json.dumps(claims).encode()), signature])


def with_list_as_header(one: Attempt) -> str:
    _, body, signature = one.token().split(".")
    return ".".join([base64url(b'["alg", "kid"]'), body, signature])


def with_claims(**changes: object) -> Callable[[Attempt], str]:
    def token(one: Attempt) -> str:
        claims = {**one.claims, **changes}
        kept = {name: value for name, value in claims.items() if value is not None}
        return replace(one, claims=kept).token()

    return token


def later(**seconds: int) -> Callable[[Attempt], str]:
    def token(one: Attempt) -> str:
        now = int(BEGAN.timestamp())
        return with_claims(**{name: now + more for name, more in seconds.items()})(one)

    return token


FORGED: dict[str, tuple[str, Callable[[Attempt], str]]] = {
    "nothing": ("form", lambda _: ""),
    "no_token": ("form", lambda _: "a.b"),
    "five_parts": ("form", lambda one: one.token() + ".x.y"),
    "too_long": ("form", lambda one: one.token() + "A" * 60_000),
    "alg_none": ("algorithm", no_algorithm),
    "alg_hs256": ("algorithm", secret_of_public_key),
    "alg_rs512": ("algorithm", with_header(alg="RS512")),
    "asks_for_more": ("form", with_header(crit=["b64"], b64=True)),
    "asks_for_nothing_sensible": ("form", with_header(crit=[None])),
    "header_as_a_list": ("form", with_list_as_header),
    "key_unknown": ("key", with_header(kid="k9")),
    "key_unnamed": ("key", with_header(kid=None)),
    "key_brought_along": ("key", with_header(kid="mine", jwk={"kty": "RSA"}, jku="https://evil")),
    "signed_by_another": ("signature", other_key),
    "roles_changed": ("signature", with_roles_changed),
    "other_issuer": ("issuer", with_claims(iss="https://other.example.org")),
    "other_audience": ("audience", with_claims(aud="tool-8")),
    "audience_missing": ("audience", with_claims(aud=None)),
    "audience_of_several": ("audience", with_claims(aud=["tool-7", "tool-8"])),
    "audience_of_several_by_us": ("audience", with_claims(aud=["tool-7", "tool-8"], azp="tool-7")),
    "audience_empty": ("audience", with_claims(aud=[])),
    "other_party": ("audience", with_claims(aud=["tool-7"], azp="tool-8")),
    "party_in_a_list": ("audience", with_claims(azp=["tool-7"])),
    "expired": ("time", later(exp=-61, iat=-400)),
    "old": ("time", later(iat=-601)),
    "from_the_future": ("time", later(iat=61)),
    "not_yet": ("time", later(nbf=61)),
    "no_end": ("time", with_claims(exp=None)),
    "endless": ("time", with_claims(exp=float("inf"))),
    "end_of_many_digits": ("time", with_claims(exp=10**400)),
    "end_in_words": ("time", with_claims(exp="9999999999")),
    "other_nonce": ("nonce", with_claims(nonce="x")),
    "no_nonce": ("nonce", with_claims(nonce=None)),
    "other_deployment": ("deployment", with_claims(**{f"{CLAIM}deployment_id": "2"})),
    "no_deployment": ("deployment", with_claims(**{f"{CLAIM}deployment_id": None})),
    "list_of_deployments": ("deployment", with_claims(**{f"{CLAIM}deployment_id": ["1"]})),
    "other_version": ("version", with_claims(**{f"{CLAIM}version": "1.2.0"})),
    "other_message": (
        "message",
        with_claims(**{f"{CLAIM}message_type": "LtiDeepLinkingRequest"}),
    ),
    "nobody": ("claims", with_claims(sub=None)),
    "nobody_seen": ("claims", with_claims(sub="user-anna\0")),
    "nobody_of_half_letters": ("claims", with_claims(sub="user-\ud800")),
    "nobody_in_numbers": ("claims", with_claims(sub=7)),
    "long_name": ("claims", with_claims(sub="x" * 256)),
    "roles_in_a_word": ("claims", with_claims(**{f"{CLAIM}roles": TEACHER})),
    "lis_in_a_word": ("claims", with_claims(**{f"{CLAIM}lis": "s01"})),
    "no_link": ("claims", with_claims(**{f"{CLAIM}resource_link": None})),
    "no_role": ("role", with_claims(**{f"{CLAIM}roles": []})),
    "teacher_elsewhere": ("role", with_claims(**{f"{CLAIM}roles": [ELSEWHERE_TEACHER]})),
    "other_course": ("context", with_claims(**{f"{CLAIM}context": {"id": "course-3"}})),
}


@pytest.mark.parametrize("name", FORGED)
def test_what_is_forged_opens_nothing(
    school: LtiCourse, one_server: ASGIApp, name: str, caplog: pytest.LogCaptureFixture
) -> None:
    code, forge = FORGED[name]
    client = TestClient(one_server, TOOL, follow_redirects=False)
    one = attempt(school, client)
    token = forge(one)
    before = store_of(school.context).places()
    with caplog.at_level(logging.DEBUG):
        answer = client.post(
            "/lti/launch",
            data={"id_token": token, "state": one.asked["state"]},
            headers={"accept-language": "uk"},
        )
    assert answer.status_code == 403
    assert says(answer.text, code)
    assert 'lang="uk"' in answer.text
    ours = [entry for entry in caplog.records if entry.name.startswith("gripcourse")]
    assert [entry.getMessage() for entry in ours] == [f"launch refused: {code} moodle"]
    assert not token or token not in caplog.text
    assert one.asked["state"] not in "".join(entry.getMessage() for entry in ours)
    assert store_of(school.context).places() == before


def test_who_wants_to_choose_content_is_told_that_there_is_none_to_choose(
    school: LtiCourse,
) -> None:
    client = school.client()
    one = attempt(school, client)
    _, forge = FORGED["other_message"]
    sent = {"id_token": forge(one), "state": one.asked["state"]}
    answer = client.post("/lti/launch", data=sent, headers={"accept-language": "en"})
    assert "nothing to choose here" in answer.text
    assert "not from your learning platform" not in answer.text


def test_a_token_that_is_right_passes_where_each_forged_one_failed(school: LtiCourse) -> None:
    client = school.client()
    one = attempt(school, client)
    sent = {"id_token": one.token(), "state": one.asked["state"]}
    assert client.post("/lti/launch", data=sent).status_code == 303


def test_another_course_of_the_platform_learns_its_number(school: LtiCourse) -> None:
    client = school.client()
    one = attempt(school, client, "ray")
    token = with_claims(**{f"{CLAIM}context": {"id": "course-3"}})(one)
    answer = client.post("/lti/launch", data={"id_token": token, "state": one.asked["state"]})
    assert "course-3" in answer.text


# ---- what is brought back twice, late, or by another


def test_an_answer_opens_something_once(school: LtiCourse) -> None:
    client = school.client()
    one = attempt(school, client)
    sent = {"id_token": one.token(), "state": one.asked["state"]}
    assert client.post("/lti/launch", data=sent).status_code == 303
    again = client.post("/lti/launch", data=sent)
    assert again.status_code == 403
    assert says(again.text, "used")


def test_who_is_not_signed_in_at_the_platform_is_told_to_do_so_there(school: LtiCourse) -> None:
    client = school.client()
    answered = {"state": school.begin(client, "anna")["state"], "error": "login_required"}
    said = client.post("/lti/launch", data=answered, headers={"accept-language": "en"})
    assert says(said.text, "denied")
    assert "Sign in there" in said.text


def test_who_tries_in_vain_keeps_nobody_of_the_same_network_out(school: LtiCourse) -> None:
    client = school.client()
    tried = [client.get("/lti/login?iss=x").status_code for _ in range(REFUSED_LINKS.times + 1)]
    assert tried == [403] * REFUSED_LINKS.times + [429]
    assert school.come(client, "anna").status_code == 303


def test_a_token_does_not_answer_to_another_question(school: LtiCourse) -> None:
    client = school.client()
    first, second = attempt(school, client), attempt(school, client)
    sent = {"id_token": first.token(), "state": second.asked["state"]}
    assert says(client.post("/lti/launch", data=sent).text, "nonce")


def test_who_takes_too_long_begins_again(school: LtiCourse) -> None:
    client = school.client()
    one = attempt(school, client)
    school.clock.now += timedelta(minutes=MINUTES)
    claims = school.platform.claims("anna", one.asked["nonce"])
    sent = {"id_token": school.platform.token(claims), "state": one.asked["state"]}
    assert says(client.post("/lti/launch", data=sent).text, "late")


@pytest.mark.parametrize("cookies", [{}, {"gripcourse-launch": "another"}])
def test_nobody_is_made_to_come_in_as_another(school: LtiCourse, cookies: dict[str, str]) -> None:
    forger, victim = school.client(), school.client()
    one = attempt(school, forger)
    sent = {"id_token": one.token(), "state": one.asked["state"]}
    victim.cookies.update(cookies)
    answer = victim.post("/lti/launch", data=sent)
    assert answer.status_code == 403
    assert says(answer.text, "browser")


@pytest.mark.parametrize(
    "spoil", [lambda _: "", lambda one: one[:-1], lambda one: "AB"[one[0] == "A"] + one[1:]]
)
def test_a_state_that_we_did_not_give_opens_nothing(
    school: LtiCourse, spoil: Callable[[str], str]
) -> None:
    client = school.client()
    one = attempt(school, client)
    sent = {"id_token": one.token(), "state": spoil(one.asked["state"])}
    assert says(client.post("/lti/launch", data=sent).text, "state")


def test_two_windows_may_come_at_the_same_time(school: LtiCourse) -> None:
    client = school.client()
    for one in (attempt(school, client), attempt(school, client)):
        sent = {"id_token": one.token(), "state": one.asked["state"]}
        assert client.post("/lti/launch", data=sent).status_code == 303
