"""The declared view with a variant's numbers: strokes in millimetres of the thing itself."""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from gripcourse.course.quantity import Kind
from gripcourse.course.view import Face, Side, View, ViewDimension, ViewLabel, ViewPart
from gripcourse.drawing.paper.document import LineKind
from gripcourse.drawing.paper.strokes import (
    Arc,
    Box,
    Stroke,
    box_of,
    covered,
    outside,
    points_of,
    reach_of,
)
from gripcourse.drawing.paper.text import Point
from gripcourse.drawing.view.cut_faces import Cut, cut_faces
from gripcourse.drawing.view.extension_lines import begun, reach
from gripcourse.drawing.view.numbers import Numbers, numbers_at
from gripcourse.drawing.view.placed_shapes import Shown, as_other, shown
from gripcourse.drawing.view.seen_marks import seen_mark
from gripcourse.errors import CourseError, Problem
from gripcourse.solver.plan import Plan
from gripcourse.text.units import factor
from gripcourse.text.words import message

_NEVER_COVERED = {LineKind.CENTRE, LineKind.HIDDEN}
_NEAR = 1e-3
_TOLERANCE = 0.15  # mm: dimensions are written to tenths


@dataclass(frozen=True, slots=True)
class Seen:
    """A stroke and the line that it is drawn in."""

    stroke: Stroke
    kind: LineKind


@dataclass(frozen=True, slots=True)
class Position:
    """A part with a number in the parts list; `mark` is where its leader ends."""

    part: ViewPart
    count: int
    mark: Point


@dataclass(frozen=True, slots=True)
class Measured:
    """A dimension with its two points, and the value of its quantity in the declared unit.

    What is computed is written to tenths; a size of a series or of the variant, as it is.
    """

    declared: ViewDimension
    value: float
    start: Point
    end: Point


@dataclass(frozen=True, slots=True)
class Overall:
    """An overall dimension that no quantity gives: for reference."""

    face: Face
    side: Side
    start: Point
    end: Point

    @property
    def value(self) -> float:
        """What it measures."""
        along = 1 if self.side is Side.RIGHT else 0
        return self.end[along] - self.start[along]


@dataclass(frozen=True, slots=True)
class Labelled:
    """A label with its place and the numbers that stand in its text, lengths in mm."""

    declared: ViewLabel
    at: Point
    values: Mapping[str, float]


@dataclass(frozen=True, slots=True)
class Figure:
    """All that a general view shows, in millimetres of the thing itself.

    Attributes:
        upright: whether the axis stands upright in the main face.
        seen: strokes that nothing covers, by face.
        extents: the box round all strokes of each face that shows anything.
        cuts: faces to be hatched, by face.
        positions: parts with numbers, as they are numbered.
        measured, labelled: dimensions and labels of all faces.
        overall: what the drawn things measure over all, where no dimension says it.
        largest: the part that reaches farthest.
    """

    upright: bool
    seen: Mapping[Face, Sequence[Seen]]
    extents: Mapping[Face, Box]
    cuts: Mapping[Face, Sequence[Cut]]
    positions: Sequence[Position]
    measured: Sequence[Measured]
    labelled: Sequence[Labelled]
    overall: Sequence[Overall]
    largest: ViewPart

    @property
    def faces(self) -> tuple[Face, ...]:
        """The faces that show anything."""
        return tuple(self.extents)

    @property
    def detail(self) -> float:
        """Diameter of the smallest circle that is seen; infinite where there is none."""
        circles = (
            2 * one.stroke.radius
            for face in self.faces
            for one in self.seen[face]
            if isinstance(one.stroke, Arc) and one.stroke.is_circle
        )
        return min(circles, default=math.inf)


