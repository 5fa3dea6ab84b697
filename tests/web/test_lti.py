"""Who comes by a learning platform is let in as whom it says; whatever is forged opens nothing."""

import hashlib
import hmac
import json
import logging
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from datetime import timedelta
from pathlib import Path
from typing import Any

import pytest
from starlette.testclient import TestClient
from starlette.types import ASGIApp

from gripcourse.access.lti.model import Bond
from gripcourse.access.lti.platforms import add_platform, load_platforms, platforms_path
from gripcourse.access.lti.states import MINUTES
from gripcourse.policy.model import Policy
from gripcourse.usecases.serving.links import revoke_links
from gripcourse.usecases.serving.lti import bind, store_of, user_key
from gripcourse.web.rates import REFUSED_LINKS
from gripcourse.web.serve import Serving, platform_routes
from support.clock import BEGAN
from support.lti_course import LtiCourse, on_its_first_day, open_lti_course
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


@pytest.fixture(scope="module")
def opened(tmp_path_factory: pytest.TempPathFactory, policy: Policy) -> Iterator[LtiCourse]:
    with open_lti_course(tmp_path_factory.mktemp("lti"), policy) as made:
        yield made


@pytest.fixture
def school(opened: LtiCourse) -> Iterator[LtiCourse]:
    """The same course on its first day."""
    with on_its_first_day(opened) as made:
        yield made


@pytest.fixture(scope="module")
def one_server(opened: LtiCourse) -> ASGIApp:
    """A server for many visitors who are all refused."""
    return opened.app()


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


# ---- the way in


def test_a_student_comes_to_the_pages_of_that_student(school: LtiCourse) -> None:
    client = school.client()
    answer = school.come(client, "anna")
    assert answer.status_code == 303
    assert answer.headers["location"].startswith("/s/s01~")
    assert "Иванова" in client.get(answer.headers["location"]).text


def test_a_student_is_known_by_the_address_of_mail_too(school: LtiCourse) -> None:
    assert school.come(school.client(), "oksana").headers["location"].startswith("/s/s02~")


def test_the_link_that_a_student_gets_ends_the_same_day(school: LtiCourse) -> None:
    client = school.client()
    link = school.come(client, "anna").headers["location"]
    school.clock.now += timedelta(hours=13)
    assert client.get(link).status_code == 410


def test_whose_links_were_revoked_comes_by_the_platform_nevertheless(school: LtiCourse) -> None:
    client = school.client()
    before = school.come(client, "oksana").headers["location"]
    revoke_links(school.context, "s02", "Dr. Ray", BEGAN)
    assert client.get(before).status_code == 410
    assert client.get(school.come(client, "oksana").headers["location"]).status_code == 200


def test_an_instructor_comes_to_the_desk(school: LtiCourse) -> None:
    client = school.client()
    door = school.come(client, "ray").headers["location"]
    assert door.startswith("/desk/sign-in/")
    assert client.post(door).headers["location"] == "/desk/"
    assert "Dr. Ray (moodle)" in client.get("/desk/").text


def test_who_is_unknown_waits_at_the_desk_until_an_instructor_says_who_it_is(
    school: LtiCourse,
) -> None:
    stranger, client = school.client(), school.client()
    assert school.come(stranger, "nobody").status_code == 403
    client.post(school.come(client, "ray").headers["location"])
    page = client.get("/desk/people").text
    key = re.search(r'name="form_key" value="([0-9a-f]{64})"', page)
    assert key is not None
    assert 'href="/desk/people" aria-current="page"' in page
    assert "Nobody Known" in page
    declared = school.declared
    form = {"form_key": key[1], "issuer": declared.issuer, "client": declared.client_id}
    form |= {"user": "user-nobody", "student": "s03"}
    for wrong in ({"user": "somebody"}, {"issuer": "https://other"}, {"student": ""}):
        assert client.post("/desk/people", data=form | wrong).status_code == 404
    assert client.post("/desk/people", data=form | {"student": "s99"}).status_code == 409
    assert client.post("/desk/people", data=form | {"form_key": "0"}).status_code == 403
    assert client.post("/desk/people", data=form).headers["location"] == "/desk/people"
    assert "Nobody Known" not in client.get("/desk/people").text
    assert school.come(stranger, "nobody").headers["location"].startswith("/s/s03~")
    bond = store_of(school.context).bonds()[user_key(declared, "user-nobody")]
    assert (bond.student, bond.by) == ("s03", "Dr. Ray (moodle)")


def test_a_launch_may_be_begun_by_a_form(school: LtiCourse) -> None:
    sent = {"iss": school.platform.address, "login_hint": "anna", "client_id": "tool-7"}
    answer = school.client().post("/lti/login", data=sent)
    assert answer.status_code == 303
    assert "login_hint=anna" in answer.headers["location"]


def test_what_the_platform_lets_us_do_is_known_after_a_launch(school: LtiCourse) -> None:
    school.come(school.client(), "anna")
    (place,) = store_of(school.context).places()
    assert place.line_item == f"{school.platform.address}/lines/1?type_id=2"
    assert (place.context, place.link) == ("course-2", "activity-5")


