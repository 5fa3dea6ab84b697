"""Names that come to the very number of another mistake: nobody can tell which was made."""

import math
from collections.abc import Iterator, Mapping

import numpy as np
from numpy.typing import NDArray

from gripcourse.formula.evaluate import evaluate
from gripcourse.grading.diagnose import CandidatesOf
from gripcourse.grading.model import Report
from gripcourse.simulation.foreign.kinds import Writing
from gripcourse.simulation.foreign.model import ForeignWork
from gripcourse.simulation.foreign.practical import size_of
from gripcourse.simulation.foreign.student import calculate
from gripcourse.simulation.foreign.writing import written
from gripcourse.slips.model import SlipId
from gripcourse.solver.plan import Plan
from gripcourse.text.units import factor

_SAME = 1e-6  # relative
_WAYS = 8  # of writing that are tried where each number has figures of its own
_POWERS_OF_PI = 3  # that a shortened pi may stand in a formula with


def same_by_value(
    plan: Plan,
    candidates_of: CandidatesOf,
    given: Mapping[str, float],
    work: ForeignWork,
    report: Report,
) -> frozenset[tuple[str, SlipId]]:
    """Return the names in a report that give the number that the student's mistake gives.

    Args:
        plan: of the variant.
        candidates_of: the wrong methods of each quantity.
        given: issued values, in declared units: a name is of what was done with the right ones.
        work: what was done.
        report: what the grader says.

    Returns:
        The quantity with the slip's name.
    """
    return frozenset(_found(plan, candidates_of, given, work, report))


def _found(
    plan: Plan,
    candidates_of: CandidatesOf,
    given: Mapping[str, float],
    work: ForeignWork,
    report: Report,
) -> Iterator[tuple[str, SlipId]]:
    same = max(_SAME, _POWERS_OF_PI * abs(work.habits.pi / math.pi - 1))
    for finding in report.findings:
        name, done = finding.quantity, work.done
        if finding.slip is None or done is None or name not in work.reaches | work.shown:
            continue
        quantity = plan.quantities[name]
        made = done.number if done.root == name and done.tree is None else math.nan
        wrong = work.calculated.found[name] if math.isnan(made) else made
        values = _values(plan, given, work, name)
        for candidate in candidates_of(name):
            if candidate.id in {finding.slip, *finding.tied}:
                at = {one: values.get(one, np.asarray(np.nan)) for one in candidate.formula.names}
                value = evaluate(candidate.formula, quantity.unit, at, plan.columns)
                declared = float(value) / factor(quantity.unit)
                # A number that was copied or typed is one as it was written.
                if math.isclose(declared, wrong, rel_tol=same) or (
                    math.isfinite(made) and is_written_as(declared, made, work.habits.writing)
                ):
                    yield name, candidate.id


def is_written_as(value: float, number: float, writing: Writing) -> bool:
    """Tell whether somebody who writes in this way may write a value as this number."""
    return math.isfinite(value) and any(
        math.isclose(float(written(value, writing, np.random.default_rng(seed))), number)
        for seed in range(_WAYS)
    )


def _values(
    plan: Plan, given: Mapping[str, float], work: ForeignWork, name: str
) -> dict[str, NDArray[np.float64]]:
    """Return what the student computed an answer with, SI, but for what was wrong before it.

    Where the step of the mistake is blank, it shows first in answers whose own method is right.
    """
    held = work.calculated.held
    if name not in work.reaches:
        held = calculate(plan, given, work.habits).held
    declared = {
        one: number / size_of(plan.quantities[one].unit)
        for one, number in held.items()
        if one in plan.quantities
    }
    done = work.done
    if done is not None and done.root not in work.reaches:
        declared[done.root] = given.get(done.root, work.calculated.typed(done.root))
    return {
        name: np.asarray(number * factor(plan.quantities[name].unit))
        for name, number in declared.items()
    }
