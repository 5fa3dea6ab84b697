"""What is read from a table with a number that lies beyond its rows: that of the row at its end."""

import math

import numpy as np

from gripcourse.formula.evaluate import evaluate_number
from gripcourse.formula.tree import Call, Formula, Node
from gripcourse.grading.comparison import Comparison
from gripcourse.text.units import factor

_READ = frozenset({"lookup", "interpolate"})


def follows_from_the_last_row(comparison: Comparison) -> bool:
    """Tell whether an answer stands at the end of a table beyond which the own number lies.

    A wrap angle of 314° is a mistake. Who looks it up finds no row for it and takes the last.
    """
    formula = comparison.plan.reference_formula(comparison.quantity.id)
    tree = None if formula is None else formula.tree
    if formula is None or formula.units or not isinstance(tree, Call):
        return False
    if tree.function not in _READ or tree.column is None:
        return False
    rows = comparison.plan.columns[tree.column]
    values = comparison.follow_through.numbers.values
    sought = evaluate_number(Formula("", _sought(tree), {}), "", values, comparison.plan.columns)
    sizes = np.asarray(rows.sizes)
    if not math.isfinite(sought) or sizes.min() <= sought <= sizes.max():
        return False
    entry = rows.values[sizes.argmax() if sought > sizes.max() else sizes.argmin()]
    return comparison.fits(float(entry) / factor(comparison.quantity.unit))


def _sought(tree: Call) -> Node:
    """Return the number that a row is looked for with; it may be rounded to a row first."""
    node: Node = tree
    while isinstance(node, Call) and node.column is not None:
        node = node.arguments[0]
    return node
