"""Choosing sheet and scale, and putting the faces onto the sheet in projection to each other."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from gripcourse.course.view import Face
from gripcourse.drawing.sheet import FORMATS, Format, block_box, corner_box
from gripcourse.drawing.strokes import Box
from gripcourse.drawing.text import Point

# GOST 2.302, the largest first; as drawing : nature.
SCALES: Sequence[tuple[float, float]] = (
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
_BETWEEN = 12.0  # mm between two faces, and from a face to the frame
_MARGIN = 4.0
_STEPS = 24  # places that are tried across the free room


@dataclass(frozen=True, slots=True)
class Arranged:
    """A sheet, its scale, and where the origin of each face lies on it, mm."""

    sheet: Format
    scale: tuple[float, float]
    origins: Mapping[Face, Point]


def arrange(
    boxes: Callable[[float], Mapping[Face, Box]], rows: int, lines: int
) -> Arranged:
    """Find the largest scale at which all faces have room, on the smaller sheet if both do.

    Args:
        boxes: gives the box of each face round its own origin, with dimensions and leaders, in
            millimetres of paper, at a scale.
        rows: of the parts list.
        lines: of the characteristics.
    """
    for over, under in SCALES:
        at_scale = boxes(over / under)
        for sheet in FORMATS:
            origins = _origins(at_scale, sheet, rows, lines)
            if origins is not None:
                return Arranged(sheet, (over, under), origins)
    over, under = SCALES[-1]
    sheet = FORMATS[-1]
    middle = (sheet.width / 2, sheet.height / 2)
    return Arranged(sheet, (over, under), dict.fromkeys(boxes(over / under), middle))


def _origins(
    boxes: Mapping[Face, Box], sheet: Format, rows: int, lines: int
) -> Mapping[Face, Point] | None:
    """Place the main face, the end on its right at its height, the plan below it."""
    taken = [block_box(sheet, rows, lines), corner_box(sheet)]
    room = sheet.frame.grown(-_MARGIN)
    main = boxes[Face.MAIN]
    best: tuple[float, Mapping[Face, Point]] | None = None
    for x in _places(room.left - main.left, room.right - main.right):
        for y in _places(room.bottom - main.bottom, room.top - main.top):
            for origins in _with_others(boxes, (x, y), room):
                placed = [boxes[face].moved(at) for face, at in origins.items()]
                if not _free(placed, room, taken):
                    continue
                badness = _badness(placed, room, taken)
                if best is None or badness < best[0]:
                    best = badness, origins
    return None if best is None else best[1]


def _with_others(
    boxes: Mapping[Face, Box], at: Point, room: Box
) -> Sequence[Mapping[Face, Point]]:
    main = boxes[Face.MAIN].moved(at)
    found: list[dict[Face, Point]] = [{Face.MAIN: at}]
    if Face.END in boxes:
        first = main.right + _BETWEEN - boxes[Face.END].left
        last = room.right - boxes[Face.END].right
        found = [{**one, Face.END: (x, at[1])} for one in found for x in {first, (first + last) / 2}]
    if Face.PLAN in boxes:
        first = main.bottom - _BETWEEN - boxes[Face.PLAN].top
        last = room.bottom - boxes[Face.PLAN].bottom
        found = [{**one, Face.PLAN: (at[0], y)} for one in found for y in {first, (first + last) / 2}]
    return found


def _places(low: float, high: float) -> Sequence[float]:
    if high < low:
        return ()
    return [low + (high - low) * step / _STEPS for step in range(_STEPS + 1)]


def _free(placed: Sequence[Box], room: Box, taken: Sequence[Box]) -> bool:
    inside = all(
        room.left <= one.left + 1e-6
        and one.right <= room.right + 1e-6
        and room.bottom <= one.bottom + 1e-6
        and one.top <= room.top + 1e-6
        for one in placed
    )
    apart = not any(one.grown(_MARGIN).overlaps(other) for one in placed for other in taken)
    among = not any(
        one.overlaps(other) for number, one in enumerate(placed) for other in placed[:number]
    )
    return inside and apart and among


def _badness(placed: Sequence[Box], room: Box, taken: Sequence[Box]) -> float:
    """Prefer faces in the middle of what is left of the sheet."""
    whole = placed[0]
    for one in placed[1:]:
        whole = whole.joined(one)
    block = taken[0]
    high = block.top if whole.right > block.left else room.bottom
    wide = room.right if whole.bottom >= block.top else block.left
    return abs((whole.left + whole.right) - (room.left + wide)) + abs(
        (whole.bottom + whole.top) - (high + room.top)
    )
