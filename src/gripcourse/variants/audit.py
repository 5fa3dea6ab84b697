"""The audit of a table of variants: feasible, far from the results of slips, fair, apart."""

from collections.abc import Mapping, Sequence

import numpy as np

from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind
from gripcourse.policy.bands import SLACK
from gripcourse.policy.model import Policy
from gripcourse.variants.answers import (
    Group,
    given_items,
    items_of,
    mean_share,
    section_totals,
    solve_groups,
)
from gripcourse.variants.apart import Apartness, limits_of, measure
from gripcourse.variants.audited import Beside, CheckedScheme, VariantAudit
from gripcourse.variants.explain import in_short
from gripcourse.variants.fair import (
    Margin,
    near_steps,
    spreads_of,
    steps_of,
    steps_ratio,
    verdicts_of,
)
from gripcourse.variants.feasible import Mask
from gripcourse.variants.model import Variant
from gripcourse.variants.monotony import ends_of, sizes_of
from gripcourse.variants.one_by_one import OneByOne, look_at_each
from gripcourse.variants.other_readings import count_readings
from gripcourse.variants.overlaps import OverlapCheck
from gripcourse.variants.pairs import Answered, Pair, describe
from gripcourse.variants.space import Space

__all__ = ["CheckedScheme", "VariantAudit", "audit"]

CLOSEST = 20  # pairs that are told of a table that keeps its limits


def audit(
    course: Course,
    policy: Policy,
    variants: Sequence[Variant],
    spaces: Sequence[Space] = (),
    check: OverlapCheck | None = None,
    workers: int = 0,
) -> VariantAudit:
    """Audit a table.

    Args:
        course: whose variants they are.
        policy: the rules for variants, bands and points.
        variants: the table.
        spaces: whose constraints the variants must satisfy as well.
        check: tells whether bodies stand in each other; None where nobody knows the bodies.
        workers: how many processes; 0 for none but this one. They change nothing of the result.
    """
    each = look_at_each(course, policy, variants, check, workers)
    groups = solve_groups(course, variants, spaces)
    size, sections = len(variants), len(course.sections)
    answered = Answered(
        computed=items_of(groups, policy, Kind.FORMULA),
        sizes=items_of(groups, policy, Kind.CHOICE, Kind.PICK),
        verdicts=items_of(groups, policy, Kind.VERDICT),
        given=given_items(groups),
    )
    totals = section_totals(answered.computed, size, sections)
    apart = measure(answered.computed, totals, limits_of(policy))
    nearest = _nearest(apart)
    told = (*nearest.values(), *(apart.beyond or _closest(apart)))
    pairs = describe(told, groups, answered, totals, policy)
    steps = steps_of(groups)
    edges = [near_steps(group, policy.variants.step_margin) for group in groups]
    return VariantAudit(
        rules=policy.variants,
        variants=_checked(variants, tuple(zip(groups, edges, strict=True)), each, policy, apart,
                          dict(zip(nearest, pairs, strict=False))),
        slips=each.counts,
        slips_counted=each.counted,
        readings=count_readings(groups, policy),
        steps=steps,
        ratio=steps_ratio(steps),
        margins=_margins(groups, edges),
        spreads=spreads_of(groups, answered.computed),
        verdicts=verdicts_of(groups, answered.verdicts),
        sizes=sizes_of(groups),
        ends=ends_of(groups),
        overlaps=None if check is None else len(each.overlaps),
        apart=apart,
        beside=Beside(*(mean_share(items, size) for items in (
            answered.computed, answered.sizes, answered.verdicts, answered.given))),
        pairs=pairs[len(nearest) :],
    )  # fmt: skip


def _nearest(apart: Apartness) -> dict[int, tuple[int, int]]:
    """Return by position whose answers would bring a variant's student most."""
    return {row: (row, int(other)) for row, other in enumerate(apart.whole.nearest) if other >= 0}


def _closest(apart: Apartness) -> tuple[tuple[int, int], ...]:
    """Return the nearest pairs of a table, each once."""
    found: dict[frozenset[int], tuple[int, int]] = {}
    for row in np.argsort(-apart.whole.share, kind="stable"):
        if apart.whole.nearest[row] >= 0:
            pair = (int(row), int(apart.whole.nearest[row]))
            found.setdefault(frozenset(pair), pair)
        if len(found) == CLOSEST:
            break
    return tuple(found.values())


def _checked(
    variants: Sequence[Variant],
    solved: Sequence[tuple[Group, Mapping[str, Mask]]],
    each: OneByOne,
    policy: Policy,
    apart: Apartness,
    nearest: Mapping[int, Pair],
) -> tuple[CheckedScheme, ...]:
    limits = limits_of(policy)
    above = apart.whole.share > limits.whole * SLACK
    for section in apart.sections:
        above |= section.share > limits.section * SLACK
    found: dict[int, CheckedScheme] = {}
    for group, near in solved:
        for place, row in enumerate(group.rows):
            broken = [one for one, at in group.refused.items() if at[place]]
            plan = group.family.plan(place) if broken else None
            found[int(row)] = CheckedScheme(
                variants[row],
                tuple(in_short(plan, one) for one in broken if plan is not None),
                each.slips.get(int(row), ()),
                tuple(quantity for quantity, at in near.items() if at[place]),
                each.overlaps.get(int(row)),
                nearest.get(int(row)),
                bool(above[row]),
            )
    return tuple(found[row] for row in range(len(variants)))


def _margins(groups: Sequence[Group], edges: Sequence[Mapping[str, Mask]]) -> tuple[Margin, ...]:
    counts: dict[str, Margin] = {}
    for group, near in zip(groups, edges, strict=True):
        for one in group.family.answered:
            id_ = one.quantity.id
            if id_ in near:
                before = counts.get(id_, Margin(id_, 0, 0))
                where = one.of(near[id_])
                counts[id_] = Margin(
                    id_, before.near + int(where.sum()), before.variants + len(where)
                )
    return tuple(sorted(counts.values(), key=lambda one: (-one.near / one.variants, one.quantity)))
