"""What stands before every page: how much may be sent, and what a browser is told to refuse."""

from collections.abc import Iterable
from http import HTTPStatus
from typing import Final

from anyio import move_on_after
from starlette.datastructures import Headers, MutableHeaders
from starlette.responses import Response
from starlette.types import ASGIApp, Message, Receive, Scope, Send

LARGEST_BODY: Final = 20_000_000
"""Bytes of one request: a workbook with pictures has a few million."""
LARGEST_DRAINED: Final = 64_000_000
"""Bytes of a refused request that are still taken, and thrown away."""

SECONDS_OF_SILENCE: Final = 60.0
"""Whoever sends nothing for so long in the middle of a request has gone."""
SECONDS_TO_HEAR_OUT: Final = 60.0
SILENT_AFTER_REFUSAL: Final = 5.0
"""Seconds: whoever is refused and still sends is heard out no longer in all, or at a stretch."""

LONGEST_PATH: Final = 1000
"""Letters of a path: no page of ours has a third of it, and every number in it can be read."""

_POLICY: Final = "Content-Security-Policy"
_FRAMES: Final = "X-Frame-Options"
_HEADERS: Final = {
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Permissions-Policy": "camera=(), geolocation=(), microphone=()",
    # A link is a key: no other site may learn it, and no cache may keep what it opens.
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
}
_HTTPS_ONLY: Final = "max-age=31536000"


def content_policy(frames: Iterable[str] = ()) -> str:
    """Say what a browser may do with a page.

    Args:
        frames: origins whose pages may show it; none for every page on which something can be done.
    """
    ancestors = " ".join(frames) or "'none'"
    return (
        "default-src 'none'; style-src 'self'; img-src 'self' data:; form-action 'self';"
        f" base-uri 'none'; frame-ancestors {ancestors}"
    )


class TooMuchError(Exception):
    """More was sent than a request may hold."""


class Incoming:
    """What a request sends: counted, bounded, and heard out before it is answered.

    Attributes:
        broken_off: whether the rest of it was not waited for.
    """

    def __init__(self, scope: Scope, receive: Receive) -> None:
        self.broken_off = False
        self._receive = receive
        self._taken = 0
        self._ended = not _has_body(Headers(scope=scope))

    async def bounded(self) -> Message:
        """Take the next part.

        Raises:
            TooMuchError: it is more than a request may hold.
        """
        received = await self._next(SECONDS_OF_SILENCE)
        if self._taken > LARGEST_BODY:
            raise TooMuchError
        return received

    async def hear_out(self) -> None:
        """Take the rest and throw it away.

        A browser that is still sending when we close sees a broken connection, and never the
        sentence that says why. Nobody keeps a connection by never coming to an end.
        """
        with move_on_after(SECONDS_TO_HEAR_OUT):
            while not self._ended and self._taken < LARGEST_DRAINED:
                await self._next(SILENT_AFTER_REFUSAL)
        self.broken_off = self.broken_off or not self._ended

    async def _next(self, silence: float) -> Message:
        if self._ended:  # what comes now is that somebody goes, and a download may take its time
            return await self._receive()
        received: Message = {"type": "http.disconnect"}
        with move_on_after(silence) as limit:
            received = await self._receive()
        self.broken_off = limit.cancelled_caught
        self._taken += len(received.get("body", b""))
        goes_on = received["type"] == "http.request" and received.get("more_body", False)
        self._ended = not goes_on
        return received


class Guard:
    """Bounds what comes in and marks what goes out; wraps the whole application."""

    def __init__(self, app: ASGIApp, *, secure: bool) -> None:
        self.app = app
        self.secure = secure

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Serve one request."""
        if scope["type"] != "http":
            await self.app(scope, receive, send)
            return
        incoming = Incoming(scope, receive)

        async def marked(sent: Message) -> None:
            if sent["type"] == "http.response.start":
                if not ends_twice:  # no browser does that
                    await incoming.hear_out()
                self._mark(headers := MutableHeaders(scope=sent))
                if incoming.broken_off or ends_twice:
                    headers["Connection"] = "close"
            await send(sent)

        ends_twice = _ends_twice(Headers(scope=scope))
        app = self.app
        if len(scope["path"]) > LONGEST_PATH:
            app = Response(status_code=HTTPStatus.REQUEST_URI_TOO_LONG)
        elif ends_twice:
            app = Response(status_code=HTTPStatus.BAD_REQUEST)
        await app(scope, incoming.bounded, marked)

    def _mark(self, headers: MutableHeaders) -> None:
        """Say what a browser is to refuse."""
        for name, value in _HEADERS.items():
            headers[name] = value
        if _POLICY not in headers:
            headers[_POLICY] = content_policy()
            headers[_FRAMES] = "DENY"
        headers.setdefault("Cache-Control", "no-store")
        if self.secure:
            headers["Strict-Transport-Security"] = _HTTPS_ONLY


def _has_body(headers: Headers) -> bool:
    return headers.get("content-length", "0") != "0" or "transfer-encoding" in headers


def _ends_twice(headers: Headers) -> bool:
    """Tell whether a request names its end in two ways.

    A web server before us may go by the other one, and take for the next request of somebody else
    what a stranger wrote.
    """
    return "content-length" in headers and "transfer-encoding" in headers


def declares_too_much(headers: Headers) -> bool:
    """Tell by its head whether a request is too large, before anything of it is read."""
    declared = headers.get("content-length", "0")
    return not declared.isdecimal() or int(declared) > LARGEST_BODY
