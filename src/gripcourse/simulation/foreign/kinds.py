"""The mistakes and habits of the second generator, how common each is, and where that comes from.

Only the proportions of weights matter. Published work tells which kinds there are and how often
people err at all: S. Wiseman, P. Cairns, A. Cox, A taxonomy of number entry error (HCI 2011,
187–196) for digits; H. Thimbleby, P. Cairns, Reducing number entry errors (J. R. Soc. Interface 7,
2010) for powers of ten; R. Panko, What we know about spreadsheet errors (J. End User Computing 10,
1998, revised 2008) for a few wrong cells in a hundred, so that half of all works with some forty
answers hold one. No published count divides mistakes in machine calculations by kind: the weights
are estimates of our own.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from types import MappingProxyType
from typing import Final


class ForeignMistake(StrEnum):
    """What is done wrongly once in a work."""

    MISREAD_DIGITS = "misread_digits"  # a given with two digits exchanged, one wrong or lost
    MISREAD_ROW = "misread_row"  # the given of the row above or below
    MISTYPED = "mistyped"  # digits of an answer, and what was typed is used
    MISCOPIED = "miscopied"  # a right answer, used later with wrong digits
    WRONG_CELL = "wrong_cell"  # the neighbouring answer
    DEGREES = "degrees"  # degrees in a function that takes radians
    EFFICIENCY = "efficiency"  # multiplied by where it divides, or forgotten
    FACTOR = "factor"  # a number of the formula forgotten
    POWER = "power"  # a square or a root forgotten
    SIGN = "sign"
    RADIUS = "radius"  # for a diameter, or the other way round
    RANGE_END = "range_end"  # the value at the other end
    MEAN = "mean"  # for the greater or the lesser
    TABLE_ROW = "table_row"  # the neighbouring row of a catalogue
    FUNCTION = "function"  # sine for cosine
    RATIO = "ratio"  # the arctangent forgotten
    BRACKETS = "brackets"  # not keyed in
    UNIT = "unit"  # an answer a thousand times too large or too small: mm and m, N and kN
    INPUT_UNIT = "input_unit"  # the same of a number that goes into one formula


@dataclass(frozen=True, slots=True)
class MistakeKind:
    """How common a mistake is, and what a grader may call it.

    Attributes:
        weight: how common; only proportions matter.
        names: kinds of slips that mean the same; none where the grader has no word for it.
        source: where kind and weight come from.
    """

    weight: float
    names: frozenset[str]
    source: str


def _kind(weight: float, names: str, source: str) -> MistakeKind:
    return MistakeKind(weight, frozenset(names.split()), source)


_ENTRY: Final = "kind: Wiseman et al. 2011; weight: own estimate"
_TEN: Final = "kind: Thimbleby and Cairns 2010; weight: own estimate"
_OWN: Final = "own estimate"

MISTAKES: Final[Mapping[ForeignMistake, MistakeKind]] = MappingProxyType(
    {
        ForeignMistake.MISREAD_DIGITS: _kind(9, "used", _ENTRY),
        ForeignMistake.MISREAD_ROW: _kind(4, "used", _ENTRY),
        ForeignMistake.MISTYPED: _kind(7, "", _ENTRY),
        ForeignMistake.MISCOPIED: _kind(6, "used", _ENTRY),
        ForeignMistake.WRONG_CELL: _kind(3, "", _ENTRY),
        ForeignMistake.DEGREES: _kind(4, "angle_unit", _OWN),
        ForeignMistake.EFFICIENCY: _kind(4, "multiplied_for_divided factor_left_out", _OWN),
        ForeignMistake.FACTOR: _kind(8, "number_left_out", _OWN),
        ForeignMistake.POWER: _kind(7, "power", _OWN),
        ForeignMistake.SIGN: _kind(6, "sign", _OWN),
        ForeignMistake.RADIUS: _kind(6, "radius_for_diameter", _OWN),
        ForeignMistake.RANGE_END: _kind(5, "wrong_end", _OWN),
        ForeignMistake.MEAN: _kind(2, "", _OWN),
        ForeignMistake.TABLE_ROW: _kind(4, "other_row", _OWN),
        ForeignMistake.FUNCTION: _kind(4, "wrong_function", _OWN),
        ForeignMistake.RATIO: _kind(2, "ratio_for_angle", _OWN),
        ForeignMistake.BRACKETS: _kind(4, "brackets multiplied_for_divided", _OWN),
        ForeignMistake.UNIT: _kind(7, "unit power_of_ten", _TEN),
        ForeignMistake.INPUT_UNIT: _kind(5, "input_unit unit power_of_ten", _TEN),
    }
)


class Doing(StrEnum):
    """What a student does altogether."""

    HONEST = "honest"
    MISTAKE = "mistake"
    COPY = "copy"  # most of a neighbour's numbers
    MOVED_COPY = "moved_copy"  # each of them moved by up to a hundredth
    MIXTURE = "mixture"  # each number one of two neighbours'
    STOLEN_FILE = "stolen_file"  # a neighbour's workbook


DOINGS: Final[Mapping[Doing, float]] = MappingProxyType(
    {
        Doing.HONEST: 40.0,
        Doing.MISTAKE: 46.0,
        Doing.COPY: 3.0,
        Doing.MOVED_COPY: 4.0,
        Doing.MIXTURE: 4.0,
        Doing.STOLEN_FILE: 3.0,
    }
)


class Writing(StrEnum):
    """How numbers are written down."""

    FIGURES_3 = "figures_3"
    FIGURES_4 = "figures_4"
    FIGURES_5 = "figures_5"
    CUT_4 = "cut_4"  # four figures, the others cut off
    DISPLAY = "display"  # all ten of a calculator
    MIXED = "mixed"  # three to six, as it comes
    DECIMALS = "decimals"  # two decimals, of small numbers three figures
    FIGURES_2 = "figures_2"
    WHOLE = "whole"  # whole millimetres, newtons and degrees; below ten one decimal
    ONE_DECIMAL = "one_decimal"
    TWO_DECIMALS = "two_decimals"  # of small numbers too

    @property
    def coarse(self) -> bool:
        """Whether a number may be rounded further than its band allows."""
        return self in {Writing.FIGURES_2, Writing.WHOLE, Writing.ONE_DECIMAL, Writing.TWO_DECIMALS}


WRITINGS: Final[Mapping[Writing, float]] = MappingProxyType(
    {
        Writing.FIGURES_3: 16.0, Writing.FIGURES_4: 16.0, Writing.FIGURES_5: 8.0,
        Writing.CUT_4: 6.0, Writing.DISPLAY: 8.0, Writing.MIXED: 10.0, Writing.DECIMALS: 16.0,
        Writing.FIGURES_2: 3.0, Writing.WHOLE: 6.0, Writing.ONE_DECIMAL: 5.0,
        Writing.TWO_DECIMALS: 6.0,
    }
)  # fmt: skip

PI: Final[Mapping[float, float]] = MappingProxyType(
    {3.141592653589793: 6.0, 3.14: 3.0, 3.1416: 1.0}
)
ROUGH_GRAVITY: Final = 10.0
GRAVITY: Final[Mapping[float, float]] = MappingProxyType({9.81: 6.0, 9.8: 2.0, ROUGH_GRAVITY: 2.0})
"""In m/s², of a constant whose id is `gravity`."""

BLANKS: Final = 0.15
"""Share of the works with blank answers."""

BLANK: Final = 0.12
"""Share of the answers that are blank there."""

COPIED: Final = 0.9
"""Share of the numbers that a copy takes over."""

MOVED: Final = 0.01
"""Share of itself that a moved number moves by, at most."""

KEEPS: Final = 0.5
"""Share of the students who go on with what the calculator holds."""

AS_TEXT: Final = 0.25
"""Share of the students who type text with a decimal comma, every second with units."""

SEEN: Final = 0.03
"""A mistake that moves its first number by less shows nothing; another is made."""
