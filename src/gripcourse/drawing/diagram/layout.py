"""A diagram laid out: every mark in its place on a sheet, at the largest scale that fits."""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product
from typing import Final, TypeAlias

from gripcourse.course.diagram import Diagram, Element
from gripcourse.drawing.diagram import bodies, contacts, drives, gears, joints, measures
from gripcourse.drawing.diagram.letters import Written, bounds, strokes_of, write_letters
from gripcourse.drawing.diagram.marks import (
    Letter,
    Mark,
    Mask,
    Path,
    cut_under,
    mirrored,
    settled,
    shifted,
)
from gripcourse.drawing.diagram.places import (
    MILLIMETRES,
    PlacedElement,
    Stop,
    is_placed,
    positions_of,
    shape_of,
    stops_of,
)
from gripcourse.drawing.paper.document import LineKind
from gripcourse.drawing.paper.strokes import Box
from gripcourse.drawing.paper.text import Point
from gripcourse.solver.plan import Plan

Symbol: TypeAlias = Callable[[PlacedElement], Iterator[Mark]]
"""Draws an element."""

WIDEST: Final = 170.0  # mm
HIGHEST: Final = 95.0  # mm

# Millimetres of paper for a millimetre. A kinematic diagram needs no scale of GOST 2.302; preferred
# numbers (R20) let it fill its place, whatever the proportions of the mechanism.
SCALES: Final = tuple(float(f"{10 ** (1 - k / 20):.3g}") for k in range(81))
SYMBOLS: Final[Mapping[str, Symbol]] = {
    "link": joints.link,
    "pivot": joints.pivot,
    "pin": joints.pin,
    "fixed_pivot": joints.fixed_pivot,
    "slider": joints.slider,
    "slot": joints.slot,
    "guide": joints.guide,
    "ground": joints.ground,
    "rack": gears.rack,
    "gear": gears.gear,
    "worm": gears.worm,
    "screw": gears.screw,
    "nut": gears.nut,
    "spring": gears.spring,
    "plate": bodies.plate,
    "roller": bodies.roller,
    "contact": contacts.contact,
    "vee": contacts.vee,
    "object": bodies.held_object,
    "cup": bodies.cup,
    "coil": bodies.coil,
    "end_view": bodies.end_view,
    "cylinder": drives.cylinder,
    "floating_cylinder": drives.floating_cylinder,
    "motor": drives.motor,
    "force": measures.force,
    "moment": measures.moment,
    "length": measures.length,
    "angle": measures.angle,
    "radius": measures.radius,
    "diameter": measures.diameter,
    "letter": measures.letter,
    "joint_name": measures.joint_name,
}

_SEEN_ALONG: Final = "end_view"  # the kind of element that stands apart from all others
_APART: Final = 8.0  # mm of paper between it and them
_MARGIN: Final = 0.6
_AXIS: Final = 3.0  # how far the axis reaches beyond everything
_TRIES: Final = 4  # scales at which letters do not find room, at most
_STILL: Final = 1e-6  # mm of paper


@dataclass(frozen=True, slots=True)
class DiagramLayout:
    """A diagram in its place.

    Attributes:
        marks: lines and shapes; letters are apart.
        written: the letters.
        origin: where the origin of the kinematics is on the sheet.
        scale: millimetres of paper for a millimetre.
        width, height: of the sheet, mm; its lower left corner is the origin of the marks.
    """

    marks: tuple[Mark, ...]
    written: tuple[Written, ...]
    origin: Point
    scale: float
    width: float
    height: float


def lay_out(
    plan: Plan, values: Mapping[str, float], language: str, widest: float = WIDEST
) -> DiagramLayout | None:
    """Lay out the diagram of a variant.

    Args:
        plan: of the scheme with the variant's options.
        values: of quantities in declared units; what is missing is computed.
        language: of the symbols.
        widest: mm that it may take of the page's width; `HIGHEST` of its height.

    Returns:
        The layout; None where the scheme declares no diagram, or where the numbers give its joints
        no place.
    """
    diagram = plan.scheme.diagram
    if diagram is None:
        return None
    stops = stops_of(plan, diagram, values)
    if not is_placed(stops.values()):
        return None
    found: DiagramLayout | None = None
    crowded, largest = 0, math.inf
    views = any(one.kind == _SEEN_ALONG for one in diagram.elements)
    for scale, beside in product(_thinkable(stops, widest), (True, False) if views else (True,)):
        if scale > largest:
            continue
        marks = _marks(plan, diagram, stops, scale, language)
        marks += _seen_along(plan, diagram, stops, scale, language, marks, beside=beside)
        size = bounds(marks)
        if size.width > widest or size.height > HIGHEST:
            # What is too large shrinks no faster than the scale: symbols keep their size.
            if not views:
                largest = scale * min(widest / size.width, HIGHEST / size.height)
            continue
        laid = _with_letters(marks, scale, widest)
        if laid.width > widest or laid.height > HIGHEST:
            found = found or laid
            continue
        if all(one.is_clear for one in laid.written):
            return laid
        # Letters find room where everything else is a little smaller.
        found = laid if crowded == 0 else found
        crowded += 1
        if crowded == _TRIES:
            break
    return found


