"""How wide a formula is, nearly: so that what cannot be broken into lines is set smaller.

Widths are in em of the text. They are estimates: nothing here knows a font.
"""

from typing import Final, assert_never

from gripcourse.formula.boxes import Applied, Box, Fence, Fraction, Root, Row, Script, Text, Value

WIDEST: Final = 44.0
"""Of what stands on a page unbroken: 155 mm in letters of 10 pt."""

SMALLEST: Final = 0.55
"""Of the size of the text: smaller letters nobody reads."""

_LETTER: Final = 0.53
_SIGN: Final = 1.1  # with the spaces round it
_SCRIPT: Final = 0.68
_RADICAL: Final = 1.05
_BAR: Final = 0.64  # what a fraction's bar is longer than its terms, and the space round it
_BRACKETS: Final = 0.76


def scale_of(box: Box) -> float:
    """Return the share of the text's size in which a box that is kept on one line fits a page."""
    return max(min(1.0, WIDEST / max(width(box), 1.0)), SMALLEST)


def width(box: Box) -> float:
    """Estimate the width of a box on one line, in em."""
    match box:
        case Text():
            found = _run_width(box)
        case Value(number, unit):
            found = _LETTER * (len(number) + (1 + len(unit) if unit else 0))
        case Row(items):
            found = sum(map(width, items))
        case Fraction(top, bottom):
            found = max(width(top), width(bottom)) + _BAR
        case Root(body):
            found = width(body) + _RADICAL
        case Script(base, sub, sup):
            scripts = (width(one) for one in (sub, sup) if one is not None)
            found = width(base) + _SCRIPT * max(scripts, default=0.0)
        case Fence(_, body):
            found = width(body) + _BRACKETS
        case Applied(word, arguments, power):
            inner = sum(map(width, arguments)) + len(arguments) * _LETTER
            found = _LETTER * len(word) + inner + (0.0 if power is None else _SCRIPT * width(power))
        case _:
            assert_never(box)
    return found


def _run_width(run: Text) -> float:
    match run.kind:
        case "operator" | "relation":
            return _SIGN
        case "times":
            return _SIGN if run.text else _LETTER / 2
        case _:
            return _LETTER * len(run.text)
