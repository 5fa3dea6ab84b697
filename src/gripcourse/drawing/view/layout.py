"""Choosing sheet and scale, and putting the faces onto the sheet in projection to each other."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache

from gripcourse.course.view import Face
from gripcourse.drawing.paper.sheet import FORMATS, Format, block_box, corner_box, lines_boxes
from gripcourse.drawing.paper.strokes import Box
from gripcourse.drawing.paper.text import Point
from gripcourse.drawing.view.placing import MARGIN, area_of, placements, spot, whole

Scale = tuple[float, float]  # drawing : nature

# GOST 2.302, the largest first.
SCALES: Sequence[Scale] = (
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
# Of details: larger ones than of the whole.
_DETAIL_SCALES: Sequence[Scale] = ((5, 1), (4, 1), *SCALES)
_MOST_ENLARGED = 10.0  # times more than has to be
_LARGEST_DETAIL = 180.0  # mm of paper: width and height
_SMALL_DETAIL = 75.0  # one whose sides are shorter is made larger where there is room
# mm of paper that the longer side of the main face takes at least; what is much reduced has more to
# show, so that it needs more, and more than the smallest sheet.
_LEAST_LENGTH, _LEAST_REDUCED = 60.0, 95.0
_REDUCED = 1 / 2.5
_LEAST_DETAIL = 0.75  # mm of paper: smaller circles cannot be told from dots
_BY_FACES = 0.36  # of it that the faces take alone: a sheet of details is no general view
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
        details: scale and origin of each detail that there is room for, by its number.
        filled: how much of the field all views take, that tables and notes leave free.
        by_faces: how much of it the faces take alone.
    """

    sheet: Format
    scale: Scale
    origins: Mapping[Face, Point]
    lines: Box
    details: Mapping[int, tuple[Scale, Point]]
    filled: float
    by_faces: float

    @property
    def factor(self) -> float:
        """Millimetres of paper for a millimetre."""
        return self.scale[0] / self.scale[1]


@dataclass(frozen=True, slots=True)
class SheetContent:
    """What is to be arranged.

    Attributes:
        faces: gives the boxes of all that each face is made of, round its own origin, in
            millimetres of paper, at a factor.
        extents: of the faces without dimensions, in millimetres of the thing itself.
        details: give the box of each detail, round its own origin, at a scale.
        enlarged: how many times larger than the faces each detail is at least.
    """

    faces: Callable[[float], Mapping[Face, Sequence[Box]]]
    extents: Sequence[Box] = ()
    details: Sequence[Callable[[Scale], Box]] = ()
    enlarged: Sequence[float] = ()


def arrange(content: SheetContent, pictured: Pictured, rows: int, lines: int) -> Arranged | None:
    """Find the smallest sheet that a thing fills and is well shown on, at the largest scale there.

    Where it fills none, the one that it fills most. Where no sheet shows its details, its size
    alone decides; else the largest scale of all.

    Args:
        content: the faces, and details of them.
        pictured: what has to be recognised.
        rows: of the parts list.
        lines: of the notes.

    Returns:
        None where no sheet has room for it at any scale.
    """
    known = replace(
        content, faces=cache(content.faces), details=[cache(one) for one in content.details]
    )
    found: list[Arranged] = []
    for size in FORMATS:
        there = [one for sheet in size for one in _largest(known, sheet, rows, lines)]
        best = max(there, key=lambda one: (one.factor, one.filled), default=None)
        if best is None:
            continue
        found.append(best)
        if _is_shown(best, pictured) and _is_filled(best):
            return best
    for fits in (_is_shown, _is_large):
        there = [one for one in found if fits(one, pictured)]
        if there:
            filled = [one for one in there if one.filled >= _FILLED]
            if filled:
                return next(filter(_is_filled, filled), max(filled, key=lambda one: one.by_faces))
            return max(there, key=lambda one: one.filled)
    return max(found, key=lambda one: one.factor, default=None)


def _is_filled(one: Arranged) -> bool:
    return one.filled >= _FILLED and one.by_faces >= _BY_FACES


