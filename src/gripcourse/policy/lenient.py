"""Numbers of a policy with which works that compute nothing earn much.

They are bounds of the policy like any other, so that no command takes what another refuses.
"""

from collections.abc import Iterator
from typing import Final

from gripcourse.errors import Problem
from gripcourse.policy.model import Policy
from gripcourse.text.words import Message, message

# With 0.2, 0.08 and 1 other people's numbers and guesses earned 11 to 37 %.
LEAST_CALCULATED: Final = 0.5
WIDEST_RELATIVE: Final = 0.05
LEAST_FIGURES: Final = 2


def lenient_numbers(policy: Policy, file: str) -> Iterator[Problem]:
    """Yield a problem for each number with which works that compute nothing earn much.

    Args:
        policy: as it was read.
        file: that it was read from, for a person.
    """
    relative = policy.tolerance.relative
    if relative > WIDEST_RELATIVE:
        most = message("Write at most {absolute}.", absolute=WIDEST_RELATIVE)
        yield Problem(file, "tolerance.relative", _earn(relative), most)
    for key, number, least in (
        ("credit.calculated", policy.calculated_share, LEAST_CALCULATED),
        ("rounding.figures", policy.figures, LEAST_FIGURES),
    ):
        if number < least:
            yield Problem(file, key, _earn(number), message("Write at least {least}.", least=least))


def _earn(number: float) -> Message:
    return message("With {number} here works that compute nothing earn points.", number=number)
