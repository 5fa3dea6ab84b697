"""A wrong sign in a formula does not go unnoticed: every operator is flipped, one at a time."""

import dataclasses
import math
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
import pytest
from numpy.typing import NDArray

from gripcourse.course.model import Convention, Course, Kind, Quantity
from gripcourse.formula.evaluate import evaluate
from gripcourse.formula.parse import parse
from gripcourse.formula.tree import (
    Call,
    Formula,
    Negation,
    Node,
    Number,
    Operation,
    Operator,
    children,
)
from gripcourse.policy.bands import band, within
from gripcourse.policy.model import Policy
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import Values, choose, reference_rounding, solve_variant
from gripcourse.text.units import factor

if TYPE_CHECKING:
    from conftest import Composition, Reference

Array: TypeAlias = NDArray[np.float64]

FLIPPED: Mapping[Operator, Operator] = {
    "+": "-",
    "-": "+",
    "*": "/",
    "/": "*",
    "<": ">",
    "<=": ">=",
    ">": "<",
    ">=": "<=",
}
CASES = Path(__file__).parents[2] / "variants" / "published_cases.toml"
OF_ANOTHER_METHOD = [
    case
    for case in tomllib.loads(CASES.read_text(encoding="utf-8"))["case"]
    if case["source"]["work"] == "derived"
]
STUDENTS = 60  # for each set of reference numbers
# Flips that change no number, and why.
EQUIVALENT: Mapping[str, str] = {
    "cups_fit: *": "cups are far smaller than their pitch, or far larger",
    "jaw_chord: +": "as printed, by E3, the band of contact is too narrow to count",
    "jaw_chord: *": "as printed, by E3, the band of contact is too narrow to count",
}
# Flips that the worked example's own numbers cannot show, and why; variants show them.
HIDDEN_BY_THE_EXAMPLE: Mapping[str, Mapping[str, str]] = {
    "rack_parallelogram": {
        "arm_angle_at_min: /": "the numerator is 0: any divisor does",
        "force_ratio_at_min: *": "the arms lie along the axis: the cosine is 1",
        "drive_force: /": "the example leaves the efficiency out, it is 1",
        "pin_diameter_required: *": "one shear plane",
    },
    "link_lever_3": {"pin_diameter_required: *": "one shear plane"},
    "plain_lever": {
        "finger_force_right: *": "the other end of the range needs more force",
        "finger_force_left: *": "the other end of the range needs more force",
    },
    "screw": {"pin_diameter_required: *": "one shear plane"},
    "slot_crosshead": {"radius_ratio: /": "the jaw has the smaller radius"},
    "slot_lever": {
        "pin_diameter_required: *": "one shear plane",
        "slot_reach: /": "the other end of the stroke gives the larger distance",
    },
    "pinion_racks": {"stroke_required: /": "the ratio of the jaw's speed to the rack's is 1"},
    "wedge_roller": {
        "finger_force_right: *": "the other end of the range needs more force",
        "finger_force_right: /": "the other end of the range needs more force",
        "finger_force_left: *": "the other end of the range needs more force",
        "finger_force_left: /": "the other end of the range needs more force",
    },
}


@dataclass(frozen=True, slots=True)
class Mutant:
    """A formula with one operator flipped; `operator` is the one that was there."""

    operator: str
    tree: Node


def mutants(node: Node) -> Iterator[Mutant]:
    """Yield a tree with each of its operators flipped; an exponent grows by one."""
    if isinstance(node, Operation) and node.operator in FLIPPED:
        yield Mutant(node.operator, dataclasses.replace(node, operator=FLIPPED[node.operator]))
    if isinstance(node, Operation) and node.operator == "**":
        more = Operation("+", node.right, Number(1.0, "1"))
        yield Mutant("**", dataclasses.replace(node, right=more))
    below = children(node)
    for place, child in enumerate(below):
        for one in mutants(child):
            changed = (*below[:place], one.tree, *below[place + 1 :])
            yield Mutant(one.operator, with_children(node, changed))


def with_children(node: Node, below: tuple[Node, ...]) -> Node:
    """Put other nodes below a node."""
    match node:
        case Operation(operator):
            return Operation(operator, *below)
        case Negation():
            return Negation(*below)
        case Call(function, _, column):
            return Call(function, below, column)
        case _:
            return node


def named_mutants(plan: Plan) -> Iterator[tuple[str, Quantity, Formula]]:
    """Yield every mutant of every reference formula, by quantity and operator."""
    for one in plan.answered:
        formula = plan.reference_formula(one.id)
        if formula is not None:
            for mutant in mutants(formula.tree):
                changed = dataclasses.replace(formula, tree=mutant.tree)
                yield f"{one.id}: {mutant.operator}", one, changed


def value(plan: Plan, one: Quantity, formula: Formula, values: Values) -> Array:
    """Compute a quantity by another formula, in its declared unit; one number for each set."""
    result = evaluate(formula, one.unit, values, plan.columns)
    if one.choice is not None:
        result = choose(result, one.choice, reference_rounding(one, plan.convention), plan)
    return result / factor(one.unit)


