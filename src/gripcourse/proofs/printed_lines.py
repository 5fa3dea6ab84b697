"""The printed substitution of every formula reads back to the number that stands behind it."""

import math
from collections.abc import Iterable, Iterator

from gripcourse.course.quantity import Quantity
from gripcourse.documents.report.angles import in_radians
from gripcourse.errors import Problem
from gripcourse.formula.evaluate import evaluate
from gripcourse.formula.markup import text
from gripcourse.formula.tree import Call, Formula, walk
from gripcourse.formula.typeset import number_box, typeset
from gripcourse.proofs.model import Proof, ProofKind, ProofResult, concluded, short_name
from gripcourse.proofs.read_back import read_back
from gripcourse.proofs.samples import Trial
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import Values
from gripcourse.solver.solve import evaluate as solve
from gripcourse.text.number_text import format_number
from gripcourse.text.units import factor, unit_text
from gripcourse.text.words import message

_FULL = 15  # figures
_SAME = 1e-6
_TRIED = 2  # sets of numbers of each composition


def printed_line(one: Quantity, formula: Formula, plan: Plan, values: Values, language: str) -> str:
    """Print a formula with numbers instead of names, all their figures and their units.

    Args:
        one: what the formula computes.
        formula: one of its versions.
        plan: that it belongs to.
        values: of one variant, SI.
        language: of the line.
    """
    counted = in_radians(one, formula, plan.quantities)
    boxes = {}
    for name in formula.names:
        unit = formula.units.get(name, "rad" if name in counted else plan.quantities[name].unit)
        shown = "" if formula.units else unit_text(unit, language)
        number = format_number(float(values[name]) / factor(unit), language, _FULL)
        boxes[name] = number_box(number, shown)
    return text(typeset(formula.tree, boxes, language))


def printable(plan: Plan) -> Iterator[tuple[Quantity, Formula]]:
    """Yield what can be read back without a catalogue: all but choices and picks by table."""
    for one in plan.quantities.values():
        formula = plan.reference_formula(one.id)
        if formula is not None and not _reads_a_table(formula):
            yield one, formula


def reads_back(one: Quantity, formula: Formula, plan: Plan, values: Values, language: str) -> bool:
    """Tell whether a printed line gives the computed value again."""
    line = printed_line(one, formula, plan, values, language)
    size = factor(one.unit) if formula.units else 1.0  # of an empirical one, in its own unit
    try:
        found = read_back(line, language) * size
    except ValueError:
        return False
    right = float(evaluate(formula, one.unit, values, plan.columns))
    return math.isclose(found, right, rel_tol=_SAME, abs_tol=_SAME * 1e-9)


def prove_printed_lines(trials: Iterable[Trial]) -> Iterator[ProofResult]:
    """Read the line of every formula back, in every language and convention of the course.

    A line of a shared part is read once for all compositions that use it with the same units.

    Returns:
        A result for each file that declares formulas.
    """
    seen: set[object] = set()
    counted: dict[str, int] = {}
    problems: dict[str, dict[str, Problem]] = {}
    for trial in trials:
        for convention in trial.plan.course.conventions:
            plan = make_plan(
                trial.plan.course, trial.plan.scheme.id, trial.plan.options, convention
            )
            new = [one for one in printable(plan) if _is_new(plan, *one, seen)]
            if not new:
                continue
            solved = solve(plan, trial.known).values
            for one, formula in new:
                counted[one.file] = counted.get(one.file, 0) + 1
                for problem in _faults(one, formula, plan, solved, len(trial.variants)):
                    problems.setdefault(one.file, {})[f"{problem.key}"] = problem
    for file, count in counted.items():
        proof = Proof(ProofKind.PRINTED_LINES, short_name(file), file, "")
        yield concluded(proof, count, tuple(problems.get(file, {}).values()))


def _faults(
    one: Quantity, formula: Formula, plan: Plan, solved: Values, count: int
) -> Iterator[Problem]:
    for place in range(min(count, _TRIED)):
        values = {
            name: value[place] if value.ndim else value
            for name, value in solved.items()
            if name in formula.names
        }
        for language in plan.course.languages:
            if not reads_back(one, formula, plan, values, language):
                yield Problem(
                    one.file,
                    f"quantity.{one.id}",
                    message(
                        "The printed line does not give its own result ({language}).",
                        language=language,
                    ),
                    message("Write the formula in another way; this is our mistake, tell us."),
                    printed_line(one, formula, plan, values, language),
                )


def _is_new(plan: Plan, one: Quantity, formula: Formula, seen: set[object]) -> bool:
    key = (one.file, one.id, formula.text, *(plan.quantities[n].unit for n in formula.names))
    is_new = key not in seen
    seen.add(key)
    return is_new


def _reads_a_table(formula: Formula) -> bool:
    return any(isinstance(node, Call) and node.column is not None for node in walk(formula.tree))