def test_only_public_halves_of_our_keys_are_shown(school: LtiCourse) -> None:
    (key,) = school.client().get("/lti/keys.json").json()["keys"]
    assert set(key) == {"kty", "n", "e", "kid", "use", "alg"}


# ---- who is who


@pytest.mark.parametrize("hint", ["nobody", "double", "contrary"])
def test_who_cannot_be_told_sees_nobodys_things_and_stands_on_the_list(
    school: LtiCourse, hint: str
) -> None:
    answer = school.come(school.client(), hint)
    assert answer.status_code == 403
    assert f"user-{hint}" in answer.text
    assert "location" not in answer.headers
    strangers = {one.user: one.reason for one in store_of(school.context).strangers()}
    assert strangers[f"user-{hint}"] == ("unknown" if hint == "nobody" else "ambiguous")


def test_who_takes_the_address_of_another_is_not_that_student(school: LtiCourse) -> None:
    school.come(school.client(), "anna")
    school.platform.users["thief"] = school.platform.users["anna"]
    answer = school.come(school.client(), "thief")
    assert answer.status_code == 403
    assert {one.user: one.reason for one in store_of(school.context).strangers()}[
        "user-thief"
    ] == "taken"
    # And the one who was first comes as before.
    assert school.come(school.client(), "anna").status_code == 303


def test_of_two_who_come_at_once_one_is_that_student(school: LtiCourse) -> None:
    store, one = store_of(school.context), school.declared
    first, second, elsewhere = (
        Bond(issuer, one.client_id, user, "s03", "rule", BEGAN)
        for issuer, user in ((one.issuer, "u1"), (one.issuer, "u2"), ("https://other", "u2"))
    )
    # Both found nobody who is that student; what is kept is looked at again when it is added to.
    assert store.bind(first) is None
    assert store.bind(second) == first
    assert store.bind(elsewhere) is None
    assert set(store.bonds().values()) == {first, elsewhere}


def test_who_was_told_once_stays_that_student(
    school: LtiCourse, monkeypatch: pytest.MonkeyPatch
) -> None:
    school.come(school.client(), "anna")
    changed = {"email": "oksana@example.org", f"{CLAIM}lis": {"person_sourcedid": "s02"}}
    monkeypatch.setitem(school.platform.users, "anna", changed)
    assert school.come(school.client(), "anna").headers["location"].startswith("/s/s01~")