def is_seen(plan: Plan, one: Quantity, formula: Formula, values: Values, policy: Policy) -> bool:
    """Tell whether a mutant changes its quantity by more than the band in any set of numbers."""
    right_formula = plan.reference_formula(one.id)
    assert right_formula is not None
    right = np.atleast_1d(value(plan, one, right_formula, values))
    wrong = np.broadcast_to(value(plan, one, formula, values), right.shape)
    return any(
        math.isfinite(expected) and not within(found, expected, band(one, expected, policy))
        for found, expected in zip(wrong.tolist(), right.tolist(), strict=True)
    )


def students(plan: Plan, references: Sequence["Reference"]) -> Values:
    """Stack references, and beside each the numbers of students who err everywhere.

    Reference values are not independent: the arms lie exactly along the axis when the smallest
    object is held, so that the sign of that angle would never show. And of two sizes the same is
    always the larger. So inputs are moved as far as students move them: nearly doubled or halved,
    angles turned, and of another sign where the bounds let them.
    """
    chance = np.random.default_rng(7)
    stacked: dict[str, Array] = {}
    for name in references[0].values:
        one = plan.quantities[name]
        right = np.array([float(one.values[name]) for one in references])
        shape = (STUDENTS, right.size)
        erred = right * chance.uniform(0.5, 1.9, shape)
        if one.unit in {"deg", "rad"}:
            erred = erred + chance.uniform(-0.4, 0.4, shape)
        elif one.bounds[0] < 0:
            erred = erred * chance.choice([-1, 1], shape)
        erred = erred + (erred == 0) * chance.uniform(0.2, 0.4, shape)
        stacked[name] = np.concatenate([right, erred.ravel()])
    return stacked


def test_a_flipped_operator_changes_an_answer(composition: "Composition", policy: Policy) -> None:
    values = students(composition.plan, composition.references)
    unseen = {
        name
        for name, one, formula in named_mutants(composition.plan)
        if not is_seen(composition.plan, one, formula, values, policy)
    }
    assert unseen - EQUIVALENT.keys() == set()


def test_a_flipped_operator_of_a_printed_version_changes_an_answer(
    printed_composition: "Composition", policy: Policy
) -> None:
    test_a_flipped_operator_changes_an_answer(printed_composition, policy)


def test_a_flipped_operator_breaks_the_worked_example(course: Course) -> None:
    """Of every quantity that the example gives a number for, in the convention that gives it."""
    for scheme in course.schemes.values():
        if scheme.example is None:
            continue
        unseen: set[str] = set()
        for convention, expected in scheme.example.expected.items():
            plan = make_plan(course, scheme.id, scheme.example.options, convention)
            given = {**scheme.example.given, **scheme.example.chosen[convention]}
            for name, one, formula in named_mutants(plan):
                if one.id in expected and one.kind is not Kind.VERDICT:
                    changed = solve_variant(_with(plan, one, formula, convention), given)
                    if _all_as_expected(changed, expected):
                        unseen.add(name)
        assert unseen == HIDDEN_BY_THE_EXAMPLE.get(scheme.id, {}).keys(), scheme.id


@pytest.mark.parametrize("case", OF_ANOTHER_METHOD, ids=[case["id"] for case in OF_ANOTHER_METHOD])
def test_a_flipped_operator_breaks_a_case_of_another_method(
    course: Course, case: dict[str, Any]
) -> None:
    """Of every quantity that the case gives a number for."""
    example = course.schemes[case["scheme"]].example
    assert example is not None
    plan = make_plan(course, case["scheme"], {**example.options, **case["options"]})
    known = {one.id for one in (*plan.givens, *plan.constants)}
    given = {name: value for name, value in example.given.items() if name in known}
    given |= case.get("given", {})
    tried = [mutant for mutant in named_mutants(plan) if mutant[1].id in case["expected"]]
    unseen = {
        name
        for name, one, formula in tried
        if _all_as_expected(
            solve_variant(_with(plan, one, formula, Convention.CORRECTED), given), case["expected"]
        )
    }
    assert tried
    assert unseen == set()


def _with(plan: Plan, one: Quantity, formula: Formula, convention: Convention) -> Plan:
    """Return the plan with another reference formula of a quantity."""
    printed = one.as_printed
    if convention is Convention.AS_PRINTED:
        printed = tuple(dataclasses.replace(p, formula=None) for p in printed)
    changed = dataclasses.replace(one, formula=formula, as_printed=printed)
    return dataclasses.replace(plan, quantities={**plan.quantities, one.id: changed})


def _all_as_expected(
    values: Mapping[str, float], expected: Mapping[str, tuple[float, float]]
) -> bool:
    return all(
        np.isclose(values[name], number, rtol=1e-12, atol=difference)
        for name, (number, difference) in expected.items()
    )


def test_every_operator_is_flipped_once() -> None:
    found = [
        (one.operator, one.tree) for one in mutants(parse("sqrt(a*b**2) + max(c, -(d - e)/f)"))
    ]
    assert [operator for operator, _ in found] == ["+", "*", "**", "/", "-"]
    assert found[3][1] == parse("sqrt(a*b**2) + max(c, -(d - e)*f)")
