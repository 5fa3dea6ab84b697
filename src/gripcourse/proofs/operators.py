"""A wrong sign in a formula does not go unnoticed: every operator is flipped, one at a time.

A flipped operator is noticed where a printed number does not come out any more, a proof fails,
or where the formula then measures something else, which the check of the course refuses.
"""

import dataclasses
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import TypeAlias

import numpy as np

from gripcourse.course.model import Course
from gripcourse.course.quantity import Convention, Kind, Quantity
from gripcourse.formula.dimension import check_dimension
from gripcourse.formula.parse import FormulaFault
from gripcourse.formula.rules import ColumnDimensions
from gripcourse.formula.tree import (
    Call,
    Formula,
    Negation,
    Node,
    Number,
    Operation,
    Operator,
    Span,
    children,
)
from gripcourse.proofs.calculations import PrintedCalculation, broken_by
from gripcourse.solver.plan import Plan
from gripcourse.solver.sizes import compute, reference_steps_up
from gripcourse.solver.solve import evaluate, to_si
from gripcourse.text.units import dimension

Columns: TypeAlias = Mapping[str, ColumnDimensions]

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
OPERATORS = (*FLIPPED, "**")
_CONDITIONS = frozenset({"<", "<=", ">", ">="})


class Noticed(StrEnum):
    """What notices a flipped operator."""

    PRINTED_NUMBER = "printed_number"
    PROOF = "proof"
    DIMENSION = "dimension"
    REFUSED = "refused"  # the variants of the course would be
    UNSHOWN = "unshown"  # the course says why no number can show it
    NOTHING = "nothing"


@dataclass(frozen=True, slots=True)
class Mutant:
    """A formula with one operator flipped; `operator` is the one that was there, at `span`."""

    operator: str
    tree: Node
    span: Span


@dataclass(frozen=True, slots=True)
class FlippedFormula:
    """A declared formula with one operator flipped.

    Attributes:
        quantity: the declaration.
        right, wrong: its formula, and what was made of it.
        operator, span: what was flipped, and where in the text.
        convention: whose reference the formula is.
        steps_up: whether it is the condition that a choice steps up by, and no formula of a value.
    """

    quantity: Quantity
    right: Formula
    wrong: Formula
    operator: str
    span: Span
    convention: Convention
    steps_up: bool = False

    @property
    def key(self) -> tuple[str, str, str, Span]:
        """What tells it from every other: file, quantity, formula, and the place in it."""
        return (self.quantity.file, self.quantity.id, self.right.text, self.span)


def mutants(node: Node) -> Iterator[Mutant]:
    """Yield a tree with each of its operators flipped; an exponent grows by one."""
    if isinstance(node, Operation) and node.operator in FLIPPED:
        flipped = dataclasses.replace(node, operator=FLIPPED[node.operator])
        yield Mutant(node.operator, flipped, node.span)
    if isinstance(node, Operation) and node.operator == "**":
        more = Operation("+", node.right, Number(1.0, "1"))
        yield Mutant("**", dataclasses.replace(node, right=more), node.span)
    below = children(node)
    for place, child in enumerate(below):
        for one in mutants(child):
            changed = (*below[:place], one.tree, *below[place + 1 :])
            yield Mutant(one.operator, _with_children(node, changed), one.span)


def _with_children(node: Node, below: tuple[Node, ...]) -> Node:
    """Put other nodes below a node."""
    match node:
        case Operation(operator):
            return dataclasses.replace(node, left=below[0], right=below[1], operator=operator)
        case Negation():
            return dataclasses.replace(node, operand=below[0])
        case Call():
            return dataclasses.replace(node, arguments=below)
        case _:
            return node


def flipped_formulas(plan: Plan) -> Iterator[FlippedFormula]:
    """Yield every flipped operator of every reference formula of a plan.

    Of a verdict, and of what a choice steps up by, only the comparisons: what is compared seldom
    decides it.
    """
    for one in plan.answered:
        for formula, steps_up in _deciding(one, plan):
            for mutant in mutants(formula.tree):
                compares = one.kind is Kind.VERDICT or steps_up
                if compares and mutant.operator not in _CONDITIONS:
                    continue
                wrong = dataclasses.replace(formula, tree=mutant.tree)
                place = (mutant.operator, mutant.span)
                yield FlippedFormula(one, formula, wrong, *place, plan.convention, steps_up)


def _deciding(one: Quantity, plan: Plan) -> Iterator[tuple[Formula, bool]]:
    """Yield the formulas that decide a value, and whether each is one that a choice steps up by."""
    formula = plan.reference_formula(one.id)
    if formula is not None:
        yield formula, False
    condition = None if one.choice is None else one.choice.condition
    if condition is not None and reference_steps_up(one, plan.convention):
        yield condition, True


def is_formula_of(flipped: FlippedFormula, plan: Plan) -> bool:
    """Tell whether a plan computes with the very formula before it was flipped."""
    one = plan.quantities.get(flipped.quantity.id)
    if one is None or one.file != flipped.quantity.file:
        return False
    return (flipped.right, flipped.steps_up) in _deciding(one, plan)


def with_formula(plan: Plan, flipped: FlippedFormula) -> Plan:
    """Return a plan in which a quantity has the flipped formula."""
    one = plan.quantities[flipped.quantity.id]
    if flipped.steps_up and one.choice is not None:
        choice = dataclasses.replace(one.choice, condition=flipped.wrong)
        changed = dataclasses.replace(one, choice=choice)
        return dataclasses.replace(plan, quantities={**plan.quantities, one.id: changed})
    printed = one.as_printed
    if plan.convention is Convention.AS_PRINTED:
        printed = tuple(dataclasses.replace(p, formula=None) for p in printed)
    changed = dataclasses.replace(one, formula=flipped.wrong, as_printed=printed)
    return dataclasses.replace(plan, quantities={**plan.quantities, one.id: changed})


def noticed_by(
    calculation: PrintedCalculation, flipped: Sequence[FlippedFormula]
) -> tuple[bool, ...]:
    """Tell which flipped operators some printed number of a calculation shows."""
    plan = calculation.plan
    values = evaluate(plan, to_si(plan, calculation.known)).values
    changed: dict[str, list[float]] = {}
    for one in flipped:
        flipped_plan = with_formula(plan, one)
        result = compute(flipped_plan, flipped_plan.quantities[one.quantity.id], values)
        changed.setdefault(one.quantity.id, []).append(float(np.asarray(result)))
    found = {name: iter(flags) for name, flags in broken_by(calculation, changed).items()}
    return tuple(next(found[one.quantity.id]) for one in flipped)


def is_measurable(flipped: FlippedFormula, plan: Plan, columns: Columns) -> bool:
    """Tell whether a flipped formula still measures what its quantity does."""
    known = {name: dimension(plan.quantities[name].unit) for name in flipped.wrong.names}
    compares = flipped.quantity.kind is Kind.VERDICT or flipped.steps_up
    unit = "" if compares else flipped.quantity.unit
    try:
        check_dimension(flipped.wrong, unit, known, columns)
    except FormulaFault:
        return False
    return True


def column_dimensions(course: Course) -> Columns:
    """Return what every catalogue column measures, as formulas are checked with it."""
    return {
        f"{catalogue.id}.{name}": (
            dimension(next(iter(catalogue.units.values()))),
            dimension(unit),
        )
        for catalogue in course.catalogues.values()
        for name, unit in catalogue.units.items()
    }
