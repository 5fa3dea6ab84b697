"""Where a student can slip: places whose effect an examiner could see."""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from enum import StrEnum

import numpy as np

from gripcourse.course.quantity import Kind, Quantity
from gripcourse.formula.evaluate import evaluate as evaluate_formula
from gripcourse.formula.tree import Formula
from gripcourse.grading.choices import judge_choice, printed_choice, same_size
from gripcourse.grading.diagnose import CandidatesOf
from gripcourse.grading.size_condition import by_formulas
from gripcourse.policy.bands import band
from gripcourse.policy.model import Policy
from gripcourse.simulation.arithmetic import PI, Hand
from gripcourse.simulation.behaviour import drawn
from gripcourse.simulation.calculation import Calculation, by_formula
from gripcourse.slips.model import DECLARED, Candidate, SlipId
from gripcourse.solver.plan import Plan
from gripcourse.solver.solve import Values, evaluate, to_si
from gripcourse.text.units import factor


class Effect(StrEnum):
    """What a deviation at a place comes to."""

    APART = "apart"
    HIDDEN = "hidden"  # too near to something that counts as right
    IMPOSSIBLE = "impossible"  # no value, or one that the workbook does not take


@dataclass(frozen=True, slots=True)
class Ground:
    """What effects are measured on: a variant with its reference, and a student's hand."""

    plan: Plan
    policy: Policy
    candidates_of: CandidatesOf
    hand: Hand
    reference: Values
    apart: float


def make_ground(
    plan: Plan,
    policy: Policy,
    candidates_of: CandidatesOf,
    hand: Hand,
    given: Mapping[str, float],
    apart: float,
) -> Ground:
    """Solve a variant.

    Args:
        plan: of the variant.
        policy: by which it is marked.
        candidates_of: the wrong methods of each quantity.
        hand: how the student computes.
        given: issued values in declared units.
        apart: bands between a deviation and every right value.
    """
    reference = evaluate(plan, to_si(plan, given)).values
    return Ground(plan, policy, candidates_of, hand, {**reference, PI: np.asarray(np.pi)}, apart)


def draw_slip(
    plan: Plan, candidates_of: CandidatesOf, kinds: Mapping[str, float], rng: np.random.Generator
) -> tuple[str, Candidate] | None:
    """Draw a kind of slip by its prior, a quantity that has it, and one way to make it.

    Args:
        plan: in which the slip is made.
        candidates_of: the wrong methods of each quantity.
        kinds: priors of the kinds to draw from.
        rng: random numbers.

    Returns:
        The quantity and the candidate; None where no quantity has such a slip.
    """
    left = dict(kinds)
    while left:
        kind = drawn(left, rng)
        for number in rng.permutation(len(plan.answered)):
            name = plan.answered[int(number)].id
            found = [one for one in candidates_of(name) if one.kind == kind]
            if found:
                return name, found[int(rng.integers(len(found)))]
        del left[kind]
    return None


def slip_kinds(policy: Policy) -> dict[str, float]:
    """Return the priors of all kinds of slips, the courses' own among them."""
    generic = {str(kind): slip.prior for kind, slip in policy.slips.kinds.items()}
    return {DECLARED: policy.slips.declared, **generic}


def effect(ground: Ground, name: str, done: Calculation) -> Effect:
    """Tell whether what was typed for a quantity can be told from everything that is right."""
    quantity = ground.plan.quantities[name]
    typed = float(done.steps[name].typed)
    low, high = quantity.bounds
    if not (math.isfinite(typed) and low <= typed <= high):
        return Effect.IMPOSSIBLE
    if quantity.kind is Kind.CHOICE:
        accepted = _is_accepted_size(ground, quantity, typed, done)
        return Effect.HIDDEN if accepted else Effect.APART
    near = any(
        typed == right  # a band of 0 has no inside
        or abs(typed - right) < ground.apart * band(quantity, right, ground.policy)
        for right in _right_values(ground, quantity, done)
        if math.isfinite(right)
    )
    return Effect.HIDDEN if near else Effect.APART


def twins_of(
    ground: Ground, name: str, candidate: Candidate, done: Calculation
) -> tuple[SlipId, ...]:
    """Return the other candidates of a quantity that give the very same value."""
    quantity = ground.plan.quantities[name]

    def value(one: Candidate) -> float:
        return _value(ground, quantity, one.formula, done.values)

    wanted = value(candidate)
    return tuple(
        one.id
        for one in ground.candidates_of(name)
        if one.id != candidate.id and math.isclose(value(one), wanted, rel_tol=1e-9)
    )


def _right_values(ground: Ground, quantity: Quantity, done: Calculation) -> Iterator[float]:
    """Yield all values that would count as right, in the declared unit, NaN among them."""
    scale = factor(quantity.unit)
    yield float(done.steps[quantity.id].right)
    yield float(ground.reference[quantity.id]) / scale
    formula = ground.plan.reference_formula(quantity.id)
    if formula is not None:
        for values in _as_they_stand(ground, quantity, done):
            yield _value(ground, quantity, formula, values)
    printed = [one.formula for one in quantity.as_printed if one.formula is not None]
    for formula in (*printed, *(one.formula for one in quantity.alternatives)):
        yield _value(ground, quantity, formula, done.values)
        yield _value(ground, quantity, formula, ground.reference)


def _as_they_stand(ground: Ground, quantity: Quantity, done: Calculation) -> Iterator[Values]:
    """Yield other numbers that the right method may be seen to go on with.

    Those in the cells, where the calculator holds others; and for one that is wrong the right one:
    a second mistake that undoes the first leaves a number in which nobody can see either.
    """
    written = {
        name: done.steps[name].typed * factor(ground.plan.quantities[name].unit)
        for name in ground.plan.inputs[quantity.id]
        if name in done.steps
    }
    yield {**done.values, **written}
    for name in written:
        yield {**done.values, name: ground.reference[name]}


def _value(ground: Ground, quantity: Quantity, formula: Formula, values: Values) -> float:
    return float(by_formula(ground.plan, quantity, formula, values, ground.hand))


def _is_accepted_size(ground: Ground, quantity: Quantity, size: float, done: Calculation) -> bool:
    """Tell whether a size is sound for the student's numbers, the reference's, or as printed."""
    plan = ground.plan
    formula = plan.reference_formula(quantity.id)
    if formula is None:
        return True
    chosen = size * factor(quantity.unit)
    for values in (done.values, ground.reference):
        required = _required(plan, quantity, formula, values)
        printed = printed_choice(plan, quantity, required)
        if printed is not None and same_size(printed, chosen):
            return True
        if judge_choice(
            plan, quantity, chosen, required, by_formulas(plan, quantity, values)
        ).sound:
            return True
    return False


def _required(plan: Plan, quantity: Quantity, formula: Formula, values: Values) -> float:
    return float(evaluate_formula(formula, quantity.unit, values, plan.columns))
