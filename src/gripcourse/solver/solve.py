"""One pure function serves the solver, the grader, the diagnosis and what-if.

`evaluate(plan, known)`: a value in `known` replaces the formula's value for everything downstream.
All values are in SI; NaN means "not supplied" in `known` and "cannot be computed" in the result.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gripcourse.course.compose import reference_formula
from gripcourse.course.quantity import Choice, Convention, Kind, Quantity, Rounding
from gripcourse.formula.evaluate import evaluate_sound, finite
from gripcourse.formula.tree import Call, Formula, Name
from gripcourse.solver.plan import Plan
from gripcourse.text.units import factor

_NOTHING = 1e-12  # of a declared unit: what is left where equal numbers were subtracted

_SERIES = 256  # of catalogues, whose formulas are kept

_TOGETHER = 16384  # variants computed at once: their columns stay in the processor's cache

Values = Mapping[str, NDArray[np.float64]]


@dataclass(frozen=True, slots=True)
class Evaluation:
    """The values of a plan in SI, by id.

    Attributes:
        values: what counts downstream: the known value where there is one, else the computed one.
        computed: what each formula gives at these values of its direct inputs.
    """

    values: Values
    computed: Values


def evaluate(plan: Plan, known: Mapping[str, ArrayLike]) -> Evaluation:
    """Compute every quantity of a plan, known values first.

    Args:
        plan: what is computed.
        known: SI values by id, scalars or arrays of one shape (n,); NaN where not supplied,
            infinite where supplied but no number: what needs it has no value. They must hold the
            givens, and may hold anything else.

    Returns:
        Values and computed values, each of shape () or (n,); NaN where an input is missing or
        outside a formula's domain.
    """
    supplied = {name: np.asarray(value, np.float64) for name, value in known.items()}
    size = max((value.size for value in supplied.values()), default=1)
    if size <= _TOGETHER:
        return _evaluate(plan, supplied)
    # What is known of all variants needs no copy.
    whole = {name: one for name, one in supplied.items() if one.ndim and np.isfinite(one).all()}
    values: dict[str, NDArray[np.float64]] = {}
    computed: dict[str, NDArray[np.float64]] = {}
    for start in range(0, size, _TOGETHER):
        rows = slice(start, start + _TOGETHER)
        part = _evaluate(plan, {name: _rows(one, rows) for name, one in supplied.items()})
        for name, own in part.computed.items():
            _put(computed, name, own, rows, size)
            if name not in known:
                values[name] = computed[name]
            elif name in whole:
                values[name] = whole[name]
            else:
                _put(values, name, part.values[name], rows, size)
    return Evaluation(values, computed)


def _rows(values: NDArray[np.float64], rows: slice) -> NDArray[np.float64]:
    """Take some of the variants; one number is that of all."""
    return values[rows] if values.ndim else values


def _put(
    table: dict[str, NDArray[np.float64]],
    name: str,
    part: NDArray[np.float64],
    rows: slice,
    size: int,
) -> None:
    """Put what some of the variants come to into a table of all; one number is that of all."""
    if part.ndim == 0:
        table[name] = part
        return
    if name not in table:
        table[name] = np.empty(size)
    table[name][rows] = part


def _evaluate(plan: Plan, known: Values) -> Evaluation:
    values: dict[str, NDArray[np.float64]] = {}
    computed: dict[str, NDArray[np.float64]] = {}
    for name, quantity in plan.quantities.items():
        if quantity.kind is Kind.MANUAL:
            continue
        computed[name] = compute(plan, quantity, values)
        if name in known:
            values[name] = _supplied(known[name], computed[name])
        else:
            values[name] = computed[name]
    return Evaluation(values, computed)


def _supplied(known: NDArray[np.float64], computed: NDArray[np.float64]) -> NDArray[np.float64]:
    """Take what is known, and what is computed where nothing is; finite or NaN."""
    if known.ndim == 0:  # one number: half of all the time of a solution otherwise
        if math.isnan(known):
            return computed
        number = finite(known)
        return np.full(computed.shape, number) if computed.ndim else number
    if np.isfinite(known).all():
        return known
    return finite(np.where(np.isnan(known), computed, known))


def solve_variant(plan: Plan, given: Mapping[str, float]) -> dict[str, float]:
    """Compute one variant in declared units.

    Args:
        plan: what is computed.
        given: givens, and constants or decisions that differ, in declared units.

    Returns:
        The value of every quantity but the manual ones, in declared units; NaN where it cannot be
        computed.
    """
    return from_si(plan, evaluate(plan, to_si(plan, given)).values)


def to_si(plan: Plan, values: Mapping[str, float]) -> dict[str, float]:
    """Convert values by id from declared units to SI."""
    return {name: value * factor(plan.quantities[name].unit) for name, value in values.items()}


def from_si(plan: Plan, values: Mapping[str, NDArray[np.float64] | float]) -> dict[str, float]:
    """Convert single values by id from SI to declared units."""
    return {
        name: _tidy(float(value) / factor(plan.quantities[name].unit))
        for name, value in values.items()
    }


def compute(plan: Plan, quantity: Quantity, values: Values) -> NDArray[np.float64]:
    """Compute one quantity at given values of its inputs.

    Args:
        plan: that the quantity belongs to.
        quantity: what is computed.
        values: SI values of its inputs, by id: finite or NaN.

    Returns:
        SI; NaN for a given number, which nothing computes.
    """
    if quantity.value is not None:
        return np.asarray(quantity.value * factor(quantity.unit))
    formula = reference_formula(quantity, plan.convention)
    if formula is None:
        return np.asarray(np.nan)
    result = evaluate_sound(formula, quantity.unit, values, plan.columns)
    return result if quantity.choice is None else choose(plan, quantity, result, values)


def choose(
    plan: Plan, quantity: Quantity, required: NDArray[np.float64], values: Values
) -> NDArray[np.float64]:
    """Return the size that the reference of a choice is for a required value.

    Args:
        plan: that the choice belongs to.
        quantity: the choice; without one the required value itself is returned.
        required: what the size must not be below, or be near to, SI, any shape.
        values: SI, finite or NaN; of what decides about a size where the choice steps up.

    Returns:
        SI; NaN where no size of the series will do.
    """
    if quantity.choice is None:
        return required
    first = entry(plan, quantity.choice, reference_rounding(quantity, plan.convention), required)
    if reference_steps_up(quantity, plan.convention):
        return _stepped_up(plan, quantity, first, values)
    return first


def entry(
    plan: Plan, choice: Choice, rounding: Rounding, required: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Return the entry of a choice's series for a required value (SI, any shape)."""
    call = entry_of(choice.column, rounding)
    return evaluate_sound(call, "", {"required": finite(np.asarray(required))}, plan.columns)


