"""One face of a general view on paper: its layout at a scale, and drawing it."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from gripcourse.course.view import Face, Side
from gripcourse.drawing.paper.document import TEXT_HEIGHT, LineKind
from gripcourse.drawing.paper.strokes import Arc, Box, Line, at_place, placed, reach_of, runs_over
from gripcourse.drawing.paper.text import Point
from gripcourse.drawing.view.contents import Figure, Measured, Overall
from gripcourse.drawing.view.details import Detail
from gripcourse.drawing.view.dimensions import FIRST_ROW, Placed, Wanted, draw_dimensions, place
from gripcourse.drawing.view.drawn_strokes import draw_cut, draw_stroke
from gripcourse.drawing.view.enlarged import DetailMark, draw_mark, marks_of
from gripcourse.drawing.view.leaders import (
    Leader,
    Note,
    draw_leaders,
    fewest,
    place_leaders,
    through,
)
from gripcourse.drawing.view.lengths import FOR_REFERENCE, length_text
from gripcourse.text.words import Words

if TYPE_CHECKING:
    from ezdxf.layouts.layout import Modelspace

POSITION_HEIGHT = 5.0  # mm, one or two sizes above dimensions (GOST 2.316)
_AXIS_BEYOND = 4.0  # mm of paper that an axis reaches beyond the outline
_ORIGIN = (0.0, 0.0)


@dataclass(frozen=True, slots=True)
class FaceLayout:
    """A face at a scale, round its own origin, mm of paper.

    Attributes:
        outline: the box round its strokes and axes.
        axes: of symmetry.
        dimensions, leaders: in their places.
        marks: of details.
    """

    outline: Box
    axes: tuple[Line, ...]
    dimensions: tuple[Placed, ...]
    leaders: tuple[Leader, ...]
    marks: tuple[DetailMark, ...] = ()

    @property
    def boxes(self) -> tuple[Box, ...]:
        """Boxes round all that is drawn: the outline, each dimension, the shelves of leaders."""
        outline = self.outline
        found = [outline]
        for one in self.dimensions:
            low, high = one.wanted.span
            near = (
                Box(outline.left, low, outline.right, high)
                if one.wanted.upright
                else Box(low, outline.bottom, high, outline.top)
            )
            found.append(one.box.joined(near))
        found += [one.box.joined(Box(*one.note.at, *one.note.at)) for one in self.leaders]
        return (*found, *_boxes_of(self.marks))

    @property
    def box(self) -> Box:
        """The box round all of it."""
        whole = self.outline
        for one in self.boxes:
            whole = whole.joined(one)
        return whole


def face_layout(
    shown: Figure, face: Face, scale: float, words: Words, details: Sequence[Detail] = ()
) -> FaceLayout:
    """Lay out a face at a scale: dimensions in rows round it, leaders above, marks of details."""
    extent = shown.extents[face]
    bare = Box(extent.left * scale, extent.bottom * scale, extent.right * scale, extent.top * scale)
    axes = tuple(_axes(face, bare, upright=shown.upright))
    wanted = [_wanted(one, scale, words) for one in shown.measured if one.declared.face is face]
    wanted += [_for_reference(one, scale, words) for one in shown.overall if one.face is face]
    down = [x for one in wanted if one.side is Side.BELOW for x, _ in (one.start, one.end)]
    notes = list(_notes(shown, face, scale, words))
    ways = marks_of(details if face is Face.MAIN else (), scale, bare, words, down)
    laid = (_marked(one, bare, axes, wanted, notes) for one in ways)
    return fewest(next(laid), laid, lambda one: through(one.leaders, _boxes_of(one.marks)))


def _marked(
    marks: tuple[DetailMark, ...],
    bare: Box,
    axes: tuple[Line, ...],
    wanted: Sequence[Wanted],
    notes: Sequence[Note],
) -> FaceLayout:
    """Lay out a face whose details are marked in one of the ways they may be."""
    outline = bare
    for axis in axes:
        outline = outline.joined(Box(*axis.start, *axis.end))
    around = _with_marks(bare, marks)
    dimensions = place(wanted, around)
    rims = [one.rim for one in marks if one.rim is not None]
    if any(runs_over(rim, one.text_box) for rim in rims for one in dimensions):
        dimensions = place(wanted, _with_rims(around, rims))
    taken = _boxes_of(marks)
    numbers = [one.text_box for one in dimensions]
    numbers += [box for mark in marks for box in mark.letters]
    below = outline
    for box in (*(one.box for one in dimensions), *taken):
        below = below.joined(box)
    with_letters = [*notes, *(one.note for one in marks if one.note)]
    leaders = place_leaders(with_letters, below, numbers, taken)
    return FaceLayout(outline, axes, tuple(dimensions), tuple(leaders), marks)


def _boxes_of(marks: Sequence[DetailMark]) -> list[Box]:
    return [box for mark in marks for box in mark.boxes]


def _with_marks(bare: Box, marks: Sequence[DetailMark]) -> Box:
    """Return the box that dimensions stand round: under it there is room for marks of sections."""
    low = [box.bottom for box in _boxes_of(marks)]
    clear = FIRST_ROW - 2 * TEXT_HEIGHT  # what a first row leaves free over its numbers
    bottom = min([bare.bottom, *(one + clear for one in low)])
    return Box(bare.left, bottom, bare.right, bare.top)


def _with_rims(box: Box, rims: Sequence[Arc]) -> Box:
    """Return a box joined with those of circles round details."""
    for rim in rims:
        box = box.joined(reach_of(rim))
    return box


def draw_face(
    layout: "Modelspace", shown: Figure, face: Face, laid: FaceLayout, scale: float, at: Point
) -> None:
    """Draw a face with its origin at a point of the sheet."""
    for seen in shown.seen[face]:
        draw_stroke(layout, placed(seen.stroke, scale, at), seen.kind)
    for axis in laid.axes:
        draw_stroke(layout, placed(axis, 1.0, at), LineKind.CENTRE)
    for cut in shown.cuts[face]:
        draw_cut(layout, cut, scale, at)
    for mark in laid.marks:
        draw_mark(layout, mark, at)
    clear = [box for mark in laid.marks for box in mark.clear]
    draw_dimensions(layout, laid.dimensions, scale, at, clear)
    draw_leaders(layout, laid.leaders, at)


def _wanted(one: Measured, scale: float, words: Words) -> Wanted:
    return Wanted(
        text=one.declared.sign + length_text(one.value, words),
        start=at_place(one.start, scale, _ORIGIN),
        end=at_place(one.end, scale, _ORIGIN),
        side=one.declared.side,
    )


def _for_reference(one: Overall, scale: float, words: Words) -> Wanted:
    start, end = at_place(one.start, scale, _ORIGIN), at_place(one.end, scale, _ORIGIN)
    return Wanted(length_text(round(one.value, 1), words) + FOR_REFERENCE, start, end, one.side)


def _notes(shown: Figure, face: Face, scale: float, words: Words) -> Iterator[Note]:
    if face is Face.MAIN:
        for number, position in enumerate(shown.positions, 1):
            mark = at_place(position.mark, scale, _ORIGIN)
            yield Note(str(number), POSITION_HEIGHT, mark)
    for label in shown.labelled:
        if label.declared.face is face:
            values = {name: length_text(value, words) for name, value in label.values.items()}
            text = label.declared.text.of(words.language).format(**values)
            yield Note(text, TEXT_HEIGHT, at_place(label.at, scale, _ORIGIN))


def _axes(face: Face, outline: Box, *, upright: bool) -> Iterator[Line]:
    """Yield the axis; where it is looked along, it shows as a cross."""
    if face is not Face.MAIN or not upright:
        yield Line((outline.left - _AXIS_BEYOND, 0.0), (outline.right + _AXIS_BEYOND, 0.0))
    if face is not Face.MAIN or upright:
        yield Line((0.0, outline.bottom - _AXIS_BEYOND), (0.0, outline.top + _AXIS_BEYOND))
