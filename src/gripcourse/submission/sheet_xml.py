"""What a spreadsheet reader that returns values does not tell: formulas, and numbers that are none.

The parts are read as XML only after the cheap checks of `preflight` have let them pass.
"""

import io
import posixpath
import re
import zipfile
from collections.abc import Iterator, Mapping
from typing import Final, TypeAlias
from xml.etree.ElementTree import Element, fromstring, tostring

Place: TypeAlias = tuple[str, str]
"""Title of a sheet and address of a cell."""

_WORKBOOK: Final = "xl/workbook.xml"
_RELATIONS: Final = "xl/_rels/workbook.xml.rels"
_NUMBER: Final = re.compile(r"\s*[+-]?(\d{1,4000}(\.\d*)?|\.\d+)([eE][+-]?\d{1,9})?\s*", re.ASCII)


def formulas(data: bytes) -> Mapping[Place, str]:
    """Return the formula of every cell that has one, beginning with `=`.

    Args:
        data: a workbook that passed the checks.

    Returns:
        By sheet and address; nothing where the parts are not where the format wants them.
    """
    found: dict[Place, str] = {}
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        for title, part in _sheets(archive):
            for cell in _cells(fromstring(archive.read(part))):  # noqa: S314 (checked)
                formula = _child(cell, "f")
                if formula is not None:
                    found[title, cell.get("r", "")] = f"={formula.text or '…'}"
    return found


def with_false_numbers_as_text(data: bytes) -> bytes:
    """Return a workbook in which every cell whose number is no number holds it as text.

    One such cell would make the reader refuse the whole workbook.
    """
    with zipfile.ZipFile(io.BytesIO(data)) as source:
        mended = {part: _mended(source.read(part)) for _, part in _sheets(source)}
        stream = io.BytesIO()
        with zipfile.ZipFile(stream, "w") as target:
            for name in dict.fromkeys(source.namelist()):
                target.writestr(name, mended.get(name) or source.read(name))
    return stream.getvalue()


def _mended(part: bytes) -> bytes | None:
    """Return a sheet without false numbers; None where it has none."""
    root = fromstring(part)  # noqa: S314 (checked for entities and depth)
    false = [cell for cell in _cells(root) if _is_false(cell)]
    for cell in false:
        cell.set("t", "str")
    return tostring(root, encoding="utf-8") if false else None


def _is_false(cell: Element) -> bool:
    value = _child(cell, "v")
    text = "" if value is None else value.text or ""
    return cell.get("t", "n") == "n" and text != "" and _NUMBER.fullmatch(text) is None


def _sheets(archive: zipfile.ZipFile) -> Iterator[tuple[str, str]]:
    """Find the part of every sheet by its title."""
    names = set(archive.namelist())
    if not {_WORKBOOK, _RELATIONS} <= names:
        return
    relations = fromstring(archive.read(_RELATIONS))  # noqa: S314 (checked)
    targets = {one.get("Id"): one.get("Target", "") for one in relations}
    for sheet in fromstring(archive.read(_WORKBOOK)).iter():  # noqa: S314 (checked)
        if _local(sheet.tag) == "sheet":
            key = next((value for name, value in sheet.items() if name.endswith("}id")), None)
            part = posixpath.normpath(posixpath.join("/xl", targets.get(key, ""))).lstrip("/")
            if part in names:
                yield sheet.get("name", ""), part


def _cells(root: Element) -> Iterator[Element]:
    return (element for element in root.iter() if _local(element.tag) == "c")


def _child(cell: Element, name: str) -> Element | None:
    return next((child for child in cell if _local(child.tag) == name), None)


def _local(tag: object) -> str:
    """Return a tag without its namespace; a strict and a usual workbook differ in theirs."""
    return tag.rpartition("}")[2] if isinstance(tag, str) else ""