def _stepped_up(
    plan: Plan, quantity: Quantity, first: NDArray[np.float64], values: Values
) -> NDArray[np.float64]:
    """Go from the first size up to one that satisfies the condition; NaN where none does."""
    used = {name: values[name] for name in plan.step_ups[quantity.id].outside}
    shape = np.broadcast_shapes(first.shape, *(one.shape for one in used.values()))
    size = np.broadcast_to(first, shape).ravel().copy()
    known = {name: np.broadcast_to(finite(one), shape).ravel() for name, one in used.items()}
    waiting = np.flatnonzero(np.isfinite(size))
    while waiting.size:
        trial = {name: one[waiting] for name, one in known.items()}
        waiting = waiting[~will_do(plan, quantity, size[waiting], trial)]
        size[waiting] = _next_larger(plan, quantity, size[waiting])
        waiting = waiting[np.isfinite(size[waiting])]
    return size.reshape(shape)


def will_do(
    plan: Plan, quantity: Quantity, size: NDArray[np.float64], values: Values
) -> NDArray[np.bool_]:
    """Tell whether sizes of a choice that steps up satisfy its condition.

    Args:
        plan: that the choice belongs to.
        quantity: the choice.
        size: to be tried, SI.
        values: what the condition needs besides, and what is computed from the size needs; SI,
            finite or NaN. What it says of these themselves is not looked at.
    """
    if quantity.choice is None or quantity.choice.condition is None:
        return np.ones(size.shape, dtype=np.bool_)
    trial = way_to_condition(plan, quantity, size, values)
    met = evaluate_sound(quantity.choice.condition, "", trial, plan.columns)
    return np.broadcast_to(met == 1.0, size.shape)


def way_to_condition(
    plan: Plan, quantity: Quantity, size: NDArray[np.float64], values: Values
) -> dict[str, NDArray[np.float64]]:
    """Return all that the condition needs, SI: what is computed from sizes too; see `will_do`."""
    trial = {**values, quantity.id: size}
    for name in plan.step_ups[quantity.id].between:
        trial[name] = compute(plan, plan.quantities[name], trial)
    return trial


def _next_larger(plan: Plan, quantity: Quantity, size: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the next larger sizes of a choice's series; NaN above the last."""
    sizes = () if quantity.choice is None else plan.columns[quantity.choice.column].sizes
    larger = np.append(sizes, np.nan)
    return np.asarray(larger[np.searchsorted(larger[:-1], size, side="right")])


@lru_cache(maxsize=_SERIES)
def entry_of(column: str, rounding: Rounding) -> Formula:
    """Return the formula that takes an entry from a series; what is made of it stays with it."""
    function = "at_least" if rounding is Rounding.UP else "nearest"
    return Formula("", Call(function, (Name("required"),), column), {})


def reference_rounding(quantity: Quantity, convention: Convention) -> Rounding:
    """Return how a convention takes the entry of a choice from its series."""
    printed = [one.rounding for one in quantity.as_printed if one.rounding is not None]
    if convention is Convention.AS_PRINTED and printed:
        return printed[0]
    return quantity.choice.rounding if quantity.choice is not None else Rounding.UP


def reference_steps_up(quantity: Quantity, convention: Convention) -> bool:
    """Tell whether a convention takes a larger size where the first breaks its condition."""
    return quantity.steps_up and reference_rounding(quantity, convention) is Rounding.UP


def _tidy(value: float) -> float:
    """Remove what floating point adds: 63 mm, not 63.00000000000001 mm, and 0°, not -2.6e-15°."""
    return 0.0 if abs(value) < _NOTHING else float(f"{value:.14g}")
