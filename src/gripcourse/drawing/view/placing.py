"""Where the faces of a view and its details have room on a sheet. Millimetres of paper."""

from collections.abc import Iterator, Mapping, Sequence

import numpy as np
import shapely
from numpy.typing import NDArray

from gripcourse.course.view import Face
from gripcourse.drawing.paper.strokes import Box
from gripcourse.drawing.paper.text import Point

Boxes = NDArray[np.float64]  # shape (n, 4): left, bottom, right, top
Points = NDArray[np.float64]  # shape (n, 2)

BETWEEN = 12.0  # between two faces
MARGIN = 4.0  # from a face to the frame and to tables
_ACROSS, _UP = 12, 16  # places that are tried in a row and in a column
_APART = 14.0  # from a detail to anything else, where there is as much room
_NOTHING = 1e-6
_NEIGHBOURS = ((-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0))


def whole(boxes: Sequence[Box]) -> Box:
    """Return the box round boxes."""
    found = boxes[0]
    for one in boxes[1:]:
        found = found.joined(one)
    return found


def area_of(boxes: Sequence[Box], taken: Sequence[Box]) -> float:
    """Return the area that boxes cover together, less what is taken by something else, mm²."""
    covered, away = (shapely.union_all(shapely.box(*_array(some).T)) for some in (boxes, taken))
    return float(shapely.difference(covered, away).area)


def placements(
    faces: Mapping[Face, Sequence[Box]], room: Box, taken: Sequence[Box]
) -> list[Mapping[Face, Point]]:
    """Return where faces may lie, the best in the middle first, then one towards each corner.

    The end view stands on the right of the main one at its height, the plan below it.

    Args:
        faces: boxes of all that each is made of, round its origin.
        room: that nothing may leave.
        taken: what nothing may lie on.
    """
    main = whole(faces[Face.MAIN])
    grid = _grid(main, room, taken)
    free = grid[_is_free(_array(faces[Face.MAIN]), grid, room, taken)]
    found: list[tuple[Points, dict[Face, Points]]] = []
    for others in _with_others(faces, main, free, room):
        fits = np.ones(len(free), dtype=np.bool_)
        for face, at in others.items():
            fits &= _is_free(_array(faces[face]), at, room, taken)
        found.append((free[fits], {face: at[fits] for face, at in others.items()}))
    rows = [(at, {Face.MAIN: at} | others) for at, others in found if len(at)]
    if not rows:
        return []
    placed = [
        {face: (float(at[n, 0]), float(at[n, 1])) for face, at in one.items()}
        for at, one in rows
        for n in range(len(at))
    ]
    ordered = sorted(placed, key=lambda one: _badness(faces, one, room, taken[0]))
    corners = [
        min(placed, key=lambda one: one[Face.MAIN][0] * x + one[Face.MAIN][1] * y)
        for x, y in _NEIGHBOURS
    ]
    return [ordered[0], *corners]


def spot(box: Box, room: Box, taken: Sequence[Box]) -> Point | None:
    """Return where a box may lie: as free as need be, then as high as can be; None for nowhere."""
    at = _grid(box, room, ())
    one = _array([box])
    at = at[_is_free(one, at, room, taken)]
    if not len(at):
        return None
    apart = np.minimum(_gaps(one[0] + at[:, [0, 1, 0, 1]], _array(taken)).min(axis=1), _APART)
    best = np.lexsort((at[:, 0], -at[:, 1], -apart))[0]
    return float(at[best, 0]), float(at[best, 1])


def _array(boxes: Sequence[Box]) -> Boxes:
    return np.array([(one.left, one.bottom, one.right, one.top) for one in boxes]).reshape(-1, 4)


def _grid(box: Box, room: Box, taken: Sequence[Box]) -> Points:
    """Return the places that are tried: evenly spread, and close to what is taken."""
    over = [one.top + MARGIN - box.bottom for one in taken]
    under = [one.bottom - MARGIN - box.top for one in taken]
    beside = [one.left - MARGIN - box.right for one in taken]
    behind = [one.right + MARGIN - box.left for one in taken]
    across = _spread(room.left - box.left, room.right - box.right, _ACROSS, [*beside, *behind])
    up = _spread(room.bottom - box.bottom, room.top - box.top, _UP, [*over, *under])
    return np.array([(x, y) for x in across for y in up]).reshape(-1, 2)


def _spread(low: float, high: float, steps: int, also: Sequence[float]) -> list[float]:
    if high < low:
        return []
    even = [low + (high - low) * step / steps for step in range(steps + 1)]
    return [*even, *(one for one in also if low <= one <= high)]


def _is_free(boxes: Boxes, at: Points, room: Box, taken: Sequence[Box]) -> NDArray[np.bool_]:
    """Tell at which places, shape (n,), boxes leave neither the room nor lie on what is taken."""
    placed = boxes[None] + at[:, None, [0, 1, 0, 1]]
    low, high = placed[..., :2].min(axis=1), placed[..., 2:].max(axis=1)
    fits = (low >= (room.left - _NOTHING, room.bottom - _NOTHING)).all(axis=1)
    fits &= (high <= (room.right + _NOTHING, room.top + _NOTHING)).all(axis=1)
    if taken:
        near = _gaps(placed, _array(taken)).min(axis=(1, 2)) < MARGIN - _NOTHING
        fits &= ~near
    return np.asarray(fits)


def _gaps(boxes: Boxes, others: Boxes) -> NDArray[np.float64]:
    """Return how far boxes are from others, along x or y, negative where they overlap."""
    one = boxes[..., None, :]
    x = np.maximum(others[:, 0] - one[..., 2], one[..., 0] - others[:, 2])
    y = np.maximum(others[:, 1] - one[..., 3], one[..., 1] - others[:, 3])
    return np.asarray(np.maximum(x, y))


def _with_others(
    faces: Mapping[Face, Sequence[Box]], main: Box, at: Points, room: Box
) -> Iterator[dict[Face, Points]]:
    """Yield where the other faces may lie: half way to the frame, or next to the main one."""
    for half in (True, False):
        found: dict[Face, Points] = {}
        if Face.END in faces:
            box = whole(faces[Face.END])
            low = at[:, 0] + main.right + BETWEEN - box.left
            far = np.maximum(low, (low + room.right - box.right) / 2)
            found[Face.END] = np.column_stack([far if half else low, at[:, 1]])
        if Face.PLAN in faces:
            box = whole(faces[Face.PLAN])
            high = at[:, 1] + main.bottom - BETWEEN - box.top
            far = np.minimum(high, (high + room.bottom - box.bottom) / 2)
            found[Face.PLAN] = np.column_stack([at[:, 0], far if half else high])
        yield found


def _badness(
    faces: Mapping[Face, Sequence[Box]], at: Mapping[Face, Point], room: Box, block: Box
) -> float:
    """Tell how far the faces lie from the middle of what the title block leaves of the sheet."""
    every = whole([whole(faces[face]).moved(place) for face, place in at.items()])
    low = block.top if every.right > block.left else room.bottom
    right = room.right if every.bottom >= block.top else block.left
    return abs(every.left + every.right - room.left - right) + abs(
        every.bottom + every.top - low - room.top
    )
