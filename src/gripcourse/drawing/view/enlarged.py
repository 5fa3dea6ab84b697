"""A detail on paper: its layout at a scale, drawing it, and its marks in the main view.

Millimetres of paper, round the middle of the detail (of the marks, round that of the main view).
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations, product
from typing import TYPE_CHECKING

from gripcourse.drawing.paper.document import ARROW, LineKind
from gripcourse.drawing.paper.strokes import Arc, Box, Line, at_place, on_circle, placed
from gripcourse.drawing.paper.text import Point, add_text, text_width
from gripcourse.drawing.view.details import Detail, Size
from gripcourse.drawing.view.dimensions import Placed, Wanted, draw_dimensions, place
from gripcourse.drawing.view.drawn_strokes import draw_cut, draw_stroke
from gripcourse.drawing.view.leaders import Leader, Note, draw_leaders, place_leaders
from gripcourse.drawing.view.lengths import FOR_REFERENCE, length_text
from gripcourse.text.words import Words, message

if TYPE_CHECKING:
    from ezdxf.layouts.layout import Modelspace

LETTER = 5.0  # mm, height of letters and of titles (GOST 2.316)
_TITLE_ABOVE = 4.0  # over what stands below it
_ROUND = 60.0  # degrees, where a leader meets the circle round a place
_DIAMETERS = (60.0, 120.0, 30.0)  # where leaders meet circles, so that they do not coincide
_AWAY, _STROKE = 1.0, 8.0  # of the marks of a plane, from the outline, and how long they are
_ARROW_AT, _SHAFT = 6.0, 8.0
_CLOSE = 2 * _SHAFT + 2 * LETTER  # planes whose arrows would run into one another
_HALF_ARROW = ARROW / 6
_ON = 0.3  # how near a line lies to a stroke that it would be drawn on
_CLEAR = 0.5  # of letters, from extension lines
_ORIGIN = (0.0, 0.0)


@dataclass(frozen=True, slots=True)
class DetailLayout:
    """A detail at a scale.

    Attributes:
        detail: what it shows.
        scale: as drawing : nature.
        title: that stands over it.
        outline: the box round its strokes.
        dimensions, leaders: in their places.
    """

    detail: Detail
    scale: tuple[float, float]
    title: str
    outline: Box
    dimensions: tuple[Placed, ...]
    leaders: tuple[Leader, ...]

    @property
    def factor(self) -> float:
        """Millimetres of paper for a millimetre."""
        return self.scale[0] / self.scale[1]

    @property
    def _body(self) -> Box:
        box = self.outline
        boxes = [*(one.box for one in self.dimensions), *(one.box for one in self.leaders)]
        for one in boxes:
            box = box.joined(one)
        return box

    @property
    def title_at(self) -> Point:
        """The middle of the base line of its title."""
        return (self.outline.left + self.outline.right) / 2, self._body.top + _TITLE_ABOVE

    @property
    def box(self) -> Box:
        """The box round all of it."""
        x, y = self.title_at
        half = text_width(self.title, LETTER) / 2
        return self._body.joined(Box(x - half, y, x + half, y + LETTER))


def letter_of(number: int, words: Words) -> str:
    """Return the letter of a detail, the first of them number 0."""
    letters = words.say(message("ABCD"))
    return letters[number % len(letters)]


def detail_layout(
    detail: Detail, number: int, scale: tuple[float, float], words: Words
) -> DetailLayout:
    """Lay out a detail at a scale."""
    factor = scale[0] / scale[1]
    extent, letter = detail.extent, letter_of(number, words)
    outline = Box(
        extent.left * factor, extent.bottom * factor, extent.right * factor, extent.top * factor
    )
    wanted = [_wanted(one, factor, words) for one in detail.sizes]
    notes = [
        Note(
            "Ø" + length_text(2 * one.radius, words),
            LETTER * 0.7,
            at_place(on_circle(one.centre, one.radius, angle), factor, _ORIGIN),
        )
        for one, angle in zip(detail.circles, _DIAMETERS, strict=False)
    ]
    name = f"{letter}—{letter}" if detail.is_section else letter
    title = f"{name} ({words.number(scale[0])}:{words.number(scale[1])})"
    dimensions = tuple(place(wanted, outline))
    return DetailLayout(
        detail, scale, title, outline, dimensions, tuple(place_leaders(notes, outline))
    )


def _wanted(one: Size, factor: float, words: Words) -> Wanted:
    text = one.sign + length_text(round(one.value, 3), words)
    if not one.sign:
        text += FOR_REFERENCE
    start, end = (at_place(point, factor, _ORIGIN) for point in (one.start, one.end))
    return Wanted(text, start, end, one.side)


def draw_detail(layout: "Modelspace", laid: DetailLayout, at: Point) -> None:
    """Draw a detail with its middle at a point of the sheet."""
    for one in laid.detail.seen:
        draw_stroke(layout, placed(one.stroke, laid.factor, at), one.kind)
    for cut in laid.detail.cuts:
        draw_cut(layout, cut, laid.factor, at)
    draw_dimensions(layout, laid.dimensions, laid.factor, at)
    draw_leaders(layout, laid.leaders, at)
    x, y = laid.title_at
    add_text(layout, laid.title, (x + at[0], y + at[1]), LETTER, align="CENTER")


@dataclass(frozen=True, slots=True)
class DetailMark:
    """How the main view tells where a detail is taken.

    Attributes:
        letter: of the detail.
        towards: 1 where a section is looked at from the left, -1 from the right.
        rim: the circle round the place; None for a section.
        x: where the plane of a section lies.
        low, high: between which heights the drawing lies there.
    """

    letter: str
    towards: int
    rim: Arc | None
    x: float
    low: float
    high: float

    @property
    def note(self) -> Note | None:
        """The letter on a leader line that meets the circle."""
        if self.rim is None:
            return None
        return Note(self.letter, LETTER, on_circle(self.rim.centre, self.rim.radius, _ROUND), False)

    @property
    def boxes(self) -> tuple[Box, ...]:
        """The boxes round stroke, arrow and letter at both ends of a plane."""
        if self.rim is not None:
            return ()
        far = self.x - self.towards * (_SHAFT + 2 * _AWAY + text_width(self.letter, LETTER))
        left, right = sorted((far, self.x + self.towards * _AWAY))
        up, down = self.high + _AWAY, self.low - _AWAY
        return (Box(left, up, right, up + _STROKE), Box(left, down - _STROKE, right, down))

    @property
    def clear(self) -> tuple[Box, ...]:
        """What a line that lies on the plane leaves free round both strokes."""
        if self.rim is not None:
            return ()
        left, right = self.x - _ON, self.x + _ON
        near, far = _AWAY / 2, _STROKE + 2 * _AWAY  # no line along the outline itself
        return (
            Box(left, self.high + near, right, self.high + far),
            Box(left, self.low - far, right, self.low - near),
        )

    @property
    def letters(self) -> tuple[Box, ...]:
        """The boxes round the letters at both ends of a plane, the upper one first."""
        if self.rim is not None:
            return ()
        near = self.x - self.towards * (_SHAFT + _AWAY)
        far = near - self.towards * text_width(self.letter, LETTER)
        left, right = sorted((near, far))
        return tuple(
            Box(left, level - LETTER / 2, right, level + LETTER / 2) for _, _, level in _ends(self)
        )


def marks_of(
    details: Sequence[Detail],
    scale: float,
    bare: Box,
    words: Words,
    below: Sequence[float] = (),
) -> list[tuple[DetailMark, ...]]:
    """Return the marks of details in a main view whose strokes fill a box, in equally good ways.

    A plane that lies close behind another one is looked at from the other side, so that the arrows
    have room; so is one by whose letter an extension line would run. What is no better from either
    side is returned both ways, that from the left first.

    Args:
        details: those on the sheet.
        scale: millimetres of paper for a millimetre.
        bare: the box.
        words: of the reader.
        below: where extension lines run down from the view.
    """
    planes = [one.at[0] * scale for one in details if one.is_section]
    rims = [
        None if one.is_section else Arc(at_place(one.at, scale, _ORIGIN), one.reach * scale)
        for one in details
    ]
    marks = []
    for number, (one, rim) in enumerate(zip(details, rims, strict=True)):
        x, _ = at_place(one.at, scale, _ORIGIN)
        towards = -1 if any(0 <= x - other < _CLOSE for other in planes if other != x) else 1
        letter = letter_of(number, words)
        sides = (towards, -towards) if one.is_section else (towards,)
        low, high = _levels(x, letter, bare, [arc for arc in rims if arc is not None])
        marks.append([DetailMark(letter, side, rim, x, low, high) for side in sides])
    ways = [(_in_the_way(chosen, below), chosen) for chosen in product(*marks)]
    least = min(how for how, _ in ways)
    return [chosen for how, chosen in ways if how == least]


def _levels(x: float, letter: str, bare: Box, rims: Sequence[Arc]) -> tuple[float, float]:
    """Return below and above what a plane is marked: the view, and circles of details beside it."""
    beside = _SHAFT + 2 * _AWAY + text_width(letter, LETTER)
    near = [one for one in rims if abs(one.centre[0] - x) < one.radius + beside]
    low = min([bare.bottom, *(one.centre[1] - one.radius for one in near)])
    return low, max([bare.top, *(one.centre[1] + one.radius for one in near)])


def _in_the_way(marks: Sequence[DetailMark], below: Sequence[float]) -> tuple[int, int]:
    """Return how many marks overlap, and how many extension lines run through letters."""
    overlaps = sum(
        one.overlaps(other)
        for first, second in combinations(marks, 2)
        for one, other in product(first.boxes, second.boxes)
    )
    lower = [box for mark in marks for box in mark.letters[1:]]
    through = sum(box.left - _CLEAR < x < box.right + _CLEAR for box in lower for x in below)
    return overlaps, through


def draw_mark(layout: "Modelspace", mark: DetailMark, at: Point) -> None:
    """Draw a mark in a main view whose origin lies at a point; its leader is a leader's."""
    if mark.rim is not None:
        draw_stroke(layout, placed(mark.rim, 1.0, at), LineKind.THIN)
        return
    for start, end, arrow in _ends(mark):
        draw_stroke(layout, placed(Line(start, end), 1.0, at), LineKind.OUTLINE)
        tail = mark.x - mark.towards * _SHAFT
        shaft = Line((tail, arrow), (mark.x, arrow))
        draw_stroke(layout, placed(shaft, 1.0, at), LineKind.THIN)
        corners = [
            (mark.x, arrow),
            (mark.x - mark.towards * ARROW, arrow + _HALF_ARROW),
            (mark.x - mark.towards * ARROW, arrow - _HALF_ARROW),
        ]
        head = layout.add_hatch(dxfattribs={"layer": LineKind.THIN})
        head.paths.add_polyline_path([at_place(one, 1.0, at) for one in corners], is_closed=True)
        beside = at_place((tail - mark.towards * _AWAY, arrow), 1.0, at)
        align = "MIDDLE_RIGHT" if mark.towards > 0 else "MIDDLE_LEFT"
        add_text(layout, mark.letter, beside, LETTER, align=align)


def _ends(mark: DetailMark) -> Iterator[tuple[Point, Point, float]]:
    """Yield both strokes of a plane, and how high the arrow of each stands."""
    up, down = mark.high + _AWAY, mark.low - _AWAY
    yield (mark.x, up), (mark.x, up + _STROKE), up + _ARROW_AT
    yield (mark.x, down), (mark.x, down - _STROKE), down - _ARROW_AT
