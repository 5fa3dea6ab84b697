"""Lines and cells of the tables on a sheet. Lengths in mm."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

from gripcourse.drawing.paper.document import LineKind
from gripcourse.drawing.paper.strokes import Box
from gripcourse.drawing.paper.text import LEADING, Point, add_text, set_in

if TYPE_CHECKING:
    from ezdxf.layouts.layout import Modelspace

PAD = 1.0  # free beside the words of a cell
SMALL, NORMAL, LARGE = 2.5, 3.5, 5.0  # heights of letters


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

    def words(
        self,
        text: str,
        corner: Point,
        size: Point,
        height: float,
        *,
        middle: bool = False,
        most: int = 1,
    ) -> None:
        """Write into a cell in so many lines at most, squeezed, then smaller, to fit."""
        room = (size[0] - 2 * PAD, size[1])
        x = corner[0] + (size[0] / 2 if middle else PAD)
        found = set_in(text, height, room, most)
        pitch = found.height * LEADING
        top = corner[1] + size[1] / 2 + pitch * (len(found.lines) - 1) / 2
        for number, line in enumerate(found.lines):
            add_text(
                self.pen.layout,
                line,
                self._place((x, top - pitch * number)),
                found.height,
                align="MIDDLE_CENTER" if middle else "MIDDLE_LEFT",
                widest=room[0],
            )

    def _place(self, point: Point) -> Point:
        return self.left + point[0], self.bottom + point[1]
