"""Two variants in detail: what one student would get with the other's answers, and why."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from gripcourse.course.quantity import Kind
from gripcourse.policy.bands import SLACK, bands
from gripcourse.policy.model import Policy
from gripcourse.policy.points import points_of
from gripcourse.solver.solve import evaluate
from gripcourse.variants.answers import AnswerItem, Group, Rows
from gripcourse.variants.feasible import Array, Mask


@dataclass(frozen=True, slots=True)
class Answered:
    """The answers of a table by kind.

    Attributes:
        computed: what counts for the limits.
        sizes: decisions, and what is read from a table by them.
        verdicts: yes or no.
        given: the given numbers, one point each.
    """

    computed: tuple[AnswerItem, ...]
    sizes: tuple[AnswerItem, ...]
    verdicts: tuple[AnswerItem, ...]
    given: tuple[AnswerItem, ...]


@dataclass(frozen=True, slots=True)
class Pair:
    """What the student of one variant would get with the answers of another.

    Attributes:
        own, other: positions in the table: who gets the answers, whose they are.
        share: of the points of the computed quantities, 0 to 1.
        sections: the same by section.
        sizes, verdicts: of the points of these, which count for no limit; 0 where there are none.
        given: share of the given numbers that are the same.
        followed: `share` if all answers were copied and judged with credit for what follows from
            the student's own earlier numbers: then the copied numbers are these.
        equal: the computed quantities that are the same.
    """

    own: int
    other: int
    share: float
    sections: tuple[float, ...]
    sizes: float
    verdicts: float
    given: float
    followed: float
    equal: tuple[str, ...]


def describe(
    pairs: Sequence[tuple[int, int]],
    groups: Sequence[Group],
    answered: Answered,
    totals: Array,
    policy: Policy,
) -> tuple[Pair, ...]:
    """Describe pairs of variants.

    Args:
        pairs: positions in the table, who gets the answers first.
        groups: the solved table.
        answered: its answers by kind.
        totals: points of the computed quantities by variant and section, shape (n, sections).
        policy: bands and points.
    """
    if not pairs:
        return ()
    own, other = np.array(pairs, dtype=np.intp).T
    size, count = totals.shape
    equal = np.array([_equal(item, own, other, size)[0] for item in answered.computed])
    sections = np.zeros((len(pairs), count))
    for item, same in zip(answered.computed, equal, strict=True):
        entry = _places(item, size)[own[same]]
        sections[same, item.sections[entry]] += item.points[entry]
    whole = sections.sum(axis=1) / totals[own].sum(axis=1)
    by_section = sections / np.maximum(totals[own], np.finfo(float).tiny)
    sizes, verdicts, given = (
        _share(items, own, other, size)
        for items in (answered.sizes, answered.verdicts, answered.given)
    )
    followed = _followed(groups, own, other, equal, answered, policy)
    names = np.array([item.quantity for item in answered.computed])
    return tuple(
        Pair(
            own=int(own[row]),
            other=int(other[row]),
            share=float(whole[row]),
            sections=tuple(float(one) for one in by_section[row]),
            sizes=float(sizes[row]),
            verdicts=float(verdicts[row]),
            given=float(given[row]),
            followed=float(followed[row]),
            equal=tuple(str(name) for name in names[equal[:, row]]),
        )
        for row in range(len(pairs))
    )


def _places(item: AnswerItem, size: int) -> Rows:
    """Return the entry of each row of the table in an item, -1 where it has none."""
    places = np.full(size, -1, dtype=np.intp)
    places[item.rows] = np.arange(len(item.rows))
    return places


def _equal(item: AnswerItem, own: Rows, other: Rows, size: int) -> tuple[Mask, Rows]:
    """Tell for which pairs the other's answer fits, and return the entries of who gets it."""
    places = _places(item, size)
    mine, theirs = places[own], places[other]
    distance = np.abs(item.values[theirs] - item.values[mine])
    fits = distance <= item.half_widths[mine] * SLACK
    return (mine >= 0) & (theirs >= 0) & fits, mine


def _share(items: Sequence[AnswerItem], own: Rows, other: Rows, size: int) -> Array:
    got, total = np.zeros(len(own)), np.zeros(len(own))
    for item in items:
        same, entry = _equal(item, own, other, size)
        got += np.where(same, item.points[entry], 0.0)
        total += np.where(entry >= 0, item.points[entry], 0.0)
    return np.divide(got, total, out=np.zeros(len(own)), where=total > 0)


def _followed(
    groups: Sequence[Group],
    own: Rows,
    other: Rows,
    equal: Array,
    answered: Answered,
    policy: Policy,
) -> Array:
    """Return what copies would get that are judged against their own earlier numbers too."""
    size = sum(len(group.rows) for group in groups)
    typed = _table(groups, size)
    rows = {item.quantity: same for item, same in zip(answered.computed, equal, strict=True)}
    shares = np.zeros(len(own))
    for group in groups:
        where = np.isin(own, group.rows)
        if not where.any():
            continue
        place = np.searchsorted(group.rows, own[where])
        copied = {quantity.id: typed[quantity.id][other[where]] for quantity in group.plan.answered}
        known = {one.id: group.values[one.id][place] for one in group.plan.givens} | copied
        computed = evaluate(group.plan, known).computed
        points = points_of(group.plan, policy)
        got = np.zeros(int(where.sum()))
        total = 0.0
        for quantity in group.plan.answered:
            if quantity.kind is not Kind.FORMULA:
                continue
            reach = bands(quantity, computed[quantity.id], policy) * SLACK
            with np.errstate(invalid="ignore"):
                follows = np.abs(copied[quantity.id] - computed[quantity.id]) <= reach
            got += points[quantity.id] * (follows | rows[quantity.id][where])
            total += points[quantity.id]
        shares[where] = got / total if total else 0.0
    return shares


def _table(groups: Sequence[Group], size: int) -> Mapping[str, Array]:
    """Return every answer of the table by quantity, shape (n,), NaN where a variant has none."""
    typed: dict[str, Array] = {}
    for group in groups:
        for quantity in group.plan.answered:
            column = typed.setdefault(quantity.id, np.full(size, np.nan))
            column[group.rows] = group.values[quantity.id]
    return typed
