"""Boxes as one line of text: what a formula says aloud, in a terminal and in a test.

The text has every bracket and every sign of multiplication, so that it can be read in one way only.
"""

from collections.abc import Iterator
from typing import Final, assert_never

from gripcourse.formula.boxes import Applied, Box, Fence, Fraction, Root, Row, Script, Text, Value
from gripcourse.text.units import stands_close

_SUPERSCRIPTS: Final = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")
_LETTERS: Final = frozenset({"variable", "upright"})
_OPEN: Final = Text("upright", "[")
_RADICALS: Final = {"": "√", "3": "∛"}


def text(box: Box) -> str:
    """Return a formula as one line of text."""
    match box:
        case Text():
            written = _run(box)
        case Value():
            written = value_text(box)
        case Row(items):
            written = _row(items)
        case Fraction(top, bottom):
            written = f"{_above(top)}/{_below(bottom)}"
        case Root(body, index):
            written = f"{_RADICALS[index]}({text(body)})"
        case Script(base, sub, sup):
            written = f"{text(base)}{'' if sub is None else f'_{text(sub)}'}{_exponent(sup)}"
        case Fence(left, body, right):
            written = f"abs({text(body)})" if left == "|" else f"{left}{text(body)}{right}"
        case Applied(word, arguments, power):
            written = f"{word}({'; '.join(map(text, arguments))}){_exponent(power)}"
        case _:
            assert_never(box)
    return written


def value_text(box: Value) -> str:
    """Write a number with its unit; a degree sign stands close."""
    return box.number + box.unit if stands_close(box.unit) else f"{box.number} {box.unit}"


def _run(box: Text) -> str:
    match box.kind:
        case "operator" | "relation":
            return f" {box.text} "
        case "times":
            return f" {box.text} " if box.text else "·"
        case _:
            return box.text


def _row(items: tuple[Box, ...]) -> str:
    """Write boxes side by side; a fraction that is multiplied keeps together in brackets."""
    written: list[str] = []
    times = False
    for item in items:
        bracketed = times and isinstance(item, Fraction)
        written.append(f"({text(item)})" if bracketed else text(item))
        times = isinstance(item, Text) and item.kind == "times"
    return "".join(written)


def _above(top: Box) -> str:
    """Write a numerator: a product of signs needs no brackets."""
    loose = any(
        (isinstance(part, Text) and part.kind in {"operator", "relation"})
        or (isinstance(part, Value) and bool(part.unit))
        for part in (_line(top))
    )
    return f"({text(top)})" if loose else text(top)


def _line(box: Box) -> Iterator[Box]:
    """Yield what stands on a box's own line, not inside brackets, fractions or roots."""
    if isinstance(box, Row):
        for item in box.items:
            yield from _line(item)
    else:
        yield box


def _below(bottom: Box) -> str:
    """Write a denominator: only one that holds together by itself needs no brackets."""
    match bottom:
        case Text(_, run):
            alone = "·" not in run
        case Row(items):  # a symbol of several runs, for example [τ], or in brackets with its index
            alone = items[0] == _OPEN or all(
                isinstance(part, Text) and part.kind in _LETTERS for part in items
            )
        case Value(number, unit):
            alone = not (unit or bottom.negative or "·" in number)
        case Script() | Root() | Fence() | Applied():
            alone = True
        case _:
            alone = False
    return text(bottom) if alone else f"({text(bottom)})"


def _exponent(box: Box | None) -> str:
    if box is None:
        return ""
    written = text(box)
    return written.translate(_SUPERSCRIPTS) if written.isdecimal() else f"^({written})"
