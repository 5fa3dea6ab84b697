"""Random changes of a sound workbook: bytes, members, XML, names, cells, styles, texts.

Every change is drawn from one generator, so that a number tells the whole file.
"""

import random
import re
import zipfile
from collections.abc import Callable
from typing import Final, TypeAlias

from hostile import peculiar
from hostile.small_workbook import (
    HIDDEN,
    PARTS,
    PROPERTIES,
    RELATIONS,
    SHEET,
    STYLES,
    TEXTS,
    WORKBOOK,
    archive,
)

Parts: TypeAlias = dict[str, bytes]
Line: TypeAlias = tuple[int, ...]
"""The numbers from which the changes of a workbook are drawn, in their order."""
Change: TypeAlias = Callable[[random.Random, Parts], None]

_TAG: Final = re.compile(rb"<[^<>]+>")
_ELEMENT: Final = re.compile(rb"<(\w+)\b[^<>]*?(?:/>|>[^<>]*</\1>)")
_VALUE: Final = re.compile(rb'"([^"]*)"')
_CONTENT: Final = re.compile(rb">([^<>]+)<")
_ATTRIBUTE: Final = re.compile(rb' [\w:]+="[^"]*"')
_ROOT: Final = re.compile(rb"<\w+ ")
_PLAIN: Final = (SHEET, WORKBOOK, TEXTS, STYLES, HIDDEN, RELATIONS, PROPERTIES, "_rels/.rels")

_NUMBERS: Final = (
    "0 -0 1 -1 2 4 9 255 65536 1048576 1048577 2147483648 9999999999 1e308 1e309 -1e309 1e-400 "
    ".5 5. 1e 0x10 1_0 NaN INF -inf 1,5 1.5.5 ١٢ ² +5 --5 true TRUE "
)
_REFERENCES: Final = (
    "A1 $E$5 E5 $E$6 XFD1048576 XFE1 A0 A1048577 $E$5:$E$9 $E:$E $5:$5 #REF! a!$E$5 "
    "'1.␣Расчёт'!$E$6 '1.␣Расчёт'!$A$1 _gripcourse!$B$1 '''!$E$5 [1]x!$E$5"
)
_WORDS: Final = (
    "n s b e d str inlineStr General @ 0.00% [h]:mm:ss yyyy dd/mm/yy 0,, 0.0\\␣кН [[[ "
    "[$-419]d\\␣mmmm UTF-16 utf-8 true zip cp1251 ../../x xl/workbook.xml http://localhost "
    "sheetData row c v f is t r si definedName answer.force meta.student given.mass "
    "=1+1 5␣мм^99999999999999999 1e99999 60,08 1␣234,5 да нет #DIV/0! 12.03.2026 5.май ½ 10³ "
    "&#0; &#xD83D; &lt; &x; ]]> <![CDATA[1]]> <!--x--> <?x?>"
)
_BYTES: Final = (b"", b" ", b"\0", b"\xff\xfe", b"9" * 400, b"1" * 5000, b"[" * 300)
_PIECES: Final = (
    *(word.replace("␣", " ").encode() for word in f"{_NUMBERS} {_REFERENCES} {_WORDS}".split()),
    *_BYTES,
)


PECULIAR: Final = 10**8
"""From this number on it is peculiarities that are drawn; what lower ones mean stays as it is."""


def mutated(seed: int) -> bytes:
    """Return a workbook with one to four random changes."""
    draw = random.Random(seed)  # noqa: S311 (nothing secret)
    parts = dict(PARTS)
    changes = CHANGES if seed < PECULIAR else (*peculiar.CHANGES, *peculiar.CHANGES, *CHANGES)
    for _ in range(draw.choice((1, 1, 2, 4))):
        draw.choice(changes)(draw, parts)
    data = archive(parts, draw.choice((zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)))
    if seed >= PECULIAR and draw.random() < 0.2:
        data = peculiar.repacked(draw, data)
    return _spoiled(draw, data) if draw.random() < 0.15 else data


def descended(line: Line) -> bytes:
    """Return a workbook with a change for each number; the last one tells how it is packed, too."""
    parts = dict(PARTS)
    for number in line:
        draw = random.Random(number)  # noqa: S311 (nothing secret)
        draw.choice(CHANGES)(draw, parts)
    draw = random.Random(-line[-1])  # noqa: S311 (as above)
    data = archive(parts, draw.choice((zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)))
    return _spoiled(draw, data) if draw.random() < 0.05 else data


