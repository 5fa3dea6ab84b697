"""Lines and cells of the tables on a sheet. Lengths in mm."""

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

from gripcourse.drawing.paper.document import LineKind
from gripcourse.drawing.paper.strokes import Box
from gripcourse.drawing.paper.text import (
    LEADING,
    Point,
    Setting,
    add_text,
    set_in,
    squeeze_of,
    text_width,
)

if TYPE_CHECKING:
    from ezdxf.layouts.layout import Modelspace

PAD = 1.0  # free beside the words of a cell
SMALL, NORMAL, LARGE = 2.5, 3.5, 5.0  # heights of letters
# A letter stands by itself before its subscript: where a program draws signs closer together than
# they are wide, as some do `7,`, it stays beside what stands under it.
_SUBSCRIPT = re.compile(r"([^\s_]+)_(\w+)")
_SIZE = re.compile(r".+?(?:;\s+|$)")
_RUNS = 3  # before the letter, the letter, what stands under it
_RAISED = 0.1  # of their height, several lines in a cell: letters reach below the last one
_OFF_LINES = 0.3  # mm that is free between letters and the lines of a cell
_SMALLER, _DROP = 0.7, 0.4  # a subscript, in heights of the letters that it stands beside


@dataclass(frozen=True, slots=True)
class Pen:
    """Draws lines."""

    layout: "Modelspace"

    def line(self, start: Point, end: Point, kind: LineKind = LineKind.OUTLINE) -> None:
        """Draw a straight line."""
        self.layout.add_line(start, end, dxfattribs={"layer": kind})

    def box(self, box: Box, kind: LineKind) -> None:
        """Draw a rectangle."""
        self.layout.add_lwpolyline(box.corners, close=True, dxfattribs={"layer": kind})


@dataclass(frozen=True, slots=True)
class Cells:
    """A table whose lower left corner lies at `left`, `bottom`."""

    pen: Pen
    left: float
    bottom: float

    def line(self, start: Point, end: Point, kind: LineKind = LineKind.OUTLINE) -> None:
        """Draw a line inside the table."""
        self.pen.line(self._place(start), self._place(end), kind)

    def words(  # noqa: PLR0913 (words are their place, size and letters)
        self,
        text: str,
        corner: Point,
        size: Point,
        height: float,
        *,
        middle: bool = False,
        most: int = 1,
        least: float = 0.0,
    ) -> None:
        """Write into a cell in so many lines at most, squeezed or smaller to fit.

        Letters that are high enough at `least` mm become no smaller than that: what such a cell
        cannot hold is cut.
        """
        found = set_in(text, height, (size[0] - 2 * PAD, size[1]), most, least=least)
        self.lines(found, corner, size, middle=middle)

    def lines(self, found: Setting, corner: Point, size: Point, *, middle: bool = False) -> None:
        """Write lines into a cell that are set already, each of them narrowed by itself."""
        x = corner[0] + (size[0] / 2 if middle else PAD)
        pitch = _pitch(found, size[1])
        further = len(found.lines) - 1
        top = corner[1] + size[1] / 2 + pitch / 2 * further
        top += _RAISED * found.height * min(further, 1)
        for number, line in enumerate(found.lines):
            add_text(
                self.pen.layout,
                line,
                self._place((x, top - pitch * number)),
                found.height,
                align="MIDDLE_CENTER" if middle else "MIDDLE_LEFT",
                widest=size[0] - 2 * PAD,
            )

    def symbols(self, text: str, corner: Point, size: Point, height: float, most: int) -> None:
        """Write sizes into a cell from its left side, a subscript behind `_`: `d_ш = 5; b = 3`."""
        room = (size[0] - 2 * PAD, size[1])
        found = set_in(text.replace("_", ""), height, room, most, between="; ")
        pitch = _pitch(found, size[1])
        raised = (pitch / 2 + _RAISED * found.height) * (len(found.lines) - 1)
        level = corner[1] + size[1] / 2 + raised
        written = iter(text.split())
        for line in found.lines:
            marked = " ".join(next(written) for _ in line.split())
            self._symbols(marked, (corner[0] + PAD, level), found.height, room[0])
            level -= pitch

    def _symbols(self, line: str, at: Point, height: float, widest: float) -> None:
        squeeze = squeeze_of(line.replace("_", ""), height, widest)
        x, y = at
        # Each size stands in its place, however wide a program draws those before it.
        for size in _SIZE.findall(line):
            self._symbol(size, (x, y), height, squeeze)
            x += _width(size, height) * squeeze

    def _symbol(self, size: str, at: Point, height: float, squeeze: float) -> None:
        x, y = at
        for number, run in enumerate(_SUBSCRIPT.split(size)):
            is_below = _is_below(number)
            high = height * _SMALLER if is_below else height
            low = y - (_DROP * height if is_below else 0.0)
            wide = text_width(run, high) * squeeze
            if run.strip():
                before = wide - text_width(run.lstrip(), high) * squeeze
                place = self._place((x + before, low))
                add_text(self.pen.layout, run, place, high, align="MIDDLE_LEFT", squeeze=squeeze)
            x += wide

    def _place(self, point: Point) -> Point:
        return self.left + point[0], self.bottom + point[1]


def _pitch(found: Setting, room: float) -> float:
    """Return from one line to the next: in a low row they stand closer than to its lines."""
    return min(found.height * LEADING, (room - 2 * _OFF_LINES) / len(found.lines))


def _width(size: str, height: float) -> float:
    """Return how wide a size is with what stands under its letters."""
    return sum(
        text_width(run, height * _SMALLER if _is_below(number) else height)
        for number, run in enumerate(_SUBSCRIPT.split(size))
    )


def _is_below(number: int) -> bool:
    return number % _RUNS == _RUNS - 1
