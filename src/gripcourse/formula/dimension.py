"""What a formula measures: checked before anything is computed."""

import difflib
from collections.abc import Iterable, Mapping
from fractions import Fraction
from typing import assert_never

from gripcourse.formula.fault import FormulaFault
from gripcourse.formula.functions import FUNCTIONS
from gripcourse.formula.rules import ColumnDimensions, Measured, common, spoken
from gripcourse.formula.tree import (
    CONSTANTS,
    Call,
    Formula,
    Name,
    Negation,
    Node,
    Number,
    Operation,
    names,
    walk,
)
from gripcourse.text.units import PLAIN, Dimension, dimension, known
from gripcourse.text.words import Message, message

_COMPARISONS = frozenset({"<", "<=", ">", ">=", "=="})


def is_condition(node: Node) -> bool:
    """Tell whether a formula is a comparison, or several joined by `and`, rather than a number."""
    return isinstance(node, Operation) and node.operator in {*_COMPARISONS, "and"}


def check_dimension(
    formula: Formula,
    unit: str,
    dimensions: Mapping[str, Dimension],
    columns: Mapping[str, ColumnDimensions],
) -> None:
    """Check that a formula measures what its quantity's unit does.

    Of an empirical formula, whose constants hide units, only the units of its names are checked.

    Raises:
        FormulaFault: it does not, or is wrong in itself.
    """
    whole = (0, len(formula.text))
    if not known(unit):
        raise FormulaFault(_unknown_unit(unit), whole)
    if formula.units:
        _check_empirical(formula, dimensions)
        return
    measured = measured_by(formula.tree, dimensions, columns)
    if measured is not None and measured != dimension(unit):
        what = message(
            "The formula gives {found}, but its quantity is declared in {declared}.",
            found=spoken(measured),
            declared=spoken(dimension(unit)),
        )
        raise FormulaFault(what, whole)


def measured_by(
    node: Node, dimensions: Mapping[str, Dimension], columns: Mapping[str, ColumnDimensions]
) -> Measured:
    """Find what a node measures; None for a zero, which is a zero of anything."""
    match node:
        case Number(value):
            return PLAIN if value else None
        case Name(name):
            return _of_name(node, name, dimensions)
        case Negation(operand):
            return measured_by(operand, dimensions, columns)
        case Operation("**", left, right):
            base = measured_by(left, dimensions, columns)
            return _to_power(base, right, measured_by(right, dimensions, columns))
        case Operation(_, left, right):
            found = (
                measured_by(left, dimensions, columns),
                measured_by(right, dimensions, columns),
            )
            return _joined(node, *found)
        case Call(name, arguments, column):
            given = tuple(measured_by(argument, dimensions, columns) for argument in arguments)
            return FUNCTIONS[name].rule(node, given, _of_column(node, column, columns))
        case _:
            assert_never(node)


def _of_name(node: Name, name: str, dimensions: Mapping[str, Dimension]) -> Dimension:
    if name in CONSTANTS:
        return PLAIN
    if name not in dimensions:
        raise FormulaFault(_unknown_name(name, dimensions), node.span)
    return dimensions[name]


def _unknown_name(name: str, known_names: Iterable[str]) -> Message:
    close = difflib.get_close_matches(name, known_names, n=1)
    if not close:
        return message("There is no quantity {name}.", name=name)
    return message("There is no quantity {name}; did you mean {close}?", name=name, close=close[0])


def _of_column(
    node: Call, column: str | None, columns: Mapping[str, ColumnDimensions]
) -> ColumnDimensions | None:
    if column is None:
        return None
    if column not in columns:
        close = difflib.get_close_matches(column, columns, n=1)
        what = message("There is no catalogue column {column}.", column=column)
        if close:
            what = message(
                "There is no catalogue column {column}; did you mean {close}?",
                column=column,
                close=close[0],
            )
        raise FormulaFault(what, node.span)
    return columns[column]


def _joined(node: Operation, left: Measured, right: Measured) -> Measured:
    """Find what an operation on two measured operands gives."""
    match node.operator:
        case "*":
            return None if left is None or right is None else left * right
        case "/":
            return None if left is None else left / (right or PLAIN)
        case "and":
            return PLAIN
        case operator:
            shared = common((node.left, node.right), (left, right), f"'{operator}'")
            return PLAIN if operator in _COMPARISONS else shared


def _to_power(base: Measured, exponent: Node, power: Measured) -> Measured:
    """Find what a power gives: anything to a number, or a plain number to a plain number."""
    if power is not None and not power.dimensionless:
        what = message("An exponent is a plain number, not {found}.", found=spoken(power))
        raise FormulaFault(what, exponent.span)
    if base is None or base.dimensionless:
        return base
    number = _constant(exponent)
    if number is None:
        what = message(
            "The exponent of something in {found} must be a number that is written out.",
            found=spoken(base),
        )
        raise FormulaFault(what, exponent.span)
    return base**number


def _constant(node: Node) -> Fraction | None:
    """Compute an expression of numbers exactly; None where it uses anything else."""
    match node:
        case Number(_, text):
            return Fraction(text)
        case Negation(operand):
            value = _constant(operand)
            return None if value is None else -value
        case Operation(operator, left_node, right_node):
            left, right = _constant(left_node), _constant(right_node)
            return None if left is None or right is None else _exact(operator, left, right)
        case _:
            return None


def _exact(operator: str, left: Fraction, right: Fraction) -> Fraction | None:
    match operator:
        case "+":
            return left + right
        case "-":
            return left - right
        case "*":
            return left * right
        case "/" if right:
            return left / right
        case _:
            return None


def _check_empirical(formula: Formula, dimensions: Mapping[str, Dimension]) -> None:
    """Check that an empirical formula says in which unit each of its names enters."""
    used = names(formula.tree)
    for node in walk(formula.tree):
        if isinstance(node, Name) and node.id in used:
            _check_empirical_name(node, formula.units, dimensions)
        if isinstance(node, Call) and node.column is not None:
            what = message("An empirical formula cannot read a catalogue.")
            raise FormulaFault(what, node.span)
    for name in formula.units:
        if name not in used:
            what = message("The units name {name}, which the formula does not use.", name=name)
            raise FormulaFault(what, (0, len(formula.text)))


def _check_empirical_name(
    node: Name, units: Mapping[str, str], dimensions: Mapping[str, Dimension]
) -> None:
    measured = _of_name(node, node.id, dimensions)
    unit = units.get(node.id)
    if unit is None:
        what = message("The units of this empirical formula do not name {name}.", name=node.id)
        raise FormulaFault(what, node.span)
    if not known(unit):
        raise FormulaFault(_unknown_unit(unit), node.span)
    if dimension(unit) != measured:
        what = message(
            "{name} enters in {unit}, but it is {found}.",
            name=node.id,
            unit=spoken(dimension(unit)),
            found=spoken(measured),
        )
        raise FormulaFault(what, node.span)


def _unknown_unit(unit: str) -> Message:
    return message("The unit {unit} is not in the table of units.", unit=unit)
