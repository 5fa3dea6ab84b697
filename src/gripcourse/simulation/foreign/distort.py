"""What mistakes make of formulas and of digits."""

import ast
import copy
import re
from collections.abc import Callable, Iterator
from collections.abc import Set as AbstractSet
from typing import Final

import numpy as np

from gripcourse.simulation.foreign.kinds import ForeignMistake

Change = Callable[[ast.expr], Iterator[ast.expr]]

_DEGREES: Final = 57.29577951308232
_THOUSAND: Final = 1000.0
_CIRCLES: Final = re.compile(r"diameter")
_RADII: Final = re.compile(r"radius")
_ENDS: Final = (("_min", "_max"), ("_open", "_closed"), ("_open", "_at_max"), ("_upper", "_lower"))
_OTHER_FUNCTION: Final = {"sin": "cos", "cos": "sin", "tan": "sin"}
_OF_ANGLES: Final = frozenset({"sin", "cos", "tan"})
_ANGLES: Final = frozenset({"asin", "acos", "atan", "atan2"})
_GROUP: Final = re.compile(r"(?<!\w)\(")  # brackets that are no function's
_READ: Final = frozenset({"lookup", "interpolate"})
_LEAST_FACTOR: Final = 2  # digits that two can be exchanged in


def distorted(
    tree: ast.expr, kind: ForeignMistake, known: AbstractSet[str], lengths: AbstractSet[str]
) -> list[ast.expr]:
    """Return what a mistake can make of a formula; nothing where it cannot be made.

    Args:
        tree: of the formula.
        kind: of mistake.
        known: names that the student has a number for.
        lengths: of these, those whose unit has a thousandfold that people use.
    """
    if kind is ForeignMistake.EFFICIENCY:
        return list(_rewritten(tree, _efficiency))
    if kind is ForeignMistake.RANGE_END:
        return list(_rewritten(tree, lambda node: _other_end(node, known)))
    if kind is ForeignMistake.BRACKETS:
        return list(_without_brackets(tree))
    if kind is ForeignMistake.INPUT_UNIT:
        return list(_rewritten(tree, lambda node: _input_unit(node, lengths)))
    change = _CHANGES.get(kind)
    return [] if change is None else list(_rewritten(tree, change))


def _rewritten(node: ast.expr, change: Change) -> Iterator[ast.expr]:
    """Yield the trees in which one part is changed."""
    yield from change(node)
    for field, part in ast.iter_fields(node):
        if isinstance(part, ast.expr) and field != "func":
            for new in _rewritten(part, change):
                yield _with(node, field, new)
        elif isinstance(part, list):
            for place, one in enumerate(part):
                if isinstance(one, ast.expr):
                    for new in _rewritten(one, change):
                        yield _with(node, field, [*part[:place], new, *part[place + 1 :]])


def _with(node: ast.expr, field: str, new: object) -> ast.expr:
    changed = copy.copy(node)
    setattr(changed, field, new)
    return changed


def _times(node: ast.expr, number: float) -> ast.expr:
    return ast.BinOp(node, ast.Mult(), ast.Constant(number))


def _degrees(node: ast.expr) -> Iterator[ast.expr]:
    match node:
        case ast.Call(ast.Name(name) as function, [argument]) if name in _OF_ANGLES:
            yield ast.Call(function, [_times(argument, _DEGREES)], [])
        case ast.Call(ast.Name(name)) if name in _ANGLES:
            yield _times(node, 1 / _DEGREES)


def _efficiency(node: ast.expr) -> Iterator[ast.expr]:
    match node:
        case ast.Name(name) if "efficiency" in name:
            yield ast.BinOp(ast.Constant(1), ast.Div(), node)
            yield ast.Constant(1)


def _factor(node: ast.expr) -> Iterator[ast.expr]:
    match node:
        case ast.BinOp(ast.Constant(int() | float()), ast.Mult(), other):
            yield other
        case ast.BinOp(other, ast.Mult() | ast.Div(), ast.Constant(int() | float())):
            yield other
        case ast.BinOp(ast.Constant(int() | float()), ast.Div(), other):
            yield ast.BinOp(ast.Constant(1), ast.Div(), other)


def _power(node: ast.expr) -> Iterator[ast.expr]:
    match node:
        case ast.BinOp(base, ast.Pow()):
            yield base
        case ast.Call(ast.Name("sqrt" | "cbrt"), [argument]):
            yield argument


def _sign(node: ast.expr) -> Iterator[ast.expr]:
    match node:
        case ast.BinOp(left, ast.Add(), right):
            yield ast.BinOp(left, ast.Sub(), right)
        case ast.BinOp(left, ast.Sub(), right):
            yield ast.BinOp(left, ast.Add(), right)


