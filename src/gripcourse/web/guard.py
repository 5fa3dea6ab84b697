"""What stands before every page: how much may be sent, and what a browser is told to refuse."""

from collections.abc import Iterable
from http import HTTPStatus
from typing import Final

from starlette.datastructures import Headers, MutableHeaders
from starlette.responses import Response
from starlette.types import ASGIApp, Message, Receive, Scope, Send

LARGEST_BODY: Final = 20_000_000
"""Bytes of one request: a workbook with pictures has a few million."""
LARGEST_DRAINED: Final = 64_000_000
"""Bytes of a refused request that are still taken, and thrown away."""

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
    """What a request sends: counted, bounded, and heard out before it is answered."""

    def __init__(self, scope: Scope, receive: Receive) -> None:
        self._receive = receive
        self._taken = 0
        self._ended = not _has_body(Headers(scope=scope))

    async def bounded(self) -> Message:
        """Take the next part.

        Raises:
            TooMuchError: it is more than a request may hold.
        """
        received = await self._next()
        if self._taken > LARGEST_BODY:
            raise TooMuchError
        return received

    async def hear_out(self) -> None:
        """Take the rest and throw it away.

        A browser that is still sending when we close sees a broken connection, and never the
        sentence that says why.
        """
        while not self._ended and self._taken < LARGEST_DRAINED:
            await self._next()

    async def _next(self) -> Message:
        received = await self._receive()
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
                await incoming.hear_out()
                self._mark(MutableHeaders(scope=sent))
            await send(sent)

        if len(scope["path"]) > LONGEST_PATH:
            await Response(status_code=HTTPStatus.REQUEST_URI_TOO_LONG)(
                scope, incoming.bounded, marked
            )
            return
        await self.app(scope, incoming.bounded, marked)

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


def declares_too_much(headers: Headers) -> bool:
    """Tell by its head whether a request is too large, before anything of it is read."""
    declared = headers.get("content-length", "0")
    return not declared.isdecimal() or int(declared) > LARGEST_BODY
