"""How a student writes numbers down, as far as anything is known of it."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Final

CUT_OFF = 0.1
"""Share of the people who cut digits off and do not round, where the policy thinks of them."""

CARRIED_TYPED = 0.5
"""Share of the people who carry on the typed number."""


@dataclass(frozen=True, slots=True)
class Manner:
    """One person's way of writing numbers, which is the same throughout a work.

    Attributes:
        cuts_off: how probable it is that digits are cut off and not rounded, 0…1.
        carries_typed: how probable it is that the typed number is carried on, and not the one in
            the calculator, 0…1.
        figures: significant figures of most numbers; 0 where most are not written alike.
        constants: what constants are shortened to, SI, by name; those that are not are absent.
    """

    cuts_off: float = CUT_OFF
    carries_typed: float = CARRIED_TYPED
    figures: int = 0
    constants: Mapping[str, float] = field(default_factory=dict)


UNKNOWN: Final = Manner()
"""The manner of somebody of whom nothing is known."""
