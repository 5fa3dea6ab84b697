"""Boxes as HTML for pages; the look of the classes is `formula.css`, plain text is in `plain`."""

from collections.abc import Iterator
from html import escape
from itertools import groupby
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
    inner,
)
from gripcourse.formula.plain import text, value_text
from gripcourse.formula.width import scale_of

__all__ = ["argument", "html", "text"]

_NO_BREAK: Final = "\u00a0"
_NARROW: Final = "\u202f"
_TALLEST: Final = 3
_ALWAYS_BRACKETED: Final = frozenset({"exp", "min", "max", "atan2"})


def html(box: Box) -> str:
    """Return a formula as one HTML element; lines break only before its outermost signs.

    A fraction, root or bracket that would be wider than a page is set smaller.
    """
    tallest = [one for one in _flat(box) if isinstance(one, Fraction | Root | Fence | Script)]
    scale = min(map(scale_of, tallest), default=1.0)
    style = "" if scale == 1.0 else f' style="font-size: {scale:.2f}em"'
    return f'<span class="formula"{style}>{_html(box)}</span>'


def _html(box: Box) -> str:
    """Return the elements of a box; upright runs are bare text: each element costs a page time."""
    elements: list[str] = []
    for upright, parts in groupby(_flat(box), _is_upright):
        if upright:
            elements.append(escape("".join(map(_run, parts))))
        else:
            elements += map(_element, parts)
    return "".join(elements)


def _flat(box: Box) -> Iterator[Box]:
    """Yield the boxes of a line one after the other."""
    match box:
        case Row(items):
            for item in items:
                yield from _flat(item)
        case Fence(left, body, right) if _height(body) == 1:
            yield Text("mark", left)
            yield from _flat(body)
            yield Text("mark", right)
        case Applied(word, arguments, power):
            name = Text("upright", word)
            yield name if power is None else Script(name, None, power)
            yield from _flat(argument(word, arguments))
        case _:
            yield box


def argument(word: str, arguments: tuple[Box, ...]) -> Box:
    """Return what follows a function's name: a lone sign after a space, or brackets."""
    first = arguments[0]
    match first:
        case Text() | Script(_, _, None):
            lone = True
        case Value():
            lone = not first.negative
        case _:
            lone = False
    if lone and len(arguments) == 1 and word not in _ALWAYS_BRACKETED:
        return Row((Text("mark", _NO_BREAK), first))
    # Short names stay together; a line may break between longer ones.
    short = all(isinstance(one, Text | Script) for one in arguments)
    between = Text("mark", f";{_NO_BREAK}" if short else "; ")
    items: list[Box] = [first]
    for other in arguments[1:]:
        items += [between, other]
    return Fence("(", Row(tuple(items)), ")")


def _is_upright(box: Box) -> bool:
    return isinstance(box, Value) or (isinstance(box, Text) and box.kind != "variable")


def _run(box: Box) -> str:
    """Write an upright box; a line may break before a sign, never after it."""
    match box:
        case Value():
            return value_text(box).replace(" ", _NO_BREAK)
        case Text("operator" | "relation", sign):
            return f" {sign}{_NO_BREAK}"
        case Text("times", sign):
            return f" {sign}{_NO_BREAK}" if sign else _NARROW
        case Text(_, run):
            return run
        case _:
            raise TypeError(f"{box} is not a run of upright text")


def _element(box: Box) -> str:
    match box:
        case Text(_, run):
            return f"<i>{escape(run)}</i>"
        case Fraction(top, bottom):
            over = f'<span class="f-top">{_html(top)}</span>'
            under = f'<span class="f-bottom">{_html(bottom)}</span>'
            kind = f"f-fraction{_class(' f-deep-', bottom)}"
            return f'<span class="{kind}">{over}<span class="f-sign">/</span>{under}</span>'
        case Root(body, index):
            sign = f'<span class="f-index">{escape(index)}</span>' if index else ""
            sign += '<span class="f-sign">√</span>'
            return f'<span class="f-root">{sign}<span class="f-body">{_html(body)}</span></span>'
        case Fence(left, body, right):
            kind = {"(": "round", "|": "bars", "{": "curly"}[left]
            return (
                f'<span class="f-fence f-{kind}"><span class="f-sign">{left}</span>'
                f'{_html(body)}<span class="f-sign">{right}</span></span>'
            )
        case Script(base, sub, sup):
            return _html(base) + _scripts(base, sub, sup)
        case Row() | Value() | Applied():
            return _html(box)
        case _:
            assert_never(box)


def _scripts(base: Box, sub: Box | None, sup: Box | None) -> str:
    """Return what stands below and above after a base."""
    below = "" if sub is None else f"<sub>{_html(sub)}</sub>"
    if sup is None:
        return below
    if sub is not None:
        above = f'<span class="f-above">{_html(sup)}</span>'
        return f'<span class="f-scripts">{above}<span class="f-below">{_html(sub)}</span></span>'
    kind = _class("f-raised-", base)
    start = f'<sup class="{kind}">' if kind else "<sup>"
    return f"{start}{_html(sup)}</sup>"


def _class(name: str, box: Box) -> str:
    """Return the class for a box that rises above its line, no class for one that does not."""
    rise = min(_rise(box), _TALLEST)
    return f"{name}{rise}" if rise else ""


def _rise(box: Box) -> int:
    """Count the lines that a box has above its own line."""
    if isinstance(box, Fraction):
        return _height(box.top)
    return max((_rise(part) for part in inner(box)), default=0)


def _height(box: Box) -> int:
    """Count the lines of text that a box is high."""
    heights = [_height(part) for part in inner(box)]
    if isinstance(box, Fraction):
        return sum(heights)
    return max(heights, default=1)
