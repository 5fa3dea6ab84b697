"""How long the solver takes for many variants, and for how long numpy would compute the same.

The same formulas as a person would write them in numpy: line after line, whole columns, nothing
checked and nothing replaced by known values; numpy's own operators, which write over what nobody
needs any more, and `np.searchsorted` for tables. Both ways come to the same numbers, which is
looked at before anything is timed.

Both ways are timed in turn in one process, the least of several runs each: what else the machine
does disturbs both alike. Counted is the processor's time in the program; the system's, which is for
clearing pages of memory, is shown beside it. `solve.py SCHEME ...` times some schemes only.
"""

import operator
import resource
import sys
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import reduce
from typing import assert_never, cast

import numpy as np

from gripcourse.course.load import load_course
from gripcourse.course.quantity import Rounding
from gripcourse.formula.evaluate import Array
from gripcourse.formula.functions import FUNCTIONS, SLACK, Column
from gripcourse.formula.tree import Call, Formula, Name, Negation, Node, Number, Operation
from gripcourse.machine.resources import course_root
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.sizes import reference_rounding
from gripcourse.solver.solve import Values, evaluate, to_si
from gripcourse.text.units import factor

RUNS = 4
COUNTS = (1_000, 10_000, 100_000)
LARGEST = 1_000_000
SPREAD = 0.05  # of each given number by itself: of more, many variants cannot be built

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


@dataclass(frozen=True, slots=True)
class Seconds:
    """Of the processor: in the program alone, and with what the system did for it."""

    program: float
    both: float


def main() -> None:
    """Solve up to 10⁶ variants of every scheme, or of those that are named, in one call each."""
    course = load_course(course_root())
    ours, plain = 0.0, 0.0
    for scheme in course.schemes.values():
        if scheme.example is None or (sys.argv[1:] and scheme.id not in sys.argv[1:]):
            continue
        plan = make_plan(course, scheme.id, scheme.example.options)
        _look_whether_same(plan)
        each = []
        for count in COUNTS:
            known = _known(plan, count)
            seconds = min(_timed(evaluate, plan, known).program for _ in range(RUNS))
            each.append(f"{seconds / count / len(plan.answered) * 1e9:4.0f}")
        own, straightly = _in_turn(plan, _known(plan, LARGEST))
        ours, plain = ours + own.program, plain + straightly.program
        print(
            f"{scheme.id:<20} {len(plan.answered):>3} quantities: {', '.join(each)} ns per value"
            f" (10³, 10⁴, 10⁵ variants); 10⁶: {own.program:5.2f} s,"
            f" {own.program / straightly.program:.2f} of numpy"
            f" ({own.both / straightly.both:.2f} with the system's)",
            flush=True,
        )
    print(f"all schemes, 10⁶ variants each: {ours:.1f} s, {ours / plain:.2f} of straight numpy")


def _look_whether_same(plan: Plan) -> None:
    """Stop where the two ways differ in any bit: then it is not the same calculation."""
    known = _known(plan, COUNTS[-1])
    own, straightly = evaluate(plan, known).values, straight(plan, known)
    for name, value in own.items():
        there = np.isfinite(value)
        if not np.array_equal(value[there], np.broadcast_to(straightly[name], value.shape)[there]):
            raise SystemExit(f"{plan.scheme.id}: {name} is another number in plain numpy")


def _in_turn(plan: Plan, known: Values) -> tuple[Seconds, Seconds]:
    """Time both ways in turn; the least of each."""
    taken = [(_timed(evaluate, plan, known), _timed(straight, plan, known)) for _ in range(RUNS)]
    own, straightly = zip(*taken, strict=True)
    return _least(own), _least(straightly)


def _least(taken: Iterable[Seconds]) -> Seconds:
    programs, both = zip(*((one.program, one.both) for one in taken), strict=True)
    return Seconds(min(programs), min(both))


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
    draw = np.random.default_rng(1)
    example = plan.scheme.example
    given = {} if example is None else example.given
    own = {name: value for name, value in given.items() if name in plan.quantities}
    return {
        name: value * draw.uniform(1 - SPREAD, 1 + SPREAD, count)
        for name, value in to_si(plan, own).items()
    }


def _timed(call: Callable[[Plan, Values], object], plan: Plan, known: Values) -> Seconds:
    before = resource.getrusage(resource.RUSAGE_SELF)
    call(plan, known)
    after = resource.getrusage(resource.RUSAGE_SELF)
    program = after.ru_utime - before.ru_utime
    return Seconds(program, program + after.ru_stime - before.ru_stime)


if __name__ == "__main__":
    main()
