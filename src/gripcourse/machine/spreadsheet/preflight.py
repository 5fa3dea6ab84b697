"""Cheap checks of a file before a spreadsheet reader sees it.

A kilobyte can unpack to gigabytes, and one merged column makes the reader allocate a million cells.
Everything here costs milliseconds and bounded memory; what passes is safe to unpack. Who reads a
file can do so in the same pass.
"""

import io
import re
import zipfile
import zlib
from collections import Counter
from collections.abc import Callable, Sequence
from typing import Final, TypeVar

from gripcourse.machine.spreadsheet.open_document_scan import check_open_document
from gripcourse.machine.spreadsheet.package import Package, part_name
from gripcourse.machine.spreadsheet.refusals import WhyRefused
from gripcourse.machine.spreadsheet.xml_scan import Bounds, RefusedError, XmlScan

Made = TypeVar("Made")
MEGABYTE: Final = 1_000_000
LARGEST_FILE: Final = 60 * MEGABYTE  # with pictures
LARGEST_TOTAL: Final = 24 * MEGABYTE  # of XML unpacked, by the sizes that the archive declares
LARGEST_PART: Final = 8 * MEGABYTE  # of XML; 99 % of real workbooks have 2.2 in all their parts
MOST_PARTS: Final = 1000
MOST_ELEMENTS: Final = 200_000  # XML elements; a cell is one or two, an answer workbook has 5000

SUBMISSION: Final = Bounds(
    LARGEST_PART, LARGEST_TOTAL, MOST_ELEMENTS, tree=LARGEST_PART, tree_elements=MOST_ELEMENTS
)
"""What a student hands in."""

TABLE: Final = Bounds(
    *(32 * MEGABYTE, 48 * MEGABYTE, 1_200_000), tree=LARGEST_PART, tree_elements=MOST_ELEMENTS
)
"""What an instructor makes: a table of as many cells as are read of one, whoever wrote it."""

_METHODS: Final = frozenset({zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED})
_CHUNK: Final = 1 << 16

_SHORT: Final = 128  # bytes
_OPEN_DOCUMENT: Final = b"opendocument"
_WORKBOOK: Final = "/workbook.xml"
_OLE: Final = b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1"
_ENCRYPTED: Final = "EncryptedPackage".encode("utf-16-le")
_PICTURES: Final = (b"\x89PNG", b"\xff\xd8\xff", b"GIF8", b"II*\0", b"MM\0*")
# Telephones' own: the name of the form stands behind four bytes of size.
_PICTURES_BEHIND: Final = ((4, b"ftyphei"), (4, b"ftypmif1"), (4, b"ftypavif"), (8, b"WEBP"))
_ARCHIVES: Final = (b"Rar!\x1a\x07", b"7z\xbc\xaf\x27\x1c")
# What a browser or a file manager shows as the document, and is none: a link to it in a cloud.
_LINKS: Final = (b"[internetshortcut]", b'{"url"', b'{"doc_id"', b"bplist00", b"l\0\0\0\1\x14\2\0")
_PAGES: Final = (
    *(
        b"<html",
        b"<!doctype html",
        b"<table",
        b"<?xml",
        b"<meta",
        b"<head",
        b"<!--",
        b"mime-version",
    ),
)
_RICH_TEXT: Final = b"{\\rtf"
_CONTROL: Final = re.compile(rb"[\0-\x08\x0e-\x1f]")  # bytes that no text has


class DecidedError(Exception):
    """A file that is refused whatever else is in it: no second look at it is worth its time.

    Attributes:
        reason: for the person who sent it.
    """

    def __init__(self, reason: WhyRefused) -> None:
        self.reason = reason
        super().__init__(reason)


def read_checked(
    name: str, data: bytes, read: Callable[[Package], Made], bounds: Bounds = SUBMISSION
) -> Made | WhyRefused:
    """Read a file while it is checked: each of its parts is gone through once.

    A file that fails is checked once more, part by part as they stand in the archive: the reason
    does not depend on what was read first.

    Args:
        name: of the file, without folders.
        data: its whole content.
        read: reads the parts that it needs; the others are checked after it.
        bounds: of what it may hold.

    Returns:
        What was read, or why the file is refused.

    Raises:
        Exception: whatever `read` raises about a file that is not refused.
    """
    try:
        _check_name(name)
        _check_magic(data)
        return _read_archive(data, read, bounds)
    except DecidedError as decided:
        return decided.reason
    except Exception as fault:  # noqa: BLE001 (whatever the bytes make a library raise)
        failed = fault.with_traceback(None)  # which holds all that was read
    reason = refusal(name, data, bounds)
    if reason is not None:
        return reason
    if isinstance(failed, RefusedError):  # for what only who reads a part must not meet
        return failed.reason
    raise failed


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
        _read_archive(data, lambda _: None, bounds)
    except RefusedError as refused:
        return refused.reason
    except (zipfile.BadZipFile, zlib.error, EOFError, OSError, ValueError):
        return WhyRefused.DAMAGED
    except (NotImplementedError, RuntimeError):  # a method or a cipher of other archivers
        return WhyRefused.NO_WORKBOOK
    return None


