"""Cheap checks of a file before a spreadsheet reader sees it.

A kilobyte can unpack to gigabytes, and one merged column makes the reader allocate a million cells.
Everything here costs milliseconds and bounded memory; what passes is safe to read in normal mode.
"""

import io
import re
import zipfile
import zlib
from collections import Counter
from typing import Final
from xml.parsers import expat

from gripcourse.text.words import Message, message

MEGABYTE: Final = 1_000_000
LARGEST_FILE: Final = 20 * MEGABYTE
LARGEST_TOTAL: Final = 60 * MEGABYTE  # unpacked, by the sizes that the archive declares
LARGEST_PART: Final = 8 * MEGABYTE  # of XML; 99 % of real workbooks have 2.2 in all their parts
MOST_PARTS: Final = 1000
MOST_SHEETS: Final = 100
MOST_ELEMENTS: Final = 300_000  # XML elements; a cell is one or two, an answer workbook has 5000
DEEPEST: Final = 100  # elements inside each other; office programs stay below 20
MOST_COVERED: Final = 100_000  # cells; the reader makes one for each cell that a range covers
MOST_RANGES: Final = 5_000
_CHUNK: Final = 1 << 16

_OLE: Final = b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1"
_ENCRYPTED: Final = "EncryptedPackage".encode("utf-16-le")
_PICTURES: Final = (b"\x89PNG", b"\xff\xd8\xff", b"GIF8", b"II*\0", b"MM\0*")
_RANGES: Final = frozenset({"mergeCell", "hyperlink", "comment"})
_BEFORE_XML: Final = b"\xef\xbb\xbf\xff\xfe\0 \t\r\n"  # byte order marks and white space
_CONTROL: Final = re.compile(rb"[\0-\x08\x0e-\x1f]")  # bytes that no text has
_CORNERS: Final = re.compile(r"\$?([A-Za-z]{1,3})\$?(\d{1,7})(?::\$?([A-Za-z]{1,3})\$?(\d{1,7}))?")

_SAVE_AGAIN: Final = message("Open the answer workbook in a spreadsheet program and save it again.")
DAMAGED: Final = message(
    "The file is damaged: it was not copied or sent as a whole. Send it again."
)
_TOO_LARGE: Final = message(
    "The file holds far more than an answer workbook does. Copy the answers into the workbook "
    "that was issued."
)
NO_WORKBOOK: Final = message("The file is not a workbook. Send the .xlsx file that was issued.")
_FOREIGN_CONTENT: Final = message(
    "The workbook holds content that no spreadsheet program writes. Copy the answers into the "
    "workbook that was issued."
)
_MERGED: Final = message(
    "Whole columns or rows, or very many cells, of the workbook are merged. Undo the merging and "
    "save the workbook again."
)


class _Refused(Exception):  # noqa: N818 - it never leaves this module
    def __init__(self, reason: Message) -> None:
        self.reason = reason
        super().__init__(reason)


def refusal(name: str, data: bytes) -> Message | None:
    """Tell why a file must not be given to the spreadsheet reader.

    Args:
        name: of the file, without folders.
        data: its whole content.

    Returns:
        The reason, for the person who sent the file, or None where the file can be read.
    """
    try:
        _check_name(name)
        _check_magic(data)
        _check_archive(data)
    except _Refused as refused:
        return refused.reason
    return None


def _check_name(name: str) -> None:
    if name.startswith(("~$", ".~lock.")):
        raise _Refused(
            message(
                "This is the lock file of a workbook that is open. Close the spreadsheet program "
                "and send the workbook itself."
            )
        )


def _check_magic(data: bytes) -> None:
    """Tell by its first bytes what a file is that is no zip archive."""
    if not data:
        raise _Refused(message("The file is empty: it has no bytes."))
    if len(data) > LARGEST_FILE:
        raise _Refused(_TOO_LARGE)
    if data.startswith(_OLE):
        raise _Refused(_about_ole(data))
    if data.startswith((b"PK\x03\x04", b"PK\x05\x06")):
        return
    if data.startswith(b"%PDF"):
        raise _Refused(message("The file is a PDF document. Send the .xlsx workbook itself."))
    if data.startswith(_PICTURES):
        raise _Refused(message("The file is a picture. Send the .xlsx workbook itself."))
    raise _Refused(_about_text(data[:_CHUNK]))


def _about_ole(data: bytes) -> Message:
    if _ENCRYPTED in data:
        return message("The workbook is protected by a password. Remove the password and save it.")
    return message("The file has the old .xls format. Save it as an .xlsx workbook.")