def _spoiled(draw: random.Random, data: bytes) -> bytes:
    """Change bytes of the archive itself; its directory as often as its members."""
    directory = max(data.rfind(b"PK\x01\x02", 0, draw.randrange(1, len(data))), 0)
    start = draw.choice((0, directory))
    place = min(start + draw.randrange(60), len(data) - 1)
    place = draw.choice((place, draw.randrange(len(data))))
    length = draw.choice((0, 1, 1, 2, 4, 40))
    put = draw.choice((b"", draw.randbytes(length), bytes(length), b"\xff" * length))
    return data[:place] + put + data[place + length :]


def _bytes(draw: random.Random, parts: Parts) -> None:
    name = draw.choice(list(parts))
    data = parts[name]
    if data:
        place, length = draw.randrange(len(data)), draw.choice((0, 1, 1, 3, 30))
        put = draw.choice((b"", draw.randbytes(length), draw.choice(_PIECES)))
        parts[name] = data[:place] + put + data[place + length :]


def _members(draw: random.Random, parts: Parts) -> None:
    one, other = draw.choice(list(parts)), draw.choice(list(parts))
    match draw.randrange(5):
        case 0:
            del parts[one]
            parts.setdefault("xl/empty.xml", b"")
        case 1:
            parts[one], parts[other] = parts[other], parts[one]
        case 2:
            parts[draw.choice((one.upper(), one.replace("/", "\\"), "x/" + one))] = parts.pop(one)
        case 3:
            parts[other.upper()] = parts[one]
        case 4:
            parts[one] = parts[one] * 2


def _found(draw: random.Random, pattern: re.Pattern[bytes], data: bytes) -> re.Match[bytes] | None:
    found = list(pattern.finditer(data))
    return draw.choice(found) if found else None


def _within(pattern: re.Pattern[bytes], names: tuple[str, ...] = _PLAIN) -> Change:
    """Return a change that replaces what a pattern finds in one of some members."""

    def change(draw: random.Random, parts: Parts) -> None:
        name = draw.choice(names)
        data = parts.get(name, b"")
        found, other = _found(draw, pattern, data), _found(draw, pattern, data)
        if found is not None and other is not None:
            group = min(1, found.re.groups) if pattern is not _ELEMENT else 0
            put = draw.choice((draw.choice(_PIECES), draw.choice(_PIECES), other[group], b""))
            parts[name] = data[: found.start(group)] + put + data[found.end(group) :]

    return change


def _twice(draw: random.Random, parts: Parts) -> None:
    name = draw.choice(_PLAIN)
    data = parts.get(name, b"")
    found = _found(draw, _ELEMENT, data)
    if found is not None:
        times = draw.choice((1, 1, 2, 50))
        parts[name] = data[: found.end()] + found[0] * times + data[found.end() :]


def _inside(draw: random.Random, parts: Parts) -> None:
    name = draw.choice(_PLAIN)
    data = parts.get(name, b"")
    found, place = _found(draw, _ELEMENT, data), _found(draw, _TAG, data)
    if found is not None and place is not None:
        parts[name] = data[: place.end()] + found[0] + data[place.end() :]


def _encoding(draw: random.Random, parts: Parts) -> None:
    name = draw.choice(_PLAIN)
    text = parts.get(name, b"").decode("utf-8", "replace")
    encoding = draw.choice(("utf-16", "utf-16-le", "cp1251", "utf-8-sig", "utf-7", "utf-32"))
    declared = text.replace("UTF-8", draw.choice((encoding, "UTF-8", "x")))
    parts[name] = declared.encode(encoding, "replace")


CHANGES: Final[tuple[Change, ...]] = (
    _bytes,
    _members,
    _within(_TAG),
    _within(_VALUE),
    _within(_CONTENT),
    _within(_ATTRIBUTE),
    _within(_ELEMENT),
    _within(_ROOT),
    _within(_VALUE, (SHEET,)),
    _within(_CONTENT, (SHEET,)),
    _within(_ATTRIBUTE, (SHEET,)),
    _within(_CONTENT, (TEXTS,)),
    _within(_CONTENT, (WORKBOOK,)),
    _within(_VALUE, (STYLES,)),
    _twice,
    _inside,
    _encoding,
)
