"""Lay a formula out as textbooks do: quotients as fractions, powers raised, roots under radicals.

The same tree is laid out with symbols and, for the substituted line, with numbers and their units;
brackets are put where what stands there needs them, so that both lines read back as one formula.
"""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import IntEnum
from typing import Final, assert_never

from gripcourse.formula.boxes import (
    Applied,
    Box,
    Fence,
    Fraction,
    Row,
    Script,
    Text,
    Value,
    boxes,
    power_box,
)
from gripcourse.formula.functions import FUNCTIONS
from gripcourse.formula.tree import Call, Name, Negation, Node, Number, Operation
from gripcourse.text.number_text import format_number

__all__ = ["Box", "declared_symbol", "equation", "number_box", "symbol_box", "typeset"]


class _Level(IntEnum):
    """How firmly a box holds together, from loose to firm."""

    CONDITION = 0
    SUM = 1
    SIGNED = 2  # begins with a minus
    PRODUCT = 3
    MEASURED = 4  # a number and its unit
    FRACTION = 5
    FIRM = 6


@dataclass(frozen=True, slots=True)
class _Piece:
    """A laid-out node and how firmly it holds together."""

    box: Box
    level: _Level


@dataclass(frozen=True, slots=True)
class _Setting:
    """What stands for the names, the reader's language, and whether fractions stay on the line."""

    names: Mapping[str, Box]
    language: str
    inline: bool = False


_PI: Final = Text("upright", "π")
_SIGNS: Final = {"<=": "≤", ">=": "≥", "==": "=", "<": "<", ">": ">", "+": "+", "-": "−"}
_RAISED_WORDS: Final = frozenset({"sin", "cos", "tan", "log"})
_ALL_DIGITS: Final = 15
_RELATION: Final = re.compile(r"\s+([≤≥<>=])\s+|([,;])\s+")
# A sign between symbols, or a bar; a bracket, where what it holds has a subscript of its own.
_SIGN: Final = re.compile(r"(\s*[·/−+]\s*|\||\[(?=[^\]]*_)|(?<=\w)\](?=$|\s*[·/−+]))")
_BRACKETED: Final = re.compile(r"\[([^\[\]]+_[^\[\]]+)\]")
_RUN: Final = re.compile(r"[A-Za-z]+|[α-ωϑϕϰϱϵ]|[^A-Za-zα-ωϑϕϰϱϵ]+")


def typeset(node: Node, names: Mapping[str, Box], language: str = "en") -> Box:
    """Lay a formula out.

    Args:
        node: its tree.
        names: what stands for each name: its symbol, or its number; where a function reads a
            catalogue and the column's own id is a key, its box is printed too.
        language: decides the decimal sign of the formula's own numbers, and tan or tg.
    """
    return _set(node, _Setting(names, language)).box


def symbol_box(symbol: str) -> Box:
    """Lay out a symbol as declarations write it: what follows `_` is a subscript, `τ_-1` too.

    Single Latin letters and small Greek ones stand for quantities and are italic; everything else
    (several letters, Cyrillic, digits, brackets, subscripts) is upright. Brackets round a symbol
    hold its subscript too: `[σ_F]`.
    """
    inner = _BRACKETED.fullmatch(symbol)
    if inner is not None:
        return Row((Text("upright", "["), symbol_box(inner[1]), Text("upright", "]")))
    base, _, sub = symbol.partition("_")
    runs = [_run(found[0]) for found in _RUN.finditer(base)]
    body: Box = runs[0] if len(runs) == 1 else Row(tuple(runs))
    below = f"−{sub[1:]}" if sub.startswith("-") else sub
    return Script(body, Text("upright", below), None) if sub else body


def declared_symbol(symbol: str) -> Box:
    """Lay out a declared symbol; that of a verdict, `σ ≤ [σ], w ≤ [w]`, is several of them."""
    first, *rest = _RELATION.split(symbol)
    items = [_side(first)]
    for relation, comma, part in zip(rest[::3], rest[1::3], rest[2::3], strict=True):
        between = Text("mark", f"{comma} ") if comma else Text("relation", relation)
        items += [between, _side(part)]
    return Row(tuple(items)) if rest else items[0]


def _side(text: str) -> Box:
    """Lay out a symbol, or several with signs and brackets between them, `D_max/2` or `[M_t]`."""
    if not _SIGN.search(text):
        return symbol_box(text)
    parts = (part for part in _SIGN.split(text) if part)
    laid = [Text("mark", part) if _SIGN.fullmatch(part) else symbol_box(part) for part in parts]
    return Row(tuple(laid))


def number_box(value: str, unit: str) -> Box:
    """Lay out a written number with its unit as people write it: `9,81` and `м/с²`."""
    return Value(value, unit)


def equation(parts: Sequence[Box]) -> Box:
    """Join boxes by signs of equality."""
    items: list[Box] = []
    for part in parts:
        items += [Text("relation", "="), part] if items else [part]
    return Row(tuple(items))


