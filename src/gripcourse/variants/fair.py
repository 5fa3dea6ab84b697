"""Whether variants ask alike: steps of the calculation, sizes near a step of a series, spread."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from gripcourse.course.composition import Composition
from gripcourse.course.quantity import Kind
from gripcourse.solver.family import Family, Member, Rows
from gripcourse.solver.sizes import compute
from gripcourse.solver.solve import from_si
from gripcourse.variants.answers import AnswerItem, Group, count_fitting, scheme_ids
from gripcourse.variants.feasible import Mask


@dataclass(frozen=True, slots=True)
class Steps:
    """How much the variants of one scheme with the same options ask for.

    Attributes:
        composition: which they are.
        variants: how many the table has.
        computed, decided, read: quantities that are computed, decided, read from a table or
            answered with yes or no.
        chain: answers in the longest chain, each needed for the next.
    """

    composition: Composition
    variants: int
    computed: int
    decided: int
    read: int
    chain: int

    @property
    def total(self) -> int:
        """All answers together."""
        return self.computed + self.decided + self.read


@dataclass(frozen=True, slots=True)
class Margin:
    """In how many of the variants with a decision a size lies at the edge of its step."""

    quantity: str
    near: int
    variants: int


@dataclass(frozen=True, slots=True)
class DifficultySpread:
    """How the answers to one quantity are spread over the variants of one scheme.

    Attributes:
        quantity, scheme: which they are.
        variants: how many have the quantity.
        points: that it is worth, the mean over the variants.
        unit: declared.
        lowest, median, highest: of the answers, in `unit`.
        equal: share of the ordered pairs of these variants in which one's answer fits the other's
            band, 0 to 1.
    """

    quantity: str
    scheme: str
    variants: int
    points: float
    unit: str
    lowest: float
    median: float
    highest: float
    equal: float


@dataclass(frozen=True, slots=True)
class VerdictShare:
    """How often a verdict comes out as yes in the variants of one scheme.

    Attributes:
        quantity, scheme: which they are.
        variants: how many have the verdict.
        points: that it is worth, the mean over the variants.
        yes: in how many of them the answer is yes.
        must_hold: whether the course refuses variants in which it is no.
    """

    quantity: str
    scheme: str
    variants: int
    points: float
    yes: int
    must_hold: bool


def steps_of(groups: Sequence[Group]) -> tuple[Steps, ...]:
    """Count the answers that the variants of each composition are asked for."""
    return tuple(one for group in groups for one in _steps(group.family))


def steps_ratio(steps: Sequence[Steps]) -> float:
    """Return how many times as many answers as the shortest assignment the longest asks for."""
    longest = max((one.total for one in steps), default=0)
    shortest = min((one.total for one in steps), default=0)
    return longest / shortest if shortest else 1.0


def near_steps(group: Group, margin: float) -> dict[str, Mask]:
    """Return by decision the variants in which a size lies at the edge of its step.

    There the size changes when a computed answer that it is taken for moves by `margin`, a share
    of itself: a student who rounds honestly could be led to the other size. A size that is taken
    straight for given numbers and other sizes is never at an edge: these are not rounded, but an
    answer computed from given numbers alone is. Nor is one at an edge whose
    neighbour is no further off than the answer may move to both sides, such as 126 whole turns:
    every answer would be at an edge, and it hardly matters which of the two is taken.

    Args:
        group: solved variants.
        margin: how far an answer may move, 0 to 1.
    """
    found: dict[str, Mask] = {}
    for member in group.family.answered:
        if member.quantity.kind is Kind.CHOICE:
            near = found.setdefault(member.quantity.id, np.zeros(group.family.size, dtype=np.bool_))
            near[member.at] = _moves(group, member, margin)
    return found


def spreads_of(
    groups: Sequence[Group], items: Sequence[AnswerItem]
) -> tuple[DifficultySpread, ...]:
    """Describe the answers to each quantity, scheme by scheme."""
    ids = scheme_ids(groups)
    declared = {
        (group.family.scheme, member.quantity.id): member
        for group in groups
        for member in group.family.answered
    }
    return tuple(
        _spread(_only(item, scheme), declared[ids[scheme], item.quantity])
        for item in items
        for scheme in np.unique(item.schemes)
    )


def verdicts_of(groups: Sequence[Group], items: Sequence[AnswerItem]) -> tuple[VerdictShare, ...]:
    """Count how the verdicts come out, scheme by scheme."""
    ids = scheme_ids(groups)
    demanded = {
        (group.family.scheme, member.quantity.id)
        for group in groups
        for member in group.family.answered
        if member.quantity.must_hold
    }
    return tuple(
        VerdictShare(
            item.quantity,
            ids[scheme],
            int(own.sum()),
            float(item.points[own].mean()),
            int(np.count_nonzero(item.values[own])),
            (ids[scheme], item.quantity) in demanded,
        )
        for item in items
        for scheme in np.unique(item.schemes)
        for own in [item.schemes == scheme]
    )


def _steps(family: Family) -> Iterator[Steps]:
    computed, decided, answered = (np.zeros(family.size, dtype=np.intp) for _ in range(3))
    chain = np.zeros(family.size, dtype=np.intp)
    depth: dict[str, Rows] = {}  # answers in the longest chain that ends with a quantity
    for member in family.members:
        kind, at = member.quantity.kind, member.at
        own = np.zeros(len(chain[at]), dtype=np.intp)
        for name in member.inputs:
            own = np.maximum(own, member.of(depth[name]))
        own = own + kind.answered
        depth.setdefault(member.quantity.id, np.zeros(family.size, dtype=np.intp))[at] = own
        chain[at] = np.maximum(chain[at], own)
        answered[at] += kind.answered
        computed[at] += kind is Kind.FORMULA
        decided[at] += kind is Kind.CHOICE
    counts = np.bincount(family.numbers, minlength=len(family.compositions))
    _, first = np.unique(family.numbers, return_index=True)
    for composition, count, place in zip(family.compositions, counts, first, strict=True):
        calculated, chosen = int(computed[place]), int(decided[place])
        read = int(answered[place]) - calculated - chosen
        yield Steps(composition, int(count), calculated, chosen, read, int(chain[place]))


def _moves(group: Group, member: Member, margin: float) -> Mask:
    inputs = {name: member.of(group.values[name]) for name in member.inputs}
    chosen = member.of(group.values[member.quantity.id])
    moved = np.zeros(chosen.shape, dtype=np.bool_)
    for where, computed in _computed_inputs(group.family, member):
        taken = {name: values[where] for name, values in inputs.items()}
        together = [computed] if len(computed) > 1 else []
        for names in (*((name,) for name in computed), *together):
            for scale in (1 - margin, 1 + margin):
                values = {**taken, **{name: taken[name] * scale for name in names}}
                other = compute(member.plan, member.quantity, values)
                moved[where] |= ~(np.abs(other - chosen[where]) <= 2 * margin * chosen[where])
    return moved


def _computed_inputs(family: Family, member: Member) -> Iterator[tuple[Rows, tuple[str, ...]]]:
    """Yield which inputs of a decision are computed, and for which of its variants they are.

    What one composition computes may be given in another.
    """
    own = np.zeros((len(member.inputs), family.size), dtype=np.bool_)
    for one in family.members:
        if one.quantity.kind is Kind.FORMULA and one.quantity.id in member.inputs:
            own[member.inputs.index(one.quantity.id), one.at] = True
    of_member = own[:, member.at]
    found: list[tuple[Rows, tuple[str, ...]]] = [(np.arange(of_member.shape[1]), ())]
    for name, is_computed in zip(member.inputs, of_member, strict=True):
        found = [
            (places[part], names + added)
            for places, names in found
            for part, added in ((~is_computed[places], ()), (is_computed[places], (name,)))
            if part.any()
        ]
    yield from found


def _only(item: AnswerItem, scheme: int) -> AnswerItem:
    """Leave of an item the variants of one scheme."""
    own = item.schemes == scheme
    return AnswerItem(
        item.quantity,
        item.rows[own],
        item.values[own],
        item.half_widths[own],
        item.points[own],
        item.sections[own],
        item.schemes[own],
    )


def _spread(item: AnswerItem, member: Member) -> DifficultySpread:
    size = len(item.rows)
    pairs = size * (size - 1)

    def declared(value: float) -> float:
        return from_si(member.plan, {item.quantity: value})[item.quantity]

    return DifficultySpread(
        item.quantity,
        member.plan.scheme.id,
        size,
        float(item.points.mean()),
        member.quantity.unit,
        declared(item.values.min()),
        declared(float(np.median(item.values))),
        declared(item.values.max()),
        float(count_fitting(item).sum() / pairs) if pairs else 0.0,
    )
