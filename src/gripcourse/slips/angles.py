"""Angles gone wrong: degrees for radians, one function for another, a ratio for its angle.

Generators as in `generic`: from a formula's surroundings to rewritten trees.
"""

import math
from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Final

from gripcourse.formula.tree import Call, Name, Negation, Node, Operation, walk
from gripcourse.slips.rewrite import everywhere, renamed, rewritings, scaled, somewhere
from gripcourse.slips.surroundings import Found, Rewritten, Surroundings

ANGLES: Final = frozenset({"deg", "rad"})
"""Units of angles."""

_IN_DEGREES: Final = 180.0 / math.pi
_DEGREE: Final = math.pi / 180.0
_OF_ANGLES: Final = frozenset({"sin", "cos", "tan"})
_GIVE_ANGLES: Final = frozenset({"asin", "acos", "atan", "atan2"})
_OTHER_FUNCTIONS: Final[Mapping[str, tuple[str, ...]]] = {
    "sin": ("cos", "tan"),
    "cos": ("sin", "tan"),
    "tan": ("sin", "cos"),
    "asin": ("acos", "atan"),
    "acos": ("asin",),
    "atan": ("asin",),
}
_COMPLEMENT: Final[Mapping[str, str]] = {"sin": "cos", "cos": "sin"}


def angle_unit(around: Surroundings) -> Iterator[Rewritten]:
    """Take degrees for radians, or radians for degrees: everywhere, or in one place."""
    right = around.formula.tree
    gives_angle = around.quantity.unit in ANGLES

    def one(node: Node) -> Iterator[Found]:
        for changed in (_taken(node), _given(node) if gives_angle else node):
            if changed is not node:
                yield changed, (f"{node.span[0]}", {})

    yield Rewritten("all", everywhere(right, _taken), {})
    if gives_angle:
        yield Rewritten("given", everywhere(right, _given), {})
    used = {node.function for node in walk(right) if isinstance(node, Call)}
    if not used.isdisjoint(_OF_ANGLES) and not used.isdisjoint(_GIVE_ANGLES):
        # A calculator in radians does both: it takes degrees for radians and gives radians.
        yield Rewritten("mode", everywhere(right, lambda node: _given(_taken(node))), {})
    for tree, (detail, places) in rewritings(right, one):
        yield Rewritten(detail, tree, places)
    if not around.formula.units and not gives_angle:
        tree = _with_degrees(around, right)
        if tree != right:
            yield Rewritten("outside", tree, {})


def _taken(node: Node) -> Node:
    """Return a function of an angle whose degrees are taken for radians; others as they are."""
    if isinstance(node, Call) and node.function in _OF_ANGLES:
        return replace(node, arguments=(scaled(node.arguments[0], _IN_DEGREES),))
    return node


def _given(node: Node) -> Node:
    """Return a function that gives an angle, whose radians are taken for degrees."""
    if isinstance(node, Call) and node.function in _GIVE_ANGLES:
        return scaled(node, _DEGREE)
    return node


def _with_degrees(around: Surroundings, node: Node) -> Node:
    """Return a tree with the degrees of every angle that stands in no function, as in R·θ."""
    match node:
        case Name(name) if name in around.quantities and around.quantities[name].unit == "deg":
            return scaled(node, _IN_DEGREES)
        case Call(function) if function in _GIVE_ANGLES:
            return scaled(node, _IN_DEGREES)
        case Negation(operand):
            return replace(node, operand=_with_degrees(around, operand))
        case Operation(_, left, right):
            new = (_with_degrees(around, left), _with_degrees(around, right))
            return replace(node, left=new[0], right=new[1])
        case _:
            return node


def halved_angle(around: Surroundings) -> Iterator[Rewritten]:
    """Halve an angle once more than the formula does: everywhere, or in one place."""
    yield from _angle_times(around, 0.5)


def doubled_angle(around: Surroundings) -> Iterator[Rewritten]:
    """Take a whole angle where the formula has its half: everywhere, or in one place."""
    yield from _angle_times(around, 2.0)


def _angle_times(around: Surroundings, ratio: float) -> Iterator[Rewritten]:
    right = around.formula.tree
    for name in around.formula.names:
        quantity = around.named(Name(name))
        if quantity is not None:
            taken, places = scaled(Name(name), ratio), {"quantity": quantity}
            yield Rewritten(name, renamed(right, {name: taken}), places)
            for place, tree in somewhere(right, name, taken):
                yield Rewritten(f"{name},{place}", tree, places)


def wrong_function(around: Surroundings) -> Iterator[Rewritten]:
    """Take another function of the angle in one place, or for each other wherever they stand.

    Wherever they stand, sine and cosine are taken for each other, and the sine for the tangent.
    """

    def change(node: Node) -> Iterator[Found]:
        if not isinstance(node, Call):
            return
        for other in _OTHER_FUNCTIONS.get(node.function, ()):
            places = {"function": other, "right": node.function}
            yield replace(node, function=other), (f"{node.span[0]},{other}", places)

    def complement(node: Node) -> Node:
        if isinstance(node, Call) and node.function in _COMPLEMENT:
            return replace(node, function=_COMPLEMENT[node.function])
        return node

    def sine_for_tangent(node: Node) -> Node:
        if isinstance(node, Call) and node.function == "tan":
            return replace(node, function="sin")
        return node

    for tree, (detail, told) in rewritings(around.formula.tree, change):
        yield Rewritten(detail, tree, told)
    places = {"function": "cos, sin", "right": "sin, cos"}
    yield Rewritten("all", everywhere(around.formula.tree, complement), places)
    places = {"function": "sin", "right": "tan"}
    yield Rewritten("all,sin", everywhere(around.formula.tree, sine_for_tangent), places)


def ratio_for_angle(around: Surroundings) -> Iterator[Rewritten]:
    """Take a ratio for its angle: the sine itself, as degrees or as radians."""

    def change(node: Node) -> Iterator[Found]:
        match node:
            case Call("asin" | "acos" | "atan", (ratio,)):
                pass
            case Call("atan2", (rise, run)):
                ratio = Operation("/", rise, run)
            case _:
                return
        place, places = f"{node.span[0]}", {"quantity": node}
        yield scaled(ratio, _DEGREE), (f"{place},deg", places)
        yield ratio, (place, places)

    for tree, (detail, places) in rewritings(around.formula.tree, change):
        yield Rewritten(detail, tree, places)
