"""Whether variants ask alike: steps of the calculation, sizes near a step of a series, spread."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gripcourse.course.composition import Composition
from gripcourse.course.quantity import Kind, Quantity
from gripcourse.formula.evaluate import evaluate as evaluate_formula
from gripcourse.solver.plan import Plan
from gripcourse.solver.solve import choose, from_si, reference_rounding
from gripcourse.variants.answers import AnswerItem, Group, count_fitting, scheme_ids
from gripcourse.variants.feasible import Array, Mask


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
    """Count the answers that each group of variants is asked for."""
    return tuple(_steps(group) for group in groups)


def steps_ratio(steps: Sequence[Steps]) -> float:
    """Return how many times as many answers as the shortest assignment the longest asks for."""
    longest = max((one.total for one in steps), default=0)
    shortest = min((one.total for one in steps), default=0)
    return longest / shortest if shortest else 1.0


def near_steps(group: Group, margin: float) -> dict[str, Mask]:
    """Return by decision the variants in which a size lies at the edge of its step.

    There the size changes when a computed answer that it is taken for moves by `margin`, a share
    of itself: a student who rounds honestly could be led to the other size. A size that rests on
    given numbers and other sizes alone is never at an edge: these are not rounded.

    Args:
        group: solved variants.
        margin: how far an answer may move, 0 to 1.
    """
    return {
        quantity.id: _moves(group, quantity, margin)
        for quantity in group.plan.answered
        if quantity.kind is Kind.CHOICE
    }


def spreads_of(
    groups: Sequence[Group], items: Sequence[AnswerItem]
) -> tuple[DifficultySpread, ...]:
    """Describe the answers to each quantity, scheme by scheme."""
    ids = scheme_ids(groups)
    plans = {
        (group.plan.scheme.id, quantity.id): group.plan
        for group in groups
        for quantity in group.plan.answered
    }
    return tuple(
        _spread(_only(item, scheme), plans[ids[scheme], item.quantity])
        for item in items
        for scheme in np.unique(item.schemes)
    )


def verdicts_of(groups: Sequence[Group], items: Sequence[AnswerItem]) -> tuple[VerdictShare, ...]:
    """Count how the verdicts come out, scheme by scheme."""
    ids = scheme_ids(groups)
    demanded = {
        (group.plan.scheme.id, quantity.id)
        for group in groups
        for quantity in group.plan.answered
        if quantity.must_hold
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


def _steps(group: Group) -> Steps:
    kinds = [quantity.kind for quantity in group.plan.answered]
    computed, decided = kinds.count(Kind.FORMULA), kinds.count(Kind.CHOICE)
    return Steps(
        group.plan.composition,
        len(group.rows),
        computed,
        decided,
        len(kinds) - computed - decided,
        _longest_chain(group.plan),
    )


def _longest_chain(plan: Plan) -> int:
    depth: dict[str, int] = {}
    for name, quantity in plan.quantities.items():
        before = max((depth[one] for one in plan.inputs.get(name, ())), default=0)
        depth[name] = before + quantity.kind.answered
    return max(depth.values(), default=0)


def _moves(group: Group, quantity: Quantity, margin: float) -> Mask:
    computed = [
        name
        for name in group.plan.inputs[quantity.id]
        if group.plan.quantities[name].kind is Kind.FORMULA
    ]
    chosen = group.values[quantity.id]
    moved = np.zeros(group.rows.shape, dtype=np.bool_)
    together = [computed] if len(computed) > 1 else []
    for names in (*([name] for name in computed), *together):
        for scale in (1 - margin, 1 + margin):
            values = {name: group.values[name] * scale for name in names}
            moved |= _choice(group, quantity, values) != chosen
    return moved


def _choice(group: Group, quantity: Quantity, moved: dict[str, Array]) -> Array:
    """Take a size with some answers moved; NaN where the series ends before it."""
    plan = group.plan
    formula = plan.reference_formula(quantity.id)
    if formula is None or quantity.choice is None:
        return group.values[quantity.id]
    values = {**group.values, **moved}
    required = evaluate_formula(formula, quantity.unit, values, plan.columns)
    return choose(required, quantity.choice, reference_rounding(quantity, plan.convention), plan)


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


def _spread(item: AnswerItem, plan: Plan) -> DifficultySpread:
    size = len(item.rows)
    pairs = size * (size - 1)

    def declared(value: float) -> float:
        return from_si(plan, {item.quantity: value})[item.quantity]

    return DifficultySpread(
        item.quantity,
        plan.scheme.id,
        size,
        float(item.points.mean()),
        plan.quantities[item.quantity].unit,
        declared(item.values.min()),
        declared(float(np.median(item.values))),
        declared(item.values.max()),
        float(count_fitting(item).sum() / pairs) if pairs else 0.0,
    )
