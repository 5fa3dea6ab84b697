"""Checking numbers beside angles and percentages: units cannot tell what such a number means."""

from collections.abc import Iterator, Mapping
from typing import Final

from gripcourse.course.quantity import Quantity
from gripcourse.errors import Problem
from gripcourse.formula.parse import caret
from gripcourse.formula.tree import Call, Formula, Name, Negation, Node, Number, Operation, walk
from gripcourse.text.units import dimension, factor, known
from gripcourse.text.words import Message, message

_OF_ANGLES: Final = frozenset({"sin", "cos", "tan"})
_EMPIRICAL: Final = frozenset({"formula", "at_least"})  # keys that `evaluated_in` is about
_SHARES: Final = frozenset({"%", "permille"})
_LIKE_WITH_LIKE: Final = frozenset({"+", "-", "<", "<=", ">", ">=", "=="})


def bare_numbers(
    one: Quantity, key: str, formula: Formula, quantities: Mapping[str, Quantity]
) -> Iterator[Problem]:
    """Yield numbers that are meant in degrees or per cent, and count as radians or shares.

    Args:
        one: the quantity that has the formula.
        key: of the formula in its declaration.
        formula: its names are known.
        quantities: what the names mean.
    """
    place = f"quantity.{one.id}.{key}"
    for part in walk(formula.tree):
        match part:
            case Call(function, (angle,), _, span) if function in _OF_ANGLES and _is_bare(angle):
                yield Problem(
                    one.file,
                    place,
                    message(
                        "A number without a unit counts as radians in {name}().", name=function
                    ),
                    message("Write degrees as 20*pi/180, or declare the angle as a quantity."),
                    caret(formula.text, span),
                )
            case Operation(sign, left, right, span) if sign in _LIKE_WITH_LIKE:
                scaled = _scaled(left, quantities) if _is_bare(right) else None
                scaled = scaled or (_scaled(right, quantities) if _is_bare(left) else None)
                if scaled is not None and scaled not in formula.units:
                    unit = quantities[scaled].unit
                    yield Problem(
                        one.file,
                        place,
                        message(
                            "'{name}' is declared in '{unit}', and enters in SI beside a number.",
                            name=scaled,
                            unit=unit,
                        ),
                        _remedy(key, scaled, unit),
                        caret(formula.text, span),
                    )


def _remedy(key: str, name: str, unit: str) -> Message:
    if key in _EMPIRICAL and unit in _SHARES:
        return message(
            "If the number is a share, declare {name} as one, without a unit: 0.05 for 5 %. Else "
            'write evaluated_in with the unit of every name, {name} = "{unit}" among them.',
            name=name,
            unit=unit,
        )
    if key in _EMPIRICAL:
        return message(
            "Write the number in SI, or evaluated_in with the unit of every name, "
            '{name} = "{unit}" among them.',
            name=name,
            unit=unit,
        )
    if unit in _SHARES:
        return message(
            "Declare {name} as a share, without a unit, and compare it with 0.05 for 5 %.",
            name=name,
        )
    return message("Write the number in SI: degrees times pi/180.")


def _is_bare(node: Node) -> bool:
    """Tell whether a piece of a formula is made of numbers alone, and is not zero."""
    parts = list(walk(node))
    numbers = [part for part in parts if isinstance(part, Number)]
    only = all(isinstance(part, Number | Negation | Operation) for part in parts)
    return only and any(part.value != 0 for part in numbers)


def _scaled(node: Node, quantities: Mapping[str, Quantity]) -> str | None:
    """Return the angle or percentage that a piece of a formula is a multiple of; else None."""
    match node:
        case Name(name) if name in quantities:
            unit = quantities[name].unit
            is_scaled = known(unit) and dimension(unit).dimensionless and factor(unit) != 1.0
            return name if is_scaled else None
        case Negation(inner):
            return _scaled(inner, quantities)
        case Operation("+" | "-", left, right):
            return _scaled(left, quantities) or _scaled(right, quantities)
        case Operation("*", left, right) if _is_bare(left) or _is_bare(right):
            return _scaled(right if _is_bare(left) else left, quantities)
        case Operation("/", left, right) if _is_bare(right):
            return _scaled(left, quantities)
        case _:
            return None
