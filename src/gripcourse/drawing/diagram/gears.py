"""Toothed parts and screws. The pitch lines are to scale; teeth too small to print are coarser."""

import math
from collections.abc import Iterator
from typing import Final

from gripcourse.drawing.diagram.joints import JOINT, edge
from gripcourse.drawing.diagram.marks import (
    ArcMark,
    Mark,
    Mask,
    Path,
    angle_of,
    between,
    place,
    polar,
)
from gripcourse.drawing.diagram.places import PlacedElement
from gripcourse.drawing.paper.document import LineKind

_LEAST_MODULE: Final = 0.7  # mm of paper
_ROOT: Final = 1.25  # modules from the pitch line to the bottom of the teeth
# A tooth about its middle: shares of the pitch, modules above the pitch line.
_TOOTH: Final = ((-0.35, -_ROOT), (-0.15, 1.0), (0.15, 1.0), (0.35, -_ROOT))
_LAND: Final = 0.15  # of a pitch, between the last tooth of a sector and its edge
_NEAR: Final = 1e-6
_BACK: Final = 2.0  # modules of a rack behind its pitch line, at least
_THREAD: Final = 2.2  # pitch of the drawn thread
_THREAD_LINE: Final = 0.8  # of its width
_COIL: Final = 1.3  # radius of a spring


def _module(shape: PlacedElement) -> float:
    return max(shape.lengths["module"], _LEAST_MODULE)


def rack(shape: PlacedElement) -> Iterator[Mark]:
    """Draw a rack along its pitch line, teeth on the left or right side of it.

    Of three points the inner one is where a gear meshes: a tooth stands there.
    """
    start, end = shape.through[0], shape.through[-1]
    module, turn = _module(shape), angle_of(start, end)
    up = 1 if shape.element.words["side"] == "left" else -1
    length, pitch = math.dist(start, end), math.pi * module
    at = math.dist(start, shape.through[1]) if len(shape.through) > len((start, end)) else 0.0
    teeth = [(x, up * height * module) for x, height in _teeth(0.0, length, pitch, at)]
    back = -up * max(shape.lengths["thick"], _BACK * module)
    foot = -up * _ROOT * module
    outline = [(0.0, foot), *teeth, (length, foot), (length, back), (0.0, back)]
    yield Path(place(outline, start, turn), edge(shape), closed=True)
    yield Mask(place(outline, start, turn))
    yield Path((start, end), LineKind.CENTRE)


def _teeth(start: float, end: float, pitch: float, at: float) -> Iterator[tuple[float, float]]:
    """Yield the corners of the teeth between two ends, one of which stands at a place."""
    half = _TOOTH[-1][0]
    first = math.ceil((start - at) / pitch + half)
    last = math.floor((end - at) / pitch - half)
    for number in range(first, last + 1):
        yield from ((at + (number + share) * pitch, height) for share, height in _TOOTH)


def gear(shape: PlacedElement) -> Iterator[Mark]:
    """Draw a gear, or the sector from `start` over `sweep`.

    Where it meshes, at the angle `mesh`, it has a gap; with `tooth` a tooth, for a second gear.
    """
    centre, radius, sweep = shape.at, shape.lengths["radius"], shape.angles["sweep"]
    start, module = shape.angles["start"], min(_module(shape), radius / 4)
    pitch = math.pi * module / radius
    is_whole = abs(sweep) > math.tau - pitch / 2
    if is_whole:  # as many teeth as give a gap on both sides
        pitch = math.tau / max(4, 2 * round(math.pi / pitch))
    at = shape.angles.get("mesh", start)
    if shape.element.words["has"] == "gap":
        at += pitch / 2
    end = start + (math.tau - _NEAR if is_whole else sweep)
    teeth = list(_teeth(start, end, pitch, at))
    corners = [polar(centre, radius + height * module, turn) for turn, height in teeth]
    if is_whole:
        yield Path(tuple(corners), edge(shape), closed=True)
    else:
        # A sector ends beside its last teeth: what is left of a pitch would look like a lug.
        root, land = radius - _ROOT * module, _LAND * pitch
        ends = (teeth[0][0] - land, teeth[-1][0] + land) if teeth else (start, end)
        outline = (polar(centre, root, ends[0]), *corners, polar(centre, root, ends[1]))
        hubs = polar(centre, JOINT, ends[0]), polar(centre, JOINT, ends[1])
        yield Path((hubs[0], *outline, hubs[1]), edge(shape))
    if shape.is_main:
        yield ArcMark(centre, radius, start, sweep, LineKind.CENTRE)


def worm(shape: PlacedElement) -> Iterator[Mark]:
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


def screw(shape: PlacedElement) -> Iterator[Mark]:
    """Draw a screw: its shaft as a thick line, its thread as a wave about it."""
    start, end = shape.through[0], shape.through[-1]
    length, radius = math.dist(start, end), max(shape.lengths["diameter"] / 2, 1.2)
    yield Path((start, end), edge(shape))
    count = max(2, round(length / _THREAD))
    wave = [(k * length / (2 * count), radius * _THREAD_LINE * (-1) ** k)
            for k in range(2 * count + 1)]  # fmt: skip
    yield Path(place(wave, start, angle_of(start, end)), LineKind.THIN)


def nut(shape: PlacedElement) -> Iterator[Mark]:
    """Draw a nut on a screw that runs along `turn`."""
    half = max(shape.lengths["length"] / 2, 1.5)
    wide = max(shape.lengths["diameter"] / 2, 1.2) + 1.4
    corners = ((-half, -wide), (half, -wide), (half, wide), (-half, wide))
    yield Path(place(corners, shape.at, shape.angles["turn"]), edge(shape), closed=True)


def spring(shape: PlacedElement) -> Iterator[Mark]:
    """Draw a helical spring between two points, to scale across them where it has a diameter."""
    start, end = shape.through[0], shape.through[-1]
    turn = angle_of(start, end)
    radius = shape.lengths.get("diameter", 2 * _COIL) / 2
    bends = 2 * max(1, round(shape.numbers["coils"]))
    coils = (
        polar(between(start, end, (k + 1) / (bends + 1)), radius, turn + math.pi / 2 * (-1) ** k)
        for k in range(bends)
    )
    yield Path((start, *coils, end), LineKind.THIN)
