"""The answers of a whole table of variants: every variant solved, quantity by quantity.

Variants of different schemes and options share a quantity where both have the same id.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind
from gripcourse.policy.bands import SLACK, bands
from gripcourse.policy.model import Policy
from gripcourse.policy.points import shares_of, weight_of
from gripcourse.solver.family import Family, Member, Rows, families_of
from gripcourse.variants.feasible import Array, Mask, Reason, judge
from gripcourse.variants.model import Variant
from gripcourse.variants.space import Space

_SAME = 1e-9  # relative; given numbers differ only by how floating point writes them


@dataclass(frozen=True, slots=True, eq=False)
class Group:
    """Variants of one scheme, solved together.

    Attributes:
        family: what they are, each with its options.
        rows: their positions in the table, ascending, shape (n,).
        values: of every quantity by id, SI, each of shape (n,); NaN for a variant without it.
        refused: why variants cannot be handed out, by reason; of shape (n,).
    """

    family: Family
    rows: Rows
    values: Mapping[str, Array]
    refused: Mapping[Reason, Mask]

    def restricted(self, places: Rows) -> "Group":
        """Return the group of some of the variants, at these ascending places."""
        return Group(
            self.family.restricted(places),
            np.arange(len(places)),
            {id_: values[places] for id_, values in self.values.items()},
            {reason: where[places] for reason, where in self.refused.items()},
        )

    def points(self, policy: Policy) -> Iterator[tuple[Member, Array]]:
        """Yield each marked quantity with its points, one number for each variant that has it."""
        marked = [
            one
            for one in self.family.members
            if one.quantity.kind.answered or one.quantity.kind is Kind.MANUAL
        ]
        sums: dict[str, tuple[Array, Array]] = {}
        for one in marked:
            fixed, weights = sums.setdefault(
                one.quantity.section, (np.zeros(self.family.size), np.zeros(self.family.size))
            )
            own = policy.main_points.get(one.quantity.id)
            if own is None:
                weights[one.at] += weight_of(one.quantity, policy)
            else:
                fixed[one.at] += own
        for one in marked:
            fixed, weights = (one.of(each) for each in sums[one.quantity.section])
            yield one, shares_of(one.quantity, policy, fixed, weights)


@dataclass(frozen=True, slots=True)
class AnswerItem:
    """One quantity in all variants that have it; every array of shape (k,).

    Attributes:
        quantity: its id.
        rows: positions in the table, ascending.
        values: the answers, SI.
        half_widths: of the bands round them, SI.
        points: that the answer is worth.
        sections: number of the section that these points belong to.
        schemes: number of the variant's scheme.
    """

    quantity: str
    rows: Rows
    values: Array
    half_widths: Array
    points: Array
    sections: Rows
    schemes: Rows


@dataclass(frozen=True, slots=True)
class Windows:
    """Which neighbours in sorted order fit the band of each variant of an item.

    Attributes:
        order: rows of the table in the order of the values.
        first, last: of the fitting ones in `order`, per entry of the item; `last` is excluded.
    """

    order: Rows
    first: Rows
    last: Rows


def windows_of(item: AnswerItem) -> Windows:
    """Sort the values of an item; what fits a band is then a stretch of neighbours."""
    order = np.argsort(item.values, kind="stable")
    ascending = item.values[order]
    reach = item.half_widths * SLACK
    first = np.searchsorted(ascending, item.values - reach, side="left")
    last = np.searchsorted(ascending, item.values + reach, side="right")
    return Windows(item.rows[order], first, last)


def count_fitting(item: AnswerItem) -> Rows:
    """Count for each entry of an item the other variants whose answer fits its band."""
    window = windows_of(item)
    return window.last - window.first - 1


def solve_groups(
    course: Course, variants: Sequence[Variant], spaces: Sequence[Space] = ()
) -> tuple[Group, ...]:
    """Solve a table, all variants of a scheme in one evaluation.

    Args:
        course: whose variants they are.
        variants: the table.
        spaces: whose constraints the variants must satisfy as well.
    """
    constraints = {space.scheme: space.constraints for space in spaces}
    groups = []
    for rows, family in families_of(course, [one.composition for one in variants]):
        given = {
            id_: np.array([variants[row].given.get(id_, np.nan) for row in rows])
            for id_ in dict.fromkeys(one.quantity.id for one in family.givens)
        }
        judged = judge(family, given, constraints.get(family.scheme, ()))
        groups.append(Group(family, rows, judged.evaluation.values, judged.refused))
    return tuple(groups)


def items_of(groups: Sequence[Group], policy: Policy, *kinds: Kind) -> tuple[AnswerItem, ...]:
    """Gather the answers of some kinds of quantities over all groups, quantity by quantity."""
    parts: dict[str, list[AnswerItem]] = {}
    schemes = {id_: number for number, id_ in enumerate(scheme_ids(groups))}
    for group in groups:
        for member, points in group.points(policy):
            quantity = member.quantity
            if quantity.kind in kinds:
                widths = bands(quantity, member.of(group.values[quantity.id]), policy)
                part = _item(group, member, points, widths, schemes[group.family.scheme])
                parts.setdefault(quantity.id, []).append(part)
    return tuple(_joined(found) for found in parts.values())


def given_items(groups: Sequence[Group]) -> tuple[AnswerItem, ...]:
    """Gather the given numbers over all groups: one point each, equal only where the same."""
    parts: dict[str, list[AnswerItem]] = {}
    schemes = {id_: number for number, id_ in enumerate(scheme_ids(groups))}
    for group in groups:
        scheme = schemes[group.family.scheme]
        for member in group.family.givens:
            values = member.of(group.values[member.quantity.id])
            part = _item(group, member, np.ones(len(values)), np.abs(values) * _SAME, scheme)
            parts.setdefault(member.quantity.id, []).append(part)
    return tuple(_joined(found) for found in parts.values())


def mean_share(items: Sequence[AnswerItem], size: int) -> float:
    """Return which share of its points one variant gets with another's answers, on average."""
    if size < 2:  # noqa: PLR2004 (a single variant has no other)
        return 0.0
    shared, total = np.zeros(size), np.zeros(size)
    for item in items:
        shared[item.rows] += item.points * count_fitting(item)
        total[item.rows] += item.points
    some = total > 0
    return float((shared[some] / total[some]).sum() / (size - 1) / size)


