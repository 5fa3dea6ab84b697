"""Whose variant do some numbers come from: variants ranked by the odds that they are theirs."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gripcourse.likeness.cells import Floats
from gripcourse.likeness.issued import IssuedValues
from gripcourse.likeness.matches import ComparedNumbers, Spread, density, last_unit

_TRUE = 0.95  # share of the numbers that come from the variant: one may be misread
_LEAST = 1e-4  # nobody knows chance better than this
_OWN_ROUNDING = 1e-9  # relative
_STRANGERS: Final[Mapping[str, str]] = MappingProxyType({})


@dataclass(frozen=True, slots=True)
class Clue:
    """One number of unknown origin.

    Attributes:
        text: as it was typed.
        meanings: what it can be: value and half a unit of its last digit, in the declared unit, by
            quantity.
    """

    text: str
    meanings: Mapping[str, tuple[float, float]]


@dataclass(frozen=True, slots=True)
class Match:
    """What one number is in a variant; an empty quantity where it is nothing there."""

    text: str
    quantity: str
    value: float


@dataclass(frozen=True, slots=True)
class Origin:
    """A variant that numbers may come from.

    Attributes:
        owner: of the row of issued values.
        odds: of this variant against all variants of other people and against none of them.
        matches: one for each number.
    """

    owner: str
    odds: float
    matches: tuple[Match, ...]


def rank(
    clues: Sequence[Clue], issued: IssuedValues, people: Mapping[str, str] = _STRANGERS
) -> tuple[Origin, ...]:
    """Rank variants by how well they explain numbers.

    Args:
        clues: the numbers; each is compared at the precision that was typed.
        issued: the values of the variants.
        people: whose a variant is, by owner, where one person has several: versions of one
            assignment are alike, and do not make each other less likely.

    Returns:
        The variants in which any number occurs, the likeliest first.
    """
    if not clues:
        return ()
    named = [people.get(owner, owner) for owner in issued.owners]
    whose = np.unique(named, return_inverse=True)[1]
    found = [_nearest(clue, issued, whose) for clue in clues]
    logs = np.zeros(len(issued.owners))
    for column, chance in found:
        logs += np.log((1 - _TRUE) + _TRUE * (column >= 0) / chance)
    prior = logs - math.log(max(len(np.unique(whose)), 1))
    odds = _against_others(prior, whose)
    occurs = np.any([column >= 0 for column, _ in found], axis=0)
    order = [row for row in np.argsort(-logs, kind="stable") if occurs[row]]
    return tuple(
        Origin(
            owner=issued.owners[row],
            odds=float(odds[row]),
            matches=tuple(
                _match(clue, issued, int(column[row]), int(row))
                for clue, (column, _) in zip(clues, found, strict=True)
            ),
        )
        for row in order
    )


def _against_others(prior: Floats, whose: NDArray[np.intp]) -> Floats:
    """Return the odds of each row against the rows of others, and against none at all.

    Args:
        prior: (rows,); logarithms of what speaks for each, 0 for none of them.
        whose: (rows,); number of the person that each belongs to.
    """
    top = max(0.0, float(prior.max(initial=0.0)))
    weights = np.exp(prior - top)
    own = np.bincount(whose, weights)
    rest = own.sum() + math.exp(-top) - own
    # What is left beside somebody who has nearly everything is lost in a difference.
    likeliest = np.argmax(own)
    rest[likeliest] = np.delete(own, likeliest).sum() + math.exp(-top)
    with np.errstate(divide="ignore"):
        return np.asarray(weights / rest[whose])


def _match(clue: Clue, issued: IssuedValues, column: int, row: int) -> Match:
    if column < 0:
        return Match(clue.text, "", math.nan)
    return Match(
        clue.text,
        issued.quantities[column],
        float(issued.at(np.array([row]), np.array([column]))[0]),
    )


def _nearest(
    clue: Clue, issued: IssuedValues, whose: NDArray[np.intp]
) -> tuple[NDArray[np.intp], Floats]:
    """Find for each variant the quantity that a number is; −1 where it is none.

    Returns:
        The column by row, and the probability that a variant has such a number by chance.
    """
    rows = len(issued.owners)
    columns = [
        (column, *clue.meanings[name])
        for column, name in enumerate(issued.quantities)
        if name in clue.meanings and clue.meanings[name][0] != 0
    ]
    if not columns:
        return np.full(rows, -1), np.ones(rows)
    place = np.array([column for column, *_ in columns], dtype=np.intp)
    value = np.array([one for _, one, _ in columns])
    unit = last_unit(value, np.array([half for *_, half in columns]))
    reach = np.maximum(unit, _OWN_ROUNDING * np.abs(value))
    values = issued.dense(place)
    away = np.where(np.isfinite(values), np.abs(values - value), np.inf) / reach
    best = np.argmin(away, axis=1)
    fits = away[np.arange(rows), best] <= 1 + _OWN_ROUNDING
    numbers = ComparedNumbers(np.zeros(len(place), dtype=np.intp), place, value, unit)
    near = density(numbers, Spread.of(issued.values)) * 2 * reach / np.abs(value)
    by_spread = np.isfinite(values) @ near
    by_count = (len(np.unique(whose[fits])) - 1) / max(len(np.unique(whose)), 1)
    chance = np.clip(np.maximum(by_spread, by_count), _LEAST, 1.0)
    return np.where(fits, place[best], -1), chance
