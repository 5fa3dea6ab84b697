"""Answers of honest students to many variants at once, and what the grader expects of them.

Every student answers everything, and each number stands in its cell as text with all its figures,
which is what the grader takes most literally.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np

from gripcourse.course.quantity import Quantity
from gripcourse.formula.evaluate import evaluate as evaluate_formula
from gripcourse.formula.tree import Formula
from gripcourse.grading.rounding import inward
from gripcourse.policy.model import Policy
from gripcourse.simulation.arithmetic import DISPLAY, Array, Hand
from gripcourse.simulation.calculation import calculate
from gripcourse.simulation.model import Mix
from gripcourse.solver.plan import Plan
from gripcourse.solver.solve import Values, evaluate
from gripcourse.text.units import factor

_MOST_ZEROS = 16  # no number has more digits


@dataclass(frozen=True, slots=True)
class Expected:
    """What follows from students' own numbers, and how far their rounding may move it.

    All in the declared unit, shape (n,); NaN where nothing follows.
    """

    value: Array
    low: Array
    high: Array


@dataclass(frozen=True, slots=True)
class Honest:
    """Honest students' work on the variants of one plan.

    Attributes:
        plan: of the variants.
        typed: what was typed by quantity, in declared units, shape (n,).
        reference: reference values, likewise.
        known: what the grader computes with: issued values, constants, what was typed; SI.
        reach: how far the number behind a typed one may be further from zero, SI, of what was
            computed.
        nearer: the share of it by which that number may be nearer to zero.
        ways: how many ways of working; the students of one variant stand together.
        coarse: the way of working that writes the fewest figures and cuts the others off.
        figures: that it writes.
    """

    plan: Plan
    typed: Mapping[str, Array]
    reference: Mapping[str, Array]
    known: Values
    reach: Values
    nearer: float
    ways: int
    coarse: int
    figures: int

    def coarsest(self) -> "Honest":
        """Return the students who write the fewest figures, one for each variant."""
        size = next(iter(self.typed.values())).size

        def only(values: Mapping[str, Array]) -> dict[str, Array]:
            return {
                name: np.broadcast_to(one, (size,))[self.coarse :: self.ways]
                for name, one in values.items()
            }

        return replace(
            self,
            typed=only(self.typed),
            reference=only(self.reference),
            known=only(self.known),
            reach=only(self.reach),
            ways=1,
            coarse=0,
        )

    def value(self, quantity: Quantity, formula: Formula, moved: Values | None = None) -> Array:
        """Apply a formula to the students' numbers, some of them moved (SI)."""
        at = {**self.known, **(moved or {})}
        result = evaluate_formula(formula, quantity.unit, at, self.plan.columns)
        return result / factor(quantity.unit)

    def expected(self, quantity: Quantity) -> Expected:
        """Return what the quantity's own formula gives at the students' numbers."""
        formula = self.plan.reference_formula(quantity.id)
        shape = self.typed[quantity.id].shape
        if formula is None:
            nothing = np.full(shape, np.nan)
            return Expected(nothing, nothing, nothing)
        base = np.broadcast_to(self.value(quantity, formula), shape)
        down, up = np.zeros_like(base), np.zeros_like(base)
        for name in formula.names:
            if name in self.reach:
                ends = [
                    np.nan_to_num(self.value(quantity, formula, {name: end}) - base)
                    for end in self._ends(name)
                ]
                down = down + np.minimum(np.minimum(*ends), 0.0)
                up = up + np.maximum(np.maximum(*ends), 0.0)
        return Expected(base, base + down, base + up)

    def _ends(self, name: str) -> tuple[Array, Array]:
        """Return the lowest and the highest number that may be behind a typed one, SI."""
        known, reach = self.known[name], self.reach[name]
        nearer = self.nearer * reach
        return (
            known - np.where(known < 0, reach, nearer),
            known + np.where(known < 0, nearer, reach),
        )


