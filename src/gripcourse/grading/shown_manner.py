"""What the right answers of a work show of how its student writes numbers.

Whether digits are cut off or rounded, how many there are, and whether 3.14 stands for π is one
person's way throughout. It tells wrong methods apart that one number cannot: 179.72 comes of
179.726 only for somebody who cuts digits off.
"""

import math
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Final

from gripcourse.course.quantity import Kind
from gripcourse.formula.tree import Formula
from gripcourse.grading.comparison import Comparison
from gripcourse.grading.last_digits import LastDigit, rule_of
from gripcourse.grading.manner import UNKNOWN, Manner
from gripcourse.grading.rounding import cuts_off, figure_half_unit
from gripcourse.grading.shortened import uses_constant, with_constants
from gripcourse.grading.submission_case import GradingCase, JudgedAnswer, is_unexplained

# So likely is it that one right answer does not show what its student does elsewhere.
_ODD_ONE: Final = 0.2
_SPEAKS_AGAINST: Final = math.log(_ODD_ONE)
_SHORTENS: Final = 0.2  # as many shorten a constant for each who does not
_LIKELIER: Final = 3.0  # times: a constant counts as shortened
_SUREST: Final = 0.98  # nobody writes all numbers in one way
_MOST: Final = 0.6  # share of the numbers that are written with as many figures
_ENOUGH: Final = 5  # numbers
_TELLING: Final = 30  # numbers: by then each way of writing has shown itself
_EDGE: Final = 1e-6  # of half a unit: what floating point leaves


def in_own_manner(
    case: GradingCase, judged: Sequence[JudgedAnswer]
) -> tuple[GradingCase, list[JudgedAnswer]]:
    """Let wrong answers be explained by how their student writes the right ones.

    Args:
        case: the submission.
        judged: every answer, none explained yet.

    Returns:
        The case, and the answers in the same order; both unchanged where nothing is to be explained
        or nothing is known.
    """
    wrong = {one.quantity.id for one in judged if is_unexplained(case, one)}
    manner = manner_of(judged) if wrong else UNKNOWN
    if manner == UNKNOWN:
        return case, list(judged)
    inputs = case.plan.inputs
    weighed = {one.quantity.id for one in judged if not wrong.isdisjoint(inputs[one.quantity.id])}
    return replace(case, manner=manner), [
        replace(one, comparison=one.comparison.in_manner(manner))
        if one.comparison is not None and one.quantity.id in wrong | weighed
        else one
        for one in judged
    ]


def manner_of(judged: Sequence[JudgedAnswer]) -> Manner:
    """Return what the right answers of a work show of how its student writes numbers."""
    right = [
        one.comparison
        for one in judged
        if one.comparison is not None
        and one.quantity.kind is Kind.FORMULA
        and one.comparison.value
        and (one.judgement.outcome.traits.equals_reference or one.judgement.outcome.traits.follows)
    ]
    figures = _figures(right)
    constants = _constants(right, figures)
    cut, typed = _ways(right[:_TELLING], figures, constants)
    return Manner(cut, typed, figures, constants, _last_digit(judged))


def _last_digit(judged: Sequence[JudgedAnswer]) -> LastDigit | None:
    """Return where all computed numbers end, wrong ones too; None where that shows nothing."""
    typed = [
        one.comparison
        for one in judged
        if one.comparison is not None
        and one.quantity.kind is Kind.FORMULA
        and not (one.quantity.exact or one.quantity.integer)
        and one.comparison.value
        and one.comparison.answer.half_unit
    ]
    return rule_of([one.answer for one in typed], typed[0].policy.figures) if typed else None


def _figures(right: Sequence[Comparison]) -> int:
    """Return with how many figures most numbers are written; 0 where that is not known."""
    counts = Counter(one.answer.figures for one in right if one.answer.figures is not None)
    if counts.total() < _ENOUGH:
        return 0
    [(most, count)] = counts.most_common(1)
    return most if count >= _MOST * counts.total() else 0


