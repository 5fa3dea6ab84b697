"""Strokes and cut faces of a view as entities of a drawing."""

from typing import TYPE_CHECKING

from gripcourse.drawing.paper.document import LineKind
from gripcourse.drawing.paper.strokes import Line, Stroke, at_place
from gripcourse.drawing.paper.text import Point
from gripcourse.drawing.view.cut_faces import Cut

if TYPE_CHECKING:
    from ezdxf.layouts.layout import Modelspace

_FAR_APART, _CLOSE = 2.0, 1.2  # lines of a hatch, mm of paper (GOST 2.306: 1 to 10)
_PITCH = 3.175  # of the standard pattern, mm
_ANSI31 = [45.0, (0.0, 0.0), (-_PITCH / 2**0.5, _PITCH / 2**0.5), []]
# How a hatch is turned, and how far apart its lines are.
_HATCH_LOOKS = {
    "right": (0.0, _FAR_APART),
    "left": (90.0, _FAR_APART),
    "close_right": (0.0, _CLOSE),
    "close_left": (90.0, _CLOSE),
}


def draw_stroke(layout: "Modelspace", stroke: Stroke, kind: LineKind) -> None:
    """Draw a line, an arc or a circle."""
    look = {"layer": kind}
    if isinstance(stroke, Line):
        layout.add_line(stroke.start, stroke.end, dxfattribs=look)
    elif stroke.is_circle:
        layout.add_circle(stroke.centre, stroke.radius, dxfattribs=look)
    else:
        layout.add_arc(stroke.centre, stroke.radius, stroke.low, stroke.high, dxfattribs=look)


def draw_cut(layout: "Modelspace", cut: Cut, scale: float, at: Point) -> None:
    """Hatch a cut face whose origin lies at a point of the sheet."""
    hatch_entity = layout.add_hatch(dxfattribs={"layer": LineKind.HATCH})
    # The standard pattern, so that programs with patterns of their own find it.
    angle, spacing = _HATCH_LOOKS[cut.hatch]
    pattern = [_ANSI31]
    hatch_entity.set_pattern_fill("ANSI31", 256, angle, spacing / _PITCH, definition=pattern)
    for ring in cut.rings:
        corners = [at_place(point, scale, at) for point in ring]
        hatch_entity.paths.add_polyline_path(corners, is_closed=True)
