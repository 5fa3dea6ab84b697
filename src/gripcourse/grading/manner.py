"""How a student writes numbers down, as far as anything is known of it."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Final

from gripcourse.grading.last_digits import LastDigit
from gripcourse.grading.rounding import typed_half_unit, without_zeros
from gripcourse.policy.model import Policy
from gripcourse.submission.model import Answer

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
        last_digit: where all numbers end; None where they are written with digits enough.
    """

    cuts_off: float = CUT_OFF
    carries_typed: float = CARRIED_TYPED
    figures: int = 0
    constants: Mapping[str, float] = field(default_factory=dict)
    last_digit: LastDigit | None = None

    def half_unit(self, answer: Answer, policy: Policy, figures: int = 0) -> float:
        """Return half a unit of the last digit that an answer counts as written with.

        Of somebody who writes few digits a short number is known to have no further ones: it is no
        number that has lost its zeros.

        Args:
            answer: what was typed.
            policy: says with how many figures a number counts as written otherwise.
            figures: of the student's other numbers, as far as that counts.
        """
        if self.last_digit is None or answer.value is None or not answer.half_unit:
            return typed_half_unit(answer, policy, figures)
        if not self.last_digit.ends(answer):
            return answer.half_unit
        return self.last_digit.half_unit(answer.value)

    def lost_zeros(self, answer: Answer, policy: Policy, figures: int = 0) -> float:
        """Return half a unit of the last digit before zeros that may only hold a place, or 0.

        Args:
            answer: what was typed.
            policy: see `rounding.without_zeros`.
            figures: likewise.
        """
        if self.last_digit is not None:
            return 0.0  # what its last digit is, is known
        return without_zeros(answer, policy, figures)


UNKNOWN: Final = Manner()
"""The manner of somebody of whom nothing is known."""
