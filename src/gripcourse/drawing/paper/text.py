"""Letters on a drawing: one font, one line, any content."""

import math
import re
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import combinations, groupby, pairwise
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ezdxf.entities.text import Text
    from ezdxf.fonts.fonts import TrueTypeFont
    from ezdxf.layouts.base import BaseLayout

Point = tuple[float, float]

FONT_FILE = "PTS55F.ttf"
FONT_FAMILY = "PT Sans"
# LibreCAD looks for a font of its own under the name of the style: this one, after GOST 2.304, has
# Cyrillic and Greek letters. Other programs take the file.
TEXT_STYLE = "lc_opengost-br"
CAP_HEIGHT = 0.711  # of the font's size: its letter A, by which text is measured
# For what the first lacks: Greek letters, of the family that documents take them from.
_SECOND_FILE = "LiberationSans-Regular.ttf"
_SECOND_CAP_HEIGHT = 0.688
_NARROWEST = 0.5  # what a line may be squeezed to before it is cut
# Of a width, what a line may fill: letters of LibreCAD, as high as ours, are up to 8 % wider, and a
# cell keeps a little free beside its words.
_FILLED = 0.95
_LEAST_HEIGHT = 1.0  # mm: smaller letters cannot be read

LEADING = 1.45  # from one line to the next, in heights of capital letters
_CLOSE = 1.28  # the same where there is no room for more: four lines of 2.5 mm in 15 mm
_CLEAR = 0.2  # of lines above and below several of them, in these heights
_HEIGHTS = (5.0, 3.5, 2.5)  # mm, of GOST 2.304; its 1.8 is for names that nothing else has room for
_WIDE = 0.85  # of their width and more: nobody sees that letters are squeezed
READ_WELL = 0.75  # of their width: seen, and read as well
WIDE_ENOUGH = 0.55  # of their width: such letters are still read
_PIECES = re.compile(r"[^\s-]*(?:-+|\s+|$)")
_CUT = "…"
_END = "|"


@dataclass(frozen=True, slots=True)
class Setting:
    """How a text is set: its lines, the height of their capital letters, mm, and their width.

    `squeeze` is what the widest line is narrowed by; less than `_NARROWEST` where it is to be cut.
    """

    lines: tuple[str, ...]
    height: float
    squeeze: float


def add_text(  # noqa: PLR0913 (a text is its place, size, direction and layer)
    layout: "BaseLayout",
    text: str,
    at: Point,
    height: float,
    *,
    align: str = "LEFT",
    layer: str = "TEXT",
    rotation: float = 0.0,
    widest: float | None = None,
    squeeze: float | None = None,
) -> "Text":
    r"""Write one line, whatever it contains: nothing of it is taken for a code.

    Args:
        layout: where to.
        text: the words; line breaks and control characters become spaces.
        at: where the line is held, mm.
        height: of capital letters, mm.
        align: where it is held: `LEFT`, `CENTER`, `RIGHT` on the base line, with `MIDDLE_` before
            it half way up the capital letters.
        layer: a `LineKind`.
        rotation: degrees, counter-clockwise.
        widest: mm that the line may take; a longer one is squeezed, and cut where that is not
            enough.
        squeeze: what letters are narrowed by, where that is known already.
    """
    from ezdxf.enums import TextEntityAlignment  # noqa: PLC0415 (0.3 s: only who draws pays for it)

    line, narrowed = fitted(text, height, widest)
    narrowed = narrowed if squeeze is None else squeeze
    entity = layout.add_text(
        dxf_text(line),
        height=height,
        rotation=rotation,
        dxfattribs={"style": TEXT_STYLE, "layer": layer, "width": narrowed},
    )
    entity.set_placement(at, align=TextEntityAlignment[align])
    wide = text_width(line, height) * narrowed
    entity.dxf.insert = _start(at, align, (wide, height), rotation)
    return entity


