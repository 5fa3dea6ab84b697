"""The answers of a whole table of variants: every variant solved, quantity by quantity.

Variants of different schemes and options share a quantity where both have the same id.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gripcourse.course.composition import Composition
from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind, Quantity
from gripcourse.formula.tree import Formula
from gripcourse.policy.bands import SLACK, bands
from gripcourse.policy.model import Policy
from gripcourse.policy.points import points_of
from gripcourse.solver.plan import Plan, plan_of
from gripcourse.variants.cases import Cases
from gripcourse.variants.feasible import Array, Feasibility, Mask, Reason, reasons_infeasible
from gripcourse.variants.model import Variant
from gripcourse.variants.space import Space

Rows = NDArray[np.intp]

_SAME = 1e-9  # relative; given numbers differ only by how floating point writes them


@dataclass(frozen=True, slots=True)
class Group:
    """Variants of one scheme with the same options, solved together.

    Attributes:
        plan: that they share.
        rows: their positions in the table, ascending, shape (k,).
        values: of every quantity by id, SI, each of shape (k,).
        refused: why variants cannot be handed out, by reason; of shape (k,).
    """

    plan: Plan
    rows: Rows
    values: Mapping[str, Array]
    refused: Mapping[Reason, Mask]


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
    """Solve a table, all variants with the same scheme and options in one evaluation.

    Args:
        course: whose variants they are.
        variants: the table.
        spaces: whose constraints the variants must satisfy as well.
    """
    together: dict[Composition, list[int]] = {}
    for row, variant in enumerate(variants):
        together.setdefault(variant.composition, []).append(row)
    by_scheme = {space.scheme: space.cases for space in spaces}
    groups = []
    for composition, rows in together.items():
        plan = plan_of(course, composition)
        given = {
            quantity.id: np.array([variants[row].given[quantity.id] for row in rows])
            for quantity in plan.givens
        }
        judged = reasons_infeasible(plan, given, _constraints(by_scheme, composition))
        groups.append(group_of(plan, judged, np.arange(len(rows)), np.array(rows, dtype=np.intp)))
    return tuple(groups)


def _constraints(by_scheme: Mapping[str, Cases], composition: Composition) -> tuple[Formula, ...]:
    cases = by_scheme.get(composition.scheme)
    case = None if cases is None else cases.with_options(composition.options)
    return () if case is None else case.constraints


def group_of(plan: Plan, judged: Feasibility, positions: Rows, rows: Rows) -> Group:
    """Make a group of some of the variants that were judged together.

    Args:
        plan: that they share.
        judged: all of them.
        positions: of those that are wanted, shape (k,).
        rows: positions that these have in the table, shape (k,).
    """
    shape = judged.feasible.shape
    values = {
        id_: np.broadcast_to(values, shape)[positions]
        for id_, values in judged.evaluation.values.items()
    }
    refused = {reason: where[positions] for reason, where in judged.refused.items()}
    return Group(plan, rows, values, refused)


def items_of(groups: Sequence[Group], policy: Policy, *kinds: Kind) -> tuple[AnswerItem, ...]:
    """Gather the answers of some kinds of quantities over all groups, quantity by quantity."""
    parts: dict[str, list[AnswerItem]] = {}
    schemes = {id_: number for number, id_ in enumerate(scheme_ids(groups))}
    for group in groups:
        points = points_of(group.plan, policy)
        for quantity in group.plan.answered:
            if quantity.kind in kinds:
                part = _part(group, quantity, points, policy, schemes[group.plan.scheme.id])
                parts.setdefault(quantity.id, []).append(part)
    return tuple(_joined(found) for found in parts.values())


def given_items(groups: Sequence[Group]) -> tuple[AnswerItem, ...]:
    """Gather the given numbers over all groups: one point each, equal only where the same."""
    parts: dict[str, list[AnswerItem]] = {}
    schemes = {id_: number for number, id_ in enumerate(scheme_ids(groups))}
    for group in groups:
        scheme = schemes[group.plan.scheme.id]
        for quantity in group.plan.givens:
            values = group.values[quantity.id]
            part = _item(group, quantity, 1.0, np.abs(values) * _SAME, scheme)
            parts.setdefault(quantity.id, []).append(part)
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
    return tuple(dict.fromkeys(group.plan.scheme.id for group in groups))


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


def _part(
    group: Group, quantity: Quantity, points: Mapping[str, float], policy: Policy, scheme: int
) -> AnswerItem:
    half_widths = bands(quantity, group.values[quantity.id], policy)
    return _item(group, quantity, points[quantity.id], half_widths, scheme)


def _item(
    group: Group, quantity: Quantity, points: float, half_widths: Array, scheme: int
) -> AnswerItem:
    values = group.values[quantity.id]
    there = np.isfinite(values)
    rows = group.rows[there]
    sections = [section.id for section in group.plan.course.sections]
    return AnswerItem(
        quantity.id,
        rows,
        values[there],
        half_widths[there],
        np.full(rows.shape, points),
        np.full(rows.shape, sections.index(quantity.section), dtype=np.intp),
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
