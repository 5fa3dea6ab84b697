"""Spreadsheet formulas of the key, in SI, over cells named `si.<id>`."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

import numpy as np

from gripcourse.course.quantity import Quantity, Rounding
from gripcourse.formula.evaluate import evaluate
from gripcourse.formula.excel import excel_form
from gripcourse.formula.tree import Call, Formula, Name, names
from gripcourse.solver.plan import Plan
from gripcourse.solver.sizes import reference_rounding
from gripcourse.solver.solve import to_si
from gripcourse.workbook.names import SI, cell_name

Ranges = Mapping[str, tuple[str, str]]
_NOWHERE: Final[Mapping[str, str]] = MappingProxyType({})


def direct_form(
    quantity: Quantity, plan: Plan, columns: Ranges, elsewhere: Mapping[str, str] = _NOWHERE
) -> str | None:
    """Return the reference formula of a quantity; of a choice, what it must not be below.

    Args:
        quantity: what is computed.
        plan: that it belongs to.
        columns: ranges of the catalogues.
        elsewhere: cells of values that do not stand where `si.<id>` does, by id.

    Returns:
        The text after the sign of equality; None where a spreadsheet cannot compute it.
    """
    formula = plan.reference_formula(quantity.id)
    if formula is None:
        return None
    cells = {name: elsewhere.get(name, cell_name(SI, name)) for name in names(formula.tree)}
    return excel_form(formula, quantity.unit, cells, columns)


def entry_form(quantity: Quantity, plan: Plan, required: str, columns: Ranges) -> str | None:
    """Return the formula that takes the entry of a choice for the value in a cell."""
    if quantity.choice is None:
        return None
    up = reference_rounding(quantity, plan.convention) is Rounding.UP
    call = Call("at_least" if up else "nearest", (Name("required"),), quantity.choice.column)
    return excel_form(Formula("", call, {}), "", {"required": required}, columns)


def required_value(quantity: Quantity, plan: Plan, values: Mapping[str, float]) -> float:
    """Compute in SI what a choice must not be below, from values in declared units."""
    formula = plan.reference_formula(quantity.id)
    if formula is None:
        return float("nan")
    used = to_si(plan, {name: values[name] for name in names(formula.tree)})
    arrays = {name: np.asarray(value) for name, value in used.items()}
    return float(evaluate(formula, quantity.unit, arrays, plan.columns))
