"""Asking a platform: bounded in time and size, never led elsewhere."""

import json
import time
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Final

import httpx2

from gripcourse.access.lti.platforms import is_safe
from gripcourse.access.lti.refused import PlatformFailedError
from gripcourse.text.words import message

_SECONDS: Final = 10.0
_SECONDS_OF_SILENCE: Final = 5.0
_LARGEST: Final = 2_000_000  # bytes; the members of a large course have some hundred thousand
_DONE: Final = range(200, 300)


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


def make_client() -> httpx2.Client:
    """Make what asks; it goes nowhere by itself, and to this machine without a proxy."""
    here = dict.fromkeys(("all://127.0.0.1", "all://localhost"))
    return httpx2.Client(
        timeout=_SECONDS_OF_SILENCE, follow_redirects=False, mounts=here, verify=True
    )


def ask(client: httpx2.Client, asked: PlatformQuestion) -> PlatformAnswer:
    """Ask a platform.

    Raises:
        PlatformFailedError: it cannot be reached, refuses, or answers something else than JSON.
    """
    if not is_safe(asked.url):
        raise PlatformFailedError(message("The platform named an address that is not by https."))
    try:
        with client.stream(
            asked.method,
            asked.url,
            headers=dict(asked.headers or {}),
            data=None if asked.fields is None else dict(asked.fields),
            content=asked.body,
        ) as response:
            body = _bounded(response)
            following = response.links.get("next", {}).get("url", "")
            status = response.status_code
    except (httpx2.HTTPError, httpx2.InvalidURL) as fault:
        said = message("The platform cannot be reached: {fault}.", fault=type(fault).__name__)
        raise PlatformFailedError(said) from fault
    if status not in _DONE:
        raise PlatformFailedError(message("The platform answered {status}.", status=str(status)))
    return PlatformAnswer(_plain(body), following)


def _bounded(response: httpx2.Response) -> bytes:
    ends, body = time.monotonic() + _SECONDS, b""
    for part in response.iter_bytes():
        body += part
        if len(body) > _LARGEST or time.monotonic() > ends:
            raise PlatformFailedError(message("The platform answered too much or too slowly."))
    return body


def _plain(body: bytes) -> Any:  # noqa: ANN401 (whatever JSON holds)
    if not body.strip():
        return None
    try:
        return json.loads(body)
    except (ValueError, RecursionError) as fault:
        raise PlatformFailedError(message("The platform answered no JSON.")) from fault
