"""The cells of a sheet that names point to, as the file stores them; no other cell is kept."""

import re
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from typing import Final, TypeAlias
from xml.etree.ElementTree import Element

from gripcourse.machine.spreadsheet.package import Package, attribute, child, local

Place: TypeAlias = tuple[int, int]
"""Row and column of a cell, from 1."""

LAST_ROW: Final = 1_048_576
LAST_COLUMN: Final = 16_384
_CORNER: Final = re.compile(r"\$?([A-Za-z]{1,3})\$?([0-9]{1,7})")


@dataclass(frozen=True, slots=True)
class StoredCell:
    """One cell as it stands in its sheet.

    Attributes:
        kind: `n`, `s`, `str`, `b`, `e`, `d` or `inlineStr`.
        text: what is stored for its value; None for nothing.
        style: index of its style.
        formula: beginning with `=`; empty for none.
    """

    kind: str
    text: str | None
    style: int
    formula: str


EMPTY: Final = StoredCell("n", None, 0, "")


def place_of(reference: str) -> Place | None:
    """Read an address such as `$C$5`; None where it is none of a sheet."""
    found = _CORNER.fullmatch(reference)
    if found is None:
        return None
    row, column = int(found[2]), column_number(found[1])
    return (row, column) if 1 <= row <= LAST_ROW and column <= LAST_COLUMN else None


def column_number(letters: str) -> int:
    """Return the number of a column, from 1."""
    number = 0
    for letter in letters.upper():
        number = number * 26 + ord(letter) - ord("A") + 1
    return number


def address(place: Place) -> str:
    """Write a place as `C5`."""
    row, column = place
    letters = ""
    while column:
        column, rest = divmod(column - 1, 26)
        letters = chr(ord("A") + rest) + letters
    return f"{letters}{row}"


def first_of_merged(package: Package, part: str, places: Collection[Place]) -> dict[Place, Place]:
    """Return for each place the cell that shows there: the first of a merged range, or itself."""
    shown = {place: place for place in places}
    content = package.content(part)
    if b"mergeCell" not in content and b"\0" not in content:  # the latter of two-byte letters
        return shown
    for element in package.elements(part):
        if local(element) == "mergeCell":
            first, _, last = element.get("ref", "").partition(":")
            one, other = place_of(first), place_of(last or first)
            if one is not None and other is not None:
                top, left = min(one[0], other[0]), min(one[1], other[1])
                bottom, right = max(one[0], other[0]), max(one[1], other[1])
                inside = (
                    place
                    for place in places
                    if top <= place[0] <= bottom and left <= place[1] <= right
                )
                shown |= dict.fromkeys(inside, (top, left))
        elif local(element) == "row":
            element.clear()
    return shown


def stored_cells(
    package: Package, part: str, wanted: Collection[Place]
) -> Mapping[Place, StoredCell]:
    """Read the wanted cells of a sheet; those that are not stored are left out.

    Raises:
        ValueError: a cell is stored twice: programs disagree which of the two counts.
    """
    rows = {row for row, _ in wanted}
    found: dict[Place, StoredCell] = {}
    for number, row in _rows(package, part):
        for place, cell in _of_row(row, number) if number in rows else ():
            if place in found:
                raise ValueError(place)
            if place in wanted:
                found[place] = _stored(cell)
    return found


def all_cells(package: Package, part: str) -> Mapping[int, Mapping[int, StoredCell]]:
    """Read all cells of a sheet that are stored: by row, then by column."""
    found: dict[int, dict[int, StoredCell]] = {}
    for number, row in _rows(package, part):
        for (_, column), cell in _of_row(row, number):
            found.setdefault(number, {})[column] = _stored(cell)
    return found


def _rows(package: Package, part: str) -> Iterator[tuple[int, Element]]:
    """Yield the rows of a sheet with their numbers; each is cleared after it was looked at."""
    number = 0
    for element in package.elements(part):
        if element.tag.endswith("row") and local(element) == "row":
            number = _whole(element.get("r")) or number + 1
            yield number, element
            element.clear()


def _of_row(row: Element, number: int) -> Iterator[tuple[Place, Element]]:
    """Yield the cells of a row; one that does not say where it is stands beside the last one."""
    column = 0
    for cell in row:
        if local(cell) == "c":
            place = place_of(cell.get("r", "")) or (number, column + 1)
            column = place[1]
            yield place, cell


def sheets_of(package: Package, workbook: str) -> Mapping[str, str]:
    """Return the part of every sheet by its title; of two with one title the first counts."""
    parts = {
        one.identifier: one.part
        for one in package.related(workbook)
        if one.kind == "worksheet" and package.has(one.part)
    }
    sheets: dict[str, str] = {}
    for element in package.elements(workbook):
        part = parts.get(attribute(element, "id") or "")
        if local(element) == "sheet" and part is not None:
            sheets.setdefault(element.get("name", ""), part)
    return sheets


def _stored(cell: Element) -> StoredCell:
    kind = cell.get("t", "n")
    value, formula = child(cell, "v"), child(cell, "f")
    inline = child(cell, "is")
    text = None if value is None else value.text
    if kind == "inlineStr":
        text = None if inline is None else text_of(inline)
    return StoredCell(
        kind=kind,
        text=text or None,
        style=_whole(cell.get("s")) or 0,
        formula="" if formula is None else f"={formula.text or '…'}",
    )


def text_of(item: Element) -> str:
    """Join the pieces of a text; how it is pronounced is not part of it."""
    pieces = [item, *(one for one in item if local(one) == "r")]
    texts = (one.text or "" for piece in pieces for one in piece if local(one) == "t")
    return "".join(texts)


def shared_texts(
    package: Package, part: str, wanted: Collection[int] | None = None
) -> Mapping[int, str]:
    """Read the wanted items of the table of shared texts; all where None."""
    found: dict[int, str] = {}
    number = 0
    for element in package.elements(part):
        if local(element) == "si":
            if wanted is None or number in wanted:
                found[number] = text_of(element)
            number += 1
            element.clear()
    return found


def _whole(text: str | None) -> int | None:
    return int(text) if text and len(text) <= 9 and text.isdecimal() else None  # noqa: PLR2004 (digits of any row)
