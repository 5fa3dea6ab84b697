"""Choosing sheet and scale, and putting the faces onto the sheet in projection to each other."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache

from gripcourse.course.view import Face
from gripcourse.drawing.paper.sheet import FORMATS, Format, block_box, corner_box, lines_boxes
from gripcourse.drawing.paper.strokes import Box
from gripcourse.drawing.paper.text import Point

# GOST 2.302, the largest first; as drawing : nature.
SCALES: Sequence[tuple[float, float]] = (
    (2.5, 1),
    (2, 1),
    (1, 1),
    (1, 2),
    (1, 2.5),
    (1, 4),
    (1, 5),
    (1, 10),
    (1, 15),
    (1, 20),
    (1, 25),
    (1, 40),
    (1, 50),
    (1, 75),
    (1, 100),
)
_BETWEEN = 12.0  # mm between two faces
_MARGIN = 4.0  # from a face to the frame and to the title block
_STEPS = 10  # places that are tried across the free room
_NOTHING = 1e-6
# mm of paper that the longer side of the main face takes at least; what is much reduced has more to
# show, so that it needs more, and more than the smallest sheet.
_LEAST_LENGTH, _LEAST_REDUCED = 60.0, 95.0
_REDUCED = 1 / 2.5
_LEAST_DETAIL = 0.75  # mm of paper: smaller circles cannot be told from dots
_FILLED = 0.5  # of the free field that the views take at least, if any sheet lets them


@dataclass(frozen=True, slots=True)
class Pictured:
    """What decides how large a thing has to be drawn, mm of the thing itself.

    Attributes:
        length: the longer side of its main face.
        detail: diameter of its smallest circle.
    """

    length: float
    detail: float


@dataclass(frozen=True, slots=True)
class Arranged:
    """How a sheet is used, mm.

    Attributes:
        sheet: its format.
        scale: as drawing : nature.
        origins: where the origin of each face lies.
        lines: where the characteristics stand.
        filled: how much of the field the faces take, that tables and notes leave free.
    """

    sheet: Format
    scale: tuple[float, float]
    origins: Mapping[Face, Point]
    lines: Box
    filled: float

    @property
    def factor(self) -> float:
        """Millimetres of paper for a millimetre."""
        return self.scale[0] / self.scale[1]


def arrange(
    boxes: Callable[[float], Mapping[Face, Box]], pictured: Pictured, rows: int, lines: int
) -> Arranged | None:
    """Find the smallest sheet that a thing fills and is well shown on, at the largest scale there.

    Where it fills none, the one that it fills most. Where no sheet shows its details, its size
    alone decides; else the largest scale of all.

    Args:
        boxes: gives the box of each face round its own origin, with dimensions and leaders, in
            millimetres of paper, at a scale.
        pictured: what has to be recognised.
        rows: of the parts list.
        lines: of the notes.

    Returns:
        None where no sheet has room for it at any scale.
    """
    at_scale = cache(boxes)
    found: list[Arranged] = []
    for size in FORMATS:
        there = [one for sheet in size for one in _largest(at_scale, sheet, rows, lines)]
        best = max(there, key=lambda one: (one.factor, one.filled), default=None)
        if best is None:
            continue
        found.append(best)
        if _is_shown(best, pictured) and best.filled >= _FILLED:
            return best
    for fits in (_is_shown, _is_large):
        there = [one for one in found if fits(one, pictured)]
        filled = (one for one in there if one.filled >= _FILLED)
        if there:
            return next(filled, max(there, key=lambda one: one.filled))
    return max(found, key=lambda one: one.factor, default=None)


def _is_shown(one: Arranged, pictured: Pictured) -> bool:
    return _is_large(one, pictured) and pictured.detail * one.factor >= _LEAST_DETAIL


def _is_large(one: Arranged, pictured: Pictured) -> bool:
    length = pictured.length * one.factor
    if one.factor >= _REDUCED:
        return length >= _LEAST_LENGTH
    return length >= _LEAST_REDUCED and one.sheet not in FORMATS[0]


def _largest(
    boxes: Callable[[float], Mapping[Face, Box]], sheet: Format, rows: int, lines: int
) -> Iterator[Arranged]:
    """Yield the arrangement at the largest scale that a sheet has room for, if there is one."""
    for over, under in SCALES:
        at_scale = boxes(over / under)
        for box in lines_boxes(sheet, rows, lines):
            taken = (block_box(sheet, rows), corner_box(sheet), box)
            origins = _origins(at_scale, sheet.frame.grown(-_MARGIN), taken)
            if origins is not None:
                yield Arranged(sheet, (over, under), origins, box, _filled(at_scale, sheet, taken))
                return


def _filled(boxes: Mapping[Face, Box], sheet: Format, taken: Sequence[Box]) -> float:
    free = _area(sheet.frame) - sum(map(_area, taken))
    return sum(map(_area, boxes.values())) / free


def _area(box: Box) -> float:
    return box.width * box.height


def _origins(
    boxes: Mapping[Face, Box], room: Box, taken: Sequence[Box]
) -> Mapping[Face, Point] | None:
    """Place the main face, the end on its right at its height, the plan below it."""
    main = boxes[Face.MAIN]
    if any(one.width > room.width or one.height > room.height for one in boxes.values()):
        return None
    found: list[tuple[float, Mapping[Face, Point]]] = []
    for x in _places(room.left - main.left, room.right - main.right):
        for y in _levels(main, room, taken):
            if not _is_free(main.moved((x, y)), room, taken):
                continue
            for origins in _with_others(boxes, (x, y), room):
                placed = [boxes[face].moved(at) for face, at in origins.items()]
                if all(_is_free(one, room, taken) for one in placed[1:]):
                    found.append((_badness(placed, room, taken[0]), origins))
    return min(found, key=lambda one: one[0])[1] if found else None


def _levels(main: Box, room: Box, taken: Sequence[Box]) -> Sequence[float]:
    """Return the heights that are tried: evenly spread, and close to what is taken."""
    low, high = room.bottom - main.bottom, room.top - main.top
    over = [one.top + _MARGIN - main.bottom for one in taken]
    under = [one.bottom - _MARGIN - main.top for one in taken]
    return [*_places(low, high), *(one for one in (*over, *under) if low <= one <= high)]


def _with_others(boxes: Mapping[Face, Box], at: Point, room: Box) -> list[dict[Face, Point]]:
    """Return where the other faces may lie: next to the main one, or half way to the frame."""
    main = boxes[Face.MAIN].moved(at)
    found: list[dict[Face, Point]] = [{Face.MAIN: at}]
    if Face.END in boxes:
        low = main.right + _BETWEEN - boxes[Face.END].left
        half = (low + room.right - boxes[Face.END].right) / 2
        found = [{**one, Face.END: (x, at[1])} for one in found for x in (half, low) if x >= low]
    if Face.PLAN in boxes:
        high = main.bottom - _BETWEEN - boxes[Face.PLAN].top
        half = (high + room.bottom - boxes[Face.PLAN].bottom) / 2
        found = [{**one, Face.PLAN: (at[0], y)} for one in found for y in (half, high) if y <= high]
    return found


def _places(low: float, high: float) -> Sequence[float]:
    if high < low:
        return ()
    return [low + (high - low) * step / _STEPS for step in range(_STEPS + 1)]


def _is_free(box: Box, room: Box, taken: Sequence[Box]) -> bool:
    fits = (
        room.left <= box.left + _NOTHING
        and box.right <= room.right + _NOTHING
        and room.bottom <= box.bottom + _NOTHING
        and box.top <= room.top + _NOTHING
    )
    return fits and not any(box.grown(_MARGIN).overlaps(other) for other in taken)


def _badness(placed: Sequence[Box], room: Box, block: Box) -> float:
    """Tell how far the faces lie from the middle of what the title block leaves of the sheet."""
    whole = placed[0]
    for one in placed[1:]:
        whole = whole.joined(one)
    low = block.top if whole.right > block.left else room.bottom
    right = room.right if whole.bottom >= block.top else block.left
    return abs(whole.left + whole.right - room.left - right) + abs(
        whole.bottom + whole.top - low - room.top
    )