def test_an_address_with_a_sign_that_folds_to_the_letter_is_anothers(
    school: LtiCourse, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The sign of kelvin becomes a k where letters are folded; a mail server tells them apart."""
    said = {"email": "o\N{KELVIN SIGN}sana@example.org"}
    monkeypatch.setitem(school.platform.users, "alike", said)
    assert school.come(school.client(), "alike").status_code == 403
    assert school.come(school.client(), "oksana").headers["location"].startswith("/s/s02~")


def test_an_address_that_the_platform_doubts_tells_nothing(
    school: LtiCourse, monkeypatch: pytest.MonkeyPatch
) -> None:
    said = {"email": "oksana@example.org", "email_verified": False}
    monkeypatch.setitem(school.platform.users, "doubted", said)
    assert school.come(school.client(), "doubted").status_code == 403


def test_an_instructor_says_who_somebody_is(school: LtiCourse) -> None:
    assert school.come(school.client(), "double").status_code == 403
    bind(school.context, school.declared, "user-double", "s04", "Dr. Ray", BEGAN)
    assert school.come(school.client(), "double").headers["location"].startswith("/s/s04~")
    assert "user-double" not in {one.user for one in store_of(school.context).strangers()}


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


def with_header(**changes: object) -> Callable[[Attempt], str]:
    def token(one: Attempt) -> str:
        return signed({**one.header, **changes}, one.claims, one.school.platform.key)

    return token


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


# ---- where somebody is led


@pytest.mark.parametrize("target", ["https://evil.example/", "//evil.example", "javascript:x"])
def test_nobody_is_led_to_where_a_launch_says(school: LtiCourse, target: str) -> None:
    client = school.client()
    asked = school.begin(client, "anna", target_link_uri=target)
    assert asked["redirect_uri"] == "http://testserver/lti/launch"
    claims = school.platform.claims("anna", asked["nonce"], **{f"{CLAIM}target_link_uri": target})
    sent = {"id_token": school.platform.token(claims), "state": asked["state"]}
    answer = client.post("/lti/launch", data=sent, headers={"host": "evil.example"})
    assert answer.headers["location"].startswith("/s/s01~")


@pytest.mark.parametrize(
    "sent",
    [
        {},
        {"iss": "https://other.example.org", "login_hint": "anna"},
        {"iss": "{platform}", "login_hint": "anna", "client_id": "tool-8"},
        {"iss": "{platform}"},
    ],
)
def test_a_platform_that_nobody_declared_is_not_asked(
    school: LtiCourse, sent: dict[str, str]
) -> None:
    query = {name: one.format(platform=school.platform.address) for name, one in sent.items()}
    answer = school.client().get("/lti/login", params=query)
    assert answer.status_code == 403
    assert says(answer.text, "platform")


def test_within_a_page_of_the_platform_a_window_is_offered(school: LtiCourse) -> None:
    client = school.client()
    sent = {"iss": school.platform.address, "login_hint": "a&b", "lti_message_hint": "7"}
    answer = client.post("/lti/login", data=sent, headers={"sec-fetch-dest": "iframe"})
    assert answer.status_code == 200
    assert 'target="_blank"' in answer.text
    assert f"login_hint={'a%26b'}" in answer.text
    assert f"frame-ancestors {school.platform.address}" in answer.headers["content-security-policy"]
    assert "x-frame-options" not in answer.headers
    assert "set-cookie" not in answer.headers


def test_no_page_on_which_something_can_be_done_is_shown_within_another(
    school: LtiCourse,
) -> None:
    client = school.client()
    for path in (school.come(client, "anna").headers["location"], "/desk/", "/"):
        headers = client.get(path).headers
        assert "frame-ancestors 'none'" in headers["content-security-policy"]
        assert headers["x-frame-options"] == "DENY"


def test_by_https_the_cookie_cannot_be_set_by_a_neighbour_and_travels_with_the_answer(
    school: LtiCourse,
) -> None:
    sent = {"iss": school.platform.address, "login_hint": "anna"}
    cookie = school.client(secure=True).get("/lti/login", params=sent).headers["set-cookie"]
    assert cookie.startswith("__Host-gripcourse-launch=")
    assert {"HttpOnly", "Secure", "SameSite=none", "Path=/"} <= set(cookie.split("; "))


def test_a_form_that_is_too_large_is_not_read(school: LtiCourse) -> None:
    client = school.client()
    assert client.post("/lti/launch", data={"id_token": "x" * 100_001}).status_code == 400
    many = "&".join(f"a{number}=1" for number in range(51))
    assert client.get(f"/lti/login?{many}").status_code == 400


# ---- the platform's keys


def test_keys_are_fetched_once_and_a_flood_of_unknown_ones_asks_no_oftener(
    school: LtiCourse,
) -> None:
    client, before = school.client(), school.platform.asked
    for _ in range(3):
        one = attempt(school, client)
        sent = {"id_token": with_header(kid="k9")(one), "state": one.asked["state"]}
        client.post("/lti/launch", data=sent)
    assert school.come(client, "anna").status_code == 303
    assert school.platform.asked == before + 1


def test_a_platform_that_does_not_answer_lets_nobody_in(school: LtiCourse) -> None:
    school.platform.down = True
    answer = school.come(school.client(), "anna")
    assert answer.status_code == 503
    assert says(answer.text, "keys")


# ---- what is declared


def test_a_server_has_the_way_in_where_a_platform_is_declared(
    school: LtiCourse, tmp_path: Path
) -> None:
    serving = Serving("127.0.0.1", 0, "https://course.example.org", None, None, 0)
    site = school.site()
    assert [one.path for one in platform_routes(site, serving)] == [
        "/lti/login",
        "/lti/launch",
        "/lti/keys.json",
        *("/desk/people", "/desk/people"),
    ]
    elsewhere = replace(school.context.course, root=tmp_path)
    other = replace(site, context=replace(school.context, course=elsewhere))
    assert platform_routes(other, serving) == []


def test_a_platform_is_declared_while_the_server_runs(school: LtiCourse) -> None:
    client, root = school.client(), school.context.course.root
    other = replace(school.declared, name="canvas", client_id="tool-9")
    add_platform(root, other)
    assert set(load_platforms(root)) == {"moodle", "canvas"}
    # Two of one issuer are told apart by what they call us.
    sent = {"iss": school.platform.address, "login_hint": "anna"}
    assert client.get("/lti/login", params=sent).status_code == 403
    answer = client.get("/lti/login", params={**sent, "client_id": "tool-9"})
    assert "client_id=tool-9" in answer.headers["location"]


def test_a_mistake_in_what_is_declared_is_told_to_who_can_mend_it(
    school: LtiCourse, caplog: pytest.LogCaptureFixture
) -> None:
    client, path = school.client(), platforms_path(school.context.course.root)
    path.write_text(path.read_text("utf-8") + "\n[platform.second\n", encoding="utf-8")
    answer = client.get(
        "/lti/login", params={"iss": "https://x"}, headers={"accept-language": "en"}
    )
    assert answer.status_code == 503
    assert "the log of the server says which" in answer.text
    (entry,) = [one for one in caplog.records if one.name.startswith("gripcourse")]
    assert entry.getMessage().startswith("private/lti.toml: line ")
    assert entry.exc_info is None


def test_what_is_declared_and_our_key_are_only_their_owners(school: LtiCourse) -> None:
    private = school.context.private
    for name in ("lti.toml", "lti_key.json"):
        assert (private / name).stat().st_mode & 0o077 == 0