def _is_shown(one: Arranged, pictured: Pictured) -> bool:
    return _is_large(one, pictured) and pictured.detail * one.factor >= _LEAST_DETAIL


def _is_large(one: Arranged, pictured: Pictured) -> bool:
    length = pictured.length * one.factor
    if one.factor >= _REDUCED:
        return length >= _LEAST_LENGTH
    return length >= _LEAST_REDUCED and one.sheet not in FORMATS[0]


def _largest(content: SheetContent, sheet: Format, rows: int, lines: int) -> Iterator[Arranged]:
    """Yield the fullest arrangement at the largest scale that a sheet has room for, if any."""
    room = sheet.frame.grown(-MARGIN)
    for scale in SCALES:
        factor = scale[0] / scale[1]
        if any(
            one.width * factor > room.width or one.height * factor > room.height
            for one in content.extents
        ):
            continue
        faces = content.faces(factor)
        boxes = [whole(one) for one in faces.values()]
        if any(one.width > room.width or one.height > room.height for one in boxes):
            continue
        found = []
        for box in lines_boxes(sheet, rows, lines):
            taken = (block_box(sheet, rows), corner_box(sheet), box)
            for origins in placements(faces, room, taken):
                there = Arranged(sheet, scale, origins, box, {}, 0.0, 0.0)
                found.append(_with_details(there, content, taken))
                if found[-1].filled >= _FILLED:
                    yield found[-1]
                    return
        if found:
            yield max(found, key=lambda one: one.filled)
            return


def _with_details(bare: Arranged, content: SheetContent, taken: Sequence[Box]) -> Arranged:
    """Add the details that there is room for, as large as it takes to fill the sheet."""
    faces = content.faces(bare.factor)
    placed = [box.moved(at) for face, at in bare.origins.items() for box in faces[face]]
    views = [whole(faces[face]).moved(at) for face, at in bare.origins.items()]
    field = bare.sheet.frame
    free = field.width * field.height - sum(one.width * one.height for one in taken)
    room = field.grown(-MARGIN)
    by_faces = area_of(views, taken) / free

    def with_scales(scales: Mapping[int, Scale]) -> Arranged:
        found: dict[int, tuple[Scale, Point]] = {}
        boxes: list[Box] = []
        for number, scale in scales.items():
            box = content.details[number](scale)
            at = spot(box, room, [*taken, *placed, *boxes])
            if at is not None:
                found[number] = scale, at
                boxes.append(box.moved(at))
        filled = area_of([*views, *boxes], taken) / free
        return replace(bare, details=found, filled=filled, by_faces=by_faces)

    choices = {
        number: _scales(box, bare.factor * content.enlarged[number])
        for number, box in enumerate(content.details)
    }
    best = with_scales({number: scales[0] for number, scales in choices.items() if scales})
    while (larger := _grown(best, choices, content, with_scales)) is not None:
        best = larger
    return best


def _grown(
    best: Arranged,
    choices: Mapping[int, Sequence[Scale]],
    content: SheetContent,
    with_scales: Callable[[Mapping[int, Scale]], Arranged],
) -> Arranged | None:
    """Make the smallest detail larger that can be and has to be; None where there is none."""
    scales = {number: scale for number, (scale, _) in best.details.items()}
    sizes = {number: _side(content.details[number](scale)) for number, scale in scales.items()}
    for number in sorted(scales, key=lambda one: sizes[one]):
        larger = choices[number][choices[number].index(scales[number]) + 1 :]
        has_to_be = best.filled < _FILLED or sizes[number] < _SMALL_DETAIL
        found = with_scales(scales | {number: larger[0]}) if larger and has_to_be else None
        if found is not None and len(found.details) == len(scales):
            return found
    return None


def _side(box: Box) -> float:
    return max(box.width, box.height)


def _scales(box: Callable[[Scale], Box], least: float) -> Sequence[Scale]:
    """Return the scales that a detail may have, the smallest first."""
    return [
        scale
        for scale in reversed(_DETAIL_SCALES)
        if 1.0 <= scale[0] / scale[1] / least <= _MOST_ENLARGED
        and _side(box(scale)) <= _LARGEST_DETAIL
    ]
