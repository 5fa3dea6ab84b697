"""Where dimensions stand: in rows outside the outline, the shorter nearer, nothing overlapping.

All lengths are millimetres of paper, in the coordinates of the face.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from gripcourse.course.view import Side
from gripcourse.drawing.paper.document import ARROW, DIMENSION_STYLE, TEXT_HEIGHT, LineKind
from gripcourse.drawing.paper.strokes import Box, Line, Stroke, outside, points_of
from gripcourse.drawing.paper.text import Point, add_text, text_width

if TYPE_CHECKING:
    from ezdxf.entities.dimension import Dimension
    from ezdxf.layouts.layout import Modelspace

FIRST_ROW = 10.0  # from the outline, GOST 2.307
ROW = 8.0  # from one dimension line to the next
_BESIDE = 1.5  # what is free beside a number
_ABOVE = 1.0  # the number over its line
_TAIL = 2.0 * ARROW  # the line behind an arrow that points inward
_HALF = 1e-6
_TRIES = (0.5, 0.3, 0.7, 0.15, 0.85)


@dataclass(frozen=True, slots=True)
class Wanted:
    """A dimension to be placed: its number as it will be written, its two points."""

    text: str
    start: Point
    end: Point
    side: Side

    @property
    def upright(self) -> bool:
        """Whether it measures across the axis."""
        return self.side in {Side.LEFT, Side.RIGHT}

    @property
    def span(self) -> tuple[float, float]:
        """What it measures, along its line."""
        ends = sorted(one[1] if self.upright else one[0] for one in (self.start, self.end))
        return ends[0], ends[1]


@dataclass(frozen=True, slots=True)
class Placed:
    """A dimension in its place.

    Attributes:
        wanted: what it shows.
        line: where its line lies, across itself.
        middle: of its number, along the line.
        inside: whether the number stands between its two points.
        reach: of the line with all that stands on it, along itself.
    """

    wanted: Wanted
    line: float
    middle: float
    inside: bool
    reach: tuple[float, float]

    @property
    def text_box(self) -> Box:
        """The box round its number."""
        half = text_width(self.wanted.text, TEXT_HEIGHT) / 2
        along = (self.middle - half, self.middle + half)
        across = (self.line + _ABOVE, self.line + _ABOVE + TEXT_HEIGHT)
        if self.wanted.upright:  # read from the right: the number stands on the left of its line
            across = (self.line - _ABOVE - TEXT_HEIGHT, self.line - _ABOVE)
            return Box(across[0], along[0], across[1], along[1])
        return Box(along[0], across[0], along[1], across[1])

    @property
    def box(self) -> Box:
        """The box round its line and number."""
        (low, high), line, half = self.reach, self.line, ARROW / 6
        arrows = Box(low, line - half, high, line + half)
        if self.wanted.upright:
            arrows = Box(line - half, low, line + half, high)
        return arrows.joined(self.text_box)


def place(wanted: Iterable[Wanted], outline: Box) -> list[Placed]:
    """Give each dimension its row outside an outline."""
    every = list(wanted)
    return [
        one
        for side in Side
        for one in _place_side([one for one in every if one.side is side], side, outline)
    ]


def draw_dimensions(
    layout: "Modelspace",
    placed: Sequence[Placed],
    scale: float,
    by: Point,
    clear: Sequence[Box] = (),
) -> None:
    """Draw dimensions of what stands on paper in a scale, moved by `by`.

    Their lines are interrupted in boxes that are to stay clear.
    """
    moved = [one.moved(by) for one in clear]
    for one in placed:
        wanted, upright = one.wanted, one.wanted.upright
        base = (one.line, wanted.start[1]) if upright else (wanted.start[0], one.line)
        dimension = layout.add_linear_dim(
            base=_moved(base, by),
            p1=_moved(wanted.start, by),
            p2=_moved(wanted.end, by),
            angle=90 if upright else 0,
            # Written out: many programs do not know of a factor of one dimension's own.
            text=wanted.text,
            dimstyle=DIMENSION_STYLE,
            override={"dimlfac": 1 / scale, "dimdec": 1},
            dxfattribs={"layer": LineKind.DIMENSION},
        )
        box = one.text_box
        middle = ((box.left + box.right) / 2, (box.bottom + box.top) / 2)
        dimension.set_location(_moved(middle, by), leader=False, relative=False)
        dimension.render()
        _write_plainly(dimension.dimension, one, middle=_moved(middle, by))
        _interrupt(dimension.dimension, moved)
        _draw_shelf(layout, one, by)


def _write_plainly(dimension: "Dimension", one: Placed, middle: Point) -> None:
    """Write the number of a dimension as one line: some programs do not show what may be more."""
    from ezdxf.entities.mtext import MText  # noqa: PLC0415 (0.3 s: only who draws pays for it)

    block = dimension.get_geometry_block()
    if block is None:
        return
    for number in [one for one in block if isinstance(one, MText)]:
        block.delete_entity(number)
        add_text(
            block,
            one.wanted.text,
            middle,
            TEXT_HEIGHT,
            align="MIDDLE_CENTER",
            layer=LineKind.DIMENSION,
            rotation=90.0 if one.wanted.upright else 0.0,
        )


def _interrupt(dimension: "Dimension", clear: Sequence[Box]) -> None:
    """Leave out of the lines of a dimension what lies in boxes."""
    block = dimension.get_geometry_block()
    if block is None:
        return
    for drawn in [one for one in block if one.dxftype() == "LINE"]:
        start, end = drawn.dxf.start, drawn.dxf.end
        whole = Line((start.x, start.y), (end.x, end.y))
        pieces: list[Stroke] = [whole]
        for box in clear:
            pieces = [left for one in pieces for left in outside(one, box.corners)]
        if pieces != [whole]:
            attributes = drawn.dxfattribs(drop={"handle", "owner", "start", "end"})
            block.delete_entity(drawn)
            for piece in pieces:
                first, last = points_of(piece)
                block.add_line(first, last, dxfattribs=attributes)


def _draw_shelf(layout: "Modelspace", one: Placed, by: Point) -> None:
    """Draw the line under a number that stands outside its two points."""
    if one.inside:
        return
    low, high = one.wanted.span
    ends = (high, one.reach[1]) if one.middle > high else (one.reach[0], low)
    points = [(one.line, end) if one.wanted.upright else (end, one.line) for end in ends]
    start, end = (_moved(point, by) for point in points)
    layout.add_line(start, end, dxfattribs={"layer": LineKind.DIMENSION})


def _moved(point: Point, by: Point) -> Point:
    return point[0] + by[0], point[1] + by[1]


def _place_side(wanted: Sequence[Wanted], side: Side, outline: Box) -> list[Placed]:
    rows: list[list[Placed]] = []
    ordered = sorted(wanted, key=lambda one: (one.span[1] - one.span[0], one.span, one.text))
    for number, one in enumerate(ordered):
        later = [end for other in ordered[number + 1 :] for end in other.span]
        lying = _on_line(one, later)
        row = next(
            (
                place
                for place in range(len(rows) + 1)
                if all(not _clash(lying, other) for above in rows[place:] for other in above)
            ),
            len(rows),
        )
        if row == len(rows):
            rows.append([])
        rows[row].append(_in_row(lying, row, side, outline))
    return [one for row in rows for one in row]


def _on_line(one: Wanted, others: Sequence[float]) -> Placed:
    """Put the number where no extension line of a longer dimension runs through it."""
    (low, high), width = one.span, text_width(one.text, TEXT_HEIGHT)
    half = width / 2 + _BESIDE

    def free(middle: float) -> bool:
        return all(abs(end - middle) >= half - _HALF for end in others)

    tail = _TAIL if high - low < 2 * ARROW + _BESIDE else 0.0
    room = high - low - 2 * half
    inside = [low + half + room * share for share in _TRIES] if room >= 0 else []
    # Beside its points; behind the extension lines there, where they leave no room.
    after = [high + _TAIL + half, *(end + half for end in others if end >= high + _TAIL)]
    before = [low - _TAIL - half, *(end - half for end in others if end <= low - _TAIL)]
    beside = sorted([*after, *before], key=lambda place: (max(place - high, low - place), -place))
    middle = next((place for place in (*inside, *beside) if free(place)), (*inside, *beside)[0])
    if middle in inside:
        return Placed(one, 0.0, middle, inside=True, reach=(low - tail, high + tail))
    reach = (min(low - _TAIL, middle - half), max(high + _TAIL, middle + half))
    return Placed(one, 0.0, middle, inside=False, reach=reach)


def _clash(first: Placed, second: Placed) -> bool:
    return first.reach[0] < second.reach[1] and second.reach[0] < first.reach[1]


def _in_row(lying: Placed, row: int, side: Side, outline: Box) -> Placed:
    away = FIRST_ROW + ROW * row
    line = {
        Side.ABOVE: outline.top + away,
        Side.BELOW: outline.bottom - away,
        Side.LEFT: outline.left - away,
        Side.RIGHT: outline.right + away,
    }[side]
    return Placed(lying.wanted, line, lying.middle, lying.inside, lying.reach)
