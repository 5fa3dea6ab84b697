"""What bands do to honest answers and to wrong methods, counted for one quantity.

A band is applied exactly as the grader does: to the reference and to the nearest point of what
follows from the student's own numbers.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gripcourse.course.quantity import Quantity
from gripcourse.policy.bands import tolerance_of
from gripcourse.policy.model import Policy
from gripcourse.simulation.arithmetic import Array, written
from gripcourse.simulation.honest import Expected, Honest
from gripcourse.slips.candidates import candidates_of

# As the grader's own slack: an answer exactly on the edge of its band passes.
_SLACK = 1 + 1e-9
_SAME = 1e-9


@dataclass(frozen=True, slots=True)
class AnswerTally:
    """Counts of one quantity; those by band are for the bands of the audit, narrowest first.

    Attributes:
        answers: honest answers.
        refused: of these, by the band that applies now.
        refused_by_band: of these, by each band.
        on_floor: honest answers that only the absolute floor accepts, at the narrowest band.
        slips: wrong methods that were tried.
        accepted: of these, by the band that applies now.
        accepted_by_band: of these, by each band.
        same: wrong methods that give the right value; nobody can tell them apart, none is counted.
        short_by: what the absolute part of the band must be, in the declared unit, for the band
            that applies now to refuse no honest answer; 0.0 where it refuses none.
        widest: the widest spread that rounded inputs leave, as a share of the value.
    """

    answers: int
    refused: int
    refused_by_band: NDArray[np.int64]
    on_floor: int
    slips: int
    accepted: int
    accepted_by_band: NDArray[np.int64]
    same: int
    short_by: float
    widest: float

    def __add__(self, other: "AnswerTally") -> "AnswerTally":
        return AnswerTally(
            self.answers + other.answers,
            self.refused + other.refused,
            self.refused_by_band + other.refused_by_band,
            self.on_floor + other.on_floor,
            self.slips + other.slips,
            self.accepted + other.accepted,
            self.accepted_by_band + other.accepted_by_band,
            self.same + other.same,
            max(self.short_by, other.short_by),
            max(self.widest, other.widest),
        )


def tally_of(
    honest: Honest, quantity: Quantity, policy: Policy, bands: Sequence[float]
) -> AnswerTally:
    """Count what bands do to the answers and the wrong methods of one quantity.

    Args:
        honest: the students' work.
        quantity: one that is computed.
        policy: the grader's.
        bands: relative tolerances to try, narrowest first.
    """
    rule = TallyRule(honest, quantity, policy, honest.expected(quantity))
    coarsest = honest.coarsest()
    strict = TallyRule(coarsest, quantity, policy, coarsest.expected(quantity))
    typed = honest.typed[quantity.id]
    asked = np.isfinite(typed) & np.isfinite(honest.reference[quantity.id])
    now = tolerance_of(quantity, policy).relative
    slips, same = _slips(strict)
    spread = (rule.expected.high - rule.expected.low) / 2
    sized = asked & (np.abs(rule.expected.value) * bands[-1] > rule.floor)
    relative = spread[sized] / np.abs(rule.expected.value[sized])
    refused = asked & ~rule.accepts(typed, now)
    bare = asked & ~rule.accepts(typed, bands[0], floor=0.0)
    return AnswerTally(
        answers=int(asked.sum()),
        refused=int(refused.sum()),
        refused_by_band=np.array([(asked & ~rule.accepts(typed, one)).sum() for one in bands]),
        on_floor=int((bare & rule.accepts(typed, bands[0])).sum()),
        slips=sum(int(counted.sum()) for _, counted in slips),
        accepted=sum(int((counted & strict.accepts(value, now)).sum()) for value, counted in slips),
        accepted_by_band=np.array(
            [
                sum(int((counted & strict.accepts(value, one)).sum()) for value, counted in slips)
                for one in bands
            ]
        ),
        same=same,
        short_by=float(rule.distance(typed, now)[refused].max(initial=0.0)),
        widest=float(np.nanmax(relative, initial=0.0)),
    )


@dataclass(frozen=True, slots=True)
class TallyRule:
    """The grader's rule for one quantity."""

    honest: Honest
    quantity: Quantity
    policy: Policy
    expected: Expected

    @property
    def floor(self) -> float:
        """The absolute part of the band, in the declared unit."""
        return tolerance_of(self.quantity, self.policy).absolute

    def accepts(self, typed: Array, band: float, floor: float | None = None) -> NDArray[np.bool_]:
        """Tell which answers a relative band accepts; as `grading.judge_value`, for arrays."""
        least = self.floor if floor is None else floor
        reference = self.honest.reference[self.quantity.id]
        nearest = self._nearest(typed, band, least)
        return _within(typed, reference, band, least) | _within(typed, nearest, band, least)

    def distance(self, typed: Array, band: float) -> Array:
        """Return how far answers are from what is right, in the declared unit."""
        reference = self.honest.reference[self.quantity.id]
        nearest = self._nearest(typed, band, self.floor)
        return np.fmin(np.abs(typed - reference), np.abs(typed - nearest))

    def _nearest(self, typed: Array, band: float, floor: float) -> Array:
        """Return the nearest point of what follows, whose range the policy cuts."""
        follows = self.expected
        most = self.policy.widest * np.maximum(band * np.abs(follows.value), floor)
        low = np.maximum(follows.low, follows.value - most)
        high = np.minimum(follows.high, follows.value + most)
        return np.clip(typed, low, high)


def _within(typed: Array, right: Array, band: float, floor: float) -> NDArray[np.bool_]:
    half_width = np.maximum(band * np.abs(right), floor)
    return np.abs(typed - right) <= half_width * _SLACK


def _slips(rule: TallyRule) -> tuple[list[tuple[Array, NDArray[np.bool_]]], int]:
    """Return what is typed for each wrong method and which answers count, and how many are right.

    A wrong method that gives the very value of the right one is no wrong answer.
    """
    honest, quantity = rule.honest, rule.quantity
    right = rule.expected.value
    found, same = [], 0
    for candidate in candidates_of(honest.plan, quantity.id, rule.policy.slips):
        value = np.broadcast_to(honest.value(quantity, candidate.formula), right.shape)
        equal = np.abs(value - right) <= _SAME * np.abs(right)
        same += int(equal.sum())
        typed = written(value, honest.figures, cuts=True)
        found.append((typed, np.isfinite(value) & ~equal))
    return found, same
