"""Wrong methods that people use with any formula: how common each is and what it is worth.

A head of course owns the numbers and the sentences; what a kind does to a formula is in `slips`.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from typing import Final

from gripcourse.text.words import Texts

DECLARED: Final = "declared"
"""Kind of the slips that a formula declares for itself."""


class SlipKind(StrEnum):
    """What a wrong method does to a formula."""

    UNIT = "unit"  # the result in another unit
    POWER_OF_TEN = "power_of_ten"
    ANGLE_UNIT = "angle_unit"  # degrees taken for radians, or the other way round
    INPUT_UNIT = "input_unit"  # an input that was not converted
    RADIUS_FOR_DIAMETER = "radius_for_diameter"
    HALVED_ANGLE = "halved_angle"  # once more than the formula does
    DOUBLED_ANGLE = "doubled_angle"  # the whole for the half that the formula has
    GRAVITY_LEFT_OUT = "gravity_left_out"
    SAFETY_LEFT_OUT = "safety_left_out"
    FACTOR_LEFT_OUT = "factor_left_out"
    NUMBER_LEFT_OUT = "number_left_out"
    TERM_LEFT_OUT = "term_left_out"
    MULTIPLIED_FOR_DIVIDED = "multiplied_for_divided"
    WRONG_FUNCTION = "wrong_function"  # sine for cosine
    POWER = "power"  # squared or not, a root left out
    SWAPPED = "swapped"  # two inputs of one dimension
    WRONG_END = "wrong_end"  # the value at the other end of the range
    MINIMUM_FOR_MAXIMUM = "minimum_for_maximum"
    SIGN = "sign"
    OTHER_ROW = "other_row"  # of a table
    MASS_FOR_WEIGHT = "mass_for_weight"
    RING_FOR_CIRCLE = "ring_for_circle"
    COUNTED_TWICE = "counted_twice"  # a factor that was counted already
    BRACKETS = "brackets"  # left out when a formula was keyed in
    UPSIDE_DOWN = "upside_down"  # a ratio the other way round
    RATIO_FOR_ANGLE = "ratio_for_angle"  # the sine for its angle
    ADDED_FOR_MULTIPLIED = "added_for_multiplied"  # or the other way round


OF_WRITING: Final = frozenset({SlipKind.UNIT, SlipKind.POWER_OF_TEN})
"""Kinds that may concern only what was written: the number in the calculator can be right."""


@dataclass(frozen=True, slots=True)
class GenericSlip:
    """One kind of wrong method.

    Attributes:
        prior: how common it is, on the scale of the others.
        credit: share of the points for an answer that it explains, 0…1.
        names: patterns of the ids of the quantities that it concerns; empty for all.
        pairs: endings of ids that are taken for each other.
        units: that are taken for each other.
        title: its name.
        hint: for the student, with places in braces.
    """

    kind: SlipKind
    prior: float
    credit: float
    names: tuple[str, ...]
    pairs: tuple[tuple[str, str], ...]
    units: tuple[str, ...]
    title: Texts
    hint: Texts


@dataclass(frozen=True, slots=True)
class SlipPolicy:
    """How slips are named.

    Attributes:
        kinds: generic slips by kind; a kind that is absent is not looked for.
        unexplained: how common a wrong answer is that nothing explains, on the scale of the priors.
        declared: how common a slip is that a formula declares for itself.
        certain: a slip is named where it is at least so probable, 0.5…1.
        tie: of two that give one number both are named where neither is so many times likelier,
            above 1.
        spread: standard deviation of the logarithm of a wrong answer, against the right one.
    """

    kinds: Mapping[SlipKind, GenericSlip]
    unexplained: float
    declared: float
    certain: float
    tie: float
    spread: float
