"""Somebody who knows a few answers and asks a self-check for the others, number by number."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np

from gripcourse.course.quantity import Kind, Quantity
from gripcourse.grading.self_check import SectionState, State, self_check
from gripcourse.policy.bands import band
from gripcourse.policy.model import Policy, Tells
from gripcourse.solver.plan import Plan
from gripcourse.solver.solve import solve_variant
from gripcourse.submission.model import Answer, Identity, Reading, Submission

_STEP: Final = 0.018
"""Relative distance of guesses: each right value is within a band of one per cent of one."""


@dataclass(frozen=True, slots=True)
class Asked:
    """What asking comes to.

    Attributes:
        known: computed answers that were right before, by chance too.
        found: that are right in the end.
        answers: how many there are.
        questions: that were asked.
        replies: different replies among them; a question tells at most their logarithm in bits.
    """

    known: int
    found: int
    answers: int
    questions: int
    replies: int


def ask_for_answers(
    plan: Plan, policy: Policy, given: Mapping[str, float], known: int, most: int, tells: Tells
) -> Asked:
    """Let somebody ask for answers, in the order of calculation, and keep what fits.

    The asker cannot compute but has all that an answer sheet shows, and knows sizes from series and
    what is yes; guesses go from the middle of what a cell lets through to its ends. Where sections
    are told, a guess is kept when its section fits.

    Args:
        plan: of the variant.
        policy: for the bands.
        given: issued numbers in declared units.
        known: computed answers that the asker has, the first ones.
        most: questions, whoever counts them.
        tells: how much is told.
    """
    right = solve_variant(plan, given)
    answered = {one.id for one in plan.answered}
    computed = [
        one for one in plan.quantities.values() if one.kind is Kind.FORMULA and one.id in answered
    ]
    typed = {
        one.id: right[one.id] if one.kind is not Kind.FORMULA else _middle(one)
        for one in plan.answered
    }
    typed |= {one.id: right[one.id] for one in computed[:known]}

    def found() -> int:
        near = (abs(typed[one.id] - right[one.id]) - band(one, right[one.id], policy)
                for one in computed)  # fmt: skip
        return sum(away <= 0 for away in near)

    before = found()
    questions, replies = 0, set[tuple[object, ...]]()
    for quantity in computed[known:]:
        for guess in _guesses(quantity):
            if questions >= most:
                break
            questions += 1
            told = self_check(
                _submission(plan, given, typed | {quantity.id: guess}), plan, policy, tells
            )
            states = {one.quantity: one.state for one in told.answers}
            sections = {one.section: one.state for one in told.sections}
            replies.add((*sorted(states.items()), *sorted(sections.items())))
            fits = states[quantity.id] is State.CONSISTENT
            if fits or sections.get(quantity.section) is SectionState.FITS:
                typed[quantity.id] = guess
                break
    return Asked(before, found(), len(computed), questions, len(replies))


def _middle(quantity: Quantity) -> float:
    low, high = quantity.bounds
    return float(np.sqrt(low * high)) if low > 0 else (low + high) / 2


def _guesses(quantity: Quantity) -> Iterator[float]:
    """Yield guesses that lie a band apart, from the middle outwards, inside what is let through."""
    low, high = quantity.bounds
    middle = _middle(quantity) or high / 2
    yield middle
    up = down = middle
    while abs(up) < abs(high) or abs(down) > max(abs(low), abs(high) * 1e-6):
        up, down = up * (1 + _STEP), down / (1 + _STEP)
        yield from (one for one in (up, down) if low <= one <= high)


def _submission(plan: Plan, given: Mapping[str, float], typed: Mapping[str, float]) -> Submission:
    return Submission(
        file="",
        digest="",
        identity=Identity("", "", plan.scheme.id, plan.options, ""),
        creator="",
        givens=given,
        answers={name: _answer(name, value) for name, value in typed.items()},
        remarks=(),
    )


def _answer(name: str, value: float) -> Answer:
    shown = float(f"{value:.5g}")
    return Answer(
        quantity=name, reading=Reading.READ, value=shown, typed=f"{shown:g}", cell="",
        half_unit=0.0, unit="", unit_fits=True, remarks=(),
    )  # fmt: skip
