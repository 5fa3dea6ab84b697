"""The cells of a sheet that names point to, as the file stores them; no other cell is kept."""

import re
from collections.abc import Collection, Iterable, Iterator, Mapping
from itertools import product
from typing import Final, NamedTuple, TypeAlias
from xml.etree.ElementTree import Element

from gripcourse.machine.spreadsheet.addresses import Place, place_of
from gripcourse.machine.spreadsheet.xml_scan import local, namespace
from gripcourse.machine.table_bounds import MOST_ROWS, TooLargeTableError


class StoredCell(NamedTuple):
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


_ESCAPED: Final = re.compile(r"_x([0-9A-Fa-f]{4})_")
_NO_SIGN: Final = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd]")  # that may stand in XML
# The letter o and its Cyrillic twin above the line are how people without a degree sign write it.
_ABOVE: Final = str.maketrans("0123456789+-−oоOО", "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁻°°°°")
_BELOW: Final = str.maketrans("0123456789+-−", "₀₁₂₃₄₅₆₇₈₉₊₋₋")
_PLACED: Final = {"superscript": _ABOVE, "subscript": _BELOW}
CROSSED_OUT: Final = "\N{COMBINING LONG STROKE OVERLAY}"
_LONGEST_CROSSED: Final = 500
_CROSSED: Final = re.compile(f".{CROSSED_OUT}", re.DOTALL)
_FOR_SOME: Final = "AlternateContent"
EMPTY: Final = StoredCell("n", None, 0, "")


Merged: TypeAlias = tuple[Place, Place]
"""The first and the last cell of a merged range."""


def first_of_merged(sheet: Element, places: Collection[Place]) -> dict[Place, Place]:
    """Return for each place the cell that shows there: the first of a merged range, or itself."""
    shown = {place: place for place in places}
    space = namespace(sheet)
    for element in sheet.iterfind(f"{space}mergeCells/{space}mergeCell"):
        merged = _merged(element)
        if merged is not None:
            shown |= _first_of(*merged, places)
    return shown


def _merged(element: Element) -> Merged | None:
    first, _, last = element.get("ref", "").partition(":")
    one, other = place_of(first), place_of(last or first)
    return None if one is None or other is None else (one, other)


def _first_of(one: Place, other: Place, places: Collection[Place]) -> Mapping[Place, Place]:
    """Return the first cell of a range for those of some places that are inside it."""
    rows = range(min(one[0], other[0]), max(one[0], other[0]) + 1)
    columns = range(min(one[1], other[1]), max(one[1], other[1]) + 1)
    inside = (place for place in product(rows, columns) if place in places)
    return dict.fromkeys(inside, (rows[0], columns[0]))


def stored_cells(sheet: Element, wanted: Collection[Place]) -> Mapping[Place, StoredCell]:
    """Read the wanted cells of a sheet; those that are not stored are left out.

    Raises:
        ValueError: a cell or its value is stored twice, or once for older and once for newer
            programs: they disagree which of the two counts.
    """
    rows = {row for row, _ in wanted}
    space = namespace(sheet)
    found: dict[Place, StoredCell] = {}
    for number, row in _numbered(_rows_in(sheet, space)):
        for place, cell in _of_row(one_for_all(row), number, space) if number in rows else ():
            if place in wanted:
                if place in found:
                    raise ValueError(place)
                found[place] = _stored(_of_one_value(cell), space)
    return found


def _rows_in(sheet: Element, space: str) -> Iterator[Element]:
    """Yield the rows that a program shows: those where cells stand, not any that is called so."""
    for data in sheet.iterfind(f"{space}sheetData"):
        yield from one_for_all(data).iterfind(f"{space}row")


def one_for_all(holder: Element) -> Element:
    """Return what holds rows, cells or texts, where all programs find the same of them.

    Raises:
        ValueError: some are for older programs, others for newer ones.
    """
    for one in holder:
        # Of every cell of every work: the ending is looked at first.
        if one.tag.endswith(_FOR_SOME) and local(one) == _FOR_SOME:
            raise ValueError(holder.tag)
    return holder


def _of_one_value(cell: Element) -> Element:
    """Return a cell that holds one value at most, which is nothing but text."""
    if not len(cell):  # an element is false without children, and says so no longer
        return cell
    values = [one for one in one_for_all(cell) if local(one) in {"v", "is"}]
    names = {one.tag for one in values}
    if len(names) < len(values) or any(len(one) for one in values if local(one) == "v"):
        raise ValueError(cell.get("r"))
    return cell


def all_cells(
    elements: Iterable[Element], merged: list[Merged]
) -> Mapping[int, Mapping[int, StoredCell]]:
    """Read all cells of a long sheet that are stored: by row, then by column.

    Args:
        elements: of the sheet as they end; its rows are cleared.
        merged: where its merged ranges are recorded.

    Raises:
        TooLargeTableError: more rows hold something than are ever read.
    """
    found: dict[int, dict[int, StoredCell]] = {}
    filled = 0
    for number, row in _numbered(_rows_of(elements, merged)):
        space = namespace(row)
        is_filled = False
        for (_, column), cell in _of_row(row, number, space):
            stored = found.setdefault(number, {})[column] = _stored(cell, space)
            is_filled = is_filled or bool(stored.text or stored.formula)
        row.clear()
        filled += is_filled
        if filled > MOST_ROWS:
            raise TooLargeTableError
    return found


