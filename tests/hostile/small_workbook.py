"""A small answer workbook as XML, and ways to spoil it.

Written out by hand, so that a test sees what it spoils and thousands of copies cost little.
"""

import dataclasses
import io
import zipfile
from collections.abc import Callable, Mapping
from typing import Final

from gripcourse.course.quantity import Kind, Quantity
from gripcourse.text.words import Texts

_MAIN = b"http://schemas.openxmlformats.org/spreadsheetml/2006/main"
_RELATED = b"http://schemas.openxmlformats.org/officeDocument/2006/relationships"
_PACKAGE = b"http://schemas.openxmlformats.org/package/2006"
_HEAD = b'<?xml version="1.0" encoding="UTF-8" standalone="yes"?>\n'

WORKBOOK: Final = "xl/workbook.xml"
RELATIONS: Final = "xl/_rels/workbook.xml.rels"
SHEET: Final = "xl/worksheets/sheet1.xml"
HIDDEN: Final = "xl/worksheets/sheet2.xml"
TEXTS: Final = "xl/sharedStrings.xml"
STYLES: Final = "xl/styles.xml"
PROPERTIES: Final = "docProps/custom.xml"

ANSWERS: Final = {
    "force": ("E5", "N", Kind.FORMULA),
    "bore": ("E6", "mm", Kind.CHOICE),
    "ratio": ("E7", "", Kind.FORMULA),
    "holds": ("E8", "", Kind.VERDICT),
    "angle": ("E9", "deg", Kind.FORMULA),
    "loss": ("E10", "%", Kind.FORMULA),
    "pressure": ("E11", "MPa", Kind.FORMULA),
    "stroke": ("E12", "mm", Kind.FORMULA),
    "width": ("E13", "mm", Kind.PICK),
}
"""Where each answer stands, its unit and its kind."""

_CELLS: Final = {
    5: '<c r="E5" s="1"><v>22941.5</v></c>',
    6: '<c r="E6" t="s"><v>1</v></c>',
    7: '<c r="E7"><f>E5/1000</f><v>22.9415</v></c>',
    8: '<c r="E8" t="s"><v>2</v></c>',
    9: '<c r="E9" s="2"><v>45000</v></c>',
    10: '<c r="E10" s="3"><v>0.055</v></c>',
    11: '<c r="E11" t="inlineStr"><is><t>1,5 МПа</t></is></c>',
    12: '<c r="E12"/>',
    13: '<c r="E13"><v>40</v></c>',
}


def _sheet() -> bytes:
    rows = "".join(
        f'<row r="{row}"><c r="C{row}" t="s"><v>0</v></c>{cell}</row>'
        for row, cell in _CELLS.items()
    )
    text = (
        f'<worksheet xmlns="{_MAIN.decode()}"><dimension ref="A1:F13"/><sheetData>{rows}'
        '</sheetData><mergeCells count="1"><mergeCell ref="E13:F13"/></mergeCells></worksheet>'
    )
    return _HEAD + text.encode()


def _names() -> bytes:
    answers = "".join(
        f"<definedName name=\"answer.{name}\">'1. Расчёт'!$E${place[1:]}</definedName>"
        for name, (place, _, _) in ANSWERS.items()
    )
    others = (
        "<definedName name=\"given.mass\">'1. Расчёт'!$E$13</definedName>"
        '<definedName name="meta.student">_gripcourse!$B$1</definedName>'
        '<definedName name="meta.variant">_gripcourse!$B$2</definedName>'
    )
    return (answers + others).encode()


