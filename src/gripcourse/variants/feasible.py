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
from gripcourse.course.quantity import Choice, Kind, Quantity, Rounding
from gripcourse.formula.evaluate import evaluate as evaluate_formula
from gripcourse.formula.tree import Formula
from gripcourse.solver.family import Family, Member, Rows, evaluate_family, family_of
from gripcourse.solver.plan import Plan
from gripcourse.solver.solve import Evaluation
from gripcourse.text.units import factor
from gripcourse.text.words import Texts
from gripcourse.variants.constraint import Constraint

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
        title: of a constraint, as its author says it; None where nobody says it.
    """

    cause: RefusalCause
    quantity: str
    formula: Formula | None = field(hash=False)  # its units are a mapping, which has no hash
    rule: OptionRule | None = field(default=None, hash=False)
    title: Texts | None = field(default=None, hash=False)


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
    plan: Plan, given: Mapping[str, Array], constraints: Sequence[Constraint] = ()
) -> Feasibility:
    """Judge a batch of candidates with the same options in one evaluation; see `judge`.

    Args:
        plan: of the scheme and its options.
        given: value of every given quantity in its declared unit, arrays of shape (n,).
        constraints: conditions that the candidates must satisfy as well.
    """
    size = max((len(np.atleast_1d(values)) for values in given.values()), default=1)
    known = {id_: np.broadcast_to(values, (size,)) for id_, values in given.items()}
    return judge(family_of(plan, size), known, constraints)


def judge(
    family: Family, given: Mapping[str, Array], constraints: Sequence[Constraint] = ()
) -> Feasibility:
    """Judge candidates of one scheme, each with its own options, in one evaluation.

    Args:
        family: the candidates.
        given: values of the given quantities in their declared units, shape (n,); NaN for
            candidates that do not have the quantity.
        constraints: conditions that the candidates that have all their quantities must satisfy as
            well.

    Returns:
        The values, and who is refused for what.
    """
    known: dict[str, Array] = {}
    for one in family.givens:
        if one.quantity.id in given:  # givens of one id may have unlike units
            own = one.of(np.asarray(given[one.quantity.id], np.float64))
            found = known.setdefault(one.quantity.id, np.full(family.size, np.nan))
            found[one.at] = own * factor(one.quantity.unit)
    batch = _Batch(family, evaluate_family(family, known))
    for member in family.members:
        _judge_member(batch, member)
    for rule in family.course.schemes[family.scheme].rules:
        _judge_rule(batch, rule)
    for constraint in constraints:
        if set(constraint.formula.names) <= batch.evaluation.values.keys():
            formula = constraint.formula
            broken = _broken(batch, formula, batch.evaluation.values)
            reason = Reason(RefusalCause.CONSTRAINT, "", formula, title=constraint.title)
            batch.add(reason, None, broken)
    infeasible = np.zeros(family.size, dtype=np.bool_)
    for where in batch.refused.values():
        infeasible |= where
    return Feasibility(batch.evaluation, batch.refused, ~infeasible)


@dataclass(frozen=True, slots=True)
class _Batch:
    """A family evaluated, and who was refused for what so far."""

    family: Family
    evaluation: Evaluation
    refused: dict[Reason, Mask] = field(default_factory=dict)

    def add(self, reason: Reason, places: Rows | None, where: Mask) -> None:
        """Refuse some of the candidates at these places, all where there are none named."""
        if where.any():
            found = self.refused.setdefault(reason, np.zeros(self.family.size, dtype=np.bool_))
            found[slice(None) if places is None else places] |= where


def _judge_member(batch: _Batch, member: Member) -> None:
    """Refuse the candidates for what is wrong with one of their quantities."""
    quantity, places = member.quantity, member.places
    if quantity.kind is Kind.MANUAL:
        return
    names_used = {quantity.id, *member.inputs}
    condition = None if quantity.choice is None else quantity.choice.condition
    for rule in (quantity.valid, condition):
        names_used.update(() if rule is None else rule.names)
    values = {name: member.of(batch.evaluation.values[name]) for name in names_used}
    own = values[quantity.id]
    finite = np.isfinite(own)
    missing = ~finite & _all_finite(values, member.inputs, own.shape)
    if quantity.choice is not None and quantity.choice.rounding is Rounding.NEAREST:
        missing |= finite & _beyond_series(member.plan, quantity, quantity.choice, values)
    batch.add(Reason(RefusalCause.NO_VALUE, quantity.id, None), places, missing)
    if quantity.kind is Kind.VERDICT:
        if quantity.must_hold:
            reason = Reason(RefusalCause.VERDICT, quantity.id, quantity.formula)
            batch.add(reason, places, own == 0.0)
        return
    in_unit = own / factor(quantity.unit)
    outside = finite & _outside(in_unit, quantity.bounds)
    batch.add(Reason(RefusalCause.BOUNDS, quantity.id, None), places, outside)
    if quantity.integer:
        whole = np.abs(in_unit - np.round(in_unit)) <= _SLACK * np.maximum(np.abs(in_unit), 1.0)
        batch.add(Reason(RefusalCause.NOT_WHOLE, quantity.id, None), places, finite & ~whole)
    for cause, rule in ((RefusalCause.GUARD, quantity.valid), (RefusalCause.CONDITION, condition)):
        if rule is not None:
            batch.add(Reason(cause, quantity.id, rule), places, _broken(batch, rule, values))


def _judge_rule(batch: _Batch, rule: OptionRule) -> None:
    """Refuse the candidates that break a rule among options."""
    numbers = batch.family.numbers
    for number, composition in enumerate(batch.family.compositions):
        forbidden = rule.broken_by(composition.options)
        if forbidden:
            reason = Reason(RefusalCause.OPTIONS, forbidden, None, rule)
            batch.add(reason, None, numbers == number)
    if not rule.same or not set(rule.same) <= batch.evaluation.values.keys():
        return
    counting = [rule.counts(one.options) for one in batch.family.compositions]
    where = np.array(counting)[numbers]
    first, *others = (batch.evaluation.values[id_] for id_ in rule.same)
    for id_, other in zip(rule.same[1:], others, strict=True):
        differ = np.abs(first - other) > _SLACK * np.maximum(np.abs(first), np.abs(other))
        batch.add(Reason(RefusalCause.SAME, id_, None, rule), None, where & differ)


def _outside(values: Array, bounds: tuple[float, float]) -> Mask:
    low, high = bounds
    with np.errstate(invalid="ignore"):
        return np.asarray(
            (values < low - _SLACK * abs(low)) | (values > high + _SLACK * abs(high)),
            dtype=np.bool_,
        )


def _broken(batch: _Batch, condition: Formula, values: Mapping[str, Array]) -> Mask:
    """Whether a condition whose quantities all have values does not hold."""
    used = condition.names
    columns = batch.family.members[0].plan.columns
    holds = evaluate_formula(condition, "", values, columns)
    shape = values[used[0]].shape if used else holds.shape
    broken = np.broadcast_to(holds, shape) != 1.0
    return np.asarray(broken & _all_finite(values, used, shape), dtype=np.bool_)


def _beyond_series(
    plan: Plan, quantity: Quantity, choice: Choice, values: Mapping[str, Array]
) -> Mask:
    """Whether what is required lies so far past an end of the series that no size is near to it."""
    formula = quantity.formula
    columns = (choice.column, *choice.also)
    sizes = np.unique(np.concatenate([plan.columns[one].sizes for one in columns]))
    if formula is None or sizes.size == 1:
        return np.zeros((), dtype=np.bool_)
    low, high = sizes[0] - (sizes[1] - sizes[0]) / 2, sizes[-1] + (sizes[-1] - sizes[-2]) / 2
    required = evaluate_formula(formula, quantity.unit, values, plan.columns)
    return _outside(required, (low, high))


def _all_finite(values: Mapping[str, Array], ids: Sequence[str], shape: tuple[int, ...]) -> Mask:
    finite = np.ones(shape, dtype=np.bool_)
    for id_ in ids:
        finite &= np.isfinite(values[id_])
    return finite
