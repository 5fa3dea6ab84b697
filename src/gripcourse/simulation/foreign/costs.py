"""What a mistake of the second generator cost, and where nothing, why."""

from collections.abc import Iterator
from enum import StrEnum

from gripcourse.grading.model import Against, Finding
from gripcourse.simulation.foreign.kinds import SEEN
from gripcourse.simulation.foreign.model import JudgedForeign

_OTHER_WAYS = frozenset({Against.ALTERNATIVE, Against.PRINTED})


class Uncharged(StrEnum):
    """Why no answer of a work with a mistake is said to be wrong."""

    BLANK = "blank"  # it was made in a step that was left blank, and costs that step
    SOUND = "sound"  # it comes to another sound size, the same verdict, or a way that is accepted
    ROUGH = "rough"  # it comes to what rounding comes to, and costs as that does
    PAID = "paid"  # a wrong number was accepted


def answers(one: JudgedForeign) -> Iterator[Finding]:
    """Yield what was found out about the cells that are filled."""
    return (found for found in one.report.findings if found.quantity in one.work.cells)


def charged(one: JudgedForeign) -> int:
    """Return how many answers lost points, other than for being too rough."""
    lost = (
        found.points < found.max_points for found in answers(one) if not found.outcome.traits.coarse
    )
    return sum(lost)


def is_moved(found: Finding) -> bool:
    """Tell whether an answer is far from what follows from the numbers before it."""
    right = found.reference if found.expected is None else found.expected
    if found.given is None or right is None:
        return False
    return abs(found.given - right) > SEEN * abs(right)


def why_uncharged(one: JudgedForeign) -> Uncharged | None:
    """Return why a mistake cost nothing; None for a work without one, or where it did cost."""
    if one.work.done is None or charged(one):
        return None
    blank = {found.quantity for found in one.report.findings} - one.work.cells.keys()
    if one.work.done.root in blank:
        return Uncharged.BLANK
    reached = [found for found in answers(one) if found.quantity in one.work.reaches]
    if any(found.outcome.traits.coarse for found in reached):
        return Uncharged.ROUGH
    moved = [found for found in reached if is_moved(found)]
    if not moved and len(reached) < len(one.work.reaches):
        return Uncharged.BLANK
    # A size that is not written may be any sound one.
    decided = one.work.decisions & blank
    numbers = (
        found
        for found in moved
        if found.quantity not in one.work.decisions and decided.isdisjoint(found.inputs)
    )
    if any(found.against not in _OTHER_WAYS for found in numbers):
        return Uncharged.PAID
    return Uncharged.SOUND
