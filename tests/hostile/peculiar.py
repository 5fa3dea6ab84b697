"""Random peculiarities of other programs and of people, one upon the other, in a sound workbook."""

import random
import re
import struct
from collections.abc import Callable
from typing import Final, TypeAlias

from hostile.small_workbook import RELATIONS, SHEET, TEXTS, WORKBOOK

Parts: TypeAlias = dict[str, bytes]
Change: TypeAlias = Callable[[random.Random, Parts], None]

_CELL: Final = re.compile(rb'<c r="E\d+"[^>]*?(?:/>|>.*?</c>)')
_NAME: Final = re.compile(rb"<definedName [^>]*>[^<]*</definedName>")
_TEXT: Final = re.compile(rb"<si>.*?</si>")
_ROW: Final = re.compile(rb"<row .*?</row>")
_LOOKS: Final = (
    *(b'<vertAlign val="superscript"/>', b'<vertAlign val="subscript"/>', b"<strike/>"),
    *(b'<vertAlign val="x"/>', b"<b/><vertAlign/>", b""),
)
_TYPED: Final = (
    "10",
    "6",
    "-3",
    "0",
    "o",
    "о",
    " мм",
    "2,3·10",
    "⁴",
    "½",
    "1e",
    "_x0031_",
    "−",
    "",
)
_FORMULAS: Final = (
    *(b'<f t="shared" ref="E5:E9" si="0">A1</f>', b'<f t="shared" si="0"/>', b'<f t="x"/>'),
    *(b'<f t="array" ref="E5:E13">A1*2</f>', b'<f t="dataTable" ref="E5" r1="A1"/>', b"<f/>"),
    *(b"<f>_xlfn.LET(_xlpm.a,1,_xlpm.a)</f>", b"<f>_xlfn.ANCHORARRAY(E5)</f>", b"<f>[1]x!A1</f>"),
)
_PLACES: Final = (
    *("$E$5", "$E$5:$E$6", "$E$5,$E$6", "E5", "$E5", "R5C5", "$E$5#", "XFE1", "@$E$5"),
    *("OFFSET($E$5,0,0)", "_xlfn.LAMBDA(_xlpm.x,1)", "Table1[[#This Row],[x]]", "$E$5 $5:$5"),
)
_SHEETS: Final = ("'1. Расчёт'!", "'1. Расчёт:_gripcourse'!", "[1]'1. Расчёт'!", "_gripcourse!", "")


def _replaced(draw: random.Random, parts: Parts, name: str, pattern: re.Pattern[bytes]) -> None:
    """Put one of what a pattern finds in place of another one."""
    data = parts.get(name, b"")
    found = list(pattern.finditer(data))
    if found:
        one, other = draw.choice(found), draw.choice(found)
        parts[name] = data[: one.start()] + other[0] + data[one.end() :]


def _pieces(draw: random.Random) -> bytes:
    pieces = (
        b'<r><rPr>%s</rPr><t xml:space="preserve">%s</t></r>'
        % (draw.choice(_LOOKS), draw.choice(_TYPED).encode())
        for _ in range(draw.choice((1, 2, 2, 3)))
    )
    return b"".join(pieces) + draw.choice((b"", b'<rPh sb="0" eb="1"><t>9</t></rPh>'))


def _put(draw: random.Random, parts: Parts, cell: bytes) -> None:
    """Put a cell in place of an answer; its address is that of the answer."""
    data = parts.get(SHEET, b"")
    found = list(_CELL.finditer(data))
    if found:
        one = draw.choice(found)
        address = one[0].split(b'"')[1]
        parts[SHEET] = data[: one.start()] + cell.replace(b"@", address) + data[one.end() :]