def _rows_of(elements: Iterable[Element], merged: list[Merged]) -> Iterator[Element]:
    """Yield the rows among elements, and record the merged ranges, which stand behind them."""
    for one in elements:
        kind = local(one)
        if kind == "row":
            yield one
        elif kind == "mergeCell" and (found := _merged(one)) is not None:
            merged.append(found)


def _numbered(rows: Iterable[Element]) -> Iterator[tuple[int, Element]]:
    """Yield the rows of a sheet with their numbers; one without stands below the last one."""
    number = 0
    for row in rows:
        number = _whole(row.get("r")) or number + 1
        yield number, row


def _of_row(row: Element, number: int, space: str) -> Iterator[tuple[Place, Element]]:
    """Yield the cells of a row; one that does not say where it is stands beside the last one."""
    column, tag = 0, f"{space}c"
    for cell in row:
        if cell.tag == tag:
            place = place_of(cell.get("r", "")) or (number, column + 1)
            column = place[1]
            yield place, cell


def _stored(cell: Element, space: str) -> StoredCell:
    kind = cell.get("t", "n")
    value, formula = cell.find(f"{space}v"), cell.find(f"{space}f")
    inline = cell.find(f"{space}is") if kind == "inlineStr" else None
    text = None if value is None else value.text
    if kind == "inlineStr":
        text = None if inline is None else text_of(inline)
    elif kind == "str" and text:
        text = _unescaped(text)
    return StoredCell(
        kind=kind,
        text=text or None,
        style=_whole(cell.get("s")) or 0,
        formula="" if formula is None else f"={formula.text or '…'}",
    )


def text_of(item: Element) -> str:
    """Join the pieces of a text; how it is pronounced is not part of it.

    What is raised stays raised: 10 with a raised 6 is a million, not a hundred and six. What is
    lowered stays lowered. Of a text of which a part is crossed out, each of that part's signs is
    followed by `CROSSED_OUT`.
    """
    space = namespace(item)
    plain = _text_in(item, space)
    pieces = [(one, _placed(_text_in(one, space), one, space)) for one in item.findall(f"{space}r")]
    struck = [_is_struck(one, space) for one, _ in pieces]
    if not any(struck) or (all(struck) and not plain):  # as some mark what is done with
        return plain + "".join([text for _, text in pieces])
    shown = ((text, is_out) for (_, text), is_out in zip(pieces, struck, strict=True))
    return plain + "".join([_crossed_out(text) if is_out else text for text, is_out in shown])


def without_crossed_out(text: str) -> str:
    """Leave out what is crossed out."""
    return _CROSSED.sub("", text) if CROSSED_OUT in text else text


def _crossed_out(text: str) -> str:
    """Strike signs through; what is too long to be shown is left out at once."""
    return "".join([sign + CROSSED_OUT for sign in text[:_LONGEST_CROSSED]])


def _is_struck(piece: Element, space: str) -> bool:
    line = piece.find(f"{space}rPr/{space}strike")
    return line is not None and line.get("val", "1") not in {"0", "false"}


def _text_in(piece: Element, space: str) -> str:
    return _unescaped("".join([one.text or "" for one in piece.findall(f"{space}t")]))


def _placed(text: str, piece: Element, space: str) -> str:
    """Write what a piece of a text shows above or below the line in the signs that stand there."""
    place = piece.find(f"{space}rPr/{space}vertAlign")
    table = None if place is None else _PLACED.get(place.get("val", ""))
    return text if table is None else text.translate(table)


def _unescaped(text: str) -> str:
    """Read the signs that the format writes by their numbers, as `_x000D_` for a line's end."""
    return _ESCAPED.sub(_sign, text) if "_x" in text else text


def _sign(escaped: re.Match[str]) -> str:
    """Return a sign by its number; one that may not stand in XML stays as it is written."""
    sign = chr(int(escaped[1], 16))
    return escaped[0] if _NO_SIGN.match(sign) else sign


def shared_texts(
    elements: Iterable[Element], wanted: Collection[int] | None = None
) -> Mapping[int, str]:
    """Read the wanted items of the table of shared texts; all where None.

    Args:
        elements: of the table; its items are cleared.
        wanted: numbers of items.
    """
    found: dict[int, str] = {}
    number = 0
    for element in elements:
        if local(element) == "si":
            if wanted is None or number in wanted:
                found[number] = text_of(element)
            number += 1
            element.clear()
    return found


def _whole(text: str | None) -> int | None:
    return int(text) if text and len(text) <= 9 and text.isdecimal() else None  # noqa: PLR2004 (digits of any row)
