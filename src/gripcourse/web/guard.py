"""What stands before every page: how much may be sent, and what a browser is told to refuse."""

from typing import Final

from starlette.datastructures import Headers, MutableHeaders
from starlette.types import ASGIApp, Message, Receive, Scope, Send

LARGEST_BODY: Final = 20_000_000
"""Bytes of one request: a workbook with pictures has a few million."""

_HEADERS: Final = {
    "Content-Security-Policy": (
        "default-src 'none'; style-src 'self'; img-src 'self' data:; form-action 'self';"
        " base-uri 'none'; frame-ancestors 'none'"
    ),
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Permissions-Policy": "camera=(), geolocation=(), microphone=()",
    # A link is a key: no other site may learn it, and no cache may keep what it opens.
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
}
_HTTPS_ONLY: Final = "max-age=31536000"


class TooMuchError(Exception):
    """More was sent than a request may hold."""


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
        left = LARGEST_BODY

        async def bounded() -> Message:
            nonlocal left
            received = await receive()
            left -= len(received.get("body", b""))
            if left < 0:
                raise TooMuchError
            return received

        async def marked(sent: Message) -> None:
            if sent["type"] == "http.response.start":
                headers = MutableHeaders(scope=sent)
                for name, value in _HEADERS.items():
                    headers[name] = value
                headers.setdefault("Cache-Control", "no-store")
                if self.secure:
                    headers["Strict-Transport-Security"] = _HTTPS_ONLY
            await send(sent)

        await self.app(scope, bounded, marked)


def declares_too_much(headers: Headers) -> bool:
    """Tell by its head whether a request is too large, before anything of it is read."""
    declared = headers.get("content-length", "0")
    return not declared.isdecimal() or int(declared) > LARGEST_BODY
