"""Connections on which nobody asks anything: ended after a while, whatever trickles in."""

import asyncio
from typing import Any, Final

from uvicorn.protocols.http.h11_impl import H11Protocol

SECONDS_OF_HEAD: Final = 20.0
"""How long a connection may be open without a request whose head has come whole."""


class EndingProtocol(H11Protocol):
    """HTTP as `uvicorn` speaks it, which itself waits for a head without end.

    A body is bounded by `guard`, and a connection that rests between two requests by `uvicorn`.
    """

    def __init__(self, *args: Any, **more: Any) -> None:  # noqa: ANN401 (whatever it is made with)
        super().__init__(*args, **more)
        self._end: asyncio.TimerHandle | None = None

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """Begin to wait for a request."""
        super().connection_made(transport)
        self._watch()

    def data_received(self, data: bytes) -> None:
        """Take what came; it may end the head that is waited for."""
        super().data_received(data)
        self._watch()

    def on_response_complete(self) -> None:
        """Wait for the next request."""
        super().on_response_complete()
        self._watch()

    def connection_lost(self, exc: Exception | None) -> None:
        """Wait no longer."""
        self._stop()
        super().connection_lost(exc)

    def _watch(self) -> None:
        if self.cycle is not None and not self.cycle.response_complete:
            self._stop()
        elif self._end is None:
            self._end = self.loop.call_later(SECONDS_OF_HEAD, self.transport.close)

    def _stop(self) -> None:
        if self._end is not None:
            self._end.cancel()
            self._end = None
