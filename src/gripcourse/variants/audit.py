"""The audit of a table of variants: feasible, far from the results of slips, fair, apart.

The result is a value: whoever prints it computes nothing.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind
from gripcourse.policy.bands import SLACK
from gripcourse.policy.model import Policy, VariantRules
from gripcourse.text.words import Message
from gripcourse.variants.answers import (
    Group,
    given_items,
    items_of,
    mean_share,
    section_totals,
    solve_groups,
)
from gripcourse.variants.apart import Apartness, limits_of, measure
from gripcourse.variants.explain import in_short
from gripcourse.variants.fair import (
    DifficultySpread,
    Margin,
    Steps,
    VerdictShare,
    near_steps,
    spreads_of,
    steps_of,
    steps_ratio,
    verdicts_of,
)
from gripcourse.variants.feasible import Mask
from gripcourse.variants.model import Variant
from gripcourse.variants.monotony import EndShare, SizeSpread, ends_of, sizes_of
from gripcourse.variants.other_readings import ReadingCount, count_readings
from gripcourse.variants.overlaps import Overlap, OverlapCheck, overlaps_of
from gripcourse.variants.pairs import Answered, Pair, describe
from gripcourse.variants.slip_distance import SlipCount, count_slips, too_near
from gripcourse.variants.space import Space

CLOSEST = 20  # pairs that are told of a table that keeps its limits
FEW = 4  # variants of a scheme: of fewer nothing is said to be always the same
COUNTED = 64  # variants that slips of all kinds are counted in, evenly taken from a larger table


@dataclass(frozen=True, slots=True)
class CheckedScheme:
    """One variant.

    Attributes:
        variant: as the table has it.
        broken: what does not hold.
        slips: quantity and id of the slips that give nearly the right result.
        edges: the decisions whose size lies at the edge of its step.
        overlap: the worst pair of bodies that stand in each other; None for none, or where nobody
            looked.
        nearest: what its student would get with the answers that bring most; None for one that
            shares nothing with any other.
        above: whether that is more than a limit allows, whole or in a section.
    """

    variant: Variant
    broken: tuple[Message, ...]
    slips: tuple[tuple[str, str], ...]
    edges: tuple[str, ...]
    overlap: Overlap | None
    nearest: Pair | None
    above: bool

    @property
    def passed(self) -> bool:
        """Whether there is nothing to look at."""
        return not (self.broken or self.slips or self.edges or self.overlap or self.above)


@dataclass(frozen=True, slots=True)
class Beside:
    """What one student gets with another's answers on average, 0 to 1: no limit counts these.

    Attributes:
        computed: of the points of computed quantities, for comparison.
        sizes: of the points of sizes picked from a series and of what is read from a table by them.
        verdicts: of the points of verdicts.
        given: share of the given numbers that are the same.
    """

    computed: float
    sizes: float
    verdicts: float
    given: float


@dataclass(frozen=True, slots=True)
class VariantAudit:
    """Everything that was found out about a table.

    Attributes:
        rules: what was demanded.
        variants: one by one, in the order of the table.
        slips: of all kinds, the most frequent first, counted in `slips_counted` variants.
        readings: other readings of quantities, and how often they differ beyond the tolerance.
        steps: what each scheme with its options asks for.
        ratio: answers of the longest assignment over those of the shortest.
        margins: decisions, and how often a size lies at the edge of its step.
        spreads: answers to computed quantities, scheme by scheme.
        verdicts: how often each comes out as yes, scheme by scheme.
        sizes: how they are spread, scheme by scheme.
        ends: which of two values formulas take, scheme by scheme.
        overlaps: variants with bodies that stand in each other; None where nobody looked.
        apart: how far the variants are apart.
        beside: what counts for no limit.
        pairs: those that are farthest above a limit; without any, the nearest there are.
    """

    rules: VariantRules
    variants: tuple[CheckedScheme, ...]
    slips: tuple[SlipCount, ...]
    slips_counted: int
    readings: tuple[ReadingCount, ...]
    steps: tuple[Steps, ...]
    ratio: float
    margins: tuple[Margin, ...]
    spreads: tuple[DifficultySpread, ...]
    verdicts: tuple[VerdictShare, ...]
    sizes: tuple[SizeSpread, ...]
    ends: tuple[EndShare, ...]
    overlaps: int | None
    apart: Apartness
    beside: Beside
    pairs: tuple[Pair, ...]

    @property
    def weak_items(self) -> tuple[DifficultySpread, ...]:
        """Quantities that hardly differ in a scheme, the least different first."""
        weak = (one for one in self.spreads if one.equal > self.rules.weak_item)
        return tuple(sorted(weak, key=lambda one: (-one.equal, one.scheme, one.quantity)))

    @property
    def weak_verdicts(self) -> frozenset[str]:
        """Verdicts that have one answer in all variants of the table: they tell nobody apart."""
        yes: dict[str, list[VerdictShare]] = {}
        for one in self.verdicts:
            yes.setdefault(one.quantity, []).append(one)
        return frozenset(
            quantity
            for quantity, shares in yes.items()
            if sum(one.yes for one in shares) in {0, sum(one.variants for one in shares)}
        )

    @property
    def same_sizes(self) -> tuple[SizeSpread, ...]:
        """Sizes that are picked and come out the same too often, the commonest first.

        What is read from a table by such a size is not named again.
        """
        same = {
            (one.scheme, one.quantity): one
            for one in self.sizes
            if one.is_picked and one.share > self.rules.same_size and one.variants >= FEW
        }
        roots = (
            one
            for (scheme, _), one in same.items()
            if not any((scheme, name) in same for name in one.rests_on)
        )
        return tuple(sorted(roots, key=lambda one: (-one.share, one.scheme, one.quantity)))

    @property
    def same_ends(self) -> tuple[EndShare, ...]:
        """Formulas of which the same of two values is taken too often."""
        return tuple(
            one for one in self.ends if one.same > self.rules.same_end and one.variants >= FEW
        )

    @property
    def lopsided_verdicts(self) -> tuple[VerdictShare, ...]:
        """Verdicts that may come out either way and hardly do, scheme by scheme."""
        low, high = self.rules.verdict_no
        return tuple(
            one
            for one in self.verdicts
            if not one.must_hold
            and one.variants >= FEW
            and not low <= 1 - one.yes / one.variants <= high
        )

    @property
    def alike_steps(self) -> bool:
        """Whether the longest assignment asks for no more than the rules allow."""
        return self.ratio <= self.rules.steps_ratio

    @property
    def passed(self) -> bool:
        """Whether there is nothing to look at."""
        return self.alike_steps and all(one.passed for one in self.variants)


def audit(
    course: Course,
    policy: Policy,
    variants: Sequence[Variant],
    spaces: Sequence[Space] = (),
    check: OverlapCheck | None = None,
) -> VariantAudit:
    """Audit a table.

    Args:
        course: whose variants they are.
        policy: the rules for variants, bands and points.
        variants: the table.
        spaces: whose constraints the variants must satisfy as well.
        check: tells whether bodies stand in each other; None where nobody knows the bodies.
    """
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
    counted = _sample(variants)
    steps = steps_of(groups)
    edges = [near_steps(group, policy.variants.step_margin) for group in groups]
    overlaps = _overlaps(groups, check)
    return VariantAudit(
        rules=policy.variants,
        variants=_checked(variants, tuple(zip(groups, edges, strict=True)), overlaps, policy, apart,
                          dict(zip(nearest, pairs, strict=False))),
        slips=count_slips(solve_groups(course, counted), policy),
        slips_counted=len(counted),
        readings=count_readings(groups, policy),
        steps=steps,
        ratio=steps_ratio(steps),
        margins=_margins(groups, edges),
        spreads=spreads_of(groups, answered.computed),
        verdicts=verdicts_of(groups, answered.verdicts),
        sizes=sizes_of(groups),
        ends=ends_of(groups),
        overlaps=None if check is None else len(overlaps),
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
    overlaps: Mapping[int, Overlap],
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
        slips = too_near(group, policy)
        for place, row in enumerate(group.rows):
            broken = [one for one, at in group.refused.items() if at[place]]
            plan = group.family.plan(place) if broken else None
            found[int(row)] = CheckedScheme(
                variants[row],
                tuple(in_short(plan, one) for one in broken if plan is not None),
                tuple(key for key, at in slips.items() if at[place]),
                tuple(quantity for quantity, at in near.items() if at[place]),
                overlaps.get(int(row)),
                nearest.get(int(row)),
                bool(above[row]),
            )
    return tuple(found[row] for row in range(len(variants)))


def _overlaps(groups: Sequence[Group], check: OverlapCheck | None) -> dict[int, Overlap]:
    """Return by position the variants whose bodies stand in each other."""
    if check is None:
        return {}
    return {
        int(group.rows[place]): one
        for group in groups
        for place, one in overlaps_of(group, range(group.family.size), check)
    }


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


def _sample(variants: Sequence[Variant]) -> tuple[Variant, ...]:
    """Take variants at equal distances from a table that is larger than what is counted."""
    if len(variants) <= COUNTED:
        return tuple(variants)
    return tuple(variants[int(row)] for row in np.linspace(0, len(variants) - 1, COUNTED))
