"""A platform is asked within limits of time and size, whatever it does instead of answering."""

import gzip
import json
import socket
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from datetime import UTC, datetime
from typing import Final

import httpx2
import pytest
from joserfc.jwk import KeySet, RSAKey

from gripcourse.access.lti.given_access import Access, open_access
from gripcourse.access.lti.launch import MEMBERS_SCOPE, SCORE_SCOPE
from gripcourse.access.lti.platforms import Platform
from gripcourse.access.lti.refused import PlatformFailedError
from gripcourse.access.lti.services import Score, send_score, students_of
from gripcourse.access.lti.web_client import PlatformClient, PlatformQuestion, ask, make_client
from support.lti_course import declared_as
from support.platform import LEARNER, StandIn, new_key

NOW: Final = datetime(2026, 10, 1, 9, 30, tzinfo=UTC)
HEAD: Final = b"HTTP/1.1 200 OK\r\nContent-Type: application/json\r\n"


def letter_by_letter(connection: socket.socket, ended: threading.Event) -> None:
    connection.sendall(HEAD)
    while not ended.wait(0.02):
        connection.sendall(b"x")


def always_about_to_answer(connection: socket.socket, ended: threading.Event) -> None:
    while not ended.wait(0.02):
        connection.sendall(b"HTTP/1.1 100 Continue\r\n\r\n")


def a_body_without_end(connection: socket.socket, ended: threading.Event) -> None:
    connection.sendall(HEAD + b"Content-Length: 1000000\r\n\r\n")
    while not ended.wait(0.02):
        connection.sendall(b" ")


def silent(_: socket.socket, ended: threading.Event) -> None:
    ended.wait()


def too_large(connection: socket.socket, _: threading.Event) -> None:
    connection.sendall(HEAD + b"Content-Length: 9000000\r\n\r\n" + b" " * 9_000_000)


def packed(connection: socket.socket, _: threading.Event) -> None:
    body = gzip.compress(b" " * 1_000_000)
    head = f"Content-Encoding: gzip\r\nContent-Length: {len(body)}\r\n\r\n"
    connection.sendall(HEAD + head.encode() + body)


@contextmanager
def served(behaves: Callable[[socket.socket, threading.Event], None]) -> Iterator[str]:
    """Run a server that takes one connection and does something with it."""
    ended = threading.Event()
    with socket.create_server(("127.0.0.1", 0)) as server:

        def serve() -> None:
            connection, _ = server.accept()
            with connection:
                connection.recv(65_536)
                try:
                    behaves(connection, ended)
                except OSError:  # who asked has gone
                    return

        thread = threading.Thread(target=serve)
        thread.start()
        try:
            yield f"http://127.0.0.1:{server.getsockname()[1]}/jwks"
        finally:
            ended.set()
            thread.join()


@pytest.mark.parametrize(
    "behaves",
    [letter_by_letter, always_about_to_answer, a_body_without_end, silent, too_large, packed],
)
def test_who_answers_too_much_or_too_slowly_is_not_waited_for(
    behaves: Callable[[socket.socket, threading.Event], None],
) -> None:
    with (
        served(behaves) as address,
        make_client(seconds=0.3 if behaves is not too_large else 30) as client,
        pytest.raises(PlatformFailedError, match="too much or too slowly"),
    ):
        ask(client, PlatformQuestion(address))


@pytest.mark.parametrize("target", ["http://169.254.169.254/", "https://elsewhere.example/jwks"])
def test_nobody_is_led_elsewhere_by_an_answer(target: str) -> None:
    asked: list[str] = []

    def redirecting(request: httpx2.Request) -> httpx2.Response:
        asked.append(str(request.url))
        return httpx2.Response(302, headers={"Location": target})

    with (
        make_client(httpx2.MockTransport(redirecting)) as client,
        pytest.raises(PlatformFailedError, match="302"),
    ):
        ask(client, PlatformQuestion("https://lms.example/jwks"))
    assert asked == ["https://lms.example/jwks"]


# ---- pages, and addresses that a platform names


