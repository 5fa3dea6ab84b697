"""A wrong sign in a formula does not go unnoticed: every operator is flipped, one at a time."""

from itertools import product
from typing import TYPE_CHECKING

import numpy as np
import pytest
from numpy.typing import NDArray

from gripcourse.course.model import Course
from gripcourse.course.quantity import Convention
from gripcourse.formula.evaluate import evaluate
from gripcourse.formula.parse import parse
from gripcourse.policy.bands import bands
from gripcourse.policy.model import Policy
from gripcourse.proofs.model import Verdict
from gripcourse.proofs.operators import FlippedFormula, flipped_formulas, mutants
from gripcourse.proofs.prove import Subject
from gripcourse.proofs.samples import Trial
from gripcourse.proofs.survivors import ProofGround, prove_operators
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.sizes import choose
from gripcourse.solver.solve import Values
from support.each import named_if_it_fails

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from conftest import Composition, Reference

    Key = tuple[str, tuple[tuple[str, str], ...]]

FEW = 3  # sets of reference numbers: too few to show what a size or a verdict does
STUDENTS = 60  # for each set of reference numbers
# Flips that change no number, and why.
EQUIVALENT = {
    "jaw_chord: +": "as printed, by E3, the band of contact is too narrow to count",
    "jaw_chord: *": "as printed, by E3, the band of contact is too narrow to count",
    "flange_ok: <=": "what bears the bending bears the torque in drawn variants; a case shows it",
    "load_lift: *": "a share of 1 in the table of motions: times it and divided by it are the same",
    "load_extend: *": "a share of 1 in the table of motions, as above",
    "load_turn: *": "a share of 1 in the table of motions, as above",
}
Array = NDArray[np.float64]


def test_a_flipped_operator_breaks_what_is_printed_of_its_quantity(
    subject: Subject, trials: dict[str, tuple[Trial, ...]]
) -> None:
    every = tuple(one for own in trials.values() for one in own)
    ground = ProofGround(subject.source, subject.calculations, subject.declared, every)
    results = tuple(prove_operators(ground))
    assert [one.problems for one in results if one.verdict is Verdict.FAILS] == []
    assert sum(one.compared for one in results) > 1000


def test_a_flipped_operator_changes_an_answer(
    course: Course,
    composition_keys: "tuple[Key, ...]",
    composed: "Callable[..., Composition]",
    policy: Policy,
    subtests: pytest.Subtests,
) -> None:
    """Also one of a printed version; what schemes and versions share is looked at once."""
    looked_at: set[object] = set()
    for convention, key in product(Convention, composition_keys):
        with named_if_it_fails(subtests, convention=convention, composition=key):
            scheme, options = key
            flips = flipped_formulas(make_plan(course, scheme, dict(options), convention))
            if {one.key for one in flips} <= looked_at:
                continue
            composition = composed(key, convention)
            assert unseen(composition, policy, looked_at) - EQUIVALENT.keys() == set()


def unseen(composition: "Composition", policy: Policy, looked_at: set[object]) -> set[str]:
    """Name flips that change their quantity by no more than the band in any set of numbers."""
    plan = composition.plan
    new = [one for one in flipped_formulas(plan) if one.key not in looked_at]
    values = students(plan, composition.references)
    hidden = set()
    for one in new:
        few = len(composition.references) < FEW and one.quantity.exact
        if few or is_seen(plan, one, values, policy):
            looked_at.add(one.key)
        else:
            hidden.add(f"{one.quantity.id}: {one.operator}")
    return hidden


def is_seen(plan: Plan, flipped: FlippedFormula, values: Values, policy: Policy) -> bool:
    one = flipped.quantity
    right, wrong = (
        evaluate(formula, one.unit, values, plan.columns)
        for formula in (flipped.right, flipped.wrong)
    )
    right, wrong = (choose(plan, one, side, values) for side in (right, wrong))
    near = np.abs(wrong - right) <= bands(one, right, policy) * (1 + 1e-9)
    return bool((np.isfinite(right) & ~near).any())


def students(plan: Plan, references: "Sequence[Reference]") -> Values:
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


def test_every_operator_is_flipped_once() -> None:
    found = [
        (one.operator, one.tree) for one in mutants(parse("sqrt(a*b**2) + max(c, -(d - e)/f)"))
    ]
    assert [operator for operator, _ in found] == ["+", "*", "**", "/", "-"]
    assert found[3][1] == parse("sqrt(a*b**2) + max(c, -(d - e)*f)")