def _read_archive(data: bytes, read: Callable[[Package], Made], bounds: Bounds) -> Made:
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        members = archive.infolist()
        _check_directory(members)
        _check_kind({part_name(member.filename) for member in members}, archive, bounds)
        package = Package(archive, XmlScan(bounds))
        made = read(package)
        package.check_others()
    return made


def _check_name(name: str) -> None:
    if name.startswith(("~$", ".~lock.")):
        raise RefusedError(WhyRefused.LOCK_FILE)


def _check_magic(data: bytes) -> None:
    """Tell by its first bytes what a file is that is no zip archive."""
    if not data:
        raise RefusedError(WhyRefused.EMPTY)
    if len(data) > LARGEST_FILE:
        raise RefusedError(WhyRefused.TOO_LARGE)
    if data.startswith(_OLE):
        raise RefusedError(_about_ole(data))
    if data.startswith((b"PK\x03\x04", b"PK\x05\x06")):
        return
    if data.startswith(b"%PDF"):
        raise RefusedError(WhyRefused.PDF)
    if data.startswith(_PICTURES) or any(data.startswith(one, at) for at, one in _PICTURES_BEHIND):
        raise RefusedError(WhyRefused.PICTURE)
    if data.startswith(_ARCHIVES):
        raise RefusedError(WhyRefused.ARCHIVE)
    if not any(data):  # a disk kept the length of what it never got
        raise RefusedError(WhyRefused.DAMAGED)
    raise RefusedError(_about_text(data[:_CHUNK]))


def _about_ole(data: bytes) -> WhyRefused:
    return WhyRefused.PASSWORD if _ENCRYPTED in data else WhyRefused.OLD_FORMAT


def _about_text(beginning: bytes) -> WhyRefused:
    """Tell a web page and a text table from other bytes."""
    start = beginning.lstrip(b"\xef\xbb\xbf \t\r\n").lower()
    if start.startswith(_PAGES):
        return WhyRefused.WEB_PAGE
    if start.startswith(_LINKS):
        return WhyRefused.LINK
    if start.startswith(_RICH_TEXT):
        return WhyRefused.TEXT_DOCUMENT
    return WhyRefused.NO_WORKBOOK if _CONTROL.search(beginning) else WhyRefused.DELIMITED_TEXT


def _check_directory(members: Sequence[zipfile.ZipInfo]) -> None:
    """Refuse by the directory alone what no spreadsheet program writes: nothing is unpacked yet."""
    if len(members) > MOST_PARTS:
        raise RefusedError(WhyRefused.TOO_LARGE)
    if any(member.compress_type not in _METHODS for member in members):
        raise RefusedError(WhyRefused.FOREIGN_CONTENT)
    names = Counter(part_name(member.filename) for member in members)
    if any(count > 1 for count in names.values()):
        # Programs disagree which of two parts with one name counts.
        raise RefusedError(WhyRefused.FOREIGN_CONTENT)


def _check_kind(names: set[str], archive: zipfile.ZipFile, bounds: Bounds) -> None:
    """Tell other documents that are zip archives too."""
    if any(name.endswith(_WORKBOOK) for name in names):  # programs disagree about its folder
        return
    if "mimetype" in names and _OPEN_DOCUMENT in _beginning(archive, "mimetype"):
        check_open_document(archive, bounds)
        raise RefusedError(WhyRefused.OPEN_DOCUMENT)
    if "xl/workbook.bin" in names:
        raise RefusedError(WhyRefused.XLSB)
    if "index/document.iwa" in names:
        raise RefusedError(WhyRefused.NUMBERS)
    if "word/document.xml" in names:
        raise RefusedError(WhyRefused.TEXT_DOCUMENT)
    if not any(name.startswith("xl/") for name in names):
        raise RefusedError(WhyRefused.NO_WORKBOOK)


def _beginning(archive: zipfile.ZipFile, name: str) -> bytes:
    """Return what a short member begins with; nothing where it is called otherwise by letter."""
    if name not in archive.namelist():
        return b""
    with archive.open(name) as stream:
        return stream.read(_SHORT)
