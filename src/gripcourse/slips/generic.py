"""What each kind of generic slip makes of a formula.

A generator is one record of `GENERATORS`: from a formula's surroundings to rewritten trees, each
with a detail that tells it from the others of its kind and with what fills the places of the hint.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from itertools import combinations
from types import MappingProxyType
from typing import Final, TypeAlias

from gripcourse.formula.tree import Call, Name, Negation, Node, Number, Operation
from gripcourse.policy.slips import SlipKind
from gripcourse.slips.angles import (
    ANGLES,
    angle_unit,
    doubled_angle,
    halved_angle,
    ratio_for_angle,
    wrong_function,
)
from gripcourse.slips.calculator import added_for_multiplied, brackets_left_out
from gripcourse.slips.ends import other_ends, taken_among
from gripcourse.slips.rewrite import number, renamed, rewritings, scaled, somewhere
from gripcourse.slips.surroundings import Found, Place, Rewritten, Surroundings
from gripcourse.slips.taken import counted_twice, mass_for_weight, other_row, ring_for_circle
from gripcourse.text.units import dimension, factor

Generator: TypeAlias = Callable[[Surroundings], Iterator[Rewritten]]

_CUBED: Final = 3.0
_OF_DIAMETERS: Final = (2.0, 0.5)
_POWERS_OF_TEN: Final = (10.0, 0.1, 100.0, 0.01, 1000.0, 0.001)


def _each(around: Surroundings, change: Callable[[Node], Iterator[Found]]) -> Iterator[Rewritten]:
    """Apply a change to each place of the formula."""
    for tree, (detail, places) in rewritings(around.formula.tree, change):
        yield Rewritten(detail, tree, places)


def _unit(around: Surroundings) -> Iterator[Rewritten]:
    for unit, ratio in _other_units(around, around.quantity.unit):
        places: Mapping[str, Place] = {"unit": unit, "asked": around.quantity.unit}
        yield Rewritten(unit, scaled(around.formula.tree, 1 / ratio), places)


def _other_units(around: Surroundings, unit: str) -> Iterator[tuple[str, float]]:
    """Yield other units of the same kind with their size in this one; angles are no ratios."""
    if unit not in around.slip.units:
        return
    for other in around.slip.units:
        alike = dimension(other) == dimension(unit) and (other in ANGLES) == (unit in ANGLES)
        if other != unit and alike:
            yield other, factor(other) / factor(unit)


def _power_of_ten(around: Surroundings) -> Iterator[Rewritten]:
    for power in _POWERS_OF_TEN:
        yield Rewritten(f"{power:g}", scaled(around.formula.tree, power), {"number": power})


def _input_unit(around: Surroundings) -> Iterator[Rewritten]:
    for name in around.formula.names:
        quantity = around.quantities[name]
        # By how many times the number is too large: the unit that it is in, and the one taken.
        taken: dict[float, tuple[str, str]] = {}
        others = list(_other_units(around, quantity.unit))
        for other, ratio in others:
            taken.setdefault(ratio, (quantity.unit, other))
        for other, ratio in others:
            taken.setdefault(1 / ratio, (other, quantity.unit))
        for ratio, (unit, asked) in sorted(taken.items()):
            right, larger = around.formula.tree, scaled(Name(name), ratio)
            places: dict[str, Place] = {"quantity": quantity, "unit": unit, "asked": asked}
            places["number"] = float(f"{ratio:.4g}")
            yield Rewritten(f"{name},{ratio:g}", renamed(right, {name: larger}), places)
            for place, tree in somewhere(right, name, larger):
                yield Rewritten(f"{name},{ratio:g},{place}", tree, places)


def _radius_for_diameter(around: Surroundings) -> Iterator[Rewritten]:
    """Halve or double what is round: everywhere, in one place, or all of it."""
    right = around.formula.tree
    found = ((name, around.named(Name(name))) for name in around.formula.names)
    round_ones = {name: quantity for name, quantity in found if quantity is not None}
    for name, quantity in round_ones.items():
        for ratio in _OF_DIAMETERS:
            taken = scaled(Name(name), ratio)
            places = {"quantity": quantity}
            yield Rewritten(f"{name},{ratio:g}", renamed(right, {name: taken}), places)
            for place, tree in somewhere(right, name, taken):
                yield Rewritten(f"{name},{ratio:g},{place}", tree, places)
    if len(round_ones) > 1:
        for ratio in _OF_DIAMETERS:
            all_taken: dict[str, Node] = {name: scaled(Name(name), ratio) for name in round_ones}
            places = {"quantity": next(iter(round_ones.values()))}
            yield Rewritten(f"all,{ratio:g}", renamed(right, all_taken), places)


def _left_out(
    around: Surroundings, is_left_out: Callable[[Node], Mapping[str, Place] | None], signs: str
) -> Iterator[Rewritten]:
    """Leave operands out of operations of some signs: `a*b` becomes `a`, and `b` where it may."""

    def change(node: Node) -> Iterator[Found]:
        if not isinstance(node, Operation) or node.operator not in signs:
            return
        after = is_left_out(node.right)
        if after is not None:
            yield node.left, (f"{node.right.span[0]}", after)
        before = is_left_out(node.left)
        if before is not None and node.operator in "+*":
            yield node.right, (f"{node.left.span[0]}", before)
        if before is not None and node.operator == "-":
            yield Negation(node.right), (f"{node.left.span[0]}", before)
        if before is not None and node.operator == "/":
            yield Operation("/", number(1.0), node.right), (f"{node.left.span[0]}", before)

    yield from _each(around, change)


def _quantity_left_out(around: Surroundings) -> Iterator[Rewritten]:
    def named(node: Node) -> Mapping[str, Place] | None:
        quantity = around.named(node)
        return None if quantity is None else {"quantity": quantity}

    yield from _left_out(around, named, "+-*/")


def _factor_left_out(around: Surroundings) -> Iterator[Rewritten]:
    def plain(node: Node) -> Mapping[str, Place] | None:
        if _is_of_angles(node):
            return {"quantity": node}
        quantity = around.dimensionless(node)
        return None if quantity is None else {"quantity": quantity}

    yield from _left_out(around, plain, "*/")


def _is_of_angles(node: Node) -> bool:
    """Tell whether a node is a function of an angle, its power, or the greater of two of them."""
    match node:
        case Call("sin" | "cos" | "tan"):
            return True
        case Operation("**", base, Number()):
            return _is_of_angles(base)
        case Call("max" | "min", arguments):
            return all(map(_is_of_angles, arguments))
    return False


def _number_left_out(around: Surroundings) -> Iterator[Rewritten]:
    def literal(node: Node) -> Mapping[str, Place] | None:
        match node:
            case Number(value) | Operation("**", Number(value), Number()):  # 2, and 1.4³
                return {"number": value}
            case Name("pi"):
                return {"number": "π"}
        return None

    yield from _left_out(around, literal, "*/")


def _term_left_out(around: Surroundings) -> Iterator[Rewritten]:
    yield from _left_out(around, lambda node: {"quantity": node}, "+-")


def _multiplied_for_divided(around: Surroundings) -> Iterator[Rewritten]:
    def change(node: Node) -> Iterator[Found]:
        if not isinstance(node, Operation):
            return
        right, left = around.dimensionless(node.right), around.dimensionless(node.left)
        if right is not None and node.operator in "*/":
            other = Operation("/" if node.operator == "*" else "*", node.left, node.right)
            yield other, (right.id, {"quantity": right})
        if left is not None and node.operator == "*":
            yield Operation("/", node.right, node.left), (left.id, {"quantity": left})
        if left is not None and node.operator == "/":
            below = Operation("*", node.left, node.right)
            yield Operation("/", number(1.0), below), (left.id, {"quantity": left})
        match node:
            # `a/(b·c)` typed into a calculator without the brackets.
            case Operation("/", above, Operation("*", first, last)):
                typed = Operation("*", Operation("/", above, first), last)
                yield typed, (f"brackets{node.span[0]}", {"quantity": last})

    yield from _each(around, change)


def _upside_down(around: Surroundings) -> Iterator[Rewritten]:
    """Turn a ratio over as a whole: F over P for P over F."""
    quantity = around.quantity
    if around.concerns(quantity.id) and quantity.unit in {"", "%"}:
        turned = Operation("/", number(1.0), around.formula.tree)
        yield Rewritten(quantity.id, turned, {"quantity": quantity})


def _power(around: Surroundings) -> Iterator[Rewritten]:
    def change(node: Node) -> Iterator[Found]:
        for other, end in _to_another_power(node):
            yield other, (f"{node.span[0]}{end}", {"quantity": node, "other": other})

    yield from _each(around, change)


def _to_another_power(node: Node) -> Iterator[tuple[Node, str]]:
    """Yield a power or a root without it, or with another, and what the detail ends with."""
    match node:
        case Operation("**", base, power):
            yield base, ""
            if isinstance(power, Number) and power.value == _CUBED:
                yield Operation("**", base, number(2.0)), ",2"
        case Call("sqrt", (body,)):
            yield body, ""
            yield Call("cbrt", (body,)), ",cbrt"
        case Call("cbrt", (body,)):
            yield Call("sqrt", (body,)), ""
            yield body, ",body"
        case Call("hypot", (one, other)):
            yield Operation("+", one, other), ""
        case Call("sin" | "cos" | "tan"):
            yield Operation("**", node, number(2.0)), ""


def _swapped(around: Surroundings) -> Iterator[Rewritten]:
    for one, other in combinations(around.formula.names, 2):
        first, second = around.quantities[one], around.quantities[other]
        if dimension(first.unit) == dimension(second.unit):
            tree = renamed(around.formula.tree, {one: Name(other), other: Name(one)})
            yield Rewritten(f"{one},{other}", tree, {"quantity": first, "other": second})


def _wrong_end(around: Surroundings) -> Iterator[Rewritten]:
    """Take a value at another end of its range: everywhere, in one place, or all of them."""
    tree = around.formula.tree
    named = {name: tuple(_other_ends(around, name)) for name in around.formula.names}
    ends = {name: (*others, *_taken_among(around, name)) for name, others in named.items()}
    for name, others in ends.items():
        for other in others:
            detail = name if others == (other,) else f"{name},{other}"
            yield Rewritten(detail, renamed(tree, {name: Name(other)}), _ends(around, name, other))

    def one(node: Node) -> Iterator[Found]:
        if isinstance(node, Name):
            for other in ends.get(node.id, ()):
                place = f"{node.id},{other},{node.span[0]}"
                yield Name(other), (place, _ends(around, node.id, other))

    yield from _each(around, one)
    pairs = {name: others[-1] for name, others in named.items() if others}
    if len(pairs) > 1:
        name, other = next(iter(pairs.items()))
        swapped = {one: Name(another) for one, another in pairs.items()}
        yield Rewritten("all", renamed(tree, dict(swapped)), _ends(around, name, other))


def _ends(around: Surroundings, name: str, other: str) -> Mapping[str, Place]:
    return {"quantity": around.quantities[name], "other": around.quantities[other]}


def _other_ends(around: Surroundings, name: str) -> Iterator[str]:
    """Yield the quantities that are called the same but for the ending."""
    unit = around.quantities[name].unit
    for other in other_ends(name, around.slip):
        if other in around.independent and around.quantities[other].unit == unit:
            yield other


def _taken_among(around: Surroundings, name: str) -> Iterator[str]:
    """Yield the quantities of which this one is the greatest or the least."""
    among = taken_among(name, around.quantities, around.slip)
    yield from (one for one in among if one in around.independent)


def _minimum_for_maximum(around: Surroundings) -> Iterator[Rewritten]:
    others = {"min": "max", "max": "min"}

    def change(node: Node) -> Iterator[Found]:
        if isinstance(node, Call) and node.function in others:
            yield replace(node, function=others[node.function]), (f"{node.span[0]}", {})

    yield from _each(around, change)


def _sign(around: Surroundings) -> Iterator[Rewritten]:
    def change(node: Node) -> Iterator[Found]:
        place = f"{node.span[0]}"
        match node:
            case Operation("+", left, right):
                yield Operation("-", left, right), (place, {})
            case Operation("-", left, right):
                yield Operation("+", left, right), (place, {})
            case Negation(operand):
                yield operand, (place, {})

    yield Rewritten("whole", Negation(around.formula.tree), {})
    yield from _each(around, change)


GENERATORS: Final[Mapping[SlipKind, Generator]] = MappingProxyType(
    {
        SlipKind.UNIT: _unit,
        SlipKind.POWER_OF_TEN: _power_of_ten,
        SlipKind.INPUT_UNIT: _input_unit,
        SlipKind.ANGLE_UNIT: angle_unit,
        SlipKind.RADIUS_FOR_DIAMETER: _radius_for_diameter,
        SlipKind.HALVED_ANGLE: halved_angle,
        SlipKind.DOUBLED_ANGLE: doubled_angle,
        SlipKind.GRAVITY_LEFT_OUT: _quantity_left_out,
        SlipKind.SAFETY_LEFT_OUT: _quantity_left_out,
        SlipKind.FACTOR_LEFT_OUT: _factor_left_out,
        SlipKind.NUMBER_LEFT_OUT: _number_left_out,
        SlipKind.TERM_LEFT_OUT: _term_left_out,
        SlipKind.MULTIPLIED_FOR_DIVIDED: _multiplied_for_divided,
        SlipKind.WRONG_FUNCTION: wrong_function,
        SlipKind.POWER: _power,
        SlipKind.SWAPPED: _swapped,
        SlipKind.WRONG_END: _wrong_end,
        SlipKind.MINIMUM_FOR_MAXIMUM: _minimum_for_maximum,
        SlipKind.SIGN: _sign,
        SlipKind.OTHER_ROW: other_row,
        SlipKind.MASS_FOR_WEIGHT: mass_for_weight,
        SlipKind.RING_FOR_CIRCLE: ring_for_circle,
        SlipKind.COUNTED_TWICE: counted_twice,
        SlipKind.BRACKETS: brackets_left_out,
        SlipKind.UPSIDE_DOWN: _upside_down,
        SlipKind.RATIO_FOR_ANGLE: ratio_for_angle,
        SlipKind.ADDED_FOR_MULTIPLIED: added_for_multiplied,
    }
)
