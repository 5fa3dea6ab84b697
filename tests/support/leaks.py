"""What a file gives away to somebody who takes it apart: numbers, secrets, places.

Nothing here knows how we write documents: a PDF is opened into its objects, a workbook into its
members, and numbers are found by what they look like. A number counts as told where its figures
are those of a value, whatever the power of ten: every unit that is so many times another is met.
"""

import base64
import io
import math
import re
import subprocess
import zipfile
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass

from pypdf import PdfReader
from pypdf.errors import PdfReadError
from pypdf.generic import DictionaryObject, IndirectObject, StreamObject

FEWEST, MOST = 4, 12  # significant figures of a number that tells something, and that are compared
# Coordinates of a page are many: by chance alone some have the first figures of some value.
FEWEST_OF_A_PAGE = 7
_NUMBER = re.compile(
    r"(?<![\w.,])\d+(?:[\u00a0\u2009\u202f]\d{3})*(?:[.,]\d+)?(?:[eE][+-]?\d+)?(?!\w)"
)
_GROUPS = re.compile(r"[\u00a0\u2009\u202f]")
_ROOTS = rb"home|root|tmp|usr|var|opt|work|Users|etc|mnt|builds"
_PLACES = re.compile(rb"(?<![\w:/.])/(?:" + _ROOTS + rb")/[\w.-]+|[A-Z]:\\+Users")
# What may hold words in an object of a PDF; the rest is the tree of its tags, thousands of them.
_WORDS = frozenset((
    "/Title", "/Producer", "/Author", "/Subject", "/Keywords", "/Creator", "/Contents", "/F", "/JS",
    "/URI", "/Desc", "/V", "/Alt", "/ActualText", "/E",
))  # fmt: skip


@dataclass(frozen=True, slots=True)
class Piece:
    """A part of a file as a reader of files may see it; on a page most numbers are coordinates."""

    name: str
    data: bytes
    is_page: bool = False


def pieces_of_pdf(data: bytes) -> Iterator[Piece]:
    """Yield the text that can be read or copied, and each object and stream, decompressed."""
    command = ["pdftotext", "-layout", "-", "-"]
    done = subprocess.run(command, input=data, capture_output=True, check=True)  # noqa: S603 (poppler)
    yield Piece("text", done.stdout)
    yield Piece("file", data, is_page=True)
    reader = PdfReader(io.BytesIO(data))
    for number in range(1, int(reader.trailer["/Size"])):
        try:
            found = reader.get_object(IndirectObject(number, 0, reader))
        except PdfReadError:  # a number without an object
            continue
        if isinstance(found, StreamObject):
            # A stream without a type is a page or a font; a table of references is numbers only.
            kind = found.get("/Type")
            if kind not in {"/XRef", "/ObjStm"}:
                yield Piece(f"object {number}", found.get_data(), is_page=kind is None)
        elif not isinstance(found, DictionaryObject) or found.keys() & _WORDS:
            yield Piece(f"object {number}", str(found).encode(), is_page="/Dest" in str(found))


def pieces_of_workbook(data: bytes) -> Iterator[Piece]:
    """Yield each member of the archive, hidden sheets and properties among them."""
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        yield Piece("comment", archive.comment)
        for name in archive.namelist():
            yield Piece(name, name.encode() + b"\n" + archive.read(name))


def pieces(name: str, data: bytes) -> list[Piece]:
    """Take a file apart by what it is called."""
    if name.endswith(".pdf"):
        return list(pieces_of_pdf(data))
    return list(pieces_of_workbook(data) if name.endswith(".xlsx") else [Piece(name, data)])


def significant(written: str) -> str:
    """Return the figures of a number as it was written, those of its power of ten left out."""
    digits = re.split("[eE]", written)[0]
    return re.sub(r"\D", "", digits).lstrip("0")


def figures_of(value: float, count: int) -> str:
    """Return so many significant figures of a value; none where it is zero or no number."""
    if not value or not math.isfinite(value):
        return ""
    return f"{abs(value):.{count - 1}e}".split("e")[0].replace(".", "")


def tells(written: str, values: Mapping[str, Iterable[float]], fewest: int = FEWEST) -> str:
    """Name whose figures a number has that was found; empty where nobody's."""
    figures = significant(written)
    if len(figures) < fewest:
        return ""
    count = min(len(figures), MOST)
    for name, spellings in values.items():
        for value in spellings:
            # A value of few figures is met by chance, and written out in full it says no more.
            if len(figures_of(value, MOST).rstrip("0")) < FEWEST:
                continue
            rounded, cut = figures_of(value, count), figures_of(value, MOST + 2)[:count]
            if figures[:count] in {rounded, cut}:
                return name
    return ""


def numbers_in(text: str) -> set[str]:
    """Return the numbers of a text as they stand there, groups of three put together."""
    return {_GROUPS.sub("", one) for one in _NUMBER.findall(text)}


def numbers_told(
    parts: Iterable[Piece], values: Mapping[str, Iterable[float]], known: Iterable[float]
) -> list[str]:
    """Say which values stand in a file, and where.

    Args:
        parts: of the file.
        values: what must not be told, each in the units in which it might be.
        known: what everybody may read; a number of exactly these figures says nothing else.
    """
    open_to_all = {figures_of(one, MOST).rstrip("0") for one in known}
    told = []
    for part in parts:
        fewest = FEWEST_OF_A_PAGE if part.is_page else FEWEST
        for written in sorted(numbers_in(part.data.decode("utf-8", "replace"))):
            if significant(written).rstrip("0") not in open_to_all:
                name = tells(written, values, fewest)
                told += [f"{part.name}: {written} is {name}"] if name else []
    return told


def secrets_told(parts: Iterable[Piece], secret: bytes) -> list[str]:
    """Say in which parts a secret stands: as it is, in hexadecimal digits, or in base 64."""
    encoded = base64.b64encode(secret).rstrip(b"=")
    spellings = (secret, secret.hex().encode(), secret.hex().upper().encode(), encoded)
    wide = [one.decode("latin-1").encode("utf-16-le") for one in spellings]
    return [part.name for part in parts if any(one in part.data for one in (*spellings, *wide))]


def places_told(parts: Iterable[Piece], names: Iterable[str]) -> list[str]:
    """Say where a path of a machine stands, or one of these names."""
    told = []
    for part in parts:
        found = [one.decode("latin-1") for one in _PLACES.findall(part.data)]
        found += [one for one in names if one.encode() in part.data]
        told += [f"{part.name}: {one}" for one in found]
    return told