PARTS: Final[Mapping[str, bytes]] = {
    "[Content_Types].xml": _HEAD + b'<Types xmlns="%s/content-types"/>' % _PACKAGE,
    "_rels/.rels": _HEAD + b'<Relationships xmlns="%s/relationships">'
    b'<Relationship Id="r1" Type="%s/officeDocument" Target="xl/workbook.xml"/>'
    b'<Relationship Id="r2" Type="%s/custom-properties" Target="docProps/custom.xml"/>'
    b'<Relationship Id="r3" Type="%s/metadata/core-properties" Target="docProps/core.xml"/>'
    b"</Relationships>" % (_PACKAGE, _RELATED, _RELATED, _PACKAGE),
    WORKBOOK: _HEAD + b'<workbook xmlns="%s" xmlns:r="%s"><workbookPr/><sheets>'
    b'<sheet name="1. %s" sheetId="1" r:id="r1"/>'
    b'<sheet name="_gripcourse" sheetId="2" state="hidden" r:id="r2"/></sheets>'
    b"<definedNames>%s</definedNames></workbook>" % (_MAIN, _RELATED, "Расчёт".encode(), _names()),
    RELATIONS: _HEAD + b'<Relationships xmlns="%s/relationships">'
    b'<Relationship Id="r1" Type="%s/worksheet" Target="worksheets/sheet1.xml"/>'
    b'<Relationship Id="r2" Type="%s/worksheet" Target="worksheets/sheet2.xml"/>'
    b'<Relationship Id="r3" Type="%s/sharedStrings" Target="sharedStrings.xml"/>'
    b'<Relationship Id="r4" Type="%s/styles" Target="styles.xml"/></Relationships>'
    % (_PACKAGE, _RELATED, _RELATED, _RELATED, _RELATED),
    SHEET: _sheet(),
    HIDDEN: _HEAD + b'<worksheet xmlns="%s"><sheetData>'
    b'<row r="1"><c r="B1" t="s"><v>3</v></c></row><row r="2"><c r="B2"><v>7</v></c></row>'
    b"</sheetData></worksheet>" % _MAIN,
    TEXTS: _HEAD
    + f'<sst xmlns="{_MAIN.decode()}"><si><t>Величина</t></si><si><r><t>63</t></r><r><t> мм</t></r>'
    "</si><si><t>да</t></si><si><t>s001</t></si></sst>".encode(),
    STYLES: _HEAD + b'<styleSheet xmlns="%s"><numFmts count="1">'
    b'<numFmt numFmtId="164" formatCode="0.0"/></numFmts><cellXfs count="4">'
    b'<xf numFmtId="0"/><xf numFmtId="164"/><xf numFmtId="14"/><xf numFmtId="10"/>'
    b"</cellXfs></styleSheet>" % _MAIN,
    PROPERTIES: _HEAD + b'<Properties><property name="gripcourse.student"><x>s001</x></property>'
    b"</Properties>",
    "docProps/core.xml": _HEAD + b"<coreProperties><creator>gripcourse</creator></coreProperties>",
}
"""The members of a sound workbook."""


def quantities() -> tuple[Quantity, ...]:
    """Return declarations of the answers."""
    nothing = dict.fromkeys(one.name for one in dataclasses.fields(Quantity) if one.init)
    return tuple(
        Quantity(
            **nothing  # type: ignore[arg-type]
            | {
                "id": name,
                "kind": kind,
                "unit": unit,
                "title": Texts(dict.fromkeys(("en", "ru", "uk"), "Величина")),
                "bounds": (0.0, 1e6),
                "slips": (),
                "as_printed": (),
                "alternatives": (),
            }
        )
        for name, (_, unit, kind) in ANSWERS.items()
    )


def archive(parts: Mapping[str, bytes], method: int = zipfile.ZIP_DEFLATED) -> bytes:
    """Pack members."""
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", method) as target:
        for name, data in parts.items():
            target.writestr(zipfile.ZipInfo(name), data, method)
    return stream.getvalue()


def patched(part: str, change: Callable[[bytes], bytes]) -> bytes:
    """Return the workbook with one member rewritten; a change that changes nothing is a fault."""
    after = change(PARTS[part])
    assert after != PARTS[part]
    return archive({**PARTS, part: after})


def replaced(part: str, old: bytes | str, new: bytes | str) -> bytes:
    """Return the workbook with a piece of one member replaced, wherever it stands."""
    before, after = (one.encode() if isinstance(one, str) else one for one in (old, new))
    return patched(part, lambda data: data.replace(before, after))


def with_members(**members: bytes) -> bytes:
    """Return the workbook with further members; `__` in a keyword is a slash, `_` a full stop."""
    named = {name.replace("__", "/").replace("_", "."): data for name, data in members.items()}
    return archive({**PARTS, **named})


def after_cells(addition: bytes | str) -> bytes:
    """Return the workbook with something behind the cells of its sheet."""
    added = addition.encode() if isinstance(addition, str) else addition
    return replaced(SHEET, b"</sheetData>", b"</sheetData>" + added)


def in_rows(addition: bytes | str) -> bytes:
    """Return the workbook with something behind its last row."""
    added = addition.encode() if isinstance(addition, str) else addition
    return replaced(SHEET, b"</sheetData>", added + b"</sheetData>")


def holding(cell: bytes | str) -> bytes:
    """Return the workbook with another first answer cell."""
    return replaced(SHEET, _CELLS[5], cell)


def stored(value: bytes | str, kind: str = "n") -> bytes:
    """Return the workbook whose first answer cell stores this."""
    text = value.encode() if isinstance(value, str) else value
    return holding(b'<c r="E5" t="%s"><v>%s</v></c>' % (kind.encode(), text))
