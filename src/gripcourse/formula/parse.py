"""Read a formula's text into its tree.

The text is first checked sign by sign (`signs`), which answers every foreign sign with its own
sentence; Python's own parser then gives the structure, and only what the language knows is taken
from it. Nothing is ever executed.
"""

import ast
import difflib
import math
import re
from collections.abc import Mapping
from functools import lru_cache
from itertools import pairwise
from typing import Final

from gripcourse.formula.fault import FormulaFault, caret
from gripcourse.formula.functions import FUNCTIONS, Function
from gripcourse.formula.signs import check_signs, comma, too_deep
from gripcourse.formula.tree import (
    Call,
    Formula,
    Name,
    Negation,
    Node,
    Number,
    Operation,
    Operator,
    Span,
    names,
    with_names,
)
from gripcourse.text.number_text import is_lost
from gripcourse.text.words import Message, message

__all__ = ["FormulaFault", "caret", "formula_of", "parse"]

_LONGEST: Final = 2000
_DEEPEST_TREE: Final = 100

_COLUMN: Final = re.compile(r"[A-Za-z_]\w*\.[A-Za-z_]\w*", re.ASCII)

# What books call functions that are spelt quite otherwise here.
_CALLED: Final = {"ln": "log", "tg": "tan", "arctg": "atan"}

_BINARY: Final[Mapping[type[ast.operator], Operator]] = {
    ast.Add: "+",
    ast.Sub: "-",
    ast.Mult: "*",
    ast.Div: "/",
    ast.Pow: "**",
}
_COMPARISON: Final[Mapping[type[ast.cmpop], Operator]] = {
    ast.Lt: "<",
    ast.LtE: "<=",
    ast.Gt: ">",
    ast.GtE: ">=",
    ast.Eq: "==",
}


# Schemes share parts, so that whoever reads a course meets each formula three times.
@lru_cache(maxsize=4096)
def parse(text: str) -> Node:
    """Read a formula; line breaks count as spaces.

    Raises:
        FormulaFault: the text is no formula; says what is wrong and where.
    """
    if not text.strip():
        raise FormulaFault(message("The formula is empty."), (0, len(text)))
    if len(text) > _LONGEST:
        what = message("A formula longer than {most} signs cannot be read.", most=_LONGEST)
        raise FormulaFault(what, (_LONGEST, len(text)))
    check_signs(text)
    line = re.sub(r"\s", " ", text)
    syntax = _syntax(line)
    _check_depth(syntax, line)
    return _condition(syntax, line)


def formula_of(text: str, units: Mapping[str, str]) -> Formula:
    """Read a formula whose names enter in these units.

    Raises:
        FormulaFault: the text is no formula; see `parse`.
    """
    return with_names(text, parse(text), units, _names_in(text))


@lru_cache(maxsize=4096)
def _names_in(text: str) -> tuple[str, ...]:
    return names(parse(text))


def _syntax(line: str) -> ast.expr:
    """Let Python read one line of checked words."""
    try:
        # In brackets, because a line that begins with a space is an error to Python.
        return ast.parse(f"({line})", mode="eval").body
    except SyntaxError as fault:
        place = max(0, min((fault.offset or 2) - 2, len(line.rstrip()) - 1))
        what = message("Something is missing or too much here.")
        raise FormulaFault(what, (place, place + 1)) from None
    except (RecursionError, MemoryError):  # how Python's parser refuses thousands of signs in a row
        raise FormulaFault(too_deep(), (0, 1)) from None


def _check_depth(syntax: ast.expr, line: str) -> None:
    """Refuse trees that are too deep for the recursive walks over them."""
    level: list[ast.AST] = [syntax]
    for _ in range(_DEEPEST_TREE):
        level = [child for node in level for child in ast.iter_child_nodes(node)]
        if not level:
            return
    deep = [node for node in level if isinstance(node, ast.expr)]
    if deep:
        raise FormulaFault(too_deep(), _span(deep[0], line))


def _span(node: ast.expr, line: str) -> Span:
    """Return the place of a node, which Python counts from the bracket that we added.

    Python counts bytes of UTF-8, a span counts characters.
    """
    encoded = line.encode()
    start, end = node.col_offset - 1, (node.end_col_offset or node.col_offset + 1) - 1
    return len(encoded[: max(0, start)].decode()), len(encoded[:end].decode())


def _condition(node: ast.expr, line: str) -> Node:
    """Read comparisons joined by `and`, or an expression."""
    match node:
        case ast.BoolOp(ast.And(), [first, *others]):
            joined = _comparison(first, line)
            for other in others:
                right = _comparison(other, line)
                span = (joined.span[0], right.span[1])
                joined = Operation("and", joined, right, span)
            return joined
        case ast.Compare():
            return _comparison(node, line)
        case _:
            return _expression(node, line)


