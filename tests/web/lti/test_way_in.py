"""Who comes by a learning platform is let in as whom it says."""

import re
from datetime import timedelta

import pytest

from gripcourse.access.lti.model import Bond
from gripcourse.usecases.serving.links import revoke_links
from gripcourse.usecases.serving.lti import bind, store_of, user_key
from support.clock import BEGAN
from support.lti_course import LtiCourse
from support.platform import (
    CLAIM,
)

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
