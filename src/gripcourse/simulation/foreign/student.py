"""One student of the second generator: from an issued variant to a calculation with a mistake."""

import ast
import math
from collections.abc import Iterator, Mapping
from itertools import pairwise
from typing import Final

import numpy as np

from gripcourse.course.quantity import Choice, Kind, Quantity, Rounding
from gripcourse.formula.tree import Formula
from gripcourse.simulation.behaviour import drawn
from gripcourse.simulation.foreign.distort import distorted, wrong_digits
from gripcourse.simulation.foreign.kinds import (
    AS_TEXT,
    GRAVITY,
    KEEPS,
    MISTAKES,
    PI,
    SEEN,
    WRITINGS,
    ForeignMistake,
)
from gripcourse.simulation.foreign.model import Calculated, Done, Habits
from gripcourse.simulation.foreign.practical import computed, parsed, size_of, tables_of
from gripcourse.simulation.foreign.writing import exactly, written
from gripcourse.solver.plan import Plan

_TRIES: Final = 60
_SIZES_TRIED: Final = 6  # of a series, before the student takes what comes
_CLOSE: Final = 1e-9
_THOUSANDS: Final = (1000.0, 0.001)
_HAVE_THOUSANDS: Final = frozenset({"mm", "m", "N", "kN", "N*m", "Pa", "kPa", "MPa", "W", "kW"})
_MISREAD: Final = frozenset({ForeignMistake.MISREAD_DIGITS, ForeignMistake.MISREAD_ROW})
_OF_RESULTS: Final = frozenset(
    {
        ForeignMistake.MISTYPED,
        ForeignMistake.MISCOPIED,
        ForeignMistake.WRONG_CELL,
        ForeignMistake.UNIT,
    }
)


def draw_habits(rng: np.random.Generator) -> Habits:
    """Draw how a student works."""
    return Habits(
        writing=drawn(WRITINGS, rng),
        keeps=bool(rng.random() < KEEPS),
        pi=drawn(PI, rng),
        gravity=drawn(GRAVITY, rng),
        as_text=bool(rng.random() < AS_TEXT),
        seed=int(rng.integers(1 << 31)),
    )


def calculate(
    plan: Plan, given: Mapping[str, float], habits: Habits, done: Done | None = None
) -> Calculated:
    """Compute a variant as a student does, step by step.

    Args:
        plan: what is computed, in which order.
        given: issued numbers in declared units.
        habits: of the student.
        done: the mistake; None for none.
    """
    rng = np.random.default_rng(habits.seed)
    held: dict[str, float] = {"pi": habits.pi}
    found: dict[str, float] = {}
    texts: dict[str, str] = {}
    for name, quantity in plan.quantities.items():
        if quantity.kind is Kind.MANUAL:
            continue
        size = size_of(quantity.unit)
        wrong = done if done is not None and done.root == name else None
        if not quantity.kind.answered:
            held[name] = _taken(quantity, given, habits, wrong) * size
            continue
        found[name] = _result(plan, quantity, held, done)
        text = _text(quantity, found[name], habits, rng)
        kept = found[name] if habits.keeps and not quantity.exact else float(text or "nan")
        if wrong is not None and wrong.kind in _OF_RESULTS:
            text, kept = _otherwise(wrong, text, kept, habits)
        if text:
            texts[name] = text
        held[name] = kept * size
    return Calculated(held, found, texts)


def _taken(
    quantity: Quantity, given: Mapping[str, float], habits: Habits, wrong: Done | None
) -> float:
    """Return a given or a constant as a student takes it, in the declared unit."""
    if wrong is not None and wrong.kind in _MISREAD:
        return wrong.number
    if quantity.value is None:
        return given[quantity.id]
    return habits.gravity if quantity.id == "gravity" else quantity.value


def _result(plan: Plan, quantity: Quantity, held: Mapping[str, float], done: Done | None) -> float:
    """Return what a formula comes to, in the declared unit; NaN where it comes to nothing."""
    formula = plan.reference_formula(quantity.id)
    if formula is None:
        return math.nan
    wrong = None if done is None or done.root != quantity.id else done.tree
    tree = parsed(formula.text) if wrong is None else wrong
    tables, size = tables_of(plan.course), size_of(quantity.unit)
    if formula.units:
        units = {**formula.units, "pi": ""}
        numbers = {name: held[name] / size_of(unit) for name, unit in units.items() if name in held}
        return computed(tree, numbers, tables)
    result = computed(tree, held, tables)
    if quantity.choice is None:
        return result / size
    return _chosen(plan, quantity, quantity.choice, result, held, done) / size


def _chosen(
    plan: Plan,
    quantity: Quantity,
    choice: Choice,
    required: float,
    held: Mapping[str, float],
    done: Done | None,
) -> float:
    """Take a size from a series: the first large enough that also meets its condition."""
    sizes = tables_of(plan.course)[choice.column].sizes
    if math.isnan(required):
        return math.nan
    if choice.rounding is Rounding.NEAREST:
        return min(sizes, key=lambda one: abs(one - required))
    enough = [one for one in sizes if one >= required * (1 - _CLOSE)]
    if choice.condition is None or not enough:
        return enough[0] if enough else math.nan
    tree, tables = parsed(choice.condition.text), tables_of(plan.course)
    tried = enough if quantity.steps_up else enough[:_SIZES_TRIED]
    sound = (
        one
        for one in tried
        if computed(tree, _with_size(plan, quantity, one, held, done), tables) == 1.0
    )
    return next(sound, enough[0])


