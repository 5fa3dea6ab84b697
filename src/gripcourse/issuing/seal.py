"""The square code on a sheet: whose it is, with the signature, for a telephone or a scanner.

A course that has an address makes a link of it: a telephone opens the course's page, and what the
code says stands behind the sign `#`, which is never sent to that page's server.
"""

import io
import re
from dataclasses import dataclass
from typing import TYPE_CHECKING
from urllib.parse import quote, unquote

from gripcourse.variants.model import Issued

if TYPE_CHECKING:
    from segno import QRCode

_MARK = "gripcourse:1"
_TEXT = re.compile(
    r"gripcourse:1:(?P<course>[^:]+):(?P<student>[^:]+):(?P<variant>[^:]+)"
    r":(?P<signature>[0-9a-f]{64})"
)
_QUIET = 2  # modules of white round the code; the sheet has more of it


@dataclass(frozen=True, slots=True)
class Seal:
    """What the code of a sheet says.

    Attributes:
        course, student, variant: ids.
        signature: of the variant as it was issued; see `signature.verify`.
    """

    course: str
    student: str
    variant: str
    signature: str


def seal_of(issued: Issued, course_id: str) -> Seal:
    """Return the seal of what was issued from a course."""
    return Seal(course_id, issued.student.id, issued.variant.id, issued.signature)


def seal_text(seal: Seal, address: str = "") -> str:
    """Write a seal as one line of ASCII; ids are quoted as in an address.

    Args:
        seal: what the code says.
        address: that it leads to; empty for a code that is no link.
    """
    ids = (quote(one, safe="") for one in (seal.course, seal.student, seal.variant))
    written = ":".join((_MARK, *ids, seal.signature))
    return f"{address}#{written}" if address else written


def read_seal(text: str) -> Seal | None:
    """Read what `seal_text` wrote; None for any other code."""
    found = _TEXT.fullmatch(text.strip().rpartition("#")[2])
    if found is None:
        return None
    return Seal(**{name: unquote(part) for name, part in found.groupdict().items()})


def seal_svg(seal: Seal, address: str = "") -> str:
    """Return the code as an SVG element whose size is left to the page; see `seal_text`."""
    stream = io.BytesIO()
    _code(seal, address).save(
        stream, kind="svg", border=_QUIET, omitsize=True, xmldecl=False, nl=False
    )
    return stream.getvalue().decode()


def seal_modules(seal: Seal, address: str = "") -> int:
    """Return how many modules the code is wide, with the white round it; see `seal_text`."""
    return int(_code(seal, address).symbol_size(border=_QUIET)[0])


def _code(seal: Seal, address: str) -> "QRCode":
    import segno  # noqa: PLC0415 (only who makes a sheet pays for it)

    return segno.make_qr(seal_text(seal, address), error="m")