def _about_text(beginning: bytes) -> Message:
    """Tell a web page and a text table from other bytes."""
    start = beginning.lstrip(b"\xef\xbb\xbf \t\r\n").lower()
    if start.startswith((b"<html", b"<!doctype html", b"<table", b"<?xml", b"<meta", b"<head")):
        return message(
            "The file is a web page or XML, not an .xlsx workbook, whatever its name says. Save it "
            "as an .xlsx workbook."
        )
    if not _CONTROL.search(beginning):
        return message(
            "The file is plain text, for example a CSV table, not an .xlsx workbook. Fill in the "
            "workbook that was issued."
        )
    return NO_WORKBOOK


def _check_archive(data: bytes) -> None:
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            members = archive.infolist()
            total = sum(member.file_size for member in members)
            if len(members) > MOST_PARTS or total > LARGEST_TOTAL:
                raise _Refused(_TOO_LARGE)
            _check_kind({member.filename.replace("\\", "/").lower() for member in members}, archive)
            scan = _Scan()
            for member in members:
                _check_part(archive, member, scan)
    except (zipfile.BadZipFile, zlib.error, EOFError, OSError, ValueError) as fault:
        raise _Refused(DAMAGED) from fault
    except (NotImplementedError, RuntimeError) as fault:  # a method or a cipher of other archivers
        raise _Refused(NO_WORKBOOK) from fault


def _check_kind(names: set[str], archive: zipfile.ZipFile) -> None:
    """Tell other documents that are zip archives too."""
    if "xl/workbook.xml" in names:
        return
    if "mimetype" in names and b"opendocument" in archive.read("mimetype"):
        raise _Refused(message("The file is an OpenDocument file. Save it as an .xlsx workbook."))
    if "xl/workbook.bin" in names:
        raise _Refused(message("The file has the .xlsb format. Save it as an .xlsx workbook."))
    if "word/document.xml" in names:
        raise _Refused(message("The file is a text document. Send the .xlsx workbook itself."))
    if not any(name.startswith("xl/") for name in names):
        raise _Refused(NO_WORKBOOK)


def _check_part(archive: zipfile.ZipFile, member: zipfile.ZipInfo, scan: "_Scan") -> None:
    """Read a part once, if it is XML: what it is called decides nothing."""
    with archive.open(member) as stream:
        chunk = stream.read(_CHUNK)
        if chunk.lstrip(_BEFORE_XML)[:1] not in {b"<", b""}:
            return
        if member.file_size > LARGEST_PART:
            raise _Refused(_TOO_LARGE)
        parser = scan.parser()
        try:
            while chunk:
                parser.Parse(chunk, False)
                chunk = stream.read(_CHUNK)
            parser.Parse(b"", True)
        except expat.ExpatError as fault:
            # The reader would stop at the same place; drawings of comments need not be sound XML.
            if member.file_size and member.filename.lower().endswith((".xml", ".rels")):
                raise _Refused(_SAVE_AGAIN) from fault


class _Scan:
    """What was seen of an archive's XML so far; it changes, because a parser calls back."""

    def __init__(self) -> None:
        self._depth = 0
        self._elements = 0
        self._seen: Counter[str] = Counter()

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
            raise _Refused(_FOREIGN_CONTENT)
        if self._elements > MOST_ELEMENTS:
            raise _Refused(_TOO_LARGE)
        name = element.rpartition(":")[2] if ":" in element else element
        if name == "sheet":
            self._count("sheet", 1, MOST_SHEETS, _TOO_LARGE)
        elif name in _RANGES:
            self._count("range", 1, MOST_RANGES, _MERGED)
            self._count("covered", _covered(attributes.get("ref", "")), MOST_COVERED, _MERGED)

    def _count(self, what: str, number: int, most: int, reason: Message) -> None:
        self._seen[what] += number
        if self._seen[what] > most:
            raise _Refused(reason)

    def _leave(self, _element: str) -> None:
        self._depth -= 1

    def _refuse_declarations(self, *_declaration: object) -> None:
        raise _Refused(_FOREIGN_CONTENT)


def _covered(reference: str) -> int:
    """Return how many cells a range covers; whole columns and rows are more than any limit."""
    found = _CORNERS.fullmatch(reference)
    if found is None:
        return MOST_COVERED + 1 if reference else 0
    left, top, right, bottom = found.groups()
    columns = abs(_column(right or left) - _column(left)) + 1
    return columns * (abs(int(bottom or top) - int(top)) + 1)


def _column(letters: str) -> int:
    number = 0
    for letter in letters.upper():
        number = number * 26 + ord(letter) - ord("A") + 1
    return number
