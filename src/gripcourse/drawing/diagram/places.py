"""Where the joints of a diagram are on paper, at each position of the drive."""

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np

from gripcourse.course.diagram import Diagram, Element
from gripcourse.course.diagram_words import VOCABULARY, Sort
from gripcourse.course.kinematics import PositionLine
from gripcourse.drawing.paper.text import Point
from gripcourse.formula.evaluate import evaluate as evaluate_formula
from gripcourse.formula.tree import Formula
from gripcourse.solver.motion import Array, coordinates, drive_at
from gripcourse.solver.plan import Plan
from gripcourse.solver.solve import evaluate, to_si

MILLIMETRES = 1000.0  # in a metre
_STILL = ""  # the position of what does not move


@dataclass(frozen=True, slots=True)
class Stop:
    """A scheme where its drive stands still.

    Attributes:
        points: along the axis and across it, in metres.
        values: of quantities and coordinates, in SI.
    """

    points: Mapping[str, Point]
    values: Mapping[str, Array]


@dataclass(frozen=True, slots=True)
class PlacedElement:
    """An element with everything it needs to be drawn, on paper.

    Attributes:
        element: as declared.
        points: by role, mm of paper.
        stops: the first point of each role at every position of the drive, mm of paper.
        lengths: by role, mm of paper.
        angles: by role.
        numbers: by role.
        symbol: of its quantity, empty where it has none.
        is_main: whether it stands in its main position; else it is drawn in another one too.
    """

    element: Element
    points: Mapping[str, tuple[Point, ...]]
    stops: Mapping[str, tuple[Point, ...]]
    lengths: Mapping[str, float]
    angles: Mapping[str, float]
    numbers: Mapping[str, float]
    symbol: str
    is_main: bool

    @property
    def at(self) -> Point:
        """Where an element stands that has one place."""
        return self.points["at"][0]

    @property
    def through(self) -> tuple[Point, ...]:
        """The points of an element that runs through several."""
        return self.points["through"]


def stops_of(plan: Plan, diagram: Diagram, values: Mapping[str, float]) -> dict[str, Stop]:
    """Return where the joints are at every position.

    Args:
        plan: of the scheme with a variant's options.
        diagram: of the scheme.
        values: of every quantity, in declared units; what is missing is computed.

    Returns:
        The stops by position; a scheme that does not move has one.
    """
    known = to_si(plan, {name: one for name, one in values.items() if name in plan.quantities})
    solved = evaluate(plan, known).values
    return {position: _stop(plan, diagram, solved, position) for position in _positions(plan)}


def _positions(plan: Plan) -> tuple[str, ...]:
    """Return the positions of a scheme; one that does not move has a single one without name."""
    return tuple(plan.scheme.kinematics.at) if plan.scheme.kinematics is not None else (_STILL,)


def shown_positions(plan: Plan) -> tuple[str, ...]:
    """Return the positions that a diagram shows, the main one first: in thick lines."""
    own = _positions(plan)
    of_line = {
        line: [name for name, one in plan.course.positions.items() if one.line is line]
        for line in (PositionLine.THICK, PositionLine.THIN)
    }
    shown = [name for names in of_line.values() for name in names if name in own]
    return tuple(shown) or own[:1]


def positions_of(element: Element, plan: Plan) -> tuple[str, ...]:
    """Return the positions at which an element is drawn, the main one first."""
    if element.positions:
        return element.positions
    shown = shown_positions(plan)
    return shown if element.moves else shown[:1]


def _stop(plan: Plan, diagram: Diagram, solved: Mapping[str, Array], position: str) -> Stop:
    motion, values = plan.scheme.kinematics, dict(solved)
    points: dict[str, Point] = {}
    if motion is not None:
        values[motion.drive] = drive_at(motion, values, position)
        values |= coordinates(motion, solved, values[motion.drive])
        swap = -1 if diagram.axis == "y" else 1
        for name, pair in motion.points.items():
            along, across = pair[::swap]
            points[name] = float(values[along]), float(values[across])
    drawn = {
        name
        for element in diagram.elements
        if element.is_drawn(plan.options)
        for one in element.points.values()
        for name in one
    }
    for name, (x, y) in diagram.points.items():
        if name in drawn:
            points[name] = _number(plan, x, "mm", values), _number(plan, y, "mm", values)
    return Stop(points, values)


def shape_of(
    element: Element, plan: Plan, stops: Mapping[str, Stop], position: str, scale: float,
    language: str,
) -> PlacedElement:  # fmt: skip
    """Put numbers to an element.

    Args:
        element: what is drawn.
        plan: of the scheme.
        stops: see `stops_of`.
        position: at which it is drawn.
        scale: millimetres of paper for a millimetre.
        language: of the symbol.
    """
    roles = VOCABULARY[element.kind].roles
    sizes: dict[Sort, dict[str, float]] = {sort: {} for sort in Sort}
    units = {Sort.LENGTH: "mm", Sort.ANGLE: "deg", Sort.NUMBER: ""}
    for role, formula in element.sizes.items():
        sort = roles[role].sort
        if roles[role].default == "" and not stops[position].values.keys() >= set(formula.names):
            continue  # a size that this variant does not have
        sizes[sort][role] = _number(plan, formula, units[sort], stops[position].values)
    quantity = plan.quantities.get(element.quantity)

    def on_paper(name: str, where: str) -> Point:
        x, y = stops[where].points[name]
        return x * MILLIMETRES * scale, y * MILLIMETRES * scale

    return PlacedElement(
        element=element,
        points={
            role: tuple(on_paper(name, position) for name in one)
            for role, one in element.points.items()
        },
        stops={
            role: tuple(on_paper(one[0], where) for where in stops)
            for role, one in element.points.items()
        },
        lengths={role: length * MILLIMETRES * scale for role, length in sizes[Sort.LENGTH].items()},
        angles=sizes[Sort.ANGLE],
        numbers=sizes[Sort.NUMBER],
        symbol="" if quantity is None else quantity.symbol.of(language),
        is_main=position == positions_of(element, plan)[0],
    )


def is_placed(stops: Iterable[Stop]) -> bool:
    """Tell whether every joint has a place: numbers that cannot be realised have none."""
    points = [point for stop in stops for point in stop.points.values()]
    return bool(points) and all(math.isfinite(one) for point in points for one in point)


def _number(plan: Plan, formula: Formula, unit: str, values: Mapping[str, Array]) -> float:
    return float(np.asarray(evaluate_formula(formula, unit, values, plan.columns)))
