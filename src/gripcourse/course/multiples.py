"""Sizes that are the whole multiples of one number: what a value is rounded to."""

import math
import re
from dataclasses import dataclass

from gripcourse.text.amounts import amount_text
from gripcourse.text.units import factor
from gripcourse.text.words import LANGUAGES, Texts, Words, message

MOST = 2000
"""Sizes of a series: a key workbook has a row for each."""


@dataclass(frozen=True, slots=True)
class Multiples:
    """The multiples of a number between two bounds.

    Attributes:
        step: the number, in the unit.
        unit: declared unit of the sizes.
        first, last: how many times the step the ends of the series are.
    """

    step: float
    unit: str
    first: int
    last: int

    @property
    def id(self) -> str:
        """Name of the series, alike for whoever wants the same sizes."""
        written = f"{self.step:.12g}_{self.unit}_{self.first}_{self.last}"
        return f"multiples_{re.sub(r'[^0-9A-Za-z]+', '_', written.replace('-', 'minus'))}"

    @property
    def column(self) -> str:
        """The `catalogue.column` of the sizes."""
        return f"{self.id}.size"

    @property
    def sizes(self) -> list[float]:
        """The sizes in SI, without what multiplying adds at the end."""
        size = factor(self.unit)
        return [float(f"{k * self.step:.12g}") * size for k in range(self.first, self.last + 1)]

    @property
    def title(self) -> Texts:
        """What students call the series."""
        if self.step == 1 and not self.unit:
            return Texts({one: Words(one).say(message("whole numbers")) for one in LANGUAGES})
        return Texts({one: _multiples_text(self, Words(one)) for one in LANGUAGES})


def between(step: float, unit: str, bounds: tuple[float, float]) -> Multiples:
    """Return the multiples of a number that two bounds hold; there may be none.

    Args:
        step: greater than zero.
        unit: of the step and the bounds.
        bounds: two numbers.
    """
    low, high = (float(f"{one / step:.12g}") for one in bounds)
    return Multiples(step, unit, math.ceil(low), math.floor(high))


def _multiples_text(one: Multiples, words: Words) -> str:
    return words.say(
        message("multiples of {amount}", amount=amount_text(one.step, one.unit, words))
    )
