"""A formula as a spreadsheet's: cells in SI instead of names, no leading sign of equality.

Spreadsheets differ from the formula language, and from Python, in what binds closer: their unary
minus binds before a power, and powers are taken from the left. Hence more brackets than a person
would set.

Where a formula has no value, the spreadsheet shows an error. LibreOffice is laxer in two places: it
takes the real root of a negative number to the power 1/3, and knows the direction atan2(0, 0).
"""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import IntEnum
from typing import Final, assert_never

from gripcourse.formula.functions import FUNCTIONS, SLACK
from gripcourse.formula.tree import (
    CONSTANTS,
    Call,
    Formula,
    Name,
    Negation,
    Node,
    Number,
    Operation,
    walk,
)
from gripcourse.text.units import factor

_LONGEST: Final = 8192  # signs, Excel's limit


class _Binding(IntEnum):
    """How closely the parts of a piece of text hold together."""

    SUM = 0
    PRODUCT = 1
    POWER = 2
    ATOM = 3


@dataclass(frozen=True, slots=True)
class _BoundText:
    text: str
    level: _Binding

    def within(self, least: _Binding) -> str:
        """Return the text, in brackets where it holds together less closely than `least`."""
        return self.text if self.level >= least else f"({self.text})"


@dataclass(frozen=True, slots=True)
class _Sheet:
    """What stands for names and columns."""

    cells: Mapping[str, str]
    columns: Mapping[str, tuple[str, str]]


def excel_form(
    formula: Formula, unit: str, cells: Mapping[str, str], columns: Mapping[str, tuple[str, str]]
) -> str | None:
    """Write a formula as a spreadsheet computes it, in SI.

    Args:
        formula: an empirical one converts its names to its own units, and its result from `unit`.
        unit: of the quantity that the formula computes.
        cells: reference of the cell that holds each name's value in SI.
        columns: by `catalogue.column`: ranges of the sizes and of the column, in SI.

    Returns:
        The text after the sign of equality; 1 or 0 for a condition; None where a function has no
        spreadsheet form or the text is longer than a cell can hold.
    """
    calls = (node for node in walk(formula.tree) if isinstance(node, Call))
    if any(FUNCTIONS[call.function].excel is None for call in calls):
        return None
    scaled = {name: _scaled(name, cells, formula.units) for name in cells}
    piece = _written(formula.tree, _Sheet(scaled, columns))
    size = factor(unit) if formula.units else 1.0
    text = piece.text if size == 1.0 else f"{piece.within(_Binding.PRODUCT)}*{_number(size)}"
    return text if len(text) < _LONGEST else None


def _scaled(name: str, cells: Mapping[str, str], units: Mapping[str, str]) -> str:
    """Return a name's cell, divided by its unit in an empirical formula."""
    size = factor(units[name]) if name in units else 1.0
    return cells[name] if size == 1.0 else f"({cells[name]}/{_number(size)})"


def _number(value: float) -> str:
    return repr(value).upper().removesuffix(".0")


def _written(node: Node, sheet: _Sheet) -> _BoundText:
    match node:
        case Number(value):
            return _BoundText(_number(value), _Binding.ATOM)
        case Name(name):
            text = "PI()" if name in CONSTANTS else sheet.cells[name]
            return _BoundText(text, _Binding.ATOM)
        case Negation(operand):
            return _BoundText(f"(-{_written(operand, sheet).within(_Binding.ATOM)})", _Binding.ATOM)
        case Operation("+" | "-" | "*" | "/" | "**"):
            return _arithmetic(node, sheet)
        case Operation():
            return _BoundText(f"IF({_condition(node, sheet)},1,0)", _Binding.ATOM)
        case Call():
            return _call(node, sheet)
        case _:
            assert_never(node)


def _arithmetic(node: Operation, sheet: _Sheet) -> _BoundText:
    left, right = _written(node.left, sheet), _written(node.right, sheet)
    match node.operator:
        case "+" | "-" as sign:
            text = f"{left.within(_Binding.SUM)}{sign}{right.within(_Binding.PRODUCT)}"
            return _BoundText(text, _Binding.SUM)
        case "*" | "/" as sign:
            text = f"{left.within(_Binding.PRODUCT)}{sign}{right.within(_Binding.POWER)}"
            return _BoundText(text, _Binding.PRODUCT)
        case _:
            text = f"{left.within(_Binding.ATOM)}^{right.within(_Binding.ATOM)}"
            return _BoundText(text, _Binding.POWER)


def _condition(node: Node, sheet: _Sheet) -> str:
    """Write a comparison with the same slack as `evaluate`."""
    if not isinstance(node, Operation):
        raise TypeError("only comparisons are joined by 'and'")
    if node.operator == "and":
        return f"AND({_condition(node.left, sheet)},{_condition(node.right, sheet)})"
    left, right = _written(node.left, sheet).text, _written(node.right, sheet).text
    slack = f"{_number(SLACK)}*MAX(ABS({left}),ABS({right}))"
    match node.operator:
        case "<=":
            return f"({left})-({right})<={slack}"
        case ">=":
            return f"({right})-({left})<={slack}"
        case "<":
            return f"({right})-({left})>{slack}"
        case ">":
            return f"({left})-({right})>{slack}"
        case _:
            return f"ABS(({left})-({right}))<={slack}"


def _call(node: Call, sheet: _Sheet) -> _BoundText:
    template = FUNCTIONS[node.function].excel
    if template is None:
        raise TypeError(f"{node.function} has no spreadsheet form")
    arguments = [_written(argument, sheet).text for argument in node.arguments]
    sizes, values = ("", "") if node.column is None else sheet.columns[node.column]
    text = template.format(*arguments, arguments=",".join(arguments), sizes=sizes, values=values)
    return _BoundText(text, _Binding.ATOM)
