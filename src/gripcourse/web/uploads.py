"""Reading the form that a browser sends."""

import time
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from datetime import datetime
from typing import Final

from python_multipart.multipart import parse_options_header
from starlette.datastructures import UploadFile
from starlette.exceptions import HTTPException
from starlette.requests import Request

from gripcourse.access.desk.model import Allowance
from gripcourse.machine.content import NamedBytes
from gripcourse.web.guard import declares_too_much
from gripcourse.web.site import Site

_FIELDS: Final = 32  # a rubric has a field for each of its lines
_LONGEST_FIELD: Final = 20_000
# What browsers send. Others make half letters, which nothing can keep, or do not decode at all.
_ENCODINGS: Final = frozenset({"utf-8", "utf8", "us-ascii", "iso-8859-1"})
_NO_FORM: Final = 400
_TOO_LARGE: Final = 413
_TOO_OFTEN: Final = 429


@dataclass(frozen=True, slots=True)
class Sent:
    """What a form holds: short texts by name, and the file if one was chosen."""

    texts: Mapping[str, str]
    file: NamedBytes | None


async def read_form(request: Request) -> Sent:
    """Read a form wholly; what it holds is nowhere yet but in memory and a temporary file.

    Raises:
        HTTPException: it is too large, in an unusual encoding, or no form.
        ClientDisconnect: whoever sent it has gone in the middle.
    """
    if declares_too_much(request.headers):
        raise HTTPException(_TOO_LARGE)
    if not _is_usually_encoded(request.headers.get("content-type", "")):
        raise HTTPException(_NO_FORM)
    async with request.form(max_files=1, max_fields=_FIELDS, max_part_size=_LONGEST_FIELD) as form:
        texts = {name: one for name, one in form.items() if isinstance(one, str)}
        files = [one for one in form.values() if isinstance(one, UploadFile) and one.filename]
        sent = [NamedBytes(str(one.filename), await one.read()) for one in files]
    return Sent(texts, sent[0] if sent else None)


def _is_usually_encoded(content_type: str) -> bool:
    """Tell whether the texts of a form are encoded in a way that every text survives."""
    _, options = parse_options_header(content_type)
    declared = options.get(b"charset", b"utf-8").decode("latin-1")
    return declared.strip().casefold() in _ENCODINGS


def count(site: Site, rate: Allowance, who: str, kept: Iterable[datetime] = ()) -> None:
    """Count one more.

    Args:
        site: the server.
        rate: what is counted.
        who: by whom.
        kept: when it was done before, as the database knows of all servers together.

    Raises:
        HTTPException: it was too often.
    """
    now = site.clock()
    lately = sum(abs((now - moment).total_seconds()) < rate.seconds for moment in kept)
    if lately >= rate.times or not site.counter.allows(rate, who, time.monotonic()):
        raise too_often(rate)


def too_often(rate: Allowance) -> HTTPException:
    """Return what refuses something that was done as often as it may be."""
    return HTTPException(_TOO_OFTEN, headers={"Retry-After": str(int(rate.seconds))})


def address_of(request: Request) -> str:
    """Return from where somebody comes; a proxy in between is believed as uvicorn was told."""
    return "" if request.client is None else request.client.host