def declared(address: str) -> Platform:
    return declared_as(StandIn(new_key(), NOW.timestamp, address=address))


def granted(client: PlatformClient, scope: str) -> Access:
    platform = declared("https://lms.example")
    return Access(client, platform, KeySet([]), lambda: NOW, tokens={scope: "t"})


def member(user: str) -> dict[str, object]:
    return {"user_id": user, "roles": [LEARNER], "name": user}


@contextmanager
def paging(following: Callable[[int], str], asked: list[str]) -> Iterator[PlatformClient]:
    """Answer each page of members with a person and the address of the next page."""

    def answer(request: httpx2.Request) -> httpx2.Response:
        asked.append(str(request.url))
        number = len(asked)
        link = following(number)
        headers = {"Link": f'<{link}>; rel="next"'} if link else {}
        body = json.dumps({"members": [member(f"u{number}")]}).encode()
        return httpx2.Response(200, headers=headers, content=body)

    with make_client(httpx2.MockTransport(answer)) as client:
        yield client


MEMBERS: Final = "https://lms.example/members"
OUR_KEY: Final = KeySet([RSAKey.generate_key(2048)])


@pytest.mark.parametrize(
    ("following", "said"),
    [
        (lambda _: MEMBERS, "do not end"),
        (lambda number: f"{MEMBERS}?page={number % 3}", "do not end"),
        (lambda number: f"{MEMBERS}?page={number}", "do not end"),
        (lambda _: "https://elsewhere.example/members", "another machine"),
        (lambda _: "http://lms.example/members", "another machine"),
        (lambda _: "http://127.0.0.1/members", "another machine"),
        (lambda _: "file:///etc/passwd", "another machine"),
        (lambda _: "https://[x/", "not by https"),
    ],
)
def test_pages_that_lead_elsewhere_or_nowhere_make_no_half_roster(
    following: Callable[[int], str], said: str
) -> None:
    asked: list[str] = []
    with paging(following, asked) as client, pytest.raises(PlatformFailedError, match=said):
        students_of(granted(client, MEMBERS_SCOPE), MEMBERS)
    assert {httpx2.URL(one).host for one in asked} == {"lms.example"}


def test_a_course_of_ever_more_people_ends(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("gripcourse.access.lti.services._MOST_PEOPLE", 3)
    asked: list[str] = []
    with (
        paging(lambda number: f"{MEMBERS}?page={number}", asked) as client,
        pytest.raises(PlatformFailedError, match="do not end"),
    ):
        students_of(granted(client, MEMBERS_SCOPE), MEMBERS)
    assert len(asked) == 4


@pytest.mark.parametrize("token", ["", " ", "a b", "a\r\nX: y", "é"])
def test_access_that_cannot_be_shown_is_none(token: str) -> None:
    def answer(_: httpx2.Request) -> httpx2.Response:
        return httpx2.Response(200, json={"access_token": token})

    with (
        make_client(httpx2.MockTransport(answer)) as client,
        pytest.raises(PlatformFailedError, match="gave no access"),
    ):
        open_access(Access(client, declared(MEMBERS), OUR_KEY, lambda: NOW), [MEMBERS_SCOPE])


def test_the_next_page_may_be_named_from_the_one_before() -> None:
    asked: list[str] = []
    with paging(lambda number: "?page=2" if number == 1 else "", asked) as client:
        access = granted(client, MEMBERS_SCOPE)
        people = students_of(access, MEMBERS)
    assert [one.user for one in people] == ["u1", "u2"]
    assert asked == [MEMBERS, f"{MEMBERS}?page=2"]


def test_a_platform_by_https_sends_no_score_to_this_machine() -> None:
    asked: list[str] = []
    score = Score(points=4, maximum=10, comment="", final=True)
    with paging(lambda _: "", asked) as client:
        access = granted(client, SCORE_SCOPE)
        with pytest.raises(PlatformFailedError, match="not by https"):
            send_score(access, "http://127.0.0.1:9/lines/1", "u1", score)
        assert asked == []
        send_score(access, "https://lms.example/lines/1", "u1", score)
    assert asked == ["https://lms.example/lines/1/scores"]
