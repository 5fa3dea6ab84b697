"""Who opens a connection and asks nothing is let go; who is answered slowly is not."""

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

import pytest
from starlette.types import ASGIApp, Receive, Scope, Send
from uvicorn import Config
from uvicorn.server import ServerState

from gripcourse.web.connections import EndingProtocol

WHOLE = b"GET / HTTP/1.1\r\nHost: x\r\n\r\n"
SECONDS = 0.1


@pytest.fixture(autouse=True)
def impatient(monkeypatch: pytest.MonkeyPatch) -> None:
    for limit in ("SECONDS_OF_HEAD", "SECONDS_OF_READING"):
        monkeypatch.setattr(f"gripcourse.web.connections.{limit}", SECONDS)


async def slow(_: Scope, _receive: Receive, send: Send) -> None:
    await asyncio.sleep(3 * SECONDS)
    headers = [(b"content-length", b"2")]
    await send({"type": "http.response.start", "status": 200, "headers": headers})
    await send({"type": "http.response.body", "body": b"ok"})


@asynccontextmanager
async def connected(
    app: ASGIApp = slow,
) -> AsyncIterator[tuple[asyncio.StreamReader, asyncio.StreamWriter]]:
    """Connect to a server that speaks by our protocol."""
    config, state = Config(app, log_level="critical"), ServerState()
    server = await asyncio.get_running_loop().create_server(
        lambda: EndingProtocol(config, state, {}), "127.0.0.1", 0
    )
    async with server:
        reader, writer = await asyncio.open_connection(*server.sockets[0].getsockname())
        try:
            yield reader, writer
        finally:
            writer.close()


@pytest.mark.parametrize("letter", [b"", b"A"])
def test_a_connection_without_a_whole_head_ends_though_letters_trickle_in(letter: bytes) -> None:
    async def hold() -> bytes:
        async with connected() as (reader, writer):
            for _ in range(1000):
                writer.write(letter)
                try:
                    return await asyncio.wait_for(reader.read(1), SECONDS / 10)
                except TimeoutError:
                    continue
        raise AssertionError

    assert asyncio.run(hold()) == b""


def test_who_is_answered_slowly_may_ask_again_on_the_same_connection() -> None:
    async def asked_twice() -> list[bytes]:
        heads = []
        async with connected() as (reader, writer):
            for _ in range(2):
                writer.write(WHOLE)
                heads.append(await reader.readline())
                await reader.readuntil(b"\r\n\r\nok")
        return heads

    assert asyncio.run(asked_twice()) == [b"HTTP/1.1 200 OK\r\n"] * 2


def test_who_asks_for_much_and_reads_nothing_is_left() -> None:
    async def told_that_nobody_reads() -> None:
        ended = asyncio.Event()

        async def much(_: Scope, _receive: Receive, send: Send) -> None:
            await send({"type": "http.response.start", "status": 200, "headers": []})
            for _number in range(100):  # more than all that lies between us keeps
                part = {"type": "http.response.body", "body": bytes(1_000_000), "more_body": True}
                await send(part)
            ended.set()

        async with connected(much) as (_, writer):
            writer.write(WHOLE)
            await asyncio.wait_for(ended.wait(), 50 * SECONDS)

    asyncio.run(told_that_nobody_reads())