def hands_of(mix: Mix) -> Hand:
    """Return every way of working that a mix knows, one entry for each; shape (m,)."""
    writing = [(one, cuts) for one in mix.figures for cuts in (False, True)] + [(DISPLAY, False)]
    names = list(mix.constants)
    taken = list(product(*(mix.constants[name] for name in names)))
    ways = list(product(writing, (False, True), mix.pi, taken))
    return Hand(
        figures=np.array([way[0][0] for way in ways]),
        cuts=np.array([way[0][1] for way in ways]),
        keeps=np.array([way[1] for way in ways]),
        pi=np.array([way[2] for way in ways]),
        constants={
            name: np.array([way[3][place] for way in ways]) for place, name in enumerate(names)
        },
    )


def work_honestly(
    plan: Plan, given: Sequence[Mapping[str, float]], hands: Hand, policy: Policy
) -> Honest:
    """Let students of every way of working answer every variant.

    Args:
        plan: of the variants.
        given: issued values of each, in declared units.
        hands: the ways of working, shape (m,).
        policy: how far a number may be from the typed one.
    """
    ways, variants = hands.figures.size, len(given)
    issued = {one.id: np.repeat([values[one.id] for values in given], ways) for one in plan.givens}
    every = _every(hands, variants)
    steps = calculate(plan, issued, every, {}).steps
    typed = {name: np.broadcast_to(step.typed, (variants * ways,)) for name, step in steps.items()}
    inputs = {name: values * factor(plan.quantities[name].unit) for name, values in issued.items()}
    reference = evaluate(plan, inputs).values
    answered = {name: typed[name] * factor(plan.quantities[name].unit) for name in typed}
    return Honest(
        plan=plan,
        typed=typed,
        reference={name: reference[name] / factor(plan.quantities[name].unit) for name in typed},
        known=evaluate(plan, inputs | answered).values,
        reach=dict(_reaches(plan, typed, every, policy)),
        nearer=inward(policy) / (2 * policy.last_digit) if policy.last_digit else 1.0,
        ways=ways,
        coarse=int(np.argmin(hands.figures - 0.5 * hands.cuts)),
        figures=int(hands.figures.min()),
    )


def _every(hands: Hand, variants: int) -> Hand:
    """Repeat all ways of working for each variant."""
    return Hand(
        figures=np.tile(hands.figures, variants),
        cuts=np.tile(hands.cuts, variants),
        keeps=np.tile(hands.keeps, variants),
        pi=np.tile(hands.pi, variants),
        constants={name: np.tile(values, variants) for name, values in hands.constants.items()},
    )


def _reaches(
    plan: Plan, typed: Mapping[str, Array], hand: Hand, policy: Policy
) -> Iterator[tuple[str, Array]]:
    """Yield how far the number behind a typed one may be; as `grading.rounding`, for arrays."""
    for name, values in typed.items():
        quantity = plan.quantities[name]
        if quantity.exact or quantity.integer:
            continue
        known = np.isfinite(values) & (values != 0)
        power = np.floor(np.log10(np.where(known, np.abs(values), 1.0)))
        last = np.minimum(np.minimum(power - hand.figures + 1, 0.0), power - policy.figures + 1)
        whole = known & (power >= hand.figures)
        last = np.where(whole, np.maximum(last, _before_zeros(values, power, policy.figures)), last)
        reach = np.where(known, policy.last_digit * 10.0**last, 0.0)
        yield name, reach * factor(quantity.unit)


def _before_zeros(values: Array, power: Array, figures: int) -> Array:
    """Return the power of ten of the last digit of whole numbers before the zeros at their end."""
    powers = 10.0 ** np.arange(1, _MOST_ZEROS)
    zeros: Array = (values[..., np.newaxis] % powers == 0).sum(axis=-1).astype(np.float64)
    return power - np.maximum(power + 1 - zeros, figures) + 1
