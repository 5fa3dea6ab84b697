"""The shapes of a part where they stand: repeated, mirrored, in the line that they are drawn in."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product
from typing import Final

from gripcourse.course.view import Face, Repeat, Ring, ViewPart, ViewShape
from gripcourse.drawing.paper.document import LineKind
from gripcourse.drawing.paper.strokes import (
    Arc,
    Box,
    Line,
    Stroke,
    box_of,
    flipped,
    mirrored,
    settled,
    settled_point,
)
from gripcourse.drawing.paper.text import Point
from gripcourse.drawing.view.numbers import Numbers
from gripcourse.drawing.view.outlines import Outline, outline

MOST_COPIES: Final = 60
"""Of one shape in a row: more cannot be told apart on paper."""
_FULL_TURN = 360.0
_ORIGIN = (0.0, 0.0)


@dataclass(frozen=True, slots=True)
class Shown:
    """A shape in its place.

    Attributes:
        outline: what is drawn, and what it covers.
        kind: the line that it is drawn in.
        hatch: of a cut face, else empty.
        hidden_edges: whether what is covered of it is dashed.
        face: the view that shows it.
        ring: what is hatched.
        box: round what it covers.
    """

    outline: Outline
    kind: LineKind
    hatch: str
    hidden_edges: bool
    face: Face
    ring: tuple[Point, ...]
    box: Box


@dataclass(frozen=True, slots=True)
class _Move:
    """A turn by `angle` about a point, or a shift."""

    shift: Point = _ORIGIN
    about: Point = _ORIGIN
    angle: float = 0.0


def shown(part: ViewPart, numbers: Numbers) -> Iterator[Shown]:
    """Yield the shapes of a part in the order in which they cover each other."""
    for shape in part.shapes:
        kind = LineKind[shape.line.upper()]
        for one in map(_settled, _repeated(shape, numbers)):
            for found in (one, _mirrored(one)) if _is_mirrored(part, shape) else (one,):
                bare = Outline(found.strokes, found.axes)
                outline = found if kind is LineKind.OUTLINE else bare
                yield Shown(
                    outline, kind, shape.hatch, shape.hidden_edges, shape.face, found.mask,
                    _box(outline),
                )  # fmt: skip


def _is_mirrored(part: ViewPart, shape: ViewShape) -> bool:
    return part.mirrored and not any(isinstance(one, Ring) for one in shape.repeats)


def as_other(one: Shown) -> Shown:
    """Return a shape as it stands in the other position: thin, and covering nothing."""
    plain = Outline(one.outline.strokes)
    return Shown(
        plain, LineKind.PHANTOM, hatch="", hidden_edges=False, face=one.face, ring=(),
        box=_box(plain),
    )  # fmt: skip


def _box(one: Outline) -> Box:
    return box_of(one.mask or (_ORIGIN,))


def _repeated(shape: ViewShape, numbers: Numbers) -> Iterator[Outline]:
    needs: dict[str, list[float]] = {}
    for name, written in shape.needs.items():
        found = numbers.numbers(written, "deg" if name == "angles" else "mm")
        if found is None:
            return
        needs[name] = found
    for moves in product(*(_moves(repeat, numbers) for repeat in shape.repeats)):
        one = outline(shape.kind, needs)
        for move in moves:
            one = _moved(one, move)
        yield one


def _moves(repeat: Repeat | Ring, numbers: Numbers) -> list[_Move]:
    count = numbers.number(repeat.count, "")
    place = numbers.point(repeat.about if isinstance(repeat, Ring) else repeat.step)
    if count is None or place is None:
        return []
    times = range(min(MOST_COPIES, round(count)))
    if isinstance(repeat, Ring):
        return [_Move(about=place, angle=_FULL_TURN * time / len(times)) for time in times]
    return [_Move(shift=(place[0] * time, place[1] * time)) for time in times]


def _settled(one: Outline) -> Outline:
    return Outline(
        tuple(map(settled, one.strokes)),
        tuple(map(settled, one.axes)),
        tuple(map(settled_point, one.mask)),
    )


def _moved(one: Outline, move: _Move) -> Outline:
    turn = math.radians(move.angle)

    def point(old: Point) -> Point:
        x, y = old[0] - move.about[0], old[1] - move.about[1]
        cosine, sine = math.cos(turn), math.sin(turn)
        return (
            x * cosine - y * sine + move.about[0] + move.shift[0],
            x * sine + y * cosine + move.about[1] + move.shift[1],
        )

    def stroke(old: Stroke) -> Stroke:
        if isinstance(old, Line):
            return Line(point(old.start), point(old.end))
        return Arc(point(old.centre), old.radius, old.low + move.angle, old.high + move.angle)

    return Outline(
        tuple(map(stroke, one.strokes)), tuple(map(stroke, one.axes)), tuple(map(point, one.mask))
    )


def _mirrored(one: Outline) -> Outline:
    return Outline(
        tuple(map(mirrored, one.strokes)),
        tuple(map(mirrored, one.axes)),
        tuple(map(flipped, one.mask)),
    )
