"""Constraints that nothing within ranges and bounds can satisfy, found before anything is drawn.

Each side of a comparison is followed through its formula from the least and greatest values of what
it uses: those of the range of a given, the bounds of everything else. What is found is at least as
wide as the truth, so that a constraint that is refused can indeed never hold.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping
from math import inf, isfinite, pi, sqrt
from typing import TypeAlias

from gripcourse.course.toml_table import Table
from gripcourse.formula.tree import (
    CONSTANTS,
    Call,
    Formula,
    Name,
    Negation,
    Node,
    Number,
    Operation,
)
from gripcourse.solver.plan import Plan
from gripcourse.text.units import factor
from gripcourse.text.words import message
from gripcourse.variants.cases import SpaceCase

Reach: TypeAlias = tuple[float, float]
"""The least and the greatest value of something."""

_ANYTHING: Reach = (-inf, inf)


def check_reach(place: Table, constraint: Formula, drawn: Iterable[tuple[Plan, SpaceCase]]) -> None:
    """Record that a constraint can never hold with some choice of options; the first is named.

    Args:
        place: its table.
        constraint: a condition.
        drawn: plans and what may be drawn for them; those that lack a quantity are passed over.
    """
    seen: set[tuple[Reach, ...]] = set()
    for plan, case in drawn:
        if not all(name in plan.quantities or name in CONSTANTS for name in constraint.names):
            continue
        declared = {name: _declared(plan, case, name) for name in constraint.names
                    if name not in CONSTANTS}  # fmt: skip
        key = tuple(declared.values())
        if key in seen:
            continue
        seen.add(key)
        known = {
            name: _scaled(one, factor(plan.quantities[name].unit)
                          / factor(constraint.units.get(name, "")))
            for name, one in declared.items()
        }  # fmt: skip
        for part in _comparisons(constraint.tree):
            if _never(part, known):
                place.add(
                    "formula",
                    message(
                        "Nothing that may be drawn satisfies this: {reaches}.",
                        reaches="; ".join(_told(plan, name, declared[name])
                                          for name in constraint.names if name in declared),
                    ),
                    message("Widen the ranges or bounds of these quantities, or loosen the"
                            " constraint."),
                )  # fmt: skip
                return


def _declared(plan: Plan, case: SpaceCase, name: str) -> Reach:
    """Return the reach of a quantity in its declared unit."""
    quantity = plan.quantities[name]
    follower = case.followers.get(name)
    values = case.given.get(name, ()) if follower is None else follower.values.values()
    if values:
        return min(values), max(values)
    if quantity.value is not None:
        return quantity.value, quantity.value
    return quantity.bounds


def _told(plan: Plan, name: str, reach: Reach) -> str:
    low, high = reach
    unit = plan.quantities[name].unit
    return f"{name} {low:g} … {high:g} {unit}".rstrip()


def _scaled(reach: Reach, by: float) -> Reach:
    return reach[0] * by, reach[1] * by


def _comparisons(tree: Node) -> Iterator[Operation]:
    match tree:
        case Operation("and", left, right):
            yield from _comparisons(left)
            yield from _comparisons(right)
        case Operation("<" | "<=" | ">" | ">=" | "=="):
            yield tree
        case _:
            return


def _never(comparison: Operation, known: Mapping[str, Reach]) -> bool:
    left, right = _reach(comparison.left, known), _reach(comparison.right, known)
    match comparison.operator:
        case "<=":
            return left[0] > right[1]
        case "<":
            return left[0] >= right[1]
        case ">=":
            return left[1] < right[0]
        case ">":
            return left[1] <= right[0]
        case _:
            return left[0] > right[1] or left[1] < right[0]


def _reach(node: Node, known: Mapping[str, Reach]) -> Reach:
    """Return the least and greatest value of a formula, or wider."""
    found = _ANYTHING
    match node:
        case Number(value):
            found = value, value
        case Name(id_):
            found = known.get(id_, (pi, pi))
        case Negation(operand):
            low, high = _reach(operand, known)
            found = -high, -low
        case Operation(operator, left, right) if operator in _OPERATIONS:
            found = _OPERATIONS[operator](_reach(left, known), _reach(right, known))
        case Call(function, arguments) if function in _FUNCTIONS:
            found = _FUNCTIONS[function]([_reach(one, known) for one in arguments])
        case _:
            pass
    return _sound(found)


def _sound(reach: Reach) -> Reach:
    """Tell nothing where infinities met and gave no number."""
    return reach if reach[0] <= reach[1] else _ANYTHING


def _added(one: Reach, other: Reach) -> Reach:
    return one[0] + other[0], one[1] + other[1]


def _taken_away(one: Reach, other: Reach) -> Reach:
    return one[0] - other[1], one[1] - other[0]


def _multiplied(one: Reach, other: Reach) -> Reach:
    if not all(isfinite(end) for end in (*one, *other)):
        return _ANYTHING
    products = [first * second for first in one for second in other]
    return min(products), max(products)


def _divided(one: Reach, other: Reach) -> Reach:
    if other[0] <= 0 <= other[1]:
        return _ANYTHING
    return _multiplied(one, (1 / other[1], 1 / other[0]))


_OPERATIONS: Mapping[str, Callable[[Reach, Reach], Reach]] = {
    "+": _added,
    "-": _taken_away,
    "*": _multiplied,
    "/": _divided,
}


def _greatest(reaches: list[Reach]) -> Reach:
    return max(one[0] for one in reaches), max(one[1] for one in reaches)


def _least(reaches: list[Reach]) -> Reach:
    return min(one[0] for one in reaches), min(one[1] for one in reaches)


def _magnitude(reaches: list[Reach]) -> Reach:
    low, high = reaches[0]
    return (0.0 if low <= 0 <= high else min(abs(low), abs(high))), max(abs(low), abs(high))


def _root(reaches: list[Reach]) -> Reach:
    low, high = reaches[0]
    return sqrt(max(low, 0.0)), sqrt(max(high, 0.0))


def _turned(_reaches: list[Reach]) -> Reach:
    return -1.0, 1.0


_FUNCTIONS: Mapping[str, Callable[[list[Reach]], Reach]] = {
    "max": _greatest,
    "min": _least,
    "abs": _magnitude,
    "sqrt": _root,
    "sin": _turned,
    "cos": _turned,
}
