"""Whether what was read really stands in the file: asked without our reader.

The members are unpacked and parsed as a whole, and each value that was read must be what a cell of
that address stores. Where several cells have one address, each of them counts: which one a
spreadsheet program takes is not our question here, but that nothing is invented.
"""

import io
import posixpath
import re
import zipfile
from collections.abc import Iterator
from datetime import date, datetime, time, timedelta
from typing import TypeAlias
from xml.etree import ElementTree as ET

from gripcourse.submission.raw import RawCell, RawWorkbook

Texts: TypeAlias = tuple[str | None, ...]

_RAISED = {
    **{str(digit): sign for digit, sign in enumerate("⁰¹²³⁴⁵⁶⁷⁸⁹")},
    "+": "⁺",
    "-": "⁻",
    "\u2212": "⁻",
    **dict.fromkeys("oOоО", "°"),
}
_LOWERED = {
    **{str(digit): sign for digit, sign in enumerate("₀₁₂₃₄₅₆₇₈₉")},
    "+": "₊",
    "-": "₋",
    "\u2212": "₋",
}
_ADDRESS = re.compile(r"\$?([A-Za-z]{1,3})\$?([0-9]{1,7})")


def invented(data: bytes, raw: RawWorkbook) -> list[str]:
    """Return what was read and stands nowhere in the file, in words; nothing for all is there."""
    parts = _trees(data)
    texts = [_text(item) for tree in parts.values() for item in tree.iter() if _is(item, "si")]
    cells = list(_cells(parts))
    names = [
        (one.get("name", "").lower().replace("_", "."), (one.text or "").strip().replace("$", ""))
        for tree in parts.values()
        for one in tree.iter()
        if _is(one, "definedName")
    ]
    merged = " ".join(
        f"{one.get('ref', '')} {_first_corner(one.get('ref', ''))}"
        for tree in parts.values()
        for one in tree.iter()
        if _is(one, "mergeCell")
    )
    faults = []
    for name, cell in _named(raw):
        address = cell.cell.rpartition("!")[2]
        if not _is_stored(cell, address, cells, texts):
            faults.append(f"{name}: {cell.value!r} stands in no cell {address}")
        places = [to for known, to in names if known == name.lower().replace("_", ".")]
        if not any(_points_at(to, address) for to in places) and address not in merged:
            faults.append(f"{name}: no name points to {address}")
    return faults


def _first_corner(reference: str) -> str:
    """Return the cell that a range shows, whichever of its corners are named."""
    corners = _ADDRESS.findall(reference)
    if not corners:
        return ""
    column = min((letters.upper() for letters, _ in corners), key=lambda one: (len(one), one))
    return f"{column}{min(int(row) for _, row in corners)}"


def _named(raw: RawWorkbook) -> Iterator[tuple[str, RawCell]]:
    yield from ((f"answer.{name}", cell) for name, cell in raw.answers.items())
    yield from ((f"given.{name}", cell) for name, cell in raw.givens.items())


def _trees(data: bytes) -> dict[str, ET.Element]:
    trees = {}
    with zipfile.ZipFile(io.BytesIO(data)) as file:
        for name in file.namelist():
            if name.endswith("/"):  # a folder, whatever it holds
                continue
            if name.lower().endswith((".xml", ".rels")) or "sheet" in name.lower():
                try:
                    plain = posixpath.normpath(name.replace("\\", "/")).lower()
                    trees[plain] = ET.fromstring(file.read(name))  # noqa: S314 (read it was)
                except (ET.ParseError, LookupError, ValueError):
                    continue
    return trees


def _cells(parts: dict[str, ET.Element]) -> Iterator[tuple[str, str, Texts]]:
    """Yield every cell of every part: its address in the row, its kind, all its texts."""
    for tree in parts.values():
        for one in tree.iter():
            if _is(one, "c"):
                values = tuple(part.text for part in one if _is(part, "v"))
                inline = tuple(_text(part) for part in one if _is(part, "is"))
                yield one.get("r", ""), one.get("t", "n"), values + inline


def _is_stored(
    cell: RawCell, address: str, cells: list[tuple[str, str, Texts]], texts: list[str]
) -> bool:
    if cell.value is None:
        return True
    return any(
        _same(cell.value, kind, text, texts)
        for where, kind, stored in cells
        if where.replace("$", "").upper() == address or not _ADDRESS.fullmatch(where)
        for text in stored
        if text is not None
    )


def _same(value: object, kind: str, text: str, texts: list[str]) -> bool:
    if isinstance(value, bool):
        return kind == "b" and text.strip() == str(int(value))
    if isinstance(value, int | float):
        return kind == "n" and _number(text, value)
    if isinstance(value, datetime | date | time | timedelta):
        return kind in {"n", "d"}  # what day a number is, is asked elsewhere
    if kind == "s":
        return text.isdecimal() and int(text) < len(texts) and value in texts
    return value in {text, _read_out(text), "#VALUE!"}


def _number(text: str, value: float) -> bool:
    try:
        return (int(text) if isinstance(value, int) else float(text)) == value
    except ValueError:
        return False


def _points_at(reference: str, address: str) -> bool:
    return reference.rpartition("!")[2].partition(":")[0].upper() == address


def _text(item: ET.Element) -> str:
    pieces = [one for one in item if _is(one, "r")]
    plain, shown = _shown(item), [_shown(piece) for piece in pieces]
    struck = [_is_struck(piece) for piece in pieces]
    if all(struck) and not plain:
        return "".join(shown)
    return plain + "".join(
        "".join(f"{sign}\u0336" for sign in text) if is_out else text
        for text, is_out in zip(shown, struck, strict=True)
    )


def _shown(piece: ET.Element) -> str:
    text = _read_out("".join(one.text or "" for one in piece if _is(one, "t")))
    places = [one.get("val") for one in _looks(piece) if _is(one, "vertAlign")][:1]
    signs = {"superscript": _RAISED, "subscript": _LOWERED}.get("".join(filter(None, places)), {})
    return "".join(signs.get(sign, sign) for sign in text)


def _is_struck(piece: ET.Element) -> bool:
    lines = [one.get("val", "1") for one in _looks(piece) if _is(one, "strike")]
    return lines[:1] not in ([], ["0"], ["false"])


def _looks(piece: ET.Element) -> list[ET.Element]:
    return [one for looks in piece if _is(looks, "rPr") for one in looks]


def _read_out(text: str) -> str:
    """Write signs for their numbers, where a part could hold the sign itself."""
    for found in reversed(list(re.finditer(r"_x([0-9A-Fa-f]{4})_", text))):
        sign = chr(int(found[1], 16))
        if sign in "\t\n\r" or " " <= sign < "\ud800" or "\udfff" < sign < "\ufffe":
            text = text[: found.start()] + sign + text[found.end() :]
    return text


def _is(element: ET.Element, name: str) -> bool:
    return isinstance(element.tag, str) and element.tag.rpartition("}")[2] == name
