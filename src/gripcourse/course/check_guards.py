"""Checking guards: one that the bounds imply says the same twice."""

from collections.abc import Iterator

from gripcourse.course.quantity import Quantity
from gripcourse.errors import Problem
from gripcourse.formula.tree import Name, Node, Number, Operation
from gripcourse.text.units import factor, known
from gripcourse.text.words import message


def check_guard(one: Quantity) -> Iterator[Problem]:
    """Yield a problem where every value inside the bounds satisfies the guard."""
    if is_implied(one):
        yield Problem(
            one.file,
            f"quantity.{one.id}.valid",
            message("The bounds imply this condition."),
            message("Remove it: a value outside the bounds is not carried on anyway."),
        )


def is_implied(one: Quantity) -> bool:
    """Tell whether the bounds of a quantity leave nothing for its guard to refuse."""
    if one.valid is None or not known(one.unit):
        return False
    scale = factor(one.unit)
    low, high = (bound * scale for bound in one.bounds)
    return _holds(one.valid.tree, one.id, low, high)


def _holds(tree: Node, name: str, low: float, high: float) -> bool:
    """Tell whether a condition on one name holds from low to high; False where nobody can tell."""
    match tree:
        case Operation("and", left, right):
            return _holds(left, name, low, high) and _holds(right, name, low, high)
        case Operation(">" | ">=" | "<" | "<=" as sign, Name(used), Number(limit)) if used == name:
            return _compares(sign, low, high, limit)
        case Operation(">" | ">=" | "<" | "<=" as sign, Number(limit), Name(used)) if used == name:
            return _compares(_TURNED[sign], low, high, limit)
        case _:
            return False


_TURNED = {">": "<", ">=": "<=", "<": ">", "<=": ">="}


def _compares(sign: str, low: float, high: float, limit: float) -> bool:
    match sign:
        case ">":
            return low > limit
        case ">=":
            return low >= limit
        case "<":
            return high < limit
        case _:
            return high <= limit