def figure(plan: Plan, view: View, solved: Mapping[str, float]) -> Figure:
    """Put a variant's values, in declared units, into the view of its scheme.

    Raises:
        CourseError: the main view shows nothing.
    """
    main = numbers_at(plan, view, solved, view.position)
    other = numbers_at(plan, view, solved, view.other) if view.other else main
    there = [part for part in view.parts if not part.positions or view.position in part.positions]
    drawn = [(part, list(shown(part, main))) for part in there]
    shapes = [one for _, found in drawn for one in found]
    ghosts = _ghosts(view, other)
    seen = _seen(drawn, ghosts)
    if not seen[Face.MAIN]:
        what = message("The main view shows nothing: it has no shape whose numbers have a value.")
        remedy = message("Correct what its shapes are drawn from.")
        raise CourseError([Problem(view.file, "part", what, remedy)])
    measured = [_begun(one, seen) for one in _measured(view, main, other, solved)]
    extents = {
        face: box_of(point for one in strokes for point in points_of(one.stroke))
        for face, strokes in seen.items()
        if strokes
    }
    size = max(extents[Face.MAIN].width, extents[Face.MAIN].height)
    return Figure(
        upright=view.upright,
        seen=seen,
        extents=extents,
        cuts={face: list(cut_faces(shapes, face)) for face in Face},
        positions=sorted(_positions(drawn, main, size), key=lambda one: one.mark),
        measured=measured,
        labelled=list(_labelled(view, main)),
        overall=[*_overall(seen, measured), *_overall_there(ghosts, seen, measured)],
        largest=max(drawn, key=_size)[0],
    )


def _ghosts(view: View, other: Numbers) -> list[Shown]:
    """Return the edges of what moves where it stands in the other position."""
    moving = [part for part in view.parts if part.moves and view.other]
    edges = [one for part in moving for one in shown(part, other) if one.kind is LineKind.OUTLINE]
    return [as_other(one) for one in edges]


def _seen(
    drawn: Sequence[tuple[ViewPart, Sequence[Shown]]], ghosts: Sequence[Shown]
) -> dict[Face, list[Seen]]:
    """Return what is seen of each face; from the end the parts lie in the opposite order."""
    shapes = [one for _, found in drawn for one in found]
    from_behind = [one for _, found in reversed(drawn) for one in found]
    return {
        face: list(_visible([*ghosts, *(from_behind if face is Face.END else shapes)], face))
        for face in Face
    }


def _visible(shapes: Sequence[Shown], face: Face) -> Iterator[Seen]:
    """Yield what later shapes leave to be seen of each; axes are never covered."""
    here = [one for one in shapes if one.face is face]
    for number, one in enumerate(here):
        left: list[Stroke] = list(one.outline.strokes)
        lost: list[Stroke] = []
        for cover in here[number + 1 :] if one.kind not in _NEVER_COVERED else ():
            if cover.outline.mask:
                if one.hidden_edges:
                    lost += [piece for stroke in left for piece in _lost(stroke, cover)]
                left = [piece for stroke in left for piece in _left(stroke, cover)]
        yield from (Seen(stroke, one.kind) for stroke in left)
        yield from (Seen(stroke, LineKind.HIDDEN) for stroke in lost)
        yield from (Seen(stroke, LineKind.CENTRE) for stroke in one.outline.axes)


def _left(stroke: Stroke, cover: Shown) -> Iterator[Stroke]:
    if reach_of(stroke).overlaps(cover.box.grown(_NEAR)):
        yield from outside(stroke, cover.outline.mask)
    else:
        yield stroke


def _lost(stroke: Stroke, cover: Shown) -> Iterator[Stroke]:
    if reach_of(stroke).overlaps(cover.box.grown(_NEAR)):
        yield from covered(stroke, cover.outline.mask)


def _positions(
    drawn: Sequence[tuple[ViewPart, Sequence[Shown]]], numbers: Numbers, size: float
) -> Iterator[Position]:
    for order, (part, shapes) in enumerate(drawn):
        mark = numbers.point(part.mark) if part.title is not None else None
        if mark is None or not shapes:
            continue
        solid = replace(part, shapes=tuple(one for one in part.shapes if not one.void))
        later = [one for _, found in drawn[order + 1 :] for one in found]
        mark = seen_mark(mark, list(shown(solid, numbers)), later, size)
        count = numbers.number(part.count, "") if part.count is not None else None
        usual = 2 if part.mirrored else 1
        yield Position(part, usual if count is None else round(count), mark)


