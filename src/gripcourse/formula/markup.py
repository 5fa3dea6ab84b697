"""Boxes as HTML for pages; the look of the classes is `formula.css`, plain text is in `plain`."""

from collections.abc import Iterator
from html import escape
from itertools import groupby
from typing import Final

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
_JOINER: Final = "\u2060"
_TALLEST: Final = 3
_ALWAYS_BRACKETED: Final = frozenset({"exp", "min", "max", "atan2"})


def html(box: Box) -> str:
    """Return a formula as one HTML element; lines break only before its outermost signs.

    A fraction, root or bracket that would be wider than a page is set smaller.
    """
    tallest = [one for one in _flat(box) if isinstance(one, Fraction | Root | Fence | Script)]
    scale = min(map(scale_of, tallest), default=1.0)
    style = "" if scale == 1.0 else f' style="font-size: {scale:.2f}em"'
    return _whole("span", "formula", box, style)


def _whole(
    tag: str, kind: str, box: Box, style: str = "", around: tuple[str, str] = ("", "")
) -> str:
    """Return a box as one element, slanted as a whole where fewer runs then have one of their own.

    Each element costs a page time.
    """
    runs = [
        (slope, "".join(written for _, written in parts))
        for slope, parts in groupby(_sloped(_written(box)), lambda part: part[0])
    ]
    slanted = 2 * sum(slope for slope, _ in runs) > len(runs)
    apart = "<span>{}</span>" if slanted else "<i>{}</i>"
    inside = "".join(
        written if slope is slanted else apart.format(written) for slope, written in runs
    )
    classes = f"{kind} f-slanted".strip() if slanted else kind
    start = f'{tag} class="{classes}"' if classes else tag
    before, after = around
    return f"<{start}{style}>{before}{inside}{after}</{tag}>"


def _sloped(parts: Iterator[tuple[bool | None, str]]) -> Iterator[tuple[bool, str]]:
    """Let a part that looks the same either way stand with what is before it."""
    last = False
    for slope, written in parts:
        last = last if slope is None else slope
        yield last, written


def _written(box: Box) -> Iterator[tuple[bool | None, str]]:
    """Yield the parts of a line, each with whether it is slanted; None where that changes nothing.

    What has elements of its own has also slopes of its own.
    """
    for one in _flat(box):
        match one:
            case Text("variable", run):
                yield True, escape(run)
            case Text("times", ""):
                yield None, _run(one)
            case Text() | Value():
                yield False, escape(_run(one))
            case Script(base, sub, sup):
                yield from _written(base)
                yield None, _scripts(base, sub, sup)
            case _:
                yield None, _element(one)


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


def _run(box: Box) -> str:
    """Write an upright box; a line may break before a sign, never after it."""
    match box:
        case Value():
            return value_text(box).replace(" ", _NO_BREAK).replace("/", f"/{_JOINER}")
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
        case Fraction(top, bottom):
            over, under = _whole("span", "f-top", top), _whole("span", "f-bottom", bottom)
            kind = f"f-fraction{_class(' f-deep-', bottom)}"
            return f'<span class="{kind}">{over}{_sign("/", bottom)}{under}</span>'
        case Root(body, index):
            sign = f'<span class="f-index">{escape(index)}</span>' if index else ""
            sign += _sign("√", body)
            return f'<span class="f-root">{sign}{_whole("span", "f-body", body)}</span>'
        case Fence(left, body, right):
            kind = {"(": "round", "|": "bars", "{": "curly"}[left]
            signs = (_sign(left, body), _sign(right))
            return _whole("span", f"f-fence f-{kind}", body, around=signs)
        case _:
            raise TypeError(f"{box} is a line of boxes")


def _sign(sign: str, after: Box | None = None) -> str:
    """Return a sign that is there but not seen; by what stands after it, whether text follows."""
    kind = "f-sign" if after is not None and _begins_with_text(after) else "f-sign f-last"
    return f'<span class="{kind}">{sign}</span>'


def _begins_with_text(box: Box) -> bool:
    match next(_flat(box), None):
        case Text(_, run):
            return bool(run.strip())
        case Value():
            return True
        case Script(base):
            return _begins_with_text(base)
        case _:
            return False


def _scripts(base: Box, sub: Box | None, sup: Box | None) -> str:
    """Return what stands below and above after a base."""
    if sub is not None and sup is not None:
        above, below = _whole("span", "f-above", sup), _whole("span", "f-below", sub)
        return f'<span class="f-scripts">{above}{below}</span>'
    below = "" if sub is None else _whole("sub", "", sub)
    return below if sup is None else _whole("sup", _class("f-raised-", base), sup)


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