def scheme_ids(groups: Sequence[Group]) -> tuple[str, ...]:
    """Return the schemes of a table, each once; `AnswerItem.schemes` counts in this order."""
    return tuple(dict.fromkeys(group.family.scheme for group in groups))


def section_totals(items: Sequence[AnswerItem], size: int, sections: int) -> Array:
    """Add up the points of items.

    Args:
        items: whose points count.
        size: how many variants the table has.
        sections: how many sections the course has.

    Returns:
        Points by variant and section, shape (size, sections).
    """
    totals = np.zeros((size, sections))
    for item in items:
        totals[item.rows, item.sections] += item.points
    return totals


def _item(
    group: Group, member: Member, points: Array, half_widths: Array, scheme: int
) -> AnswerItem:
    values = member.of(group.values[member.quantity.id])
    there = np.isfinite(values)
    rows = member.of(group.rows)[there]
    sections = [section.id for section in member.plan.course.sections]
    return AnswerItem(
        member.quantity.id,
        rows,
        values[there],
        half_widths[there],
        points[there],
        np.full(rows.shape, sections.index(member.quantity.section), dtype=np.intp),
        np.full(rows.shape, scheme, dtype=np.intp),
    )


def _joined(parts: Sequence[AnswerItem]) -> AnswerItem:
    rows = np.concatenate([part.rows for part in parts])
    order = np.argsort(rows)
    return AnswerItem(
        parts[0].quantity,
        rows[order],
        np.concatenate([part.values for part in parts])[order],
        np.concatenate([part.half_widths for part in parts])[order],
        np.concatenate([part.points for part in parts])[order],
        np.concatenate([part.sections for part in parts])[order],
        np.concatenate([part.schemes for part in parts])[order],
    )
