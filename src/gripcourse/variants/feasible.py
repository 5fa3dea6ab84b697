"""Why a variant cannot be handed out: what has no value, or breaks a rule.

One judgement serves drawing (thousands of candidates at once), the import of a table and a single
variant. Only the first cause is named: what fails because of it is not listed again.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from enum import StrEnum
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from gripcourse.course.option_rule import OptionRule
from gripcourse.course.quantity import Kind, Quantity
from gripcourse.formula.evaluate import evaluate as evaluate_formula
from gripcourse.formula.tree import Formula, names
from gripcourse.solver.plan import Plan
from gripcourse.solver.solve import Evaluation, evaluate
from gripcourse.text.units import factor

Mask: TypeAlias = NDArray[np.bool_]
Array: TypeAlias = NDArray[np.float64]

_SLACK = 1e-9  # relative; a bound that was converted between units is still met


class RefusalCause(StrEnum):
    """What is wrong with a quantity, or that a constraint is broken."""

    NO_VALUE = "no value"  # no entry in a catalogue, a root of a negative number, ...
    NOT_WHOLE = "not whole"
    BOUNDS = "out of bounds"
    GUARD = "guard"
    VERDICT = "verdict"
    CONDITION = "condition"
    CONSTRAINT = "constraint"
    OPTIONS = "options"  # choices that a rule does not let go together
    SAME = "same"  # givens that a rule binds to one number differ


@dataclass(frozen=True, slots=True)
class Reason:
    """A reason to refuse variants.

    Attributes:
        cause: what is wrong.
        quantity: the quantity it is wrong with; empty for a constraint. Of a rule among options the
            option whose choice is forbidden, or the given that differs from the first.
        formula: what does not hold; None for bounds and missing values.
        rule: the rule among options that is broken; None where it is no such rule.
    """

    cause: RefusalCause
    quantity: str
    formula: Formula | None = field(hash=False)  # its units are a mapping, which has no hash
    rule: OptionRule | None = field(default=None, hash=False)


@dataclass(frozen=True, slots=True)
class Feasibility:
    """What became of a batch of candidates.

    Attributes:
        evaluation: all values, in SI.
        refused: by reason, which candidates have it; a reason that nothing has is left out.
        feasible: which candidates have none.
    """

    evaluation: Evaluation
    refused: Mapping[Reason, Mask]
    feasible: Mask


def reasons_infeasible(
    plan: Plan, given: Mapping[str, Array], constraints: Sequence[Formula] = ()
) -> Feasibility:
    """Judge a batch of candidates of one scheme in one evaluation.

    Args:
        plan: of the scheme and its options.
        given: value of every given quantity in its declared unit, arrays of shape (n,).
        constraints: conditions that the candidates must satisfy as well.

    Returns:
        The values, and who is refused for what.
    """
    known = {
        id_: np.asarray(values, dtype=np.float64) * factor(plan.quantities[id_].unit)
        for id_, values in given.items()
    }
    evaluation = evaluate(plan, known)
    size = max((len(np.atleast_1d(values)) for values in known.values()), default=1)
    batch = _Batch(plan, evaluation, size)
    found: dict[Reason, Mask] = {}
    for quantity in plan.quantities.values():
        found |= _reasons_of(batch, quantity)
    for rule in plan.scheme.rules:
        found |= _broken_rule(batch, rule)
    for formula in constraints:
        found[Reason(RefusalCause.CONSTRAINT, "", formula)] = _broken(batch, formula)
    refused = {reason: where for reason, where in found.items() if where.any()}
    infeasible = np.zeros(size, dtype=np.bool_)
    for where in refused.values():
        infeasible |= where
    return Feasibility(evaluation, refused, ~infeasible)


@dataclass(frozen=True, slots=True)
class _Batch:
    """A plan evaluated for `size` candidates."""

    plan: Plan
    evaluation: Evaluation
    size: int

    def values(self, quantity: str) -> Array:
        """Return a quantity's values in SI, one per candidate."""
        return np.broadcast_to(self.evaluation.values[quantity], (self.size,))


def _reasons_of(batch: _Batch, quantity: Quantity) -> dict[Reason, Mask]:
    if quantity.kind is Kind.MANUAL:
        return {}
    values = batch.values(quantity.id)
    finite = np.isfinite(values)
    inputs = batch.plan.inputs.get(quantity.id, ())
    found = {Reason(RefusalCause.NO_VALUE, quantity.id, None): ~finite & _all_finite(batch, inputs)}
    if quantity.kind is Kind.VERDICT:
        if quantity.must_hold:
            found[Reason(RefusalCause.VERDICT, quantity.id, quantity.formula)] = values == 0.0
        return found
    in_unit = values / factor(quantity.unit)
    found[Reason(RefusalCause.BOUNDS, quantity.id, None)] = finite & _outside(
        in_unit, quantity.bounds
    )
    if quantity.integer:
        whole = np.abs(in_unit - np.round(in_unit)) <= _SLACK * np.maximum(np.abs(in_unit), 1.0)
        found[Reason(RefusalCause.NOT_WHOLE, quantity.id, None)] = finite & ~whole
    if quantity.valid is not None:
        broken = _broken(batch, quantity.valid)
        found[Reason(RefusalCause.GUARD, quantity.id, quantity.valid)] = broken
    if quantity.choice is not None and quantity.choice.condition is not None:
        condition = quantity.choice.condition
        found[Reason(RefusalCause.CONDITION, quantity.id, condition)] = _broken(batch, condition)
    return found


def _broken_rule(batch: _Batch, rule: OptionRule) -> dict[Reason, Mask]:
    options = batch.plan.options
    if not rule.counts(options):
        return {}
    found: dict[Reason, Mask] = {}
    forbidden = rule.broken_by(options)
    if forbidden:
        reason = Reason(RefusalCause.OPTIONS, forbidden, None, rule)
        found[reason] = np.ones(batch.size, dtype=np.bool_)
    for other in rule.same[1:] if set(rule.same) <= batch.plan.quantities.keys() else ():
        first, second = batch.values(rule.same[0]), batch.values(other)
        differ = np.abs(first - second) > _SLACK * np.maximum(np.abs(first), np.abs(second))
        found[Reason(RefusalCause.SAME, other, None, rule)] = differ
    return found


def _outside(values: Array, bounds: tuple[float, float]) -> Mask:
    low, high = bounds
    with np.errstate(invalid="ignore"):
        return np.asarray(
            (values < low - _SLACK * abs(low)) | (values > high + _SLACK * abs(high)),
            dtype=np.bool_,
        )


def _broken(batch: _Batch, condition: Formula) -> Mask:
    """Whether a condition whose quantities all have values does not hold."""
    holds = evaluate_formula(condition, "", batch.evaluation.values, batch.plan.columns)
    broken = np.broadcast_to(holds, (batch.size,)) != 1.0
    return np.asarray(broken & _all_finite(batch, names(condition.tree)), dtype=np.bool_)


def _all_finite(batch: _Batch, ids: Sequence[str]) -> Mask:
    finite = np.ones(batch.size, dtype=np.bool_)
    for id_ in ids:
        finite &= np.isfinite(batch.values(id_))
    return finite
