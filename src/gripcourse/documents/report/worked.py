"""A quantity as a line of calculation: symbols = numbers with units = result.

A number that is not known stays a symbol, so that a line can be printed for somebody who has not
got that far; the line then ends before the result.
"""

import math
from collections.abc import Iterator, Mapping
from itertools import groupby
from typing import Final

from gripcourse.course.column_symbols import column_symbols, reads_value
from gripcourse.course.quantity import Kind, Quantity, Rounding
from gripcourse.documents.report.angles import in_radians
from gripcourse.formula.boxes import Box, Row, Text
from gripcourse.formula.tree import Call, Formula, Name, Node, Operation, names, walk
from gripcourse.formula.typeset import equation, number_box, symbol_box, typeset
from gripcourse.solver.condition_text import condition_box
from gripcourse.solver.plan import Plan
from gripcourse.text.units import factor, unit_text
from gripcourse.text.words import Words, message

_RELATIONS: Final = {"<": "<", "<=": "≤", ">": ">", ">=": "≥", "==": "="}
_MANY_FIGURES: Final = 7  # a given number is printed as it was given


def worked_line(
    quantity: Quantity, inputs: Mapping[str, float], result: float | None, plan: Plan, words: Words
) -> Box | None:
    """Lay out how a quantity follows from numbers.

    Args:
        quantity: what is computed, decided or checked.
        inputs: values by id, each in its declared unit; what is missing stays a symbol.
        result: the value in the declared unit; None to end before it.
        plan: declarations, and whose version of a formula is the reference.
        words: the reader's language.

    Returns:
        `D = √(4P/(πpη)) = √(4·18 353 Н/(…)) = 60,08 мм`; for a choice
        `D ≥ D_тр = 60,08 мм → 63 мм`, with the condition that it steps up by, if any; for a
        verdict `σ = 24,4 МПа ≤ [σ] = 80 МПа: да`; None for what is not computed.
    """
    formula = plan.reference_formula(quantity.id)
    if formula is None:
        return None
    symbols = _symbols(quantity, formula, plan, words)
    # The number of a formula that is a mere name would be the result itself.
    hidden = result is None and isinstance(formula.tree, Name) and quantity.kind is not Kind.CHOICE
    numbers = symbols if hidden else symbols | _numbers(quantity, formula, inputs, plan, words)
    if quantity.kind is Kind.VERDICT:
        return _verdict(formula.tree, symbols, numbers, result, words)
    sides = _sides(formula.tree, symbols, numbers, words)
    own = _symbol(quantity, words)
    if quantity.kind is Kind.CHOICE:
        return _choice(quantity, own, sides, result, plan, words)
    if reads_value(formula.tree):
        own, *sides = sides  # `b(D) = b(63 мм)`: the table's column has the quantity's symbol
    if result is not None:
        sides.append(_value(result, quantity.unit, words))
    # What is the same twice is written once: `l = h = 40 мм`, not `l = h = 40 мм = 40 мм`.
    return equation([own, *(side for side, _ in groupby(sides))])


def entering_units(quantity: Quantity, plan: Plan, words: Words) -> tuple[tuple[str, str], ...]:
    """Return in which units the bare numbers of an empirical formula stand.

    Returns:
        Declared symbol and written unit of each number that has one; empty for other formulas,
        whose numbers carry their units.
    """
    formula = plan.reference_formula(quantity.id)
    entering = {} if formula is None else formula.units
    return tuple(
        (plan.quantities[name].symbol.of(words.language), unit_text(unit, words.language))
        for name, unit in entering.items()
        if unit
    )


def notation_notes(plan: Plan, words: Words) -> tuple[str, ...]:
    """Return what the lines of a plan's calculation write and no textbook explains."""
    formulas = (plan.reference_formula(one.id) for one in plan.answered)
    calls = (node for one in formulas if one is not None for node in walk(one.tree))
    if not any(isinstance(node, Call) and node.function == "at_least" for node in calls):
        return ()
    return (words.say(message("min{{≥ b}} is the smallest size of the series not below b.")),)


