"""Dimension rules of functions: what they accept and what they give."""

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import TypeAlias

from gripcourse.formula.fault import FormulaFault
from gripcourse.formula.tree import Call, Node
from gripcourse.text.units import PLAIN, Dimension, dimension, dimension_text
from gripcourse.text.words import LANGUAGES, Message, Texts, message

Measured: TypeAlias = Dimension | None
"""What an expression measures; None for the number 0, which fits everything."""

ColumnDimensions: TypeAlias = tuple[Dimension, Dimension]
"""Of the size column of a catalogue, and of the column that is looked up."""

Rule: TypeAlias = Callable[[Call, Sequence[Measured], ColumnDimensions | None], Measured]
"""From a call, its arguments and its column to what it gives; raises `FormulaFault`."""


def spoken(measured: Measured) -> Message | Texts:
    """Name a dimension by a unit that a person knows."""
    if measured is None or measured.dimensionless:
        return message("a plain number")
    return Texts({language: dimension_text(measured, language) for language in LANGUAGES})


def common(nodes: Sequence[Node], found: Sequence[Measured], where: Message | str) -> Measured:
    """Return the one dimension that several operands share.

    Raises:
        FormulaFault: two of them differ; the caret stands under the second.
    """
    shared: Measured = None
    for node, measured in zip(nodes, found, strict=True):
        if shared is not None and measured is not None and shared != measured:
            what = message(
                "{where} needs like with like, but here {first} stands against {second}.",
                where=where,
                first=spoken(shared),
                second=spoken(measured),
            )
            raise FormulaFault(what, node.span)
        shared = measured if shared is None else shared
    return shared


def alike(power: Fraction = Fraction(1)) -> Rule:
    """Take arguments of one dimension, give that dimension to a power."""

    def rule(call: Call, found: Sequence[Measured], _column: ColumnDimensions | None) -> Measured:
        shared = common(call.arguments, found, f"{call.function}()")
        return None if shared is None and power else (shared or PLAIN) ** power

    return rule


def of_units(wanted: Sequence[str], given: str) -> Rule:
    """Take arguments measured in given units, the last one repeating, and give a unit.

    `of_units(("N", "m"), "Pa")` is the rule of a function from a force and a length to a pressure.
    """

    def rule(call: Call, found: Sequence[Measured], _column: ColumnDimensions | None) -> Measured:
        for index, (node, measured) in enumerate(zip(call.arguments, found, strict=True)):
            needed = dimension(wanted[min(index, len(wanted) - 1)])
            _demand(call, node, measured, needed)
        return dimension(given)

    return rule


plain: Rule = of_units(("",), "")
"""Take plain numbers, angles among them, and give one."""


def size_of_value(
    call: Call, found: Sequence[Measured], column: ColumnDimensions | None
) -> Measured:
    """Take a value of the column, give a size of the catalogue."""
    size, value = _columns(column)
    _demand(call, call.arguments[0], found[0], value)
    return size


def value_of_size(
    call: Call, found: Sequence[Measured], column: ColumnDimensions | None
) -> Measured:
    """Take a size of the catalogue, give a value of the column."""
    size, value = _columns(column)
    _demand(call, call.arguments[0], found[0], size)
    return value


def _columns(column: ColumnDimensions | None) -> ColumnDimensions:
    if column is None:
        raise TypeError("a catalogue function was called without its column")
    return column


def _demand(call: Call, node: Node, measured: Measured, needed: Dimension) -> None:
    if measured is None or measured == needed:
        return
    what = message(
        "{name}() needs {needed} here, not {found}.",
        name=call.function,
        needed=spoken(needed),
        found=spoken(measured),
    )
    raise FormulaFault(what, node.span)