def _radius(node: ast.expr) -> Iterator[ast.expr]:
    match node:
        case ast.Name(name) if _CIRCLES.search(name):
            yield _times(node, 0.5)
        case ast.Name(name) if _RADII.search(name):
            yield _times(node, 2)


def _other_end(node: ast.expr, known: AbstractSet[str]) -> Iterator[ast.expr]:
    match node:
        case ast.Name(name):
            for one, other in (*_ENDS, *((right, left) for left, right in _ENDS)):
                there = name.removesuffix(one) + other
                if name.endswith(one) and there in known:
                    yield ast.Name(there)


def _mean(node: ast.expr) -> Iterator[ast.expr]:
    match node:
        case ast.Call(ast.Name("max" | "min"), [_, _, *_] as arguments):
            yield ast.Call(ast.Name("mean"), arguments, [])


def _row(node: ast.expr) -> Iterator[ast.expr]:
    match node:
        case ast.Call(ast.Name(name), [ast.Constant(str()), _] as arguments) if name in _READ:
            for side in ("before", "after"):
                yield ast.Call(ast.Name(f"{name}_row_{side}"), arguments, [])


def _function(node: ast.expr) -> Iterator[ast.expr]:
    match node:
        case ast.Call(ast.Name(name), [argument]) if name in _OTHER_FUNCTION:
            yield ast.Call(ast.Name(_OTHER_FUNCTION[name]), [argument], [])


def _input_unit(node: ast.expr, lengths: AbstractSet[str]) -> Iterator[ast.expr]:
    match node:
        case ast.Name(name) if name in lengths:
            yield _times(node, _THOUSAND)
            yield _times(node, 1 / _THOUSAND)


def _ratio(node: ast.expr) -> Iterator[ast.expr]:
    """The angle's own function is forgotten, and its ratio written down as degrees."""
    match node:
        case ast.Call(ast.Name("asin" | "acos" | "atan"), [ratio]):
            yield _times(ratio, 1 / _DEGREES)
        case ast.Call(ast.Name("atan2"), [rise, run]):
            yield _times(ast.BinOp(rise, ast.Div(), run), 1 / _DEGREES)


def _without_brackets(tree: ast.expr) -> Iterator[ast.expr]:
    """Yield what is computed where a pair of brackets is not keyed in."""
    text = ast.unparse(tree)
    for found in _GROUP.finditer(text):
        last = _closing(text, found.start())
        flat = f"{text[: found.start()]}{text[found.end() : last]}{text[last + 1 :]}"
        other = ast.parse(flat, mode="eval").body
        if ast.dump(other) != ast.dump(tree):
            yield other


def _closing(text: str, first: int) -> int:
    depth = 0
    for place in range(first, len(text)):
        depth += (text[place] == "(") - (text[place] == ")")
        if not depth:
            return place
    raise ValueError(text)


_CHANGES: Final = {
    ForeignMistake.DEGREES: _degrees,
    ForeignMistake.FACTOR: _factor,
    ForeignMistake.POWER: _power,
    ForeignMistake.SIGN: _sign,
    ForeignMistake.RADIUS: _radius,
    ForeignMistake.MEAN: _mean,
    ForeignMistake.TABLE_ROW: _row,
    ForeignMistake.FUNCTION: _function,
    ForeignMistake.RATIO: _ratio,
}


def wrong_digits(value: float, rng: np.random.Generator) -> float:
    """Return a number with two neighbouring digits exchanged, one digit wrong, or one lost."""
    digits = [f"{value:.6g}"]
    if "e" in digits[0]:
        digits = [f"{value:f}".rstrip("0").rstrip(".")]
    text = digits[0]
    places = [place for place, sign in enumerate(text) if sign.isdigit()]
    how = rng.random()
    if how < 0.6 and len(places) >= _LEAST_FACTOR:  # noqa: PLR2004 (shares: exchanged, wrong, lost)
        at = int(rng.integers(len(places) - 1))
        one, other = places[at], places[at + 1]
        signs = list(text)
        signs[one], signs[other] = signs[other], signs[one]
        return float("".join(signs))
    place = int(rng.choice(places))
    if how < 0.9 or len(places) < _LEAST_FACTOR:  # noqa: PLR2004 (as above)
        moved = (int(text[place]) + int(rng.choice([-1, 1, 3]))) % 10
        return float(f"{text[:place]}{moved}{text[place + 1 :]}")
    return float(text[:place] + text[place + 1 :])
