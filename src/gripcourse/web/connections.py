"""Connections on which nobody asks anything, or nobody reads the answer: ended after a while."""

import asyncio
from typing import Any, Final

from uvicorn.protocols.http.h11_impl import H11Protocol

SECONDS_OF_HEAD: Final = 20.0
"""How long a connection may be open without a request whose head has come whole."""

SECONDS_OF_READING: Final = 60.0
"""How long whoever asked may leave some ten thousand bytes of the answer waiting."""


class EndingProtocol(H11Protocol):
    """HTTP as `uvicorn` speaks it, which itself waits for heads and for readers without end.

    A body is bounded by `guard`, and a connection that rests between two requests by `uvicorn`.
    """

    def __init__(self, *args: Any, **more: Any) -> None:  # noqa: ANN401 (whatever it is made with)
        super().__init__(*args, **more)
        self._end: asyncio.TimerHandle | None = None
        self._unread: asyncio.TimerHandle | None = None

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
        self._read()
        super().connection_lost(exc)

    def pause_writing(self) -> None:
        """Begin to wait until somebody reads."""
        super().pause_writing()
        self._read()
        self._unread = self.loop.call_later(SECONDS_OF_READING, self.transport.abort)

    def resume_writing(self) -> None:
        """Go on: somebody read."""
        self._read()
        super().resume_writing()

    def _watch(self) -> None:
        if self.cycle is not None and not self.cycle.response_complete:
            self._stop()
        elif self._end is None:
            self._end = self.loop.call_later(SECONDS_OF_HEAD, self._leave)

    def _leave(self) -> None:
        if self.transport.get_write_buffer_size():  # the end of an answer that nobody takes
            self.transport.abort()
        else:
            self.transport.close()

    def _stop(self) -> None:
        if self._end is not None:
            self._end.cancel()
            self._end = None

    def _read(self) -> None:
        if self._unread is not None:
            self._unread.cancel()
            self._unread = None