def _comparison(node: ast.expr, line: str) -> Node:
    if not isinstance(node, ast.Compare):
        what = message("Only comparisons can be joined by 'and'.")
        raise FormulaFault(what, _span(node, line))
    if len(node.ops) > 1:
        what = message("Write two comparisons joined by 'and': a < b and b < c.")
        raise FormulaFault(what, _span(node, line))
    operator = _COMPARISON.get(type(node.ops[0]))
    if operator is None:
        what = message("A comparison is written with <, <=, >, >= or ==.")
        raise FormulaFault(what, _span(node, line))
    left, right = _expression(node.left, line), _expression(node.comparators[0], line)
    return Operation(operator, left, right, _span(node, line))


def _expression(node: ast.expr, line: str) -> Node:
    """Read arithmetic."""
    span = _span(node, line)
    match node:
        case ast.Constant(float() | int() as value) if not isinstance(value, bool):
            return _number(float(value), line[slice(*span)], span)
        case ast.Name(name):
            return _name(name, span)
        case ast.UnaryOp(ast.USub(), operand):
            return Negation(_expression(operand, line), span)
        case ast.BinOp(left, sign, right) if type(sign) in _BINARY:
            operator = _BINARY[type(sign)]
            return Operation(operator, _expression(left, line), _expression(right, line), span)
        case ast.Call(ast.Name() as name, arguments, []):
            return _call(name, arguments, line, span)
        case _:
            raise FormulaFault(_refusal(node), span)


def _refusal(node: ast.expr) -> Message:
    """Say why a piece of Python is not of the language."""
    match node:
        case ast.Tuple():
            return comma()
        case ast.Compare() | ast.BoolOp(ast.And()):
            return message("A comparison cannot be part of an expression.")
        case ast.BoolOp() | ast.UnaryOp(ast.Not()):
            return message("Conditions know only 'and'.")
        case ast.Constant(str()):
            return message("Text in quotation marks can only name a catalogue's column.")
        case ast.UnaryOp(ast.UAdd()):
            return message("There is nothing before this plus.")
        case _:
            return message("This is not part of the formula language.")


def _number(value: float, text: str, span: Span) -> Number:
    if not math.isfinite(value):
        raise FormulaFault(message("This number is too large."), span)
    if is_lost(text, value):
        raise FormulaFault(message("This number is too small: it would be taken as 0."), span)
    return Number(value, text, span)


def _name(name: str, span: Span) -> Name:
    if name in FUNCTIONS:
        what = message("{name} is a function and needs its arguments in brackets.", name=name)
        raise FormulaFault(what, span)
    return Name(name, span)


def _call(name: ast.Name, arguments: list[ast.expr], line: str, span: Span) -> Call:
    function = FUNCTIONS.get(name.id)
    if function is None:
        raise FormulaFault(_unknown(name.id), _span(name, line))
    column = None
    if function.reads_column:
        column, arguments = _column(function, arguments, span, line), arguments[1:]
    _check_commas(arguments, line)
    _check_count(function, len(arguments), span)
    return Call(function.name, tuple(_expression(part, line) for part in arguments), column, span)


def _unknown(name: str) -> Message:
    if name in _CALLED:
        meant = _CALLED[name]
        return message("There is no function {name}; did you mean {close}?", name=name, close=meant)
    close = difflib.get_close_matches(name, FUNCTIONS, n=1)
    if not close:
        known = ", ".join(FUNCTIONS)
        return message(
            "There is no function {name}, and a product needs its sign *. Functions are {known}.",
            name=name,
            known=known,
        )
    return message("There is no function {name}; did you mean {close}?", name=name, close=close[0])


def _column(function: Function, arguments: list[ast.expr], span: Span, line: str) -> str:
    match arguments:
        case [ast.Constant(str() as column), *_] if _COLUMN.fullmatch(column):
            return column
        case [first, *_]:
            span = _span(first, line)
    what = message(
        '{name}() needs a catalogue and its column first, as in {name}("bolts.size", x).',
        name=function.name,
    )
    raise FormulaFault(what, span)


def _check_commas(arguments: list[ast.expr], line: str) -> None:
    """Refuse 0,75 among the arguments of a function: it would be read as two numbers."""
    for one, other in pairwise(arguments):
        between = (_span(one, line)[1], _span(other, line)[0])
        digits = line[between[0] - 1 : between[0]] + line[between[1] : between[1] + 1]
        if line[slice(*between)] == "," and len(digits) == 2 and digits.isdecimal():  # noqa: PLR2004
            what = message(
                "Is this a decimal comma? Write a point, or a space between two arguments."
            )
            raise FormulaFault(what, between)


def _check_count(function: Function, count: int, span: Span) -> None:
    if function.least <= count <= function.most:
        return
    least, most = function.least, function.most
    wanted = str(least) if least == most else f"{least}…{most}"
    what = message(
        "{name}() takes {wanted} values, and here are {count}.",
        name=function.name,
        wanted=wanted,
        count=count,
    )
    raise FormulaFault(what, span)
