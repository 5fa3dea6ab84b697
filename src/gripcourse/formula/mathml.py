"""Boxes as MathML, for pages that a browser shows; the look is the browser's own."""

import re
from collections.abc import Iterator
from html import escape
from typing import Final, assert_never

from gripcourse.formula.boxes import (
    Applied,
    Box,
    Fence,
    Fraction,
    Root,
    Row,
    Script,
    Text,
    Value,
    boxes,
)
from gripcourse.formula.markup import argument
from gripcourse.text.units import stands_close

_INVISIBLE_TIMES: Final = "\u2062"
_APPLIED_TO: Final = "\u2061"
_NO_BREAK: Final = "\u00a0"
_BRACKETS: Final = frozenset("()[]{}|")
_PIECE: Final = re.compile(r"[()\[\]{}|]|[^()\[\]{}|]+")
_JUXTAPOSED: Final = Text("times", "")
_THIN_SPACE: Final = '<mspace width="0.17em"/>'


def mathml(box: Box, *, large: bool = False) -> str:
    """Return a formula as one `<math>` element, well formed both as HTML and as XML.

    Args:
        box: the formula.
        large: whether fractions have their full size, as on a line of their own.
    """
    start = '<math displaystyle="true">' if large else "<math>"
    return f"{start}{''.join(_elements(box))}</math>"


def reads_aloud(box: Box) -> bool:
    """Tell whether the signs of a box say the same where a viewer draws nothing but them."""
    return not any(
        isinstance(part, Fraction | Root)
        or (isinstance(part, Script) and part.sup is not None)
        or (isinstance(part, Applied) and part.power is not None)
        for part in boxes(box)
    )


def _one(box: Box) -> str:
    """Return a box as exactly one element, as fractions, indices and exponents need it."""
    elements = list(_elements(box))
    return elements[0] if len(elements) == 1 else f"<mrow>{''.join(elements)}</mrow>"


def _elements(box: Box) -> Iterator[str]:
    """Yield the elements of a box, side by side."""
    match box:
        case Text():
            yield from _text(box)
        case Value():
            yield from _value(box)
        case Row(items):
            yield from _row(items)
        case Fraction(top, bottom):
            yield f"<mfrac>{_one(top)}{_one(bottom)}</mfrac>"
        case Root(body, index):
            yield _root(body, index)
        case Script(base, sub, sup):
            yield _script(base, sub, sup)
        case Fence(left, body, right):
            yield f"<mrow>{_bracket(left)}{''.join(_elements(body))}{_bracket(right)}</mrow>"
        case Applied(word, arguments, power):
            name = f"<mi>{escape(word)}</mi>"
            yield name if power is None else f"<msup>{name}{_one(power)}</msup>"
            yield f"<mo>{_APPLIED_TO}</mo>"
            yield from _elements(argument(word, arguments))
        case _:
            assert_never(box)


def _row(items: tuple[Box, ...]) -> Iterator[str]:
    for before, item in zip((None, *items), items, strict=False):
        if isinstance(item, Applied) and before == _JUXTAPOSED:
            yield _THIN_SPACE  # l cos θ, not lcos θ
        yield from _elements(item)


def _value(value: Value) -> Iterator[str]:
    yield f"<mn>{escape(value.number)}</mn>"
    if value.unit:
        gap = "" if stands_close(value.unit) else _NO_BREAK
        yield f"<mtext>{gap}{escape(value.unit)}</mtext>"


def _root(body: Box, index: str) -> str:
    if index:
        return f"<mroot>{_one(body)}<mn>{escape(index)}</mn></mroot>"
    return f"<msqrt>{''.join(_elements(body))}</msqrt>"


def _script(base: Box, sub: Box | None, sup: Box | None) -> str:
    if sub is not None and sup is not None:
        return f"<msubsup>{_one(base)}{_one(sub)}{_one(sup)}</msubsup>"
    if sub is not None:
        return f"<msub>{_one(base)}{_one(sub)}</msub>"
    return f"<msup>{_one(base)}{_one(sup)}</msup>" if sup is not None else _one(base)


def _bracket(sign: str) -> str:
    """Return a bracket that grows with what it holds."""
    return f"<mo>{sign}</mo>" if sign != "|" else '<mo stretchy="true" fence="true">|</mo>'


def _text(box: Text) -> Iterator[str]:
    match box.kind:
        case "number":
            yield f"<mn>{escape(box.text)}</mn>"
        case "variable":
            yield f"<mi>{escape(box.text)}</mi>"
        case "upright":
            yield from map(_upright, _PIECE.findall(box.text))
        case "operator" | "relation":
            yield f"<mo>{escape(box.text)}</mo>"
        case "times":
            yield f"<mo>{box.text or _INVISIBLE_TIMES}</mo>"
        case "mark":
            yield _mark(box.text)
        case _:
            assert_never(box.kind)


def _upright(run: str) -> str:
    """Return letters, digits or a bracket of a symbol; one letter alone would turn italic."""
    if run in _BRACKETS:
        return f'<mo stretchy="false">{run}</mo>'
    if run.isdecimal():
        return f"<mn>{run}</mn>"
    start = '<mi mathvariant="normal">' if len(run) == 1 else "<mi>"
    return f"{start}{escape(run)}</mi>"


def _mark(text: str) -> str:
    """Return a sign that is no relation and no operation between two boxes."""
    if text == _NO_BREAK:
        return _THIN_SPACE
    sign = text.strip()
    # A minus after another sign would count as a subtraction.
    return '<mo form="prefix">−</mo>' if sign == "−" else f"<mo>{escape(sign)}</mo>"