def _text_of_many_looks(draw: random.Random, parts: Parts) -> None:
    if draw.random() < 0.5:
        _put(draw, parts, b'<c r="@" t="inlineStr"><is>%s</is></c>' % _pieces(draw))
    else:
        data = parts.get(TEXTS, b"")
        found = list(_TEXT.finditer(data))
        if found:
            one = draw.choice(found)
            item = b"<si>%s</si>" % _pieces(draw)
            parts[TEXTS] = data[: one.start()] + item + data[one.end() :]


def _formula(draw: random.Random, parts: Parts) -> None:
    value = draw.choice((b"<v>22941.5</v>", b"<v/>", b"", b"<v>#N/A</v>", b"<v>1,5</v>"))
    looks = draw.choice((b"", b' t="str"', b' t="e"', b' cm="1"', b' vm="1" t="e"', b' t="b"'))
    _put(draw, parts, b'<c r="@"%s>%s%s</c>' % (looks, draw.choice(_FORMULAS), value))


def _moved_cells(draw: random.Random, parts: Parts) -> None:
    _replaced(draw, parts, SHEET, draw.choice((_CELL, _ROW)))


def _name_elsewhere(draw: random.Random, parts: Parts) -> None:
    data = parts.get(WORKBOOK, b"")
    found = list(_NAME.finditer(data))
    if not found:
        return
    one = draw.choice(found)
    name = one[0].split(b'"')[1]
    name = draw.choice((name, name.upper(), name.replace(b".", b"_"), b"given.mass"))
    scope = draw.choice((b"", b' localSheetId="0"', b' localSheetId="1"', b' hidden="1"'))
    where = (draw.choice(_SHEETS) + draw.choice(_PLACES)).encode()
    made = b'<definedName name="%s"%s>%s</definedName>' % (name, scope, where)
    end = draw.choice((one.end(), one.start()))
    parts[WORKBOOK] = data[: one.start()] + made + data[end:]


def _copied_sheet(draw: random.Random, parts: Parts) -> None:
    """Copy the sheet with some of its answers, and give the copy names of its own."""
    part = "xl/worksheets/sheet9.xml"
    parts[part] = parts.get(SHEET, b"")
    number = b"7" * draw.randrange(1, 5)
    parts[part] = re.sub(rb"<v>22941.5</v>", b"<v>%s</v>" % number, parts[part])
    related = b'<Relationship Id="r9" Type="x/worksheet" Target="worksheets/sheet9.xml"/>'
    end = b"</Relationships>"
    parts[RELATIONS] = parts.get(RELATIONS, b"").replace(end, related + end)
    sheet = '<sheet name="1. Расчёт (2)" sheetId="9" r:id="r9"/></sheets>'.encode()
    names = "".join(
        f'<definedName name="answer.{name}" localSheetId="2">\'1. Расчёт (2)\'!$E${row}'
        "</definedName>"
        for name, row in (("force", 5), ("stroke", draw.choice((5, 12, 13))))
    )
    data = parts.get(WORKBOOK, b"").replace(b"</sheets>", sheet)
    parts[WORKBOOK] = data.replace(b"<definedNames>", b"<definedNames>" + names.encode())
    if draw.random() < 0.6:
        blank = parts.get(SHEET, b"").replace(b"<v>22941.5</v>", b"")
        parts[SHEET] = blank


def _for_newer_programs(draw: random.Random, parts: Parts) -> None:
    name = draw.choice((SHEET, WORKBOOK, TEXTS))
    data = parts.get(name, b"")
    found = list(re.finditer(rb"<(c|definedName|si|row|sheet)\b", data))
    if not found:
        return
    place = draw.choice(found).start()
    inner = draw.choice((_CELL, _NAME, _TEXT, _ROW)).search(data)
    choice = b'<mc:Choice Requires="x">%s</mc:Choice>' % (b"" if inner is None else inner[0])
    both = b'<mc:AlternateContent xmlns:mc="m">%s</mc:AlternateContent>' % choice
    parts[name] = data[:place] + both + data[place:]


