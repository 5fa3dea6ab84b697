"""Doing a calculation again with the digits that a calculator keeps, or with those in the cells.

Who writes 0.3 for 0.314 or 26 for 26.3 and goes on with all digits, or takes ten for gravity, comes
to numbers that follow from no cell. What the calculator held follows from the issued numbers.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

from gripcourse.course.quantity import Kind, Quantity
from gripcourse.formula.evaluate import evaluate_number
from gripcourse.grading.comparison import Comparison
from gripcourse.grading.manner import CUT_OFF
from gripcourse.grading.rounding import cuts_off, kept_figures
from gripcourse.grading.shortened import with_constants
from gripcourse.grading.submission_case import GradingCase
from gripcourse.solver.size_numbers import choose_number
from gripcourse.solver.solve import to_si
from gripcourse.text.units import factor

FINEST: Final = 5e-6
"""What 3.1416 for π and the last digits of a calculator leave of a number, relative."""

_EDGE: Final = 1e-6  # of half a unit: what floating point leaves

AS_WRITTEN: Final[Mapping[str, float]] = MappingProxyType({})
"""Nothing was gone on with but what stands in the cells, and the results behind it."""


@dataclass(frozen=True, slots=True)
class Way:
    """How a student goes on from one answer to the next.

    Attributes:
        constants: what constants are shortened to, SI, by name.
        keeps: whether with what the calculator holds, or with what stands in the cell.
        instead: what was gone on with after answers that are not their formula's result, where that
            is not what stands in the cell; SI, by id.
    """

    constants: Mapping[str, float]
    keeps: bool
    instead: Mapping[str, float]


@dataclass(frozen=True, slots=True)
class Held:
    """What a calculation comes to in a way.

    Attributes:
        way: the way.
        results: of each formula, SI.
        values: what was gone on with, SI.
        met: ids of the computed answers that are their formula's result, as exactly as typed.
    """

    way: Way
    results: Mapping[str, float]
    values: Mapping[str, float]
    met: frozenset[str]


def calculated(case: GradingCase, typed: Mapping[str, Comparison], way: Way) -> Held:
    """Do a calculation again in a way.

    Args:
        case: the submission.
        typed: the answers that have a value, by id.
        way: how the student goes on.
    """
    plan = case.plan
    values, results, met = to_si(plan, case.given), dict[str, float](), set[str]()
    for name, quantity in plan.quantities.items():
        if name in values or quantity.kind is Kind.MANUAL:
            continue
        if not quantity.kind.answered:
            values[name] = way.constants.get(name, _declared(quantity))
            continue
        results[name] = result = result_of(case, quantity, way, values)
        answer, typed_in = typed.get(name), way.instead.get(name)
        if answer is None:
            number = result if way.keeps else in_cell(case, quantity, result)
        else:
            number = answer.value * factor(quantity.unit)
            if quantity.kind is Kind.FORMULA and is_written_for(case, answer, result):
                met.add(name)
                number = result if way.keeps else number
        values[name] = number if typed_in is None else typed_in
    return Held(way, results, values, frozenset(met))


def is_written_for(case: GradingCase, answer: Comparison, result: float) -> bool:
    """Tell whether an answer is a result, SI, as the student writes it."""
    value, result = answer.value, result / factor(answer.quantity.unit)
    if not math.isfinite(result):
        return False
    half_unit = half_unit_of(case, answer)
    away = abs(value - result)
    if away <= half_unit * (1 + _EDGE):
        return True
    cuts = cuts_off(case.policy) and case.manner.cuts_off >= CUT_OFF
    return cuts and abs(value) < abs(result) and away < 2 * half_unit


def half_unit_of(case: GradingCase, answer: Comparison) -> float:
    """Return half a unit of the last digit of an answer as its student writes numbers."""
    manner = case.manner
    half_unit = manner.half_unit(answer.answer, case.policy, manner.figures)
    return max(half_unit, FINEST * abs(answer.value))


def _declared(quantity: Quantity) -> float:
    return math.nan if quantity.value is None else quantity.value * factor(quantity.unit)


def result_of(
    case: GradingCase, quantity: Quantity, way: Way, values: Mapping[str, float]
) -> float:
    """Return what a formula comes to in a way, SI; of a choice the size.

    Args:
        case: the submission.
        quantity: whose formula.
        way: how the student goes on.
        values: what was gone on with until then, SI.
    """
    formula = with_constants(case.plan, quantity.id, way.constants)
    if formula is None:
        return math.nan
    result = evaluate_number(formula, quantity.unit, values, case.plan.columns)
    return choose_number(case.plan, quantity, result, values)


def in_cell(case: GradingCase, quantity: Quantity, result: float) -> float:
    """Return what the student would have written of a result, SI."""
    if quantity.kind is not Kind.FORMULA or quantity.exact or quantity.integer:
        return result
    scale, manner = factor(quantity.unit), case.manner
    if manner.last_digit is not None:
        return scale * manner.last_digit.written(result / scale)
    if manner.figures:
        return scale * kept_figures(result / scale, manner.figures, cut=False)
    return result
