"""Asking a platform: bounded in time and size, never led elsewhere."""

import json
import math
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from datetime import UTC, datetime
from email.utils import parsedate_to_datetime
from http import HTTPStatus
from typing import Any, Final
from urllib.parse import urljoin

import httpx2
from anyio import fail_after
from anyio.from_thread import BlockingPortal, start_blocking_portal

from gripcourse.access.lti.platforms import is_safe
from gripcourse.access.lti.refused import PlatformFailedError, PlatformFailure
from gripcourse.access.lti.unreached import why_unreached
from gripcourse.text.words import message

_SECONDS: Final = 10.0
_SECONDS_OF_SILENCE: Final = 5.0
_LARGEST: Final = 2_000_000  # bytes; the members of a large course have some hundred thousand
_DONE: Final = range(200, 300)
_BROKEN: Final = range(500, 600)
_BUSY: Final = (HTTPStatus.TOO_MANY_REQUESTS, HTTPStatus.SERVICE_UNAVAILABLE)
# Canvas says so by a status that means "not allowed" elsewhere, and by nothing else: the number in
# `X-Rate-Limit-Remaining` is the one after what was held back for the question is given back.
_TOO_OFTEN: Final = b"rate limit exceeded"


@dataclass(frozen=True, slots=True)
class PlatformQuestion:
    """What is asked of a platform.

    Attributes:
        url: where; by https, or on this machine.
        method: of HTTP.
        headers: to send.
        fields: of a form; None for none.
        body: to send instead of a form; None for none.
    """

    url: str
    method: str = "GET"
    headers: Mapping[str, str] | None = None
    fields: Mapping[str, str] | None = None
    body: bytes | None = None


@dataclass(frozen=True, slots=True)
class PlatformAnswer:
    """What a platform answered: plain data, and where the next page of it is."""

    content: Any
    next_page: str


@dataclass(frozen=True, slots=True)
class PlatformClient:
    """What asks platforms: a client with a thread of its own, in which a question can be dropped.

    A limit of silence alone is none: a head that comes letter by letter is never silent.

    Attributes:
        client: speaks HTTP.
        portal: the thread.
        seconds: how long an answer may take as a whole.
    """

    client: httpx2.AsyncClient
    portal: BlockingPortal
    seconds: float


@contextmanager
def make_client(
    transport: httpx2.AsyncBaseTransport | None = None, seconds: float = _SECONDS
) -> Iterator[PlatformClient]:
    """Make what asks; it goes nowhere by itself, and to this machine without a proxy.

    Args:
        transport: what carries the questions; None for the network.
        seconds: how long an answer may take as a whole.
    """
    here = dict.fromkeys(("all://127.0.0.1", "all://localhost"))
    with start_blocking_portal() as portal:
        client = httpx2.AsyncClient(
            timeout=_SECONDS_OF_SILENCE,
            follow_redirects=False,
            mounts=here if transport is None else None,
            transport=transport,
            verify=True,
        )
        try:
            yield PlatformClient(client, portal, seconds)
        finally:
            portal.call(client.aclose)


def ask(client: PlatformClient, asked: PlatformQuestion) -> PlatformAnswer:
    """Ask a platform.

    Raises:
        PlatformFailedError: it cannot be reached, refuses, takes too long, or answers something
            else than JSON.
    """
    if not is_safe(asked.url):
        raise PlatformFailedError(message("The platform named an address that is not by https."))
    try:
        return client.portal.call(_answered, client, asked)
    except (TimeoutError, httpx2.ReadTimeout, httpx2.WriteTimeout) as fault:
        raise _too_much(PlatformFailure.AWAY) from fault
    except (httpx2.HTTPError, httpx2.InvalidURL) as fault:
        raise why_unreached(fault, asked.url) from fault


async def _answered(client: PlatformClient, asked: PlatformQuestion) -> PlatformAnswer:
    with fail_after(client.seconds):
        async with client.client.stream(
            asked.method,
            asked.url,
            headers={**(asked.headers or {}), "Accept-Encoding": "identity"},
            data=None if asked.fields is None else dict(asked.fields),
            content=asked.body,
        ) as response:
            body = await _bounded(response)
    if response.status_code not in _DONE:
        raise _not_done(response, body)
    return PlatformAnswer(_plain(body), _next_page(response, asked.url))


async def _bounded(response: httpx2.Response) -> bytes:
    # Not as we asked: what was packed may be a thousand times as large when it is unpacked.
    if response.headers.get("content-encoding", "identity") != "identity":
        raise _too_much()
    body = b""
    async for part in response.aiter_bytes():
        body += part
        if len(body) > _LARGEST:
            raise _too_much()
    return body


def _next_page(response: httpx2.Response, asked: str) -> str:
    following = response.links.get("next", {}).get("url", "")
    try:
        return urljoin(asked, following) if following else ""
    except ValueError as fault:
        said = message("The platform named an address that is not by https.")
        raise PlatformFailedError(said) from fault


def _too_much(failure: PlatformFailure = PlatformFailure.REFUSED) -> PlatformFailedError:
    said = message("The platform answered too much or too slowly.")
    return PlatformFailedError(said, failure)


def _not_done(response: httpx2.Response, body: bytes) -> PlatformFailedError:
    status = response.status_code
    failure = PlatformFailure.REFUSED
    if status in _BUSY or (status == HTTPStatus.FORBIDDEN and _TOO_OFTEN in body.lower()):
        failure = PlatformFailure.BUSY
    elif status in _BROKEN:
        failure = PlatformFailure.BROKEN
    elif status == HTTPStatus.UNAUTHORIZED:
        failure = PlatformFailure.UNKNOWN
    said = message("The platform answered {status}.", status=str(status))
    if failure is PlatformFailure.BUSY:
        said = message(
            "The platform is busy and wants to be asked again later ({status}).",
            status=str(status),
        )
    pause = _pause(response.headers.get("retry-after", ""))
    return PlatformFailedError(said, failure, status, pause)


def _pause(written: str) -> float | None:
    """Read after how many seconds to come again: they stand there, or a date does."""
    try:
        seconds = float(written)
    except ValueError:
        try:
            moment = parsedate_to_datetime(written)
        except ValueError:
            return None
        if moment.tzinfo is None:
            return None
        seconds = (moment - datetime.now(UTC)).total_seconds()
    return max(seconds, 0.0) if math.isfinite(seconds) else None


def _plain(body: bytes) -> Any:  # noqa: ANN401 (whatever JSON holds)
    if not body.strip():
        return None
    try:
        return json.loads(body)
    except (ValueError, RecursionError) as fault:
        raise PlatformFailedError(message("The platform answered no JSON.")) from fault