def _symbols(quantity: Quantity, formula: Formula, plan: Plan, words: Words) -> dict[str, Box]:
    """Return the symbol of every name, and what stands for the tables that are read."""
    used = {name: _symbol(plan.quantities[name], words) for name in names(formula.tree)}
    catalogues = plan.course.catalogues
    return used | column_symbols(
        formula.tree, quantity, plan.quantities, catalogues, words.language
    )


def _numbers(
    quantity: Quantity, formula: Formula, inputs: Mapping[str, float], plan: Plan, words: Words
) -> dict[str, Box]:
    """Return a number for every name that has one."""
    counted = in_radians(quantity, formula, plan.quantities)
    return {
        name: _number(plan.quantities[name], inputs[name], formula, words, counted=name in counted)
        for name in names(formula.tree)
        if name in inputs and not math.isnan(inputs[name])
    }


def _number(
    quantity: Quantity, value: float, formula: Formula, words: Words, *, counted: bool
) -> Box:
    if formula.units:
        entering = value * factor(quantity.unit) / factor(formula.units[quantity.id])
        return number_box(words.number(entering), "")
    if counted:
        entering = value * factor(quantity.unit)
        return number_box(words.number(entering), unit_text("rad", words.language))
    given = quantity.kind in {Kind.GIVEN, Kind.CONSTANT}
    return _value(value, quantity.unit, words, _MANY_FIGURES if given else 5)


def _value(value: float, unit: str, words: Words, figures: int = 5) -> Box:
    if unit == "rad":
        value, unit = math.degrees(value), "deg"
    return number_box(words.number(value, figures), unit_text(unit, words.language))


def _symbol(quantity: Quantity, words: Words) -> Box:
    return symbol_box(quantity.symbol.of(words.language))


def _sides(
    node: Node, symbols: Mapping[str, Box], numbers: Mapping[str, Box], words: Words
) -> list[Box]:
    """Return an expression in symbols and, where that says more, in numbers."""
    written = typeset(node, symbols, words.language)
    substituted = typeset(node, numbers, words.language)
    return [written] if written == substituted else [written, substituted]


def _choice(
    quantity: Quantity, own: Box, sides: list[Box], result: float | None, plan: Plan, words: Words
) -> Box:
    nearest = quantity.choice is not None and quantity.choice.rounding is Rounding.NEAREST
    items = [own, Text("relation", "≈" if nearest else "≥"), equation(sides)]
    condition = condition_box(quantity, plan, words.language) if quantity.steps_up else None
    if condition is not None:
        items += [Text("mark", "; "), condition]
    if result is not None:
        items += [Text("relation", "→"), _value(result, quantity.unit, words)]
    return Row(tuple(items))


def _verdict(
    node: Node,
    symbols: Mapping[str, Box],
    numbers: Mapping[str, Box],
    result: float | None,
    words: Words,
) -> Box:
    items: list[Box] = []
    for comparison in _comparisons(node):
        if items:
            items.append(Text("mark", "; "))
        items += [
            equation(_sides(comparison.left, symbols, numbers, words)),
            Text("relation", _RELATIONS[comparison.operator]),
            equation(_sides(comparison.right, symbols, numbers, words)),
        ]
    if result is not None:
        said = words.say(message("yes") if result else message("no"))
        items += [Text("mark", ": "), Text("upright", said)]
    return Row(tuple(items))


def _comparisons(node: Node) -> Iterator[Operation]:
    """Yield the comparisons that a condition joins by `and`."""
    if not isinstance(node, Operation):
        raise TypeError("the condition of a verdict is no comparison")
    if node.operator == "and":
        yield from _comparisons(node.left)
        yield from _comparisons(node.right)
    else:
        yield node
