"""What a number may be taken for when it is read, copied or typed, and how likely each is.

The sum of all shares is below one: the rest are numbers from elsewhere, which may be anything.
"""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from decimal import Decimal
from itertools import pairwise
from typing import Final

# Shares of the wrong numbers, shared in turn among the ways of each kind. Nobody has counted them.
_EXCHANGED, _DIGIT, _LOST, _DOUBLED = 0.15, 0.15, 0.08, 0.02
_TEN, _ROW, _ELSEWHERE, _LEFT_OUT = 0.1, 0.12, 0.04, 0.2
ANYTHING: Final = 0.12
"""Share of the wrong numbers that are none of these."""

_POWERS: Final = (10.0, 0.1, 100.0, 0.01, 1000.0, 0.001)
_FIGURES: Final = 6  # that people read of a number; a calculator shows more


def misreadings(
    right: float, rows: Sequence[float] = (), alike: Sequence[float] = ()
) -> dict[float, float]:
    """Return the numbers that one may be taken for, each with its share of all wrong numbers.

    Args:
        right: the number, in the unit that it is written in.
        rows: numbers of the rows above and below.
        alike: others of the same unit.
    """
    text = _written(right)
    kinds: tuple[tuple[float, Iterable[float]], ...] = (
        (_EXCHANGED, _exchanged(text)),
        (_DIGIT, _other_digit(text)),
        (_LOST, _lost(text)),
        (_DOUBLED, _doubled(text)),
        (_TEN, (right * power for power in _POWERS)),
        (_ROW, rows),
        (_ELSEWHERE, alike),
        (_LEFT_OUT, (0.0,)),  # of a sum
    )
    found: dict[float, float] = {}
    for share, numbers in kinds:
        ways = [one for one in numbers if math.isfinite(one) and not math.isclose(one, right)]
        for one in ways:
            found[one] = found.get(one, 0.0) + share / len(ways)
    return found


def neighbours(
    numbers: Mapping[str, tuple[float, str]], name: str
) -> tuple[list[float], list[float]]:
    """Return what stands beside a number, and all others of its unit.

    Args:
        numbers: values with their units, in the order in which they stand, by id.
        name: of the number.
    """
    names = list(numbers)
    if name not in numbers:
        return [], []
    place, unit = names.index(name), numbers[name][1]
    beside = {*names[max(0, place - 1) : place], *names[place + 1 : place + 2]}
    alike = [one for one in names if one != name and numbers[one][1] == unit]
    return (
        [numbers[one][0] for one in alike if one in beside],
        [numbers[one][0] for one in alike if one not in beside],
    )


def _written(value: float) -> str:
    """Write a number as people do, without a power of ten."""
    return f"{Decimal(f'{value:.{_FIGURES}g}'):f}"


def _digits(text: str) -> list[int]:
    return [place for place, sign in enumerate(text) if sign.isdigit()]


def _exchanged(text: str) -> Iterator[float]:
    for one, other in pairwise(_digits(text)):
        signs = list(text)
        signs[one], signs[other] = signs[other], signs[one]
        yield float("".join(signs))


def _other_digit(text: str) -> Iterator[float]:
    for place in _digits(text):
        for digit in "0123456789":
            if digit != text[place]:
                yield float(f"{text[:place]}{digit}{text[place + 1 :]}")


def _lost(text: str) -> Iterator[float]:
    places = _digits(text)
    for place in places if len(places) > 1 else ():
        yield float(text[:place] + text[place + 1 :])


def _doubled(text: str) -> Iterator[float]:
    for place in _digits(text):
        yield float(text[:place] + text[place] + text[place:])
