"""What the formulas of a view may use: quantities, coordinates, and the view's own lengths."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from graphlib import TopologicalSorter

import numpy as np

from gripcourse.course.model import Scheme
from gripcourse.course.view import Expression, View
from gripcourse.drawing.paper.strokes import DIGITS, settled_angle
from gripcourse.drawing.paper.text import Point
from gripcourse.formula.evaluate import Array, Column
from gripcourse.formula.evaluate import evaluate as evaluate_formula
from gripcourse.formula.tree import Formula
from gripcourse.solver.motion import coordinates, drive_at
from gripcourse.solver.plan import Plan
from gripcourse.solver.solve import Values, to_si
from gripcourse.text.units import factor


@dataclass(frozen=True, slots=True)
class Numbers:
    """Values at one position of the drive, in SI."""

    values: Values
    plan: Plan

    def number(self, formula: Formula, unit: str) -> float | None:
        """Compute a formula in a unit, settled; None without a value or where a name is missing."""
        if any(name not in self.values for name in formula.names):
            return None
        found = float(evaluate_formula(formula, unit, self.values, self.plan.columns))
        if math.isnan(found):
            return None
        found /= factor(unit)
        return settled_angle(found) if unit == "deg" else round(found, DIGITS)

    def numbers(self, written: Sequence[Expression], unit: str = "mm") -> list[float] | None:
        """Compute several formulas; None where one of them has no value."""
        found = [0.0 if one is None else self.number(one, unit) for one in written]
        complete = [one for one in found if one is not None]
        return complete if len(complete) == len(found) else None

    def point(self, written: Sequence[Expression]) -> Point | None:
        """Compute a point, mm."""
        found = self.numbers(written)
        return None if found is None else (found[0], found[1])


def numbers_at(plan: Plan, view: View, solved: Mapping[str, float], position: str) -> Numbers:
    """Collect the numbers of a view at a position of the kinematics.

    Args:
        plan: of the variant.
        view: of its scheme.
        solved: values of the variant in declared units; what is NaN is left out.
        position: one that the scheme has; empty where the scheme has none.
    """
    finite = {name: value for name, value in solved.items() if math.isfinite(value)}
    known = {name: np.asarray(one) for name, one in to_si(plan, finite).items()}
    found = values_at(plan.scheme, plan.columns, view, known, position)
    return Numbers(
        {name: one for name, one in found.items() if name in known or np.isfinite(one).all()}, plan
    )


def values_at(
    scheme: Scheme, columns: Mapping[str, Column], view: View, known: Values, position: str
) -> dict[str, Array]:
    """Add to known values the coordinates of a position and the measures of a view.

    Args:
        scheme: of the variants.
        columns: catalogue columns in SI.
        view: of the scheme.
        known: by name in SI, single numbers or arrays of shape (n,).
        position: one that the scheme has; empty where the scheme has none.

    Returns:
        All of them in SI; NaN where something cannot be computed. A measure whose formulas all
        need a name that is not known is absent.
    """
    found = dict(known)
    motion = scheme.kinematics
    if motion is not None and position:
        drive = drive_at(motion, found, position)
        found |= {**coordinates(motion, found, drive), motion.drive: drive}
    for name in _in_order(view):
        for formula in view.measures[name].formulas:
            if found.keys() >= set(formula.names):
                unit = view.measures[name].unit
                new = evaluate_formula(formula, unit, found, columns)
                before = found.get(name, new)
                found[name] = np.where(np.isnan(before), new, before)
    return found


def _in_order(view: View) -> tuple[str, ...]:
    """Return the view's own measures, each after those that it needs."""
    needed = {
        name: [one for formula in measure.formulas for one in formula.names if one in view.measures]
        for name, measure in view.measures.items()
    }
    return tuple(TopologicalSorter(needed).static_order())