def _with_size(
    plan: Plan, quantity: Quantity, size: float, held: Mapping[str, float], done: Done | None
) -> dict[str, float]:
    """Return what a student has at hand who tries a size: what is computed from it too."""
    tried = {**held, quantity.id: size}
    for name in plan.step_ups[quantity.id].between if quantity.steps_up else ():
        one = plan.quantities[name]
        tried[name] = _result(plan, one, tried, done) * size_of(one.unit)
    return tried


def _text(quantity: Quantity, value: float, habits: Habits, rng: np.random.Generator) -> str:
    if math.isnan(value):
        return ""
    if quantity.exact:
        return exactly(value)
    if quantity.integer:
        return f"{value:.0f}" if value == round(value) else written(value, habits.writing, rng)
    return written(value, habits.writing, rng)


def _otherwise(done: Done, text: str, kept: float, habits: Habits) -> tuple[str, float]:
    """Return what is written and what is gone on with, where one of them is wrong."""
    wrong = exactly(done.number)
    match done.kind:
        case ForeignMistake.MISCOPIED:
            return text, done.number
        case ForeignMistake.MISTYPED:
            return wrong, done.number
        case ForeignMistake.UNIT if habits.seed % 2:
            return wrong, done.number
        case _:
            return wrong, kept


def draw_mistake(
    plan: Plan, given: Mapping[str, float], habits: Habits, rng: np.random.Generator
) -> tuple[Done, Calculated] | None:
    """Draw a mistake that shows; None where none was found."""
    right = calculate(plan, given, habits)
    weights = {kind: one.weight for kind, one in MISTAKES.items()}
    for _ in range(_TRIES):
        kind = drawn(weights, rng)
        ways = list(_ways(plan, given, right, kind, rng))
        if not ways:
            continue
        done = ways[int(rng.integers(len(ways)))]
        made = calculate(plan, given, habits, done)
        if _shows(right, made, reached(plan, done)):
            return done, made
    return None


def reached(plan: Plan, done: Done) -> frozenset[str]:
    """Return the answers that a mistake itself is in."""
    if done.kind not in {*_MISREAD, ForeignMistake.MISCOPIED}:
        return frozenset({done.root})
    return frozenset(one.id for one in plan.answered if done.root in plan.inputs[one.id])


def _ways(
    plan: Plan, given: Mapping[str, float], right: Calculated, kind: ForeignMistake,
    rng: np.random.Generator,
) -> Iterator[Done]:  # fmt: skip
    """Yield ways to make a mistake, each at another place."""
    if kind in _MISREAD:
        yield from _misread(plan, given, kind, rng)
        return
    answers = [one for one in plan.answered if one.kind in {Kind.FORMULA, Kind.PICK}]
    if kind is ForeignMistake.WRONG_CELL:
        for one, other in pairwise(answers):
            if one.section == other.section:
                yield Done(kind, one.id, number=right.typed(other.id))
        return
    for one in answers:
        typed = right.typed(one.id)
        if math.isnan(typed) or not typed:
            continue
        if kind in _OF_RESULTS:
            number = _instead(one, typed, kind, rng)
            if number is not None:
                yield Done(kind, one.id, number=number)
        else:
            formula = plan.reference_formula(one.id)
            for tree in () if formula is None else _trees(plan, one, formula, kind):
                yield Done(kind, one.id, tree=tree)


def _instead(
    one: Quantity, typed: float, kind: ForeignMistake, rng: np.random.Generator
) -> float | None:
    """Return the number that is typed or used instead of an answer; None where none can be."""
    if kind is ForeignMistake.UNIT:
        return typed * float(rng.choice(_THOUSANDS)) if one.unit in _HAVE_THOUSANDS else None
    return wrong_digits(typed, rng)


def _misread(
    plan: Plan, given: Mapping[str, float], kind: ForeignMistake, rng: np.random.Generator
) -> Iterator[Done]:
    if kind is ForeignMistake.MISREAD_DIGITS:
        for one in plan.givens:
            yield Done(kind, one.id, number=wrong_digits(given[one.id], rng))
        return
    for one, other in pairwise(plan.givens):
        # Nobody goes on with a friction of 36 mm: the next row is taken where it looks alike.
        if one.unit and one.unit == other.unit:
            yield Done(kind, one.id, number=given[other.id])
            yield Done(kind, other.id, number=given[one.id])


def _trees(plan: Plan, one: Quantity, formula: Formula, kind: ForeignMistake) -> list[ast.expr]:
    order = list(plan.quantities)
    known = set(order[: order.index(one.id)])
    if formula.units:
        known &= set(formula.units)
    used = set(formula.names)
    thousands = {name for name in used if plan.quantities[name].unit in _HAVE_THOUSANDS}
    return distorted(parsed(formula.text), kind, known, thousands)


def _shows(right: Calculated, made: Calculated, places: frozenset[str]) -> bool:
    """Tell whether a mistake changes a number that it reaches, and leaves all of them a value."""
    if made.texts.keys() != right.texts.keys():
        return False
    return any(
        abs(made.typed(name) - right.typed(name)) > SEEN * abs(right.typed(name))
        for name in places & right.texts.keys()
    )
