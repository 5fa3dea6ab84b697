"""Where somebody is led, whose keys are believed, and what is declared of a platform."""

from dataclasses import replace
from pathlib import Path

import pytest

from gripcourse.access.lti.platforms import add_platform, load_platforms, platforms_path
from gripcourse.usecases.serving.living import LivingCourse
from gripcourse.web.serve import Serving, platform_routes
from support.lti_attempt import attempt, says, with_header
from support.lti_course import LtiCourse
from support.platform import CLAIM

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
    other = replace(site, living=LivingCourse(replace(school.context, course=elsewhere)))
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
