"""One visitor alone keeps nobody else out: by sending without end, by tries in vain, by files."""

import asyncio
from contextlib import ExitStack
from typing import TYPE_CHECKING

import pytest
from starlette.testclient import TestClient
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from gripcourse.usecases.serving.living import LivingCourse
from gripcourse.usecases.serving.sign_in import offer_sign_in
from gripcourse.web.app import make_app
from gripcourse.web.checking import make_checkers
from gripcourse.web.guard import Guard
from gripcourse.web.queues import MOST_UPLOADS
from gripcourse.web.rates import REFUSED_SIGN_INS
from gripcourse.web.site import Site

if TYPE_CHECKING:
    from web.conftest import Server


def test_a_request_that_names_its_end_in_two_ways_is_refused_and_nothing_follows_it() -> None:
    """A web server before us may go by the other: the rest would be a stranger's next request."""
    sent: list[Message] = []

    async def reached(*_: object) -> None:
        raise AssertionError

    both = [(b"content-length", b"4"), (b"transfer-encoding", b"chunked")]
    asyncio.run(through_guard(reached, both, [b""], sent))
    assert sent[0]["status"] == 400
    assert (b"connection", b"close") in sent[0]["headers"]


@pytest.mark.parametrize("reads", [True, False])
def test_who_stops_in_the_middle_of_sending_is_not_waited_for(
    monkeypatch: pytest.MonkeyPatch, *, reads: bool
) -> None:
    for seconds in ("SECONDS_OF_SILENCE", "SILENT_AFTER_REFUSAL"):
        monkeypatch.setattr(f"gripcourse.web.guard.{seconds}", 0.01)
    sent: list[Message] = []

    async def answer(_: Scope, receive: Receive, send: Send) -> None:
        while reads and (await receive())["type"] != "http.disconnect":
            pass
        await send({"type": "http.response.start", "status": 404, "headers": []})

    asyncio.run(through_guard(answer, [(b"transfer-encoding", b"chunked")], [b"x"], sent))
    assert (b"connection", b"close") in sent[0]["headers"]


async def through_guard(
    app: ASGIApp, headers: list[tuple[bytes, bytes]], parts: list[bytes], sent: list[Message]
) -> None:
    """Send parts of a body that never comes to its end."""

    async def receive() -> Message:
        if not parts:
            await asyncio.Event().wait()
        return {"type": "http.request", "body": parts.pop(), "more_body": True}

    async def send(message: Message) -> None:
        sent.append(message)

    scope = {"type": "http", "path": "/", "headers": headers}
    await Guard(app, secure=False)(scope, receive, send)


def test_one_student_sends_a_few_files_at_once_and_others_send_theirs(server: "Server") -> None:
    site = Site(LivingCourse(server.context), make_checkers(server.context, 1, None), server.clock)
    client, files = TestClient(make_app(site)), {"file": ("a.xlsx", b"PK at once")}
    mine, theirs = server.home("s01"), server.home("s02")
    token = {"authorization": f"Bearer {mine.split('/')[2]}", "accept-language": "en"}
    with ExitStack() as on_their_way:
        for _ in range(MOST_UPLOADS):
            on_their_way.enter_context(site.uploads.one_more("s01"))
        refused = client.post(f"{mine}hand-in", files=files)
        program = client.post("/api/v1/hand-ins", files=files, headers=token)
        assert client.post(f"{theirs}hand-in", files=files).status_code == 200
    assert (refused.status_code, program.status_code) == (429, 429)
    assert "still on their way" in program.json()["detail"]
    assert program.headers["retry-after"] == "5"
    assert client.post(f"{mine}hand-in", files=files).status_code == 200


def test_who_tries_to_sign_in_in_vain_keeps_no_instructor_of_the_same_network_out(
    server: "Server",
) -> None:
    client, times = server.client(), REFUSED_SIGN_INS.times
    for_programs = {"authorization": "Bearer wrong"}
    tried = [client.post(f"/desk/sign-in/wrong{n}").status_code for n in range(times)]
    tried.append(client.post("/api/v1/desk/session", headers=for_programs).status_code)
    assert tried == [403] * times + [429]
    right = offer_sign_in(server.context, "Dr. Ноль", server.clock.now)
    assert client.post(f"/desk/sign-in/{right}").status_code == 200


@pytest.mark.parametrize(("bound", "value"), [("_MOST_FILES", 1), ("_MOST", 20)])
def test_what_one_student_may_keep_is_bounded_in_number_and_size(
    server: "Server", monkeypatch: pytest.MonkeyPatch, bound: str, value: int
) -> None:
    client, home = server.client(), server.home("s03")
    before = server.context.desk.hand_ins("s03")
    added = value + (len(before) if bound == "_MOST_FILES" else sum(one.size for one in before))
    monkeypatch.setattr(f"gripcourse.usecases.serving.hand_in.{bound}", added)
    files = [{"file": ("a.xlsx", f"PK of {bound}, {n}".encode())} for n in range(2)]
    first, second = (client.post(f"{home}hand-in", files=one) for one in files)
    assert (first.status_code, second.status_code) == (200, 400)
    assert "no more room" in second.text
    assert len(server.context.desk.hand_ins("s03")) == len(before) + 1
