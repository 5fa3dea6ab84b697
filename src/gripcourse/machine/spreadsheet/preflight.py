"""Cheap checks of a file before a spreadsheet reader sees it.

A kilobyte can unpack to gigabytes, and one merged column makes the reader allocate a million cells.
Everything here costs milliseconds and bounded memory; what passes is safe to unpack.
"""

import io
import re
import zipfile
import zlib
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final
from xml.parsers import expat

from gripcourse.machine.spreadsheet.package import part_name
from gripcourse.machine.spreadsheet.refusals import WhyRefused
from gripcourse.machine.spreadsheet.sheet_cells import column_number

MEGABYTE: Final = 1_000_000
LARGEST_FILE: Final = 60 * MEGABYTE  # with pictures
LARGEST_TOTAL: Final = 24 * MEGABYTE  # of XML unpacked, by the sizes that the archive declares
LARGEST_PART: Final = 8 * MEGABYTE  # of XML; 99 % of real workbooks have 2.2 in all their parts
MOST_PARTS: Final = 1000
MOST_SHEETS: Final = 100
MOST_ELEMENTS: Final = 200_000  # XML elements; a cell is one or two, an answer workbook has 5000
DEEPEST: Final = 100  # elements inside each other; office programs stay below 20
MOST_COVERED: Final = 100_000  # cells; the reader makes one for each cell that a range covers
MOST_RANGES: Final = 5_000
MOST_RELATIONS: Final = 10_000  # of all parts; each link to the network is one


@dataclass(frozen=True, slots=True)
class Bounds:
    """What a file may hold.

    Attributes:
        part, total: bytes of XML, unpacked, by the sizes that the archive declares.
        elements: of XML.
    """

    part: int
    total: int
    elements: int


SUBMISSION: Final = Bounds(LARGEST_PART, LARGEST_TOTAL, MOST_ELEMENTS)
"""What a student hands in."""

TABLE: Final = Bounds(64 * MEGABYTE, 96 * MEGABYTE, 3_000_000)
"""What an instructor makes: a table of a hundred thousand rows is one."""

_METHODS: Final = frozenset({zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED})
_CHUNK: Final = 1 << 16

_OLE: Final = b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1"
_ENCRYPTED: Final = "EncryptedPackage".encode("utf-16-le")
_PICTURES: Final = (b"\x89PNG", b"\xff\xd8\xff", b"GIF8", b"II*\0", b"MM\0*")
_RANGES: Final = frozenset({"mergeCell", "hyperlink", "comment"})
_BEFORE_XML: Final = b"\xef\xbb\xbf\xff\xfe\0 \t\r\n"  # byte order marks and white space
_CONTROL: Final = re.compile(rb"[\0-\x08\x0e-\x1f]")  # bytes that no text has
_CORNERS: Final = re.compile(r"\$?([A-Za-z]{1,3})\$?(\d{1,7})(?::\$?([A-Za-z]{1,3})\$?(\d{1,7}))?")


class _Refused(Exception):  # noqa: N818 - it never leaves this module
    def __init__(self, reason: WhyRefused) -> None:
        self.reason = reason
        super().__init__(reason)


def refusal(name: str, data: bytes, bounds: Bounds = SUBMISSION) -> WhyRefused | None:
    """Tell why a file must not be unpacked any further.

    Args:
        name: of the file, without folders.
        data: its whole content.
        bounds: of what it may hold.

    Returns:
        The reason, for the person who sent the file, or None where the file can be read.
    """
    try:
        _check_name(name)
        _check_magic(data)
        _check_archive(data, bounds)
    except _Refused as refused:
        return refused.reason
    return None


def _check_name(name: str) -> None:
    if name.startswith(("~$", ".~lock.")):
        raise _Refused(WhyRefused.LOCK_FILE)


def _check_magic(data: bytes) -> None:
    """Tell by its first bytes what a file is that is no zip archive."""
    if not data:
        raise _Refused(WhyRefused.EMPTY)
    if len(data) > LARGEST_FILE:
        raise _Refused(WhyRefused.TOO_LARGE)
    if data.startswith(_OLE):
        raise _Refused(_about_ole(data))
    if data.startswith((b"PK\x03\x04", b"PK\x05\x06")):
        return
    if data.startswith(b"%PDF"):
        raise _Refused(WhyRefused.PDF)
    if data.startswith(_PICTURES):
        raise _Refused(WhyRefused.PICTURE)
    raise _Refused(_about_text(data[:_CHUNK]))


def _about_ole(data: bytes) -> WhyRefused:
    return WhyRefused.PASSWORD if _ENCRYPTED in data else WhyRefused.OLD_FORMAT


def _about_text(beginning: bytes) -> WhyRefused:
    """Tell a web page and a text table from other bytes."""
    start = beginning.lstrip(b"\xef\xbb\xbf \t\r\n").lower()
    if start.startswith((b"<html", b"<!doctype html", b"<table", b"<?xml", b"<meta", b"<head")):
        return WhyRefused.WEB_PAGE
    return WhyRefused.NO_WORKBOOK if _CONTROL.search(beginning) else WhyRefused.DELIMITED_TEXT


