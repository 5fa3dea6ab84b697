"""The cells of a sheet that names point to, as the file stores them; no other cell is kept."""

import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from itertools import product
from operator import attrgetter
from typing import Final, NamedTuple, TypeAlias
from xml.etree.ElementTree import Element

from gripcourse.machine.spreadsheet.addresses import Place, place_of
from gripcourse.machine.spreadsheet.xml_scan import local, local_name, namespace


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
_TAG_OF: Final = attrgetter("tag")
EMPTY: Final = StoredCell("n", None, 0, "")


Merged: TypeAlias = tuple[Place, Place]
"""The first and the last cell of a merged range."""


def first_of_merged(sheet: Element, places: Collection[Place]) -> dict[Place, Place]:
    """Return for each place the cell that shows there: the first of a merged range, or itself."""
    shown = {place: place for place in places}
    space = namespace(sheet)
    for element in sheet.iterfind(f"{space}mergeCells/{space}mergeCell"):
        merged = merged_range(element.get("ref", ""))
        if merged is not None:
            shown |= _first_of(*merged, places)
    return shown


def merged_range(reference: str) -> Merged | None:
    """Read the range that is merged; None where it is none of a sheet."""
    first, _, last = reference.partition(":")
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
    value_tag = f"{space}v"
    found: dict[Place, StoredCell] = {}
    for number, row in _numbered(_rows_in(sheet, space)):
        for place, cell in _of_row(one_for_all(row), number, space) if number in rows else ():
            if place in wanted:
                if place in found:
                    raise ValueError(place)
                found[place] = _stored(_of_one_value(cell, value_tag), space)
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
    # Of every cell of every work: the few tags of all of them are looked at.
    if any(local_name(tag) == _FOR_SOME for tag in set(map(_TAG_OF, holder))):
        raise ValueError(holder.tag)
    return holder


def _of_one_value(cell: Element, value_tag: str) -> Element:
    """Return a cell that holds one value at most, which is nothing but text."""
    if not len(cell):  # an element is false without children, and says so no longer
        return cell
    if len(cell) == 1 and cell[0].tag == value_tag and not len(cell[0]):  # nearly all
        return cell
    values = [one for one in one_for_all(cell) if local(one) in {"v", "is"}]
    names = {one.tag for one in values}
    if len(names) < len(values) or any(len(one) for one in values if local(one) == "v"):
        raise ValueError(cell.get("r"))
    return cell


def _numbered(rows: Iterable[Element]) -> Iterator[tuple[int, Element]]:
    """Yield the rows of a sheet with their numbers; one without stands below the last one."""
    number = 0
    for row in rows:
        number = whole_number(row.get("r")) or number + 1
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
        text = unescaped(text)
    return StoredCell(
        kind=kind,
        text=text or None,
        style=whole_number(cell.get("s")) or 0,
        formula="" if formula is None else f"={formula.text or '…'}",
    )


class TextPiece(NamedTuple):
    """A piece of a text that looks other than the rest of it.

    Attributes:
        text: as it is written in the file.
        place: `superscript` or `subscript`; anything else for neither.
        is_struck: whether it is crossed out.
    """

    text: str
    place: str
    is_struck: bool


def text_of(item: Element) -> str:
    """Join the pieces of a text; how it is pronounced is not part of it. See `joined_text`."""
    space = namespace(item)
    pieces = [
        TextPiece(_text_in(one, space), _place_of(one, space), _is_struck(one, space))
        for one in item.findall(f"{space}r")
    ]
    return joined_text(_text_in(item, space), pieces)


def joined_text(plain: str, pieces: Sequence[TextPiece]) -> str:
    """Join the pieces of a text behind what stands in none.

    What is raised stays raised: 10 with a raised 6 is a million, not a hundred and six. What is
    lowered stays lowered. Of a text of which a part is crossed out, each of that part's signs is
    followed by `CROSSED_OUT`.
    """
    plain = unescaped(plain)
    if not pieces:
        return plain
    shown = [(_placed(unescaped(one.text), one.place), one.is_struck) for one in pieces]
    struck = [is_out for _, is_out in shown]
    if not any(struck) or (all(struck) and not plain):  # as some mark what is done with
        return plain + "".join([text for text, _ in shown])
    return plain + "".join([_crossed_out(text) if is_out else text for text, is_out in shown])


def without_crossed_out(text: str) -> str:
    """Leave out what is crossed out."""
    return _CROSSED.sub("", text) if CROSSED_OUT in text else text


def _crossed_out(text: str) -> str:
    """Strike signs through; what is too long to be shown is left out at once."""
    return "".join([sign + CROSSED_OUT for sign in text[:_LONGEST_CROSSED]])


def is_struck(value: str) -> bool:
    """Tell by what a file says of a line through a text whether there is one."""
    return value not in {"0", "false"}


def _is_struck(piece: Element, space: str) -> bool:
    line = piece.find(f"{space}rPr/{space}strike")
    return line is not None and is_struck(line.get("val", "1"))


def _text_in(piece: Element, space: str) -> str:
    return "".join([one.text or "" for one in piece.findall(f"{space}t")])


def _place_of(piece: Element, space: str) -> str:
    place = piece.find(f"{space}rPr/{space}vertAlign")
    return "" if place is None else place.get("val", "")


def _placed(text: str, place: str) -> str:
    """Write what a piece of a text shows above or below the line in the signs that stand there."""
    table = _PLACED.get(place)
    return text if table is None else text.translate(table)


def unescaped(text: str) -> str:
    """Read the signs that the format writes by their numbers, as `_x000D_` for a line's end."""
    return _ESCAPED.sub(_sign, text) if "_x" in text else text


def _sign(escaped: re.Match[str]) -> str:
    """Return a sign by its number; one that may not stand in XML stays as it is written."""
    sign = chr(int(escaped[1], 16))
    return escaped[0] if _NO_SIGN.match(sign) else sign


def shared_texts(items: Sequence[Element], wanted: Iterable[int]) -> Mapping[int, str]:
    """Read the wanted items of the table of shared texts; those that it lacks are left out.

    Args:
        items: of the table.
        wanted: numbers of items, from 0.
    """
    return {number: text_of(items[number]) for number in wanted if number < len(items)}


def whole_number(text: str | None) -> int | None:
    """Read a number of a row or of a style; None where it is none."""
    return int(text) if text and len(text) <= 9 and text.isdecimal() else None  # noqa: PLR2004 (digits of any row)