def _start(at: Point, align: str, size: Point, rotation: float) -> Point:
    """Return where the base line of a text begins: some programs know of no other alignment."""
    across = {"LEFT": 0.0, "CENTER": 0.5, "RIGHT": 1.0}[align.rpartition("_")[2]] * size[0]
    up = size[1] / 2 if align.startswith("MIDDLE_") else 0.0
    turn = math.radians(rotation)
    return (
        at[0] - across * math.cos(turn) + up * math.sin(turn),
        at[1] - across * math.sin(turn) - up * math.cos(turn),
    )


def fitted(text: str, height: float, widest: float | None) -> tuple[str, float]:
    """Return the line that fits into a width, and the factor that its letters are narrowed by."""
    line = one_line(text)
    if widest is None:
        return line, 1.0
    if (squeeze := squeeze_of(line, height, widest)) >= _NARROWEST:
        return line, squeeze
    while line and squeeze_of(line + _CUT, height, widest) < _NARROWEST:
        line = line[:-1]
    return line.rstrip() + _CUT, _NARROWEST


def squeeze_of(line: str, height: float, widest: float) -> float:
    """Return the factor that the letters of a line are narrowed by to fit into a width."""
    room = widest * _FILLED
    return room / max(text_width(line, height), room)


def set_in(
    text: str,
    height: float,
    room: tuple[float, float],
    most: int,
    between: str = " ",
    least: float = 0.0,
) -> Setting:
    """Choose lines and height: as few lines as need no squeezing, else as can be read well.

    Letters are of the standard's heights, and of the smallest of them before they are squeezed: not
    every program draws narrow letters. They become smaller than that only where there is no room
    for more lines, and one would have to be squeezed so that it is hard to read.

    Args:
        text: the words.
        height: of capital letters where there is room enough, mm.
        room: width and height, mm.
        most: lines.
        between: where they may be broken.
        least: height that letters keep however narrow they become, mm; 0 for none.
    """
    heights = [one for one in _HEIGHTS if one <= height] or [height]
    settings = [
        [_set(text, high, room, count, between) for count in _counts(high, room, most)]
        for high in heights
    ]
    smallest = settings[-1]
    tries = [
        *((found, _WIDE) for found in settings),
        (smallest, READ_WELL),
        (smallest, WIDE_ENOUGH),
    ]
    for found, narrowest in tries:
        for one in found:
            if one.squeeze >= narrowest:
                return one
    if least:
        return _kept_high(text, least, room, most)
    tiny = [
        _set(text, high, room, count, between)
        if between.strip()
        else _balanced(text, high, room[0], count)
        for count in range(1, most + 1)
        for high in [min(heights[-1], room[1] / _lines_high(count, _CLOSE))]
    ]
    return max(map(_smaller, tiny), key=lambda one: one.height * one.squeeze)


def _kept_high(text: str, height: float, room: tuple[float, float], most: int) -> Setting:
    """Break a text into as many lines as there is any room for; what is left over is to be cut."""
    counts = [one for one in range(1, most + 1) if height * _lines_high(one, _CLOSE) <= room[1]]
    return max(
        (_balanced(text, height, room[0], count) for count in counts or [1]),
        key=lambda one: one.squeeze,
    )


def _smaller(one: Setting) -> Setting:
    """Return a setting in letters so small that they need not be narrower than can be read."""
    height = max(min(_LEAST_HEIGHT, one.height), one.height * min(1.0, one.squeeze / WIDE_ENOUGH))
    return replace(one, height=height, squeeze=min(1.0, one.squeeze * one.height / height))


def _balanced(text: str, height: float, width: float, count: int) -> Setting:
    """Break a text between words, or behind a hyphen, so that its widest line is the narrowest."""
    pieces = [one for one in _PIECES.findall(one_line(text)) if one]
    places = range(1, len(pieces))
    ways = combinations(places, min(count - 1, len(places)))
    found = [
        tuple("".join(pieces[low:high]).strip() for low, high in pairwise((0, *way, len(pieces))))
        for way in ways
    ]
    return max((_setting(lines, height, width) for lines in found), key=lambda one: one.squeeze)


def _counts(height: float, room: tuple[float, float], most: int) -> list[int]:
    return [one for one in range(1, most + 1) if height * _lines_high(one) <= room[1]]


