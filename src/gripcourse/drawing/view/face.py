"""One face of a general view on paper: its layout at a scale, and drawing it."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from gripcourse.course.view import Face
from gripcourse.drawing.paper.document import TEXT_HEIGHT, LineKind
from gripcourse.drawing.paper.strokes import Box, Line, Stroke, at_place, placed
from gripcourse.drawing.paper.text import Point
from gripcourse.drawing.view.contents import Figure, Measured, Overall
from gripcourse.drawing.view.dimensions import Placed, Wanted, draw_dimensions, place
from gripcourse.drawing.view.leaders import Leader, Note, draw_leaders, place_leaders
from gripcourse.text.words import Words

if TYPE_CHECKING:
    from ezdxf.layouts.layout import Modelspace

POSITION_HEIGHT = 5.0  # mm, one or two sizes above dimensions (GOST 2.316)
_AXIS_BEYOND = 4.0  # mm of paper that an axis reaches beyond the outline
_HATCH_SPACING = 2.0  # mm of paper
_PITCH = 3.175  # of the standard pattern, mm
_ANSI31 = [45.0, (0.0, 0.0), (-_PITCH / 2**0.5, _PITCH / 2**0.5), []]
_LEANING = {"right": 0.0, "left": 90.0}
_ORIGIN = (0.0, 0.0)
_FIGURES = 7  # tenths of a millimetre of any machine, thousandths of a small size
_SERIES_DECIMALS = 3  # no series is finer
_SAME = 1e-9
FOR_REFERENCE = "*"


@dataclass(frozen=True, slots=True)
class FaceLayout:
    """A face at a scale, round its own origin, mm of paper.

    Attributes:
        outline: the box round its strokes and axes.
        axes: of symmetry.
        dimensions, leaders: in their places.
    """

    outline: Box
    axes: tuple[Line, ...]
    dimensions: tuple[Placed, ...]
    leaders: tuple[Leader, ...]

    @property
    def box(self) -> Box:
        """The box round all of it."""
        box = self.outline
        for dimension in self.dimensions:
            box = box.joined(dimension.box)
        for leader in self.leaders:
            box = box.joined(leader.box)
        return box


def length_text(value: float, words: Words) -> str:
    """Write a length to tenths of a millimetre, as dimensions do.

    A size as a series or a table of variants has it, such as a module of 1.25 mm or a wire of
    0.355 mm, is written as it is: rounded, it would be another size.
    """
    tidy = round(value, _SERIES_DECIMALS)
    is_tidy = math.isclose(value, tidy, rel_tol=_SAME)
    return words.number(tidy if is_tidy else round(value, 1), _FIGURES)


def face_layout(shown: Figure, face: Face, scale: float, words: Words) -> FaceLayout:
    """Lay out a face at a scale: dimensions in rows round it, leaders above."""
    extent = shown.extent(face)
    bare = Box(extent.left * scale, extent.bottom * scale, extent.right * scale, extent.top * scale)
    axes = tuple(_axes(face, bare, upright=shown.upright))
    outline = bare
    for axis in axes:
        outline = outline.joined(Box(*axis.start, *axis.end))
    wanted = [_wanted(one, scale, words) for one in shown.measured if one.declared.face is face]
    wanted += [_for_reference(one, scale, words) for one in shown.overall if one.face is face]
    dimensions = place(wanted, bare)
    numbers = [one.text_box for one in dimensions]
    below = outline
    for one in dimensions:
        below = below.joined(one.box)
    notes = [*_notes(shown, face, scale, words)]
    return FaceLayout(outline, axes, tuple(dimensions), tuple(place_leaders(notes, below, numbers)))


def draw_face(
    layout: "Modelspace", shown: Figure, face: Face, laid: FaceLayout, scale: float, at: Point
) -> None:
    """Draw a face with its origin at a point of the sheet."""
    for seen in shown.seen[face]:
        draw_stroke(layout, placed(seen.stroke, scale, at), seen.kind)
    for axis in laid.axes:
        draw_stroke(layout, placed(axis, 1.0, at), LineKind.CENTRE)
    for cut in shown.cuts[face]:
        rings = [[at_place(point, scale, at) for point in ring] for ring in cut.rings]
        _draw_hatch(layout, rings, cut.hatch)
    draw_dimensions(layout, laid.dimensions, scale, at)
    draw_leaders(layout, laid.leaders, at)


def draw_stroke(layout: "Modelspace", stroke: Stroke, kind: LineKind) -> None:
    """Draw a line, an arc or a circle."""
    look = {"layer": kind}
    if isinstance(stroke, Line):
        layout.add_line(stroke.start, stroke.end, dxfattribs=look)
    elif stroke.is_circle:
        layout.add_circle(stroke.centre, stroke.radius, dxfattribs=look)
    else:
        layout.add_arc(stroke.centre, stroke.radius, stroke.low, stroke.high, dxfattribs=look)


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


def _draw_hatch(layout: "Modelspace", rings: Sequence[Sequence[Point]], hatch: str) -> None:
    hatch_entity = layout.add_hatch(dxfattribs={"layer": LineKind.HATCH})
    # The standard pattern, so that programs with patterns of their own find it.
    size, angle = _HATCH_SPACING / _PITCH, _LEANING[hatch]
    pattern = [_ANSI31]
    hatch_entity.set_pattern_fill("ANSI31", 256, angle, size, definition=pattern)
    for ring in rings:
        hatch_entity.paths.add_polyline_path(ring, is_closed=True)
