"""Whether variants ask for different things: how sizes spread, and what is always the same.

A size that comes out the same for nearly everybody, a verdict that nearly everybody answers alike
and a range of which one end always governs tell no student from another.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np

from gripcourse.course.quantity import Kind
from gripcourse.formula.evaluate import evaluate as evaluate_formula
from gripcourse.formula.functions import SLACK
from gripcourse.formula.tree import Formula, choices_of_two, names
from gripcourse.solver.family import Member
from gripcourse.solver.solve import from_si
from gripcourse.text.units import dimension
from gripcourse.text.words import Texts
from gripcourse.variants.answers import Group
from gripcourse.variants.feasible import Array

_PERCENTS = (5.0, 50.0, 95.0)


@dataclass(frozen=True, slots=True)
class SizeSpread:
    """How a size is spread over the variants of one scheme.

    Attributes:
        scheme, quantity: which they are.
        unit: declared.
        is_picked: whether it is taken from a series or read from a table, and not computed.
        variants: how many have it.
        low, median, high: the least of the values at or below which 5, 50 and 95 % of them lie, in
            `unit`.
        rests_on: ids that it is taken for or read by.
        commonest: the value that most variants have, in `unit`.
        share: share of the variants that have it, 0 to 1.
    """

    scheme: str
    quantity: str
    unit: str
    is_picked: bool
    rests_on: frozenset[str]
    variants: int
    low: float
    median: float
    high: float
    commonest: float
    share: float


@dataclass(frozen=True, slots=True)
class EndShare:
    """Which of two values a formula takes as the greater or lesser in the variants of one scheme.

    Attributes:
        scheme, quantity: whose formula it is.
        first, second: ids of the quantities on either side that the other side lacks, for example
            those of the two ends of a range.
        variants: how many have it.
        share: of the variants in which the first is taken; half of those in which both are alike.
        because: why it is always the same; None where that is not declared.
    """

    scheme: str
    quantity: str
    first: str
    second: str
    variants: int
    share: float
    because: Texts | None = field(default=None, hash=False)  # a mapping has no hash

    @property
    def same(self) -> float:
        """Share of the variants in which the commoner of the two is taken, 0.5 to 1."""
        return max(self.share, 1 - self.share)


def sizes_of(groups: Sequence[Group]) -> tuple[SizeSpread, ...]:
    """Describe sizes scheme by scheme: what is picked, and every computed length."""
    return tuple(one for group in groups for one in _sizes(group))


def ends_of(groups: Sequence[Group]) -> tuple[EndShare, ...]:
    """Tell for each formula that takes the greater or lesser of two values which it takes."""
    return tuple(one for group in groups for one in _ends(group))


def _sizes(group: Group) -> Iterator[SizeSpread]:
    found: dict[str, list[Member]] = {}
    for member in group.family.answered:
        if _is_size(member):
            found.setdefault(member.quantity.id, []).append(member)
    for id_, members in found.items():
        values = np.concatenate([one.of(group.values[id_]) for one in members])
        values = values[np.isfinite(values)]
        if len(values):
            yield _spread(members[0], values)


def _is_size(member: Member) -> bool:
    quantity = member.quantity
    if quantity.kind in {Kind.CHOICE, Kind.PICK}:
        return True
    return quantity.kind is Kind.FORMULA and dimension(quantity.unit) == dimension("m")


def _spread(member: Member, values: Array) -> SizeSpread:
    quantity = member.quantity
    sorts, counts = np.unique(np.round(values, 12), return_counts=True)
    # Sizes that occur: between two sizes of a series there is none.
    ranks = np.percentile(values, _PERCENTS, method="inverted_cdf")
    found = (*ranks, sorts[np.argmax(counts)])
    low, median, high, commonest = (
        from_si(member.plan, {quantity.id: float(one)})[quantity.id] for one in found
    )
    return SizeSpread(
        member.plan.scheme.id,
        quantity.id,
        quantity.unit,
        quantity.kind is not Kind.FORMULA,
        frozenset(member.inputs),
        len(values),
        low,
        median,
        high,
        commonest,
        float(counts.max() / len(values)),
    )


@dataclass(frozen=True, slots=True)
class Taken:
    """Which of two values a formula takes, variant by variant.

    Attributes:
        member: whose formula it is.
        first, second: ids on either side that the other side lacks.
        share: of each variant that has it: 1 where the first is taken, 0 where the second is, a
            half where both are alike; NaN without a value.
    """

    member: Member
    first: str
    second: str
    share: Array


def taken_of(group: Group) -> Iterator[Taken]:
    """Yield what each formula takes that takes the greater or lesser of two values."""
    for member in group.family.answered:
        formula = member.plan.reference_formula(member.quantity.id)
        if formula is None or member.quantity.kind is not Kind.FORMULA:
            continue
        for call in choices_of_two(formula.tree):
            first, second = (
                evaluate_formula(
                    Formula("", one, formula.units),
                    "",
                    {name: member.of(group.values[name]) for name in names(one)},
                    member.plan.columns,
                )
                for one in call.arguments
            )
            sides = [set(names(one)) for one in call.arguments]
            sign = _sign(first, second) * (1 if call.function == "max" else -1)
            yield Taken(
                member,
                ", ".join(sorted(sides[0] - sides[1])),
                ", ".join(sorted(sides[1] - sides[0])),
                np.ravel((1 + sign) / 2),
            )


def _sign(first: Array, second: Array) -> Array:
    """Return the sign of a difference, 0 where two numbers are the same that came by two routes."""
    alike = np.abs(first - second) <= SLACK * np.maximum(np.abs(first), np.abs(second))
    return np.where(alike, 0.0, np.sign(first - second))


def _ends(group: Group) -> Iterator[EndShare]:
    taken: dict[tuple[str, str, str], list[Array]] = {}
    reasons: dict[tuple[str, str, str], Texts | None] = {}
    for one in taken_of(group):
        declared = one.member.quantity
        ends = (declared.id, one.first, one.second)
        taken.setdefault(ends, []).append(one.share)
        reasons[ends] = declared.one_end
    for ends, found in taken.items():
        shares = np.concatenate(found)
        shares = shares[np.isfinite(shares)]
        if len(shares):
            share = float(shares.mean())
            yield EndShare(group.family.scheme, *ends, len(shares), share, reasons[ends])
