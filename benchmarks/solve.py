"""How long the solver takes for many variants, and for how long numpy would compute the same.

The same formulas as a person would write them in numpy: line after line, whole columns, nothing
checked and nothing replaced by known values; numpy's own operators, which write over what nobody
needs any more, and `np.searchsorted` for tables. Both ways come to the same numbers, which is
looked at before anything is timed.

Both ways are timed in turn in one process, each of which first got memory of its own, so that a
machine's other work disturbs both alike; `solve.py SCHEME ...` times some schemes only.
"""

import operator
import subprocess
import sys
from collections.abc import Callable, Mapping
from functools import reduce
from time import process_time
from typing import assert_never, cast

import numpy as np

from gripcourse.course.load import load_course
from gripcourse.course.quantity import Rounding
from gripcourse.formula.evaluate import Array
from gripcourse.formula.functions import FUNCTIONS, SLACK, Column
from gripcourse.formula.tree import Call, Formula, Name, Negation, Node, Number, Operation
from gripcourse.machine.resources import course_root
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import Values, evaluate, reference_rounding, to_si
from gripcourse.text.units import factor

RUNS = 2
COUNTS = (1_000, 10_000, 100_000)
LARGEST = 1_000_000

_PLAIN: Mapping[str, Callable[[Array, Array], Array]] = {
    "+": operator.add, "-": operator.sub, "*": operator.mul, "/": operator.truediv,
    "**": operator.pow, "<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge,
    "==": operator.eq, "and": operator.and_,
}  # fmt: skip
_NUMPY: Mapping[str, Callable[..., Array]] = {
    "sqrt": np.sqrt, "cbrt": np.cbrt, "sin": np.sin, "cos": np.cos, "tan": np.tan,
    "asin": np.arcsin, "acos": np.arccos, "atan": np.arctan, "abs": np.abs, "exp": np.exp,
    "log": np.log, "atan2": np.arctan2, "hypot": np.hypot, "exceeds": np.greater,
}  # fmt: skip


def main() -> None:
    """Solve up to 10⁶ variants of every scheme in one call each."""
    course = load_course(course_root())
    ours, plain = 0.0, 0.0
    for scheme in course.schemes.values():
        if scheme.example is None:
            continue
        plan = make_plan(course, scheme.id, scheme.example.options)
        each = []
        for count in COUNTS:
            known = _known(plan, count)
            seconds = min(_timed(evaluate, plan, known) for _ in range(RUNS))
            each.append(f"{seconds / count / len(plan.answered) * 1e9:4.0f}")
        own, straightly = (_alone(way, scheme.id) for way in ("own", "straight"))
        ours, plain = ours + own, plain + straightly
        print(
            f"{scheme.id:<20} {len(plan.answered):>3} quantities: {', '.join(each)} ns per value"
            f" (10³, 10⁴, 10⁵ variants); 10⁶: {own:5.2f} s, {own / straightly:.2f} of numpy"
        )
    print(f"all schemes, 10⁶ variants each: {ours:.1f} s, {ours / plain:.2f} of straight numpy")


def _alone(way: str, scheme: str) -> float:
    """Time one way in processes of its own: it must not get the memory that the other gave back."""
    command = [sys.executable, __file__, way, scheme]
    return min(
        float(subprocess.run(command, check=True, capture_output=True, text=True).stdout)  # noqa: S603
        for _ in range(RUNS)
    )


def _timed_alone(way: str, scheme_id: str) -> float:
    course = load_course(course_root())
    example = course.schemes[scheme_id].example
    plan = make_plan(course, scheme_id, {} if example is None else example.options)
    known = _known(plan, LARGEST)
    return _timed(evaluate if way == "own" else straight, plan, known)


def straight(plan: Plan, known: Values) -> dict[str, Array]:
    """Compute a plan as plain numpy does it."""
    found = dict(known)
    with np.errstate(all="ignore"):
        for name, quantity in plan.quantities.items():
            formula = plan.reference_formula(name)
            if name in found or (formula is None and quantity.value is None):
                continue
            if quantity.value is not None:
                found[name] = np.asarray(quantity.value * factor(quantity.unit))
            elif formula is not None:
                found[name] = _in_units(formula, quantity.unit, plan, found)
                if quantity.choice is not None:
                    rounding = reference_rounding(quantity, plan.convention)
                    pick = "at_least" if rounding is Rounding.UP else "nearest"
                    column = plan.columns[quantity.choice.column]
                    found[name] = _read(pick, found[name], column)
    return found


def _in_units(formula: Formula, unit: str, plan: Plan, found: Values) -> Array:
    if not formula.units:
        return _plain(formula.tree, plan, found)
    own = {name: found[name] / factor(one) for name, one in formula.units.items()}
    return _plain(formula.tree, plan, own) * factor(unit)


def _plain(node: Node, plan: Plan, found: Values) -> Array:
    match node:
        case Number(value):
            return cast("Array", value)  # numpy computes with a plain number as well
        case Name(name):
            return cast("Array", np.pi) if name == "pi" else found[name]
        case Negation(operand):
            return operator.neg(_plain(operand, plan, found))
        case Operation(sign, left, right):
            return _PLAIN[sign](_plain(left, plan, found), _plain(right, plan, found))
        case Call():
            return _called(node, plan, found)
        case _:
            assert_never(node)


def _called(call: Call, plan: Plan, found: Values) -> Array:
    values = tuple(_plain(one, plan, found) for one in call.arguments)
    if call.function in {"min", "max"}:
        return reduce(np.minimum if call.function == "min" else np.maximum, values)
    if call.function in _NUMPY:
        return _NUMPY[call.function](*values)
    if call.column is None:
        return FUNCTIONS[call.function].compute(values, None)
    return _read(call.function, values[0], plan.columns[call.column])


def _read(function: str, number: Array, column: Column) -> Array:
    """Read a table that has no row for what is above its last one."""
    if function == "at_least":
        row = np.searchsorted(column.values, number * (1 - SLACK))
        return np.append(column.sizes, np.nan)[row]
    if function == "lookup":
        order = np.argsort(column.sizes)
        row = np.searchsorted(column.sizes[order], number * (1 - SLACK))
        return np.append(column.values[order], np.nan)[row]
    return FUNCTIONS[function].compute((number,), column)


def _known(plan: Plan, count: int) -> Values:
    spread = np.random.default_rng(1).uniform(0.95, 1.05, count)
    example = plan.scheme.example
    given = {} if example is None else example.given
    own = {name: value for name, value in given.items() if name in plan.quantities}
    return {name: value * spread for name, value in to_si(plan, own).items()}


def _timed(call: Callable[[Plan, Values], object], plan: Plan, known: Values) -> float:
    start = process_time()
    call(plan, known)
    return process_time() - start


if __name__ == "__main__":
    if sys.argv[1:]:
        print(_timed_alone(*sys.argv[1:]))
    else:
        main()