def _thinkable(stops: Mapping[str, Stop], widest: float) -> Iterator[float]:
    """Yield the scales at which the joints fit, the largest first; the last in any case."""
    points = [point for stop in stops.values() for point in stop.points.values()]
    wide, high = (
        (max(one[axis] for one in points) - min(one[axis] for one in points)) * MILLIMETRES
        for axis in (0, 1)
    )
    for scale in SCALES:
        if (wide * scale <= widest and high * scale <= HIGHEST) or scale == SCALES[-1]:
            yield scale


def _with_letters(found: list[Mark], scale: float, widest: float) -> DiagramLayout:
    """Place the letters, and everything on the smallest sheet that holds it."""
    marks = list(map(settled, found))
    drawn: list[Mark] = [mark for mark in marks if not isinstance(mark, Letter)]
    letters = [mark for mark in marks if isinstance(mark, Letter)]
    size = bounds(marks)
    room = (widest - size.width) / 2, (HIGHEST - size.height) / 2
    sheet = Box(
        size.left - room[0], size.bottom - room[1], size.right + room[0], size.top + room[1]
    )
    written = write_letters(letters, strokes_of(drawn), sheet.grown(-_MARGIN))
    drawn = [*drawn, *(mark for one in written for mark in one.marks)]
    whole = bounds(drawn)
    for one in written:
        whole = whole.joined(one.box)
    whole = whole.grown(_MARGIN)
    left, low = whole.left, whole.bottom
    return DiagramLayout(
        marks=tuple(shifted(mark, -left, -low) for mark in drawn),
        written=tuple(one.shifted(-left, -low) for one in written),
        origin=(-left, -low),
        scale=scale,
        width=whole.width,
        height=whole.height,
    )


def _marks(
    plan: Plan, diagram: Diagram, stops: Mapping[str, Stop], scale: float, language: str
) -> list[Mark]:
    """Return everything that is drawn at a scale; the main position comes last, over the other."""
    drawn: dict[bool, list[Mark]] = {False: [], True: []}
    for element in diagram.elements:
        if element.kind != _SEEN_ALONG and element.is_drawn(plan.options):
            for shape in _shapes(element, plan, stops, scale, language):
                drawn[shape.is_main] += _everywhere(shape)
    # What stands in the main position hides the lines of the other one, too.
    before = [mark for mark in drawn[True] if isinstance(mark, Mask)]
    marks = [*cut_under([*drawn[False], *before]), *cut_under(drawn[True])]
    if plan.scheme.kinematics is not None:
        size = bounds(marks)
        ends = (size.left - _AXIS, 0.0), (size.right + _AXIS, 0.0)
        marks.append(Path(ends, LineKind.CENTRE))
    return marks


def _seen_along(  # noqa: PLR0913 (as for all marks, and the others)
    plan: Plan,
    diagram: Diagram,
    stops: Mapping[str, Stop],
    scale: float,
    language: str,
    drawn: Sequence[Mark],
    *,
    beside: bool,
) -> list[Mark]:
    """Return the views along the axis, on the axis or below everything else."""
    found: list[Mark] = []
    for element in diagram.elements:
        if element.kind == _SEEN_ALONG and element.is_drawn(plan.options):
            others = bounds(drawn)
            for shape in _shapes(element, plan, stops, scale, language):
                marks = list(SYMBOLS[element.kind](shape))
                size = bounds(marks)
                right = others.right + _APART - size.left
                middle, below = (others.left + others.right) / 2, others.bottom - _APART - size.top
                at = (right, 0.0) if beside else (middle, below)
                found += [shifted(mark, *at) for mark in marks]
    return found


def _shapes(
    element: Element, plan: Plan, stops: Mapping[str, Stop], scale: float, language: str
) -> Iterator[PlacedElement]:
    """Yield an element where it is drawn; what does not move, once."""
    first: PlacedElement | None = None
    for position in positions_of(element, plan):
        shape = shape_of(element, plan, stops, position, scale, language)
        if first is None or _differ(first, shape):
            yield shape
        first = first or shape


def _differ(one: PlacedElement, other: PlacedElement) -> bool:
    return (
        any(
            abs(a - b) > _STILL
            for role, points in one.points.items()
            for point, moved in zip(points, other.points[role], strict=True)
            for a, b in zip(point, moved, strict=True)
        )
        or any(abs(a - other.lengths[role]) > _STILL for role, a in one.lengths.items())
        or any(abs(a - other.angles[role]) > _STILL for role, a in one.angles.items())
    )


def _everywhere(shape: PlacedElement) -> Iterator[Mark]:
    """Yield the marks of an element, repeated and mirrored as it is declared.

    One symbol tells what all its copies are: they have one name.
    """
    count, rows = (round(shape.numbers[role]) for role in ("repeat", "rows"))
    steps = [(column * shape.lengths["pitch"], row * shape.lengths["row_pitch"])
             for column, row in product(range(count), range(rows))]  # fmt: skip
    for mark in SYMBOLS[shape.element.kind](shape):
        copies = [one for step in steps for one in _on_sides(shifted(mark, *step), shape)]
        letters = [one for one in copies if isinstance(one, Letter)]
        if letters:
            names = tuple(thing for one in letters for thing in one.thing)
            yield replace(letters[0], names=names)
        else:
            yield from copies


def _on_sides(mark: Mark, shape: PlacedElement) -> Iterator[Mark]:
    if shape.element.mirror != "only":
        yield mark
    if shape.element.mirror != "none":
        yield mirrored(mark)
