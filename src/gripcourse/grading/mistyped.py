"""A right number of which digits were exchanged, lost or doubled when it was typed."""

import math
from collections.abc import Iterator
from itertools import pairwise
from typing import Final

from gripcourse.course.quantity import Kind
from gripcourse.grading.comparison import Comparison
from gripcourse.submission.model import Answer

# Fewer digits are met by chance; more than that are no longer typed but computed by a cell.
_FEWEST: Final = 3
_MOST: Final = 7
_SLACK: Final = 1e-9


def is_mistyped(comparison: Comparison) -> bool:
    """Tell whether an answer has the digits of what follows from the student's own numbers.

    Some twenty of the nine thousand numbers of four figures can be typed so for another: by chance
    one wrong number in several hundreds is met.
    """
    text = _typed(comparison.answer)
    if comparison.quantity.kind is not Kind.FORMULA or not math.isfinite(comparison.expected):
        return False
    if not _FEWEST <= _figures(text) <= _MOST:
        return False
    return any(_is_meant(comparison, one) for one in _before_typing(text))


def _typed(answer: Answer) -> str:
    """Return the digits of a number as it was typed, without its sign; nothing for none."""
    if answer.value is None or not answer.half_unit:
        return ""
    decimals = max(0, -math.floor(math.log10(2 * answer.half_unit) + _SLACK))
    return f"{abs(answer.value):.{min(decimals, 2 * _MOST)}f}"


def _figures(text: str) -> int:
    return len(text.replace(".", "").lstrip("0"))


def _is_meant(comparison: Comparison, text: str) -> bool:
    """Tell whether a number as written down is what follows, rounded or cut off."""
    if _figures(text) < _FEWEST:
        return False
    meant = math.copysign(float(text), comparison.expected)
    last_digit = 10.0 ** -len(text.partition(".")[2])
    lost = abs(comparison.follows.nearest(meant)) - abs(meant)
    slack = _SLACK * abs(meant)
    return -last_digit / 2 - slack <= lost <= last_digit * comparison.policy.last_digit + slack


def _before_typing(text: str) -> Iterator[str]:
    """Yield the numbers that a typed one may come from."""
    digits = [place for place, sign in enumerate(text) if sign.isdigit()]
    for one, other in pairwise(digits):
        if text[one] != text[other]:
            signs = list(text)
            signs[one], signs[other] = signs[other], signs[one]
            yield "".join(signs)
        else:
            yield text[:one] + text[one + 1 :]
            yield text[:other] + text[other + 1 :]
    for place in range(len(text) + 1):
        for lost in "0123456789":
            yield text[:place] + lost + text[place:]