def _lines_high(count: int, leading: float = LEADING) -> float:
    """Return how high so many lines stand, in heights of capital letters."""
    return leading * count + _CLEAR * (count - 1)


def _set(text: str, height: float, room: tuple[float, float], count: int, between: str) -> Setting:
    lines = tuple(wrapped(text, height, room[0], count, between)) or ("",)
    return _setting(lines, height, room[0])


def _setting(lines: tuple[str, ...], height: float, width: float) -> Setting:
    return Setting(lines, height, min(squeeze_of(one, height, width) for one in lines))


def wrapped(text: str, height: float, widest: float, most: int, between: str = " ") -> list[str]:
    """Break a text between words into at most so many lines; the last one takes what is left.

    Args:
        text: the words.
        height: of capital letters, mm.
        widest: mm that a line may take.
        most: lines.
        between: what stands where a line may end; what of it is no space ends the line.
    """
    lines: list[str] = []
    for word in filter(None, one_line(text).split(between)):
        longer = f"{lines[-1]}{between}{word}" if lines else word
        if lines and (text_width(longer, height) <= widest * _FILLED or len(lines) == most):
            lines[-1] = longer
        else:
            lines[-1:] = [one + between.rstrip() for one in lines[-1:]]
            lines.append(word)
    return lines


@lru_cache(maxsize=4096)
def text_width(text: str, height: float) -> float:
    """Return how wide a line is whose capital letters are `height` high, mm."""
    first, second = _font(FONT_FILE), _font(_SECOND_FILE)
    of_second = height / CAP_HEIGHT * _SECOND_CAP_HEIGHT
    known = _letters(FONT_FILE)
    return sum(
        first.text_width_ex("".join(run), cap_height=height)
        if has_glyphs
        else second.text_width_ex("".join(run), cap_height=of_second)
        for has_glyphs, run in groupby(text, key=lambda letter: ord(letter) in known)
    )


def one_line(text: str) -> str:
    """Return a text without line breaks, control characters and halves of surrogate pairs."""
    clean = "".join(one if one.isprintable() else " " for one in text)
    return " ".join(clean.split())


def capital(text: str) -> str:
    """Return a text that begins with a capital letter."""
    return text[:1].upper() + text[1:]


def dxf_text(line: str) -> str:
    r"""Protect what a DXF TEXT would take for a code: `%%c`, `^I`, `\U+0416`.

    Each sign is written by its own code, so that the reader sees what was typed. (`\P` and braces
    mean something in MTEXT only.)
    """
    protected = line.replace("^", "^ ").replace("%%", "%%%%%%")
    return protected.replace("\\U+", "\\U+005CU+").replace("\\M+", "\\U+005CM+")


def read_text(entity: "Text") -> str:
    r"""Return what a reader sees of a TEXT made by `add_text`.

    Not for one read from a file: there `\U+` has been read already.
    """
    # 0.3 s: only who draws pays for it
    from ezdxf.lldxf.encoding import decode_dxf_unicode  # noqa: PLC0415
    from ezdxf.tools.text import plain_text  # noqa: PLC0415

    # The library takes a caret at the very end for half a code and drops it.
    return decode_dxf_unicode(plain_text(entity.dxf.text + _END).removesuffix(_END))


@lru_cache(maxsize=2)
def _font(file: str) -> "TrueTypeFont":
    # 0.3 s: only who draws pays for it
    from ezdxf.fonts import fonts  # noqa: PLC0415

    # What the library remembers of this machine may be older than a font; it would take another.
    if not fonts.font_manager.has_font(file):
        fonts.build_system_font_cache()
    return fonts.TrueTypeFont(file, 1.0)


@lru_cache(maxsize=1)
def _letters(file: str) -> frozenset[int]:
    """Return the codes of the letters that a font has."""
    # 0.3 s: only who draws pays for it
    from ezdxf.fonts.fonts import font_manager  # noqa: PLC0415

    return frozenset(font_manager.get_ttf_font(file).getBestCmap())