def _constants(right: Sequence[Comparison], figures: int) -> Mapping[str, float]:
    """Return the constants that the answers which use them show to be shortened."""
    odds: dict[str, dict[float, float]] = {}
    for one in right:
        plan, name, habits = one.plan, one.quantity.id, one.policy.habits
        if not uses_constant(plan, name, habits):
            continue
        used = [
            (constant, value)
            for constant, values in habits.items()
            if uses_constant(plan, name, (constant,))
            for value in values
        ]
        exact = _speaks(_shows(one, None, figures))
        for constant, value in used:
            formula = with_constants(plan, name, {constant: value})
            of_constant = odds.setdefault(constant, {})
            before = of_constant.get(value, math.log(_SHORTENS))
            of_constant[value] = before + _speaks(_shows(one, formula, figures)) - exact
    likeliest = {name: max(found, key=found.__getitem__) for name, found in odds.items()}
    return {
        name: value for name, value in likeliest.items() if odds[name][value] > math.log(_LIKELIER)
    }


def _shows(comparison: Comparison, formula: Formula | None, figures: int) -> bool:
    """Tell whether a number is what a formula comes to, rounded or cut off."""
    half_unit = _half_unit(comparison, figures)
    return any(
        _is_rounded(comparison.value, one, half_unit) or _is_cut(comparison.value, one, half_unit)
        for one in _results(comparison, formula)
    )


def _results(comparison: Comparison, formula: Formula | None) -> tuple[float, float]:
    """Return what a formula comes to with the numbers in the cells, and with those before them.

    Args:
        comparison: of the answer.
        formula: with shortened constants; None for the right one.
    """
    if formula is None:
        return comparison.expected, comparison.reference
    before = comparison.at_reference(formula)
    if comparison.own_inputs.isdisjoint(formula.names):
        return before, before
    return comparison.number_at_own(formula), before


def _half_unit(comparison: Comparison, figures: int) -> float:
    """Return half a unit of the last digit of a number whose zeros a cell may have lost."""
    half_unit = comparison.answer.half_unit
    as_others = figure_half_unit(comparison.value, figures) if figures else half_unit
    return min(half_unit, as_others) if half_unit else as_others


def _is_rounded(value: float, result: float, half_unit: float) -> bool:
    return abs(value - result) <= half_unit * (1 + _EDGE)


def _is_cut(value: float, result: float, half_unit: float) -> bool:
    away = abs(value - result)
    return away < 2 * half_unit * (1 + _EDGE) and abs(value) <= abs(result)


def _ways(
    right: Sequence[Comparison], figures: int, constants: Mapping[str, float]
) -> tuple[float, float]:
    """Return how probable it is that a student cuts digits off, and carries on what is typed."""
    cut, typed = _log_odds(UNKNOWN.cuts_off), _log_odds(UNKNOWN.carries_typed)
    as_reference = {one.quantity.id for one in right if _is_written_for_reference(one, figures)}
    for one in right:
        half_unit = _half_unit(one, figures)
        if not half_unit:
            continue
        uses = constants and uses_constant(one.plan, one.quantity.id, constants)
        formula = with_constants(one.plan, one.quantity.id, constants) if uses else None
        from_cells, from_before = (
            (_is_cut(one.value, result, half_unit), _is_rounded(one.value, result, half_unit))
            for result in _results(one, formula)
        )
        cut += _speaks(from_cells[0] or from_before[0]) - _speaks(from_cells[1] or from_before[1])
        if one.own_inputs.intersection(one.plan.inputs[one.quantity.id]) <= as_reference:
            # Only where nothing else moved what it is computed from does the calculator hold that.
            typed += _speaks(any(from_cells)) - _speaks(any(from_before))
    thinks_of_it = bool(right) and cuts_off(right[0].policy)
    return _share(cut) if thinks_of_it else UNKNOWN.cuts_off, _share(typed)


def _is_written_for_reference(comparison: Comparison, figures: int) -> bool:
    half_unit, reference = _half_unit(comparison, figures), comparison.reference
    return _is_rounded(comparison.value, reference, half_unit) or _is_cut(
        comparison.value, reference, half_unit
    )


def _log_odds(share: float) -> float:
    return math.log(share / (1 - share))


def _share(log_odds: float) -> float:
    surest = _log_odds(_SUREST)
    return 1 / (1 + math.exp(-min(max(log_odds, -surest), surest)))


def _speaks(shown: object) -> float:
    """Return the logarithm of how likely a number is by a way that it shows, or does not show."""
    return 0.0 if shown else _SPEAKS_AGAINST
