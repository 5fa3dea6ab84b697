"""What must be known of an OpenDocument spreadsheet before another program opens it.

A kilobyte of it can say that a row of a thousand cells is there a million times, and any part of it
can unpack to gigabytes: LibreOffice would try for a minute, in whatever memory it gets.
"""

import math
import re
import zipfile
from collections.abc import Mapping
from typing import Final
from xml.parsers import expat

from gripcourse.machine.spreadsheet.refusals import WhyRefused
from gripcourse.machine.spreadsheet.sheet_cells import whole_number
from gripcourse.machine.spreadsheet.xml_names import check_long_tags
from gripcourse.machine.spreadsheet.xml_scan import (
    DEEPEST,
    MOST_NAMES,
    MOST_SHEETS,
    Bounds,
    RefusedError,
    refuse_declarations,
)
from gripcourse.machine.table_bounds import MOST_OF_WORKBOOK
from gripcourse.text.number_text import is_lost

_CONTENT: Final = "content.xml"
_MANIFEST: Final = "META-INF/manifest.xml"
_LONGEST_MANIFEST: Final = 1 << 20
_ENCRYPTED: Final = b"encryption-data"
_XML: Final = (".xml", ".rdf")
_TABLE: Final = "urn:oasis:names:tc:opendocument:xmlns:table:1.0"
_OFFICE: Final = "urn:oasis:names:tc:opendocument:xmlns:office:1.0"
_TEXT: Final = "urn:oasis:names:tc:opendocument:xmlns:text:1.0"
_SHEET: Final = f"{_TABLE} table"
_ROW: Final = f"{_TABLE} table-row"
_CELLS: Final = frozenset({f"{_TABLE} table-cell", f"{_TABLE} covered-table-cell"})
_PARAGRAPH: Final = f"{_TEXT} p"
_ROWS: Final = f"{_TABLE} number-rows-repeated"
_COLUMNS: Final = f"{_TABLE} number-columns-repeated"
_KIND: Final = f"{_OFFICE} value-type"
_VALUE: Final = f"{_OFFICE} value"
_HOLDS: Final = (_KIND, _VALUE, f"{_TABLE} formula")
_NUMBERS: Final = frozenset({"float", "percentage", "currency"})
# LibreOffice makes a zero of what is no number, and twelve of 12,5.
_NUMBER: Final = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d{1,3})?", re.ASCII)


def check_open_document(archive: zipfile.ZipFile, bounds: Bounds) -> None:
    """Look through an OpenDocument spreadsheet.

    Args:
        archive: which it is; its directory was looked at.
        bounds: of what it may hold.

    Raises:
        RefusedError: it is protected by a password, or must not be opened.
        Exception: what `zipfile` raises of a damaged one.
    """
    members = {one.filename: one for one in archive.infolist()}
    sizes = [one.file_size for one in members.values() if one.filename.lower().endswith(_XML)]
    if sum(sizes) > bounds.total or max(sizes, default=0) > bounds.part:
        raise RefusedError(WhyRefused.TOO_LARGE)
    if _MANIFEST in members:
        with archive.open(members[_MANIFEST]) as manifest:
            if _ENCRYPTED in manifest.read(_LONGEST_MANIFEST):
                raise RefusedError(WhyRefused.PASSWORD)
    if _CONTENT not in members:  # LibreOffice shows a blank document
        raise RefusedError(WhyRefused.DAMAGED)
    content = archive.read(members[_CONTENT])
    check_long_tags(content)
    _CellCount(bounds).check(content)


class _CellCount:
    """What was counted so far; it changes, because a parser calls back."""

    def __init__(self, bounds: Bounds) -> None:
        self._elements = bounds.elements
        self._cells = MOST_OF_WORKBOOK  # that hold anything, each as often as it is there
        self._sheets = MOST_SHEETS
        self._depth = self._rows = self._columns = 0
        self._names: dict[str, str] = {}

    def check(self, content: bytes) -> None:
        """Go through the content.

        Raises:
            RefusedError: there is too much of it, it is no sound XML, or declares entities.
        """
        parser = expat.ParserCreate(namespace_separator=" ", intern=self._names)
        parser.StartElementHandler, parser.EndElementHandler = self._enter, self._leave
        parser.StartDoctypeDeclHandler = refuse_declarations
        try:
            parser.Parse(content, True)
        except (expat.ExpatError, LookupError, UnicodeError) as fault:
            raise RefusedError(WhyRefused.INVALID_XML) from fault

    def _enter(self, element: str, attributes: Mapping[str, str]) -> None:
        self._depth += 1
        self._elements -= 1
        if self._elements < 0:
            raise RefusedError(WhyRefused.TOO_LARGE)
        if self._depth > DEEPEST or len(self._names) > MOST_NAMES:
            raise RefusedError(WhyRefused.FOREIGN_CONTENT)
        if element in _CELLS:
            if attributes.get(_KIND) in _NUMBERS:
                _expect_number(attributes.get(_VALUE, ""))
            self._columns = _times(attributes.get(_COLUMNS))
            if any(one in attributes for one in _HOLDS):
                self._count()
        elif element == _ROW:
            self._rows = _times(attributes.get(_ROWS))
        elif element == _PARAGRAPH and self._columns:
            self._count()
        elif element == _SHEET:
            self._sheets -= 1
            if self._sheets < 0:
                raise RefusedError(WhyRefused.TOO_LARGE)

    def _count(self) -> None:
        """Count the cell that is read, once, as often as it is there."""
        self._cells -= self._columns * self._rows
        self._columns = 0
        if self._cells < 0:
            raise RefusedError(WhyRefused.TOO_LARGE)

    def _leave(self, element: str) -> None:
        self._depth -= 1
        if element in _CELLS:
            self._columns = 0


def _expect_number(value: str) -> None:
    """Refuse what would silently become another number.

    Raises:
        RefusedError: it is none, or larger than any.
    """
    if not _NUMBER.fullmatch(value) or math.isinf(float(value)) or is_lost(value, float(value)):
        raise RefusedError(WhyRefused.FOREIGN_CONTENT)


def _times(text: str | None) -> int:
    """Read how often something is there; what is no number of a sheet is too often."""
    if text is None:
        return 1
    return whole_number(text) or MOST_OF_WORKBOOK + 1
