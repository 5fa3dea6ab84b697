"""Toothed parts and screws. The pitch lines are to scale; teeth too small to print are coarser."""

import math
from collections.abc import Iterator
from typing import Final

from gripcourse.drawing.document import LineKind
from gripcourse.drawing.joints import JOINT, edge
from gripcourse.drawing.marks import Arc, Mark, Path, angle_of, between, place, polar
from gripcourse.drawing.places import Shape

_LEAST_MODULE: Final = 0.7  # mm of paper
_ROOT: Final = 1.25  # modules from the pitch line to the bottom of the teeth
# A tooth over one pitch: share of the pitch, modules above the pitch line.
_TOOTH: Final = ((0.0, -_ROOT), (0.15, -_ROOT), (0.35, 1.0), (0.65, 1.0), (0.85, -_ROOT))
_BACK: Final = 2.0  # modules of a rack behind its pitch line, at least
_THREAD: Final = 2.2  # pitch of the drawn thread
_THREAD_LINE: Final = 0.8  # of its width
_COILS: Final = 8
_COIL: Final = 1.3  # radius of a spring


def _module(shape: Shape) -> float:
    return max(shape.lengths["module"], _LEAST_MODULE)


def rack(shape: Shape) -> Iterator[Mark]:
    """Draw a rack along its pitch line, teeth on the left or right side of it."""
    start, end = shape.through[0], shape.through[-1]
    module, turn = _module(shape), angle_of(start, end)
    up = 1 if shape.element.words["side"] == "left" else -1
    length = math.dist(start, end)
    count = max(2, round(length / (math.pi * module)))
    pitch = length / count
    teeth = [((k + share) * pitch, up * height * module)
             for k in range(count) for share, height in _TOOTH]  # fmt: skip
    back = -up * max(shape.lengths["thick"], _BACK * module)
    outline = [*teeth, (length, -up * _ROOT * module), (length, back), (0.0, back)]
    yield Path(place(outline, start, turn), edge(shape), closed=True)
    yield Path((start, end), LineKind.CENTRE)


def gear(shape: Shape) -> Iterator[Mark]:
    """Draw a gear, or the sector from `start` over `sweep`."""
    centre, radius, sweep = shape.at, shape.lengths["radius"], shape.angles["sweep"]
    start, module = shape.angles["start"], min(_module(shape), radius / 4)
    count = max(3, round(abs(sweep) * radius / (math.pi * module)))
    step = sweep / count
    teeth = tuple(
        polar(centre, radius + height * module, start + (k + share) * step)
        for k in range(count)
        for share, height in _TOOTH
    )
    is_whole = abs(sweep) > math.tau - step / 2
    if is_whole:
        yield Path(teeth, edge(shape), closed=True)
    else:
        last = polar(centre, radius - _ROOT * module, start + sweep)
        hub = JOINT
        yield Path((polar(centre, hub, start), *teeth, last,
                    polar(centre, hub, start + sweep)), edge(shape))  # fmt: skip
    if shape.is_main:
        yield Arc(centre, radius, start, sweep, LineKind.CENTRE)


def worm(shape: Shape) -> Iterator[Mark]:
    """Draw a worm along `turn`: its cylinder with slanting threads."""
    half, radius = shape.lengths["length"] / 2, max(shape.lengths["radius"], 1.5)
    turn, at = shape.angles["turn"], shape.at
    box = ((-half, -radius), (half, -radius), (half, radius), (-half, radius))
    yield Path(place(box, at, turn), edge(shape), closed=True)
    count = max(3, round(2 * half / _THREAD))
    pitch = 2 * half / count
    for k in range(count):
        x = -half + k * pitch
        yield Path(place(((x, -radius), (x + pitch, radius)), at, turn), edge(shape))


def screw(shape: Shape) -> Iterator[Mark]:
    """Draw a screw: its shaft as a thick line, its thread as a wave about it."""
    start, end = shape.through[0], shape.through[-1]
    length, radius = math.dist(start, end), max(shape.lengths["diameter"] / 2, 1.2)
    yield Path((start, end), edge(shape))
    count = max(2, round(length / _THREAD))
    wave = [(k * length / (2 * count), radius * _THREAD_LINE * (-1) ** k)
            for k in range(2 * count + 1)]  # fmt: skip
    yield Path(place(wave, start, angle_of(start, end)), LineKind.THIN)


def nut(shape: Shape) -> Iterator[Mark]:
    """Draw a nut on a screw that runs along `turn`."""
    half = max(shape.lengths["length"] / 2, 1.5)
    wide = max(shape.lengths["diameter"] / 2, 1.2) + 1.4
    corners = ((-half, -wide), (half, -wide), (half, wide), (-half, wide))
    yield Path(place(corners, shape.at, shape.angles["turn"]), edge(shape), closed=True)


def spring(shape: Shape) -> Iterator[Mark]:
    """Draw a helical spring between two points."""
    start, end = shape.through[0], shape.through[-1]
    turn = angle_of(start, end)
    coils = (
        polar(between(start, end, (k + 1) / (_COILS + 1)), _COIL, turn + math.pi / 2 * (-1) ** k)
        for k in range(_COILS)
    )
    yield Path((start, *coils, end), LineKind.THIN)
