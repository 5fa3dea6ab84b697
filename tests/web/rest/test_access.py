"""A token opens what its owner's page shows, and nothing else; tried with every operation."""

from datetime import UTC, datetime
from typing import TYPE_CHECKING

import pytest

from gripcourse.access.desk.links import SignedLink, link_text
from gripcourse.web.rest.app import OPERATIONS, REST
from gripcourse.web.rest.declare import PLACES, ApiOperation, TokenRole

if TYPE_CHECKING:
    from httpx2 import Response
    from starlette.testclient import TestClient

    from web.rest.conftest import Api

SECRET = b"the work of s03"
END = datetime(2026, 12, 31, tzinfo=UTC)
EVERY = pytest.mark.parametrize("operation", OPERATIONS, ids=lambda one: f"{one.method} {one.path}")


def ask(
    client: "TestClient", operation: ApiOperation, token: str | None, scheme: str = "Bearer"
) -> "Response":
    path = PLACES.sub(lambda place: "1" if place[2] else "s03", operation.path)
    headers = {} if token is None else {"Authorization": f"{scheme} {token}"}
    return client.request(operation.method, f"{REST}{path}", headers=headers)


@pytest.fixture
def neighbour(api: "Api") -> "Api":
    """The third student has handed in something."""
    headers = {"Authorization": f"Bearer {api.link('s03')}"}
    files = {"file": ("secret.xlsx", SECRET)}
    made = api.client().post(f"{REST}/hand-ins", files=files, headers=headers)
    assert made.status_code == 201
    return api


def own_of_third(api: "Api") -> tuple[bytes, ...]:
    third = api.server.classroom.register["s03"]
    return (SECRET, b"secret.xlsx", third.student.name.encode(), third.signature.encode())


@EVERY
def test_a_token_that_is_none_of_this_role_opens_nothing(
    neighbour: "Api", operation: ApiOperation
) -> None:
    key, course = neighbour.server.context.key, neighbour.server.context.course.id
    good = neighbour.link("s03")
    session = neighbour.token(TokenRole.INSTRUCTOR)
    student = operation.role is TokenRole.STUDENT
    ended = neighbour.token(TokenRole.INSTRUCTOR)
    neighbour.server.context.desk.end_session(ended, neighbour.server.clock.now)
    links = {
        link_text(SignedLink("s03", END, 0), bytes(32), course): "link_forged",
        link_text(SignedLink("s03", END, 0), key, "other"): "link_forged",
        good.replace("s03", "s01"): "link_forged",
        neighbour.link("s03", days=-1): "link_expired",
        link_text(SignedLink("s03", END, 7), key, course): "link_revoked",
    }
    tokens = (
        {**links, session: "link_forged"}
        if student
        else dict.fromkeys((*links, good, ended, "guess"), "not_signed_in")
    )
    tokens |= {} if operation.role is not TokenRole.SIGN_IN else {session: "not_signed_in"}
    client, desk, own = neighbour.client(), neighbour.server.context.desk, own_of_third(neighbour)
    before = desk.hand_ins(), desk.checks(), desk.requests(), desk.publications()
    for token, code in tokens.items():
        answer = ask(client, operation, token)
        assert (answer.status_code, answer.json()["code"]) == (401, code)
        assert answer.headers["content-type"] == "application/problem+json"
        assert answer.headers["www-authenticate"] == 'Bearer error="invalid_token"'
        assert not any(one in answer.content for one in own)
    for token, scheme in ((None, ""), (good, "Basic"), ("", "Bearer")):
        answer = ask(client, operation, token, scheme)
        assert (answer.status_code, answer.json()["code"]) == (401, "no_token")
        assert answer.headers["www-authenticate"] == "Bearer"
    assert (desk.hand_ins(), desk.checks(), desk.requests(), desk.publications()) == before


@pytest.mark.parametrize(
    "operation",
    [one for one in OPERATIONS if one.role is TokenRole.STUDENT],
    ids=lambda one: f"{one.method} {one.path}",
)
def test_a_neighbours_token_opens_nothing_of_a_student(
    neighbour: "Api", operation: ApiOperation
) -> None:
    content = ask(neighbour.client(), operation, neighbour.link("s01")).content
    assert not any(own in content for own in own_of_third(neighbour))


def test_the_cookie_of_the_desk_is_no_token(api: "Api") -> None:
    cookie = {"cookie": f"gripcourse-desk={api.token(TokenRole.INSTRUCTOR)}"}
    answer = api.client().post(f"{REST}/desk/withdraw", headers=cookie)
    assert answer.status_code == 401


def test_who_tries_tokens_has_to_wait(api: "Api") -> None:
    client = api.client()
    found = [
        client.get(f"{REST}/status", headers={"Authorization": "Bearer x"}).status_code
        for _ in range(61)
    ]
    assert found == [401] * 60 + [429]
