"""Two mistakes that give one number: a cosine left out, and its angle typed in radians.

The cosine of a few hundredths of a degree is 1 in all the figures that anybody types.
"""

from collections.abc import Sequence
from typing import Final

from gripcourse.course.quantity import Quantity
from gripcourse.formula.tree import Call, Name
from gripcourse.policy.slips import SlipKind
from gripcourse.slips.model import Candidate
from gripcourse.text.words import Message, message

_PAIR: Final = (SlipKind.FACTOR_LEFT_OUT, SlipKind.INPUT_UNIT)
_UNITS: Final = frozenset({"deg", "rad"})


def said_of_lost_cosine(methods: Sequence[Candidate]) -> Message | None:
    """Say of both mistakes in one sentence what the number shows; None of any other methods."""
    if len(methods) != len(_PAIR):
        return None
    for left_out, typed in (methods, methods[::-1]):
        if (left_out.kind, typed.kind) == _PAIR and _is_cosine_of(left_out, typed):
            return message(
                "A known slip: {cosine} counts as 1 in this number. It was left out, or the angle "
                "was typed in radians while the calculator was set to degrees.",
                cosine=left_out.said.place("quantity"),
            )
    return None


def _is_cosine_of(left_out: Candidate, typed: Candidate) -> bool:
    """Tell whether the factor is the cosine of the angle that was typed too small."""
    places = typed.said.places
    match left_out.said.places.get("quantity"), places.get("quantity"), places.get("number"):
        case Call("cos", (Name(angle),)), Quantity() as quantity, float(times):
            units = {places.get("unit"), places.get("asked")}
            return angle == quantity.id and units == _UNITS and times < 1
    return False
