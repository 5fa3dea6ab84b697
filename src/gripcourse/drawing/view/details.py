"""What is shown again at a larger scale: places of the main view as seen, or cut across the axis.

Millimetres of the thing itself, round the middle of the place.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import shapely

from gripcourse.course.view import Face, Side, View, ViewDetail
from gripcourse.drawing.paper.document import LineKind
from gripcourse.drawing.paper.strokes import Arc, Box, Line, Stroke, box_of, covered, points_of
from gripcourse.drawing.paper.text import Point
from gripcourse.drawing.view.bodies import Scene
from gripcourse.drawing.view.contents import Figure, Seen
from gripcourse.drawing.view.cut_faces import Cut, cut_of
from gripcourse.drawing.view.cut_through import CutThrough, cut_through
from gripcourse.drawing.view.numbers import Numbers, numbers_at
from gripcourse.solver.plan import Plan

_SMALLEST = 1e-3  # mm²
_MOST_CIRCLES = 3  # whose diameters are told
_SHOWN_AGAIN = frozenset({LineKind.OUTLINE, LineKind.THIN, LineKind.CENTRE, LineKind.HIDDEN})


@dataclass(frozen=True, slots=True)
class Size:
    """A size that a detail tells: its two points, and the side that its dimension stands on."""

    value: float
    sign: str
    start: Point
    end: Point
    side: Side


@dataclass(frozen=True, slots=True)
class Detail:
    """A place that is shown again.

    Attributes:
        at: where its middle lies in the main view.
        reach: half of what is shown.
        is_section: whether it is a section; else its rim is a circle.
        seen: its strokes.
        cuts: faces to be hatched.
        circles: whose diameters are told, each once.
        sizes: its dimensions.
    """

    at: Point
    reach: float
    is_section: bool
    seen: Sequence[Seen]
    cuts: Sequence[Cut]
    circles: Sequence[Arc]
    sizes: Sequence[Size]

    @property
    def extent(self) -> Box:
        """The box round its strokes."""
        return box_of(point for one in self.seen for point in points_of(one.stroke))


def details_of(
    shown: Figure, plan: Plan, view: View, solved: Mapping[str, float]
) -> tuple[Detail, ...]:
    """Return the details of a variant that there is something to be seen in.

    Args:
        shown: its figure.
        plan: of the variant.
        view: of its scheme.
        solved: its values in declared units.
    """
    if not view.details:
        return ()
    numbers = numbers_at(plan, view, solved, view.position)
    found = (_detail(one, shown, view, numbers) for one in view.details)
    return tuple(one for one in found if one is not None and one.seen)


def _detail(declared: ViewDetail, shown: Figure, view: View, numbers: Numbers) -> Detail | None:
    at = numbers.point(declared.at)
    reach = numbers.number(declared.reach, "mm") if declared.reach is not None else None
    if at is None or reach is None or reach <= 0:
        return None
    if not declared.is_section:
        return _enlarged(shown, at, reach)
    values = {name: np.atleast_1d(one) for name, one in numbers.values.items()}
    scene = Scene(values, numbers.plan.columns, 1, frozenset())
    return _section(cut_through(view, scene, at, reach), at, reach)


def _enlarged(shown: Figure, at: Point, reach: float) -> Detail:
    rim = Arc((0.0, 0.0), reach)
    mask = points_of(rim)[:-1]
    seen = [
        Seen(piece, one.kind)
        for one in shown.seen[Face.MAIN]
        if one.kind in _SHOWN_AGAIN
        for piece in covered(_moved(one.stroke, at), mask)
    ]
    seen += [
        Seen(piece, LineKind.CENTRE)
        for axis in _axis(shown, at, reach)
        for piece in covered(axis, mask)
    ]
    window = shapely.Polygon(mask)
    cuts = [cut for one in shown.cuts[Face.MAIN] for cut in _cut_within(one, at, window)]
    whole = [
        one.stroke
        for one in seen
        if one.kind is LineKind.OUTLINE and isinstance(one.stroke, Arc) and one.stroke.is_circle
    ]
    by_size = {round(one.radius, 2): one for one in whole}
    circles = [by_size[key] for key in sorted(by_size)][:_MOST_CIRCLES]
    return Detail(at, reach, False, [*seen, Seen(rim, LineKind.THIN)] if seen else [],
                  cuts, circles, ())  # fmt: skip


def _axis(shown: Figure, at: Point, reach: float) -> Iterator[Line]:
    """Yield the axis of the whole where it runs through the place."""
    if shown.upright and abs(at[0]) < reach:
        yield Line((-at[0], -reach), (-at[0], reach))
    if not shown.upright and abs(at[1]) < reach:
        yield Line((-reach, -at[1]), (reach, -at[1]))


def _moved(stroke: Stroke, at: Point) -> Stroke:
    if isinstance(stroke, Line):
        return Line(_from(stroke.start, at), _from(stroke.end, at))
    return Arc(_from(stroke.centre, at), stroke.radius, stroke.low, stroke.high)


def _from(point: Point, at: Point) -> Point:
    return point[0] - at[0], point[1] - at[1]


def _cut_within(cut: Cut, at: Point, window: shapely.Polygon) -> Iterator[Cut]:
    rings = [[_from(point, at) for point in ring] for ring in cut.rings]
    seen = shapely.Polygon(rings[0], rings[1:]).buffer(0).intersection(window)
    for piece in shapely.get_parts(seen):
        if isinstance(piece, shapely.Polygon) and piece.area > _SMALLEST:
            yield cut_of(piece, cut.hatch)


def _section(found: CutThrough, at: Point, reach: float) -> Detail:
    return Detail(at, reach, True, found.seen, found.cuts, (), tuple(_sizes(found)))


def _sizes(found: CutThrough) -> Iterator[Size]:
    """Yield diameter and length of the pin, and how wide all of it is, each once."""
    if not found.seen:
        return
    pin = found.pin
    whole = box_of(
        point
        for one in found.seen
        if one.kind is LineKind.OUTLINE
        for point in points_of(one.stroke)
    )
    if pin is not None:
        yield Size(pin.height, "Ø", (pin.right, pin.bottom), (pin.right, pin.top), Side.RIGHT)
        yield Size(
            round(pin.width, 1), "", (pin.left, pin.bottom), (pin.right, pin.bottom), Side.BELOW
        )
    if pin is None or whole.width - pin.width > _SMALLEST:
        level = whole.bottom
        yield Size(round(whole.width, 1), "", (whole.left, level), (whole.right, level), Side.BELOW)