def _prefix(draw: random.Random, parts: Parts) -> None:
    name = draw.choice((SHEET, WORKBOOK, TEXTS))
    data = parts.get(name, b"")
    head, _, body = data.partition(b"?>\n")
    body = body.replace(b"</", b"\0").replace(b"<", b"<x:").replace(b"\0", b"</x:")
    declared = draw.choice((b"xmlns:x=", b"xmlns:y=", b"xmlns="))
    parts[name] = head + b"?>\n" + body.replace(b"xmlns=", declared, 1)


def _written_otherwise(draw: random.Random, parts: Parts) -> None:
    """Write some signs of a part by their numbers, in pieces, or with what says nothing."""
    name = draw.choice((SHEET, WORKBOOK, TEXTS))
    data = parts.get(name, b"")
    found = list(re.finditer(rb">([^<>&]+)<", data))
    if found:
        one = draw.choice(found)
        text = one[1].decode("utf-8", "replace")
        wide = "".join(draw.choice((sign, f"&#{ord(sign)};")) for sign in text)
        half = len(text) // 2
        put = draw.choice((wide, f"<![CDATA[{text}]]>", f"{text[:half]}<!-- -->{text[half:]}",
                           f" \n{text}\t", f"{text}\u200b", f"\ufeff{text}"))  # fmt: skip
        parts[name] = data[: one.start(1)] + put.encode() + data[one.end(1) :]


def _other_letters(draw: random.Random, parts: Parts) -> None:
    name = draw.choice((SHEET, WORKBOOK, TEXTS, RELATIONS))
    encoding = draw.choice(("utf-32", "utf-32-le", "utf-7", "cp037", "utf-16-be", "koi8-r", "gbk"))
    text = parts.get(name, b"").decode("utf-8", "replace")
    said = draw.choice((encoding, "UTF-8"))
    parts[name] = text.replace("UTF-8", said).encode(encoding, "replace")


def _members_besides(draw: random.Random, parts: Parts) -> None:
    name = draw.choice((SHEET, WORKBOOK, TEXTS))
    other = draw.choice(
        (
            f"__MACOSX/{name}",
            f"./{name}",
            name.replace("/", "//"),
            f"answers/{name}",
            f"{name}/",
            f"{name} ",
            name.title(),
            f"xl/../{name}",
            f"%78{name[1:]}",
        )
    )
    parts[other] = parts.get(name, b"").replace(b"22941.5", b"777").replace("да".encode(), b"no")


CHANGES: Final[tuple[Change, ...]] = (
    *(_text_of_many_looks, _formula, _moved_cells, _name_elsewhere, _copied_sheet, _prefix),
    *(_for_newer_programs, _written_otherwise, _other_letters, _members_besides),
)


def repacked(draw: random.Random, data: bytes) -> bytes:
    """Change what the directory of an archive says, as few packers do."""
    entries = [one.start() for one in re.finditer(rb"PK\x01\x02", data)]
    end = data.rfind(b"PK\x05\x06")
    if not entries or end < 0:
        return data
    place = draw.choice(entries)
    made = bytearray(data)
    match draw.randrange(5):
        case 0:
            made[place + 8 : place + 10] = draw.choice((b"\x08\0", b"\0\x08", b"\x01\0", b"\x40\0"))
        case 1:
            size = draw.choice((0, 1, 0xFFFFFFFE, 0xFFFFFFFF, 9_000_000))
            field = place + draw.choice((20, 24))
            made[field : field + 4] = struct.pack("<I", size)
        case 2:
            other = draw.choice(entries)
            made[place + 42 : place + 46] = made[other + 42 : other + 46]
        case 3:
            record = struct.pack("<4sIQI", b"PK\6\7", 0, draw.choice((0, end, 2**63)), 1)
            made[end:end] = record
        case _:
            field = end + draw.choice((4, 8, 10, 12, 16))
            made[field : field + 2] = draw.choice((b"\xff\xff", b"\0\0", b"\1\0"))
    return bytes(made)