def _measured(
    view: View, main: Numbers, other: Numbers, solved: Mapping[str, float]
) -> Iterator[Measured]:
    for one in view.dimensions:
        numbers = other if one.at_other else main
        start, end = numbers.point(one.start), numbers.point(one.end)
        if start is not None and end is not None and one.quantity in numbers.values:
            value = solved[one.quantity]
            is_computed = numbers.plan.quantities[one.quantity].kind is Kind.FORMULA
            yield Measured(one, round(value, 1) if is_computed else value, start, end)


def _size(one: tuple[ViewPart, Sequence[Shown]]) -> float:
    points = [
        point for shape in one[1] for stroke in shape.outline.strokes for point in points_of(stroke)
    ]
    box = box_of(points or [(0.0, 0.0)])
    return max(box.width, box.height)


def _begun(one: Measured, seen: Mapping[Face, Sequence[Seen]]) -> Measured:
    """Let the extension lines of a dimension begin at lines of the drawing."""
    strokes, side = [line.stroke for line in seen[one.declared.face]], one.declared.side
    return replace(one, start=begun(one.start, side, strokes), end=begun(one.end, side, strokes))


def _overall(
    seen: Mapping[Face, Sequence[Seen]], measured: Sequence[Measured]
) -> Iterator[Overall]:
    """Yield length and height of the main face, and the width of another one.

    What a plan measures along the axis need not be said again above it.
    """
    for face, side in (
        (Face.MAIN, Side.BELOW),
        (Face.MAIN, Side.RIGHT),
        (Face.END, Side.BELOW),
        (Face.PLAN, Side.RIGHT),
    ):
        edges = [one.stroke for one in seen[face] if one.kind is LineKind.OUTLINE]
        if edges:
            found = Overall(face, side, *reach(edges, side))
            if not any(_is_same(found, one) for one in measured):
                yield found


def _overall_there(
    ghosts: Sequence[Shown], seen: Mapping[Face, Sequence[Seen]], measured: Sequence[Measured]
) -> Iterator[Overall]:
    """Yield the height of what moves in the other position, where it reaches beyond all else."""
    moved = [one for shape in ghosts if shape.face is Face.MAIN for one in shape.outline.strokes]
    edges = [one.stroke for one in seen[Face.MAIN] if one.kind is LineKind.OUTLINE]
    if moved and edges:
        found = Overall(Face.MAIN, Side.RIGHT, *reach(moved, Side.RIGHT))
        held = Overall(Face.MAIN, Side.RIGHT, *reach(edges, Side.RIGHT))
        beside = [one.value for one in measured if one.declared.side is Side.RIGHT]
        if found.value > max([held.value, *beside]) + _TOLERANCE:
            yield found


def _is_same(overall: Overall, one: Measured) -> bool:
    upright = {Side.LEFT, Side.RIGHT}
    same_way = (one.declared.side in upright) == (overall.side in upright)
    return (
        same_way
        and (one.declared.face is overall.face or one.declared.face is Face.PLAN)
        and abs(one.value - overall.value) < _TOLERANCE
    )


def _labelled(view: View, numbers: Numbers) -> Iterator[Labelled]:
    for one in view.labels:
        at = numbers.point(one.at)
        units = {name: _unit(source, view, numbers) for name, source in one.values.items()}
        found = {
            name: float(numbers.values[source]) / factor(units[name])
            for name, source in one.values.items()
            if source in numbers.values
        }
        if at is not None and len(found) == len(one.values):
            yield Labelled(one, at, found)


def _unit(name: str, view: View, numbers: Numbers) -> str:
    measure = view.measures.get(name)
    return measure.unit if measure is not None else numbers.plan.quantities[name].unit