def _run(text: str) -> Text:
    italic = len(text) == 1 and ((text.isascii() and text.isalpha()) or "α" <= text <= "ϵ")
    return Text("variable" if italic else "upright", text)


def _set(node: Node, setting: _Setting) -> _Piece:
    match node:
        case Number(value):
            written = format_number(value, setting.language, _ALL_DIGITS)
            level = _Level.MEASURED if "·" in written else _Level.FIRM
            return _Piece(Text("number", written), level)
        case Name(name):
            box = setting.names.get(name, _PI) if name == "pi" else setting.names[name]
            return _Piece(box, _level(box))
        case Negation(operand):
            body = _fenced(_set(operand, setting), _Level.PRODUCT)
            return _Piece(Row((Text("mark", "−"), body)), _Level.SIGNED)
        case Operation():
            return _operation(node, setting)
        case Call():
            return _call(node, setting)
        case _:
            assert_never(node)


def _level(box: Box) -> _Level:
    """Tell how firmly a name's box holds: a number with a unit is a product of the two."""
    if not isinstance(box, Value):
        return _Level.FIRM
    if box.negative:
        return _Level.SIGNED
    return _Level.MEASURED if box.unit or "·" in box.number else _Level.FIRM


def _fenced(piece: _Piece, least: _Level) -> Box:
    """Return a piece's box, in brackets where it holds together less firmly than `least`."""
    return piece.box if piece.level >= least else Fence("(", piece.box, ")")


def _operation(node: Operation, setting: _Setting) -> _Piece:
    if node.operator == "**":
        return _power(node.left, node.right, setting)
    left, right = _set(node.left, setting), _set(node.right, setting)
    match node.operator:
        case "*":
            return _product(left, right)
        case "/":
            return _quotient(left, right, inline=setting.inline)
        case "+" | "-" as operator:
            sign = Text("operator", _SIGNS[operator])
            return _Piece(Row((left.box, sign, _fenced(right, _Level.PRODUCT))), _Level.SUM)
        case "and":
            sign = Text("mark", "; ")
        case operator:
            sign = Text("relation", _SIGNS[operator])
    return _Piece(Row((left.box, sign, right.box)), _Level.CONDITION)


def _quotient(left: _Piece, right: _Piece, *, inline: bool) -> _Piece:
    """Set a fraction; in an exponent, where there is no room for one, a slash."""
    if not inline:
        return _Piece(Fraction(left.box, right.box), _Level.FRACTION)
    # A slash right after a unit would be read as part of it.
    measured = any(isinstance(part, Value) and part.unit for part in boxes(left.box))
    above = _fenced(left, _Level.FIRM if measured else _Level.SIGNED)
    below = _fenced(right, _Level.FIRM)
    return _Piece(Row((above, Text("mark", "/"), below)), _signed(left))


def _signed(left: _Piece) -> _Level:
    """Tell how firmly a product holds: one that begins with a minus needs brackets sooner."""
    return _Level.SIGNED if left.level is _Level.SIGNED else _Level.PRODUCT


def _product(left: _Piece, right: _Piece) -> _Piece:
    first, second = _fenced(left, _Level.SIGNED), _fenced(right, _Level.MEASURED)
    sign = Text("times", "·" if _dotted(first, second) else "")
    return _Piece(Row((first, sign, second)), _signed(left))


def _dotted(left: Box, right: Box) -> bool:
    """Tell whether a product needs a visible sign: beside numbers, or to be read rightly."""
    while isinstance(left, Row):
        left = left.items[-1]
    while isinstance(right, Row):
        right = right.items[0]
    both_fractions = isinstance(left, Fraction) and isinstance(right, Fraction)
    after_word = isinstance(left, Applied)
    return both_fractions or after_word or _numeric(left) or _numeric(right)


def _numeric(box: Box) -> bool:
    """Tell whether a factor is a number, or is made of numbers that stand for quantities."""
    while isinstance(box, Script):
        box = box.base
    if isinstance(box, Text):
        return box.kind == "number"
    return any(isinstance(part, Value) for part in boxes(box))


def _power(base: Node, exponent: Node, setting: _Setting) -> _Piece:
    above = _set(exponent, _Setting(setting.names, setting.language, inline=True)).box
    below = _set(base, setting).box
    whole = isinstance(exponent, Number) and exponent.value.is_integer()
    word = isinstance(base, Call) and base.function in _RAISED_WORDS
    if whole and word and isinstance(below, Applied):
        return _Piece(Applied(below.word, below.arguments, above), _Level.FIRM)
    return _Piece(power_box(below, above), _Level.FIRM)


def _call(node: Call, setting: _Setting) -> _Piece:
    function = FUNCTIONS[node.function]
    arguments = tuple(_set(argument, setting).box for argument in node.arguments)
    column = None if node.column is None else setting.names.get(node.column)
    return _Piece(function.form(arguments, column, setting.language), _Level.FIRM)