def _check_archive(data: bytes, bounds: Bounds) -> None:
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            members = archive.infolist()
            _check_directory(members)
            _check_kind({part_name(member.filename) for member in members}, archive)
            scan = _Scan(bounds)
            for member in members:
                _check_part(archive, member, scan)
    except (zipfile.BadZipFile, zlib.error, EOFError, OSError, ValueError) as fault:
        raise _Refused(WhyRefused.DAMAGED) from fault
    except (NotImplementedError, RuntimeError) as fault:  # a method or a cipher of other archivers
        raise _Refused(WhyRefused.NO_WORKBOOK) from fault


def _check_directory(members: Sequence[zipfile.ZipInfo]) -> None:
    """Refuse by the directory alone what no spreadsheet program writes: nothing is unpacked yet."""
    if len(members) > MOST_PARTS:
        raise _Refused(WhyRefused.TOO_LARGE)
    if any(member.compress_type not in _METHODS for member in members):
        raise _Refused(WhyRefused.FOREIGN_CONTENT)
    names = Counter(part_name(member.filename) for member in members)
    if any(count > 1 for count in names.values()):
        # Programs disagree which of two parts with one name counts.
        raise _Refused(WhyRefused.FOREIGN_CONTENT)


def _check_kind(names: set[str], archive: zipfile.ZipFile) -> None:
    """Tell other documents that are zip archives too."""
    if "xl/workbook.xml" in names:
        return
    if "mimetype" in names and b"opendocument" in archive.read("mimetype"):
        raise _Refused(WhyRefused.OPEN_DOCUMENT)
    if "xl/workbook.bin" in names:
        raise _Refused(WhyRefused.XLSB)
    if "word/document.xml" in names:
        raise _Refused(WhyRefused.TEXT_DOCUMENT)
    if not any(name.startswith("xl/") for name in names):
        raise _Refused(WhyRefused.NO_WORKBOOK)


def _check_part(archive: zipfile.ZipFile, member: zipfile.ZipInfo, scan: "_Scan") -> None:
    """Read a part once, if it is XML: what it is called decides nothing."""
    with archive.open(member) as stream:
        beginning = stream.read(_CHUNK)
        if beginning.lstrip(_BEFORE_XML)[:1] not in {b"<", b""}:
            return
        scan.unpack(member.file_size)
        # In one piece: with each further one the parser looks through a long attribute again.
        content = beginning + stream.read()
    try:
        if content:
            scan.parser().Parse(content, True)
    except (expat.ExpatError, LookupError, UnicodeError) as fault:  # the latter two of encodings
        # The reader would stop at the same place; drawings of comments need not be sound XML.
        if member.filename.lower().endswith((".xml", ".rels")):
            raise _Refused(WhyRefused.INVALID_XML) from fault


class _Scan:
    """What was seen of an archive's XML so far; it changes, because a parser calls back."""

    def __init__(self, bounds: Bounds) -> None:
        self._bounds = bounds
        self._depth = 0
        self._elements = 0
        self._unpacked = 0
        self._seen: Counter[str] = Counter()

    def unpack(self, size: int) -> None:
        """Count the declared size of a part, which `zipfile` never unpacks beyond.

        Pictures are not counted: nothing but XML is ever unpacked.
        """
        self._unpacked += size
        if size > self._bounds.part or self._unpacked > self._bounds.total:
            raise _Refused(WhyRefused.TOO_LARGE)

    def parser(self) -> expat.XMLParserType:
        """Return a parser for the next part."""
        self._depth = 0
        parser = expat.ParserCreate()
        parser.StartElementHandler = self._enter
        parser.EndElementHandler = self._leave
        parser.StartDoctypeDeclHandler = self._refuse_declarations
        return parser

    def _enter(self, element: str, attributes: dict[str, str]) -> None:
        self._depth += 1
        self._elements += 1
        if self._depth > DEEPEST:
            raise _Refused(WhyRefused.FOREIGN_CONTENT)
        if self._elements > self._bounds.elements:
            raise _Refused(WhyRefused.TOO_LARGE)
        name = element.rpartition(":")[2] if ":" in element else element
        if name == "sheet":
            self._count("sheet", 1, MOST_SHEETS, WhyRefused.TOO_LARGE)
        elif name == "Relationship":
            self._count("relation", 1, MOST_RELATIONS, WhyRefused.TOO_LARGE)
        elif name in _RANGES:
            self._count("range", 1, MOST_RANGES, WhyRefused.MERGED)
            self._count(
                "covered", _covered(attributes.get("ref", "")), MOST_COVERED, WhyRefused.MERGED
            )

    def _count(self, what: str, number: int, most: int, reason: WhyRefused) -> None:
        self._seen[what] += number
        if self._seen[what] > most:
            raise _Refused(reason)

    def _leave(self, _element: str) -> None:
        self._depth -= 1

    def _refuse_declarations(self, *_declaration: object) -> None:
        raise _Refused(WhyRefused.FOREIGN_CONTENT)


def _covered(reference: str) -> int:
    """Return how many cells a range covers; whole columns and rows are more than any limit."""
    found = _CORNERS.fullmatch(reference)
    if found is None:
        return MOST_COVERED + 1 if reference else 0
    left, top, right, bottom = found.groups()
    columns = abs(column_number(right or left) - column_number(left)) + 1
    return columns * (abs(int(bottom or top) - int(top)) + 1)
