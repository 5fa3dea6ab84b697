"""The condition of a choice as people write it: with symbols, a column by what is read from it."""

from gripcourse.course.column_symbols import column_symbols
from gripcourse.course.quantity import Quantity
from gripcourse.formula.boxes import Box
from gripcourse.formula.plain import text
from gripcourse.formula.typeset import symbol_box, typeset
from gripcourse.solver.plan import Plan


def condition_box(quantity: Quantity, plan: Plan, language: str) -> Box | None:
    """Lay out what a chosen size must also satisfy; None where there is nothing."""
    condition = None if quantity.choice is None else quantity.choice.condition
    if condition is None:
        return None
    names = {name: symbol_box(plan.quantities[name].symbol.of(language))
             for name in condition.names}  # fmt: skip
    read = column_symbols(condition.tree, None, plan.quantities, plan.course.catalogues, language)
    return typeset(condition.tree, read | names, language)


def condition_text(quantity: Quantity, plan: Plan, language: str) -> str:
    """Return the same on one line; empty where there is nothing."""
    box = condition_box(quantity, plan, language)
    return "" if box is None else text(box)
