"""Which of many sound candidates are drawn, so that what has two outcomes comes out either way.

A verdict that is "yes" for nearly everybody, and a range of which the same end nearly always
governs, tell no student from another. Ranges make both outcomes possible; how often they occur is
left to the drawing, which counts them and prefers what balances them.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Final, TypeAlias

import numpy as np

from gripcourse.course.quantity import Kind
from gripcourse.variants.answers import Group
from gripcourse.variants.feasible import Array, Mask
from gripcourse.variants.monotony import taken_of

_SWEEPS: Final = 3  # times that every choice is looked at again, beside the others
_VERDICT_WEIGHT: Final = 3.0  # it has points of its own that a guess must not earn
_END_WEIGHT: Final = 1.0  # of an end of a range
_SIZE_WEIGHT: Final = 0.5  # of a size that more than half of the variants have
_LEAST_SHARE: Final = 0.1  # of the candidates that have what is balanced; fewer count as so many
_DIGITS: Final = 9  # of what is compared: sizes in SI units, and how uneven a choice leaves things

Name: TypeAlias = tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Outcomes:
    """What has two outcomes, candidate by candidate: the one is as welcome as the other.

    Of a size that is picked each value makes an outcome of its own: to have it or another. There
    only the first is unwelcome, where more than half have it.

    Attributes:
        names: which they are, shape (m,): a quantity, with the two sides of an end or with the
            value of a size.
        weights: how much the balance of each counts, shape (m,).
        is_size: which of them are sizes, shape (m,).
        marks: 1 for the one outcome, -1 for the other, 0 where a candidate has neither; (k, m).
    """

    names: tuple[Name, ...]
    weights: Array
    is_size: Mask
    marks: Array


@dataclass(slots=True)
class Balance:
    """How often either outcome was drawn so far, scheme by scheme."""

    ahead: dict[Name, float] = field(default_factory=dict)
    sizes: dict[Name, int] = field(default_factory=dict)

    def of(self, scheme: str, outcomes: Outcomes) -> Array:
        """Return by how much the one outcome is ahead of the other, shape (m,)."""
        return np.array([
            2 * self.sizes.get((scheme, *name), 0) - self.sizes.get((scheme, name[0]), 0)
            if is_size
            else self.ahead.get((scheme, *name), 0.0)
            for name, is_size in zip(outcomes.names, outcomes.is_size, strict=True)
        ])  # fmt: skip

    def count(self, scheme: str, outcomes: Outcomes, place: int) -> None:
        """Count a candidate that was drawn."""
        marks = outcomes.marks[place]
        for name, is_size, mark in zip(outcomes.names, outcomes.is_size, marks, strict=True):
            if not is_size:
                key = (scheme, *name)
                self.ahead[key] = self.ahead.get(key, 0.0) + float(mark)
            elif mark > 0:
                for key in ((scheme, *name), (scheme, name[0])):
                    self.sizes[key] = self.sizes.get(key, 0) + 1


def outcomes_of(group: Group) -> Outcomes:
    """Tell how verdicts that may be no come out, which end of a range governs, and the sizes."""
    columns: dict[Name, Array] = {}
    weights: dict[Name, float] = {}

    def column(name: Name, weight: float) -> Array:
        weights[name] = weight
        return columns.setdefault(name, np.zeros(group.family.size))

    for member in group.family.answered:
        id_ = member.quantity.id
        own = member.of(group.values[id_])
        if member.quantity.kind is Kind.VERDICT and not member.quantity.must_hold:
            column((id_,), _VERDICT_WEIGHT)[member.at] = 2 * own - 1
        elif member.quantity.kind in {Kind.CHOICE, Kind.PICK}:
            for value in np.unique(np.round(own[np.isfinite(own)], _DIGITS)):
                has = np.isclose(own, value, rtol=0, atol=10.0**-_DIGITS)
                column((id_, str(value)), _SIZE_WEIGHT)[member.at] = np.where(has, 1, -1)
    for one in taken_of(group):
        name = (one.member.quantity.id, one.first, one.second)
        column(name, _END_WEIGHT)[one.member.at] = 2 * one.share - 1
    marks = np.array(list(columns.values())).reshape(len(columns), group.family.size).T
    is_size = np.array([len(name) == 2 for name in columns], dtype=np.bool_)  # noqa: PLR2004
    marks = np.nan_to_num(marks)
    return Outcomes(tuple(columns), np.array(list(weights.values())) / _held(marks), is_size, marks)


def _held(marks: Array) -> Array:
    """Return what weights are divided by, shape (m,): fewer make uneven what few have."""
    share = (marks != 0).mean(axis=0) if len(marks) else np.ones(marks.shape[1])
    return np.asarray(np.maximum(share, _LEAST_SHARE) ** 2)


def choose(
    outcomes: Outcomes,
    ahead: Array,
    waiting: Mapping[int, Sequence[int]],
    lacking: Mapping[int, int],
) -> list[int]:
    """Choose candidates that balance what has two outcomes.

    Each place is filled with the candidate that leaves the least sum of squares, then every choice
    is looked at again beside all others.

    Args:
        outcomes: of the candidates.
        ahead: by how much the one outcome is ahead so far, shape (m,).
        waiting: candidates of each combination.
        lacking: how many of each are wanted.

    Returns:
        As many places of each combination as it lacks, as far as there are any; ascending.
    """
    pools = [
        np.asarray(places, dtype=np.intp)
        for case, places in waiting.items()
        for _ in range(min(lacking[case], len(places)))
    ]
    marks, now = outcomes.marks, ahead.astype(np.float64)
    least = np.where(outcomes.is_size, 0.0, -np.inf)
    chosen = np.full(len(pools), -1, dtype=np.intp)
    free = np.ones(len(marks), dtype=np.bool_)
    for _ in range(_SWEEPS):
        before = chosen.copy()
        for number, pool in enumerate(pools):
            if chosen[number] >= 0:
                now -= marks[chosen[number]]
                free[chosen[number]] = True
            open_ = pool[free[pool]]
            left = np.maximum(now + marks[open_], least)
            # Of candidates that are equally good the first is taken, however sums are rounded.
            best = open_[np.argmin(np.round(left**2 @ outcomes.weights, _DIGITS))]
            chosen[number], free[best] = best, False
            now += marks[best]
        if (chosen == before).all():
            break
    return sorted(int(place) for place in chosen)
