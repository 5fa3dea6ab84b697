"""What a stored cell holds: a number, a text, a date, an error, as a spreadsheet shows it."""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import date, datetime, time, timedelta
from functools import cache
from typing import Final, NamedTuple, TypeAlias
from xml.etree.ElementTree import Element

from gripcourse.machine.spreadsheet.package import UNSOUND, Package
from gripcourse.machine.spreadsheet.sheet_cells import StoredCell
from gripcourse.machine.spreadsheet.xml_scan import local
from gripcourse.text.number_text import is_lost

CellValue: TypeAlias = bool | int | float | str | datetime | date | time | timedelta | None
"""What a spreadsheet cell can hold; `date` includes `datetime`."""

GENERAL: Final = "General"
_LONGEST_FORMAT: Final = 500  # characters; spreadsheet programs write 255 at most
_NUMBER: Final = re.compile(r"\s*[+-]?(\d{1,4000}(\.\d*)?|\.\d+)([eE][+-]?\d{1,9})?\s*", re.ASCII)
_MOST_STYLES: Final = 100_000
_DIGITS: Final = 9  # of an index


class CellContent(NamedTuple):
    """What a cell holds.

    Attributes:
        value: as a spreadsheet program understands it.
        error: whether the value is an error of a formula; without a value, whether the cell points
            to a text that is not there.
    """

    value: CellValue
    error: bool = False


class UnreadableContentError(ValueError):
    """Something that no spreadsheet program writes, where it matters."""


@dataclass(frozen=True, slots=True)
class NumberFormats:
    """How a workbook shows its numbers.

    Attributes:
        of_styles: by the number of a style; None for a format that no program writes. Nothing where
            the styles are gone or cannot be read.
    """

    of_styles: tuple[str | None, ...]

    def of(self, cell: StoredCell) -> str:
        """Return the format of a cell; the usual one where its own is lost."""
        return self._found(cell) or GENERAL

    def is_lost(self, cell: StoredCell) -> bool:
        """Tell whether a cell has a style that nobody can know."""
        return self._found(cell) is None and (cell.style != 0 or self.of_styles != ())

    def is_plain(self, style: int) -> bool:
        """Tell whether a style shows numbers as they are stored."""
        return self.of_styles[style] in {GENERAL, ""}

    def _found(self, cell: StoredCell) -> str | None:
        return self.of_styles[cell.style] if cell.style < len(self.of_styles) else None


def formats_of(package: Package, part: str | None) -> NumberFormats:
    """Return the number formats of a workbook: spreadsheet programs open one without styles, too.

    Args:
        package: the workbook.
        part: with its styles; None where it names none.

    Raises:
        UnreadableContentError: there are more styles than any program writes.
        RefusedError: they hold what must not be read.
        Exception: what `zipfile` raises of damaged ones.
    """
    if part is None or not package.has(part):
        return NumberFormats(())
    try:
        return NumberFormats(package.made_of(part, _formats_in))
    except UNSOUND:
        return NumberFormats(())


def _formats_in(styles: Element) -> tuple[str | None, ...]:
    declared: dict[str, str] = {}
    used: list[str] = []
    for element in styles.iter():
        if local(element) == "numFmt":
            declared[element.get("numFmtId", "")] = element.get("formatCode", "")
        elif local(element) == "cellXfs":
            used = [one.get("numFmtId", "0") for one in element if local(one) == "xf"]
    if len(used) > _MOST_STYLES:
        raise UnreadableContentError
    builtin = _builtin_formats()
    codes = (declared.get(one) or builtin.get(one, GENERAL) for one in used)
    return tuple(code if len(code) <= _LONGEST_FORMAT else None for code in codes)


@cache
def _builtin_formats() -> Mapping[str, str]:
    """Return the formats that need no declaration, by their numbers as a file writes them."""
    from openpyxl.styles.numbers import BUILTIN_FORMATS  # noqa: PLC0415 (100 ms to import)

    return {str(number): code for number, code in BUILTIN_FORMATS.items()}


def shown_value(
    cell: StoredCell, number_format: str, texts: Mapping[int, str], *, from_1904: bool
) -> CellContent:
    """Tell what a cell holds.

    Args:
        cell: as it is stored.
        number_format: of the cell; one of a date makes a date of its number.
        texts: the shared texts that cells point to.
        from_1904: whether the workbook counts days from 1904 on.
    """
    text = cell.text
    if text is None:
        return CellContent(None)
    if cell.kind == "n" and _NUMBER.fullmatch(text):
        return _number(text, number_format, from_1904=from_1904)
    if cell.kind == "s":
        index = text_index(text)
        shared = None if index is None else texts.get(index)
        return CellContent(shared or None, error=shared is None)
    return CellContent(_not_a_number(cell.kind, text), error=cell.kind == "e")


def _not_a_number(kind: str, text: str) -> CellValue:
    """Return what a cell holds; a number that is none stays what it is, a text."""
    if kind == "b" and text.strip() in {"0", "1"}:
        return text.strip() == "1"
    return _date(text) if kind == "d" else text


def text_index(text: str | None) -> int | None:
    """Read the number of a shared text; None where it is none."""
    return int(text) if text and text.isdecimal() and len(text) <= _DIGITS else None


def counts_from_1904(package: Package, workbook: str) -> bool:
    """Tell whether a workbook counts days from 1904 on, as old ones of a Macintosh do."""
    return any(
        element.get("date1904", "0") in {"1", "true"}
        for element in package.elements(workbook, "workbookPr")
    )


def _number(text: str, number_format: str, *, from_1904: bool) -> CellContent:
    number = float(text) if set(".eE") & set(text) else int(text)
    if is_lost(text, number):  # too small to be held: it must not become a zero
        return CellContent(text)
    if number_format in {GENERAL, ""}:
        return CellContent(number)
    from openpyxl.styles.numbers import is_date_format, is_timedelta_format  # noqa: PLC0415 (as above)
    from openpyxl.utils.datetime import CALENDAR_MAC_1904, WINDOWS_EPOCH, from_excel  # noqa: PLC0415

    if not is_date_format(number_format):
        return CellContent(number)
    epoch = CALENDAR_MAC_1904 if from_1904 else WINDOWS_EPOCH
    try:
        return CellContent(from_excel(number, epoch, is_timedelta_format(number_format)))
    except (OverflowError, ValueError):
        return CellContent("#VALUE!", error=True)


def _date(text: str) -> CellValue:
    """Read a date as the strict format stores it; what is none stays a text."""
    try:
        return datetime.fromisoformat(text.strip().removesuffix("Z"))
    except ValueError:
        return text
