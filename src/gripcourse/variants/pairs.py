"""Two variants in detail: what one student would get with the other's answers, and why."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from gripcourse.course.quantity import Kind
from gripcourse.policy.bands import SLACK, bands
from gripcourse.policy.model import Policy
from gripcourse.solver.family import Rows, evaluate_family
from gripcourse.variants.answers import AnswerItem, Group
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
    if not item.rows.size:  # it comes out in no variant
        return np.zeros(len(own), dtype=np.bool_), mine
    distance = np.abs(item.values[theirs] - item.values[mine])
    fits = distance <= item.half_widths[mine] * SLACK
    return (mine >= 0) & (theirs >= 0) & fits, mine


def _share(items: Sequence[AnswerItem], own: Rows, other: Rows, size: int) -> Array:
    got, total = np.zeros(len(own)), np.zeros(len(own))
    for item in (one for one in items if one.rows.size):
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
        asked = np.flatnonzero(np.isin(own, group.rows))
        if len(asked):
            shares[asked] = _followed_in(group, own[asked], other[asked], typed, policy, {
                id_: same[asked] for id_, same in rows.items()
            })  # fmt: skip
    return shares


def _followed_in(
    group: Group,
    own: Rows,
    other: Rows,
    typed: Mapping[str, Array],
    policy: Policy,
    equal: Mapping[str, Mask],
) -> Array:
    """Do the same for pairs whose own variants are of one group, as often as each is asked for."""
    place = np.searchsorted(group.rows, own)
    shares = np.zeros(len(own))
    # A variant may be in several pairs: each round takes it once.
    turn = _turns(place)
    for number in range(int(turn.max()) + 1):
        now = np.flatnonzero(turn == number)
        at = place[now]
        whose = np.full(group.family.size, -1, dtype=np.intp)
        whose[at] = other[now]
        known = {one.quantity.id: group.values[one.quantity.id] for one in group.family.givens}
        copied = {
            one.quantity.id: np.where(whose >= 0, typed[one.quantity.id][whose], np.nan)
            for one in group.family.answered
        }
        computed = evaluate_family(group.family, known | copied).computed
        same = {id_: np.zeros(group.family.size, dtype=np.bool_) for id_ in equal}
        for id_, where in equal.items():
            same[id_][at] = where[now]
        got, total = np.zeros(group.family.size), np.zeros(group.family.size)
        for member, points in group.points(policy):
            if member.quantity.kind is not Kind.FORMULA:
                continue
            id_ = member.quantity.id
            right = member.of(computed[id_])
            reach = bands(member.quantity, right, policy) * SLACK
            with np.errstate(invalid="ignore"):
                follows = np.abs(member.of(copied[id_]) - right) <= reach
            got[member.at] += points * (follows | member.of(same[id_]))
            total[member.at] += points
        share = np.divide(got, total, out=np.zeros(group.family.size), where=total > 0)
        shares[now] = share[at]
    return shares


def _turns(places: Rows) -> Rows:
    """Number how many times each place has come before."""
    order = np.argsort(places, kind="stable")
    ascending = places[order]
    starts = np.flatnonzero(np.concatenate([[True], ascending[1:] != ascending[:-1]]))
    first = np.repeat(starts, np.diff(np.concatenate([starts, [len(places)]])))
    turns = np.zeros(len(places), dtype=np.intp)
    turns[order] = np.arange(len(places)) - first
    return turns


def _table(groups: Sequence[Group], size: int) -> Mapping[str, Array]:
    """Return every answer of the table by quantity, shape (n,), NaN where a variant has none."""
    typed: dict[str, Array] = {}
    for group in groups:
        for member in group.family.answered:
            id_ = member.quantity.id
            column = typed.setdefault(id_, np.full(size, np.nan))
            column[member.of(group.rows)] = member.of(group.values[id_])
    return typed
