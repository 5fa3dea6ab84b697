"""Which flipped operators nothing notices: no printed number, no proof, no rule."""

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from gripcourse.course.quantity import Convention, Kind
from gripcourse.errors import Problem
from gripcourse.formula.parse import caret
from gripcourse.proofs.calculations import PrintedCalculation
from gripcourse.proofs.declared import DeclaredProof, DeclaredProofs, Unshown, names_used
from gripcourse.proofs.declared_trials import compare, trials_for
from gripcourse.proofs.kinematics import names_of, ratio_differs, state_differs
from gripcourse.proofs.model import Proof, ProofKind, ProofResult, Verdict, short_name
from gripcourse.proofs.operators import (
    Columns,
    FlippedFormula,
    Noticed,
    column_dimensions,
    flipped_formulas,
    is_formula_of,
    is_measurable,
    noticed_by,
    with_formula,
)
from gripcourse.proofs.samples import SampleSource, Trial
from gripcourse.solver.plan import Plan
from gripcourse.text.units import factor
from gripcourse.text.words import message
from gripcourse.variants.feasible import reasons_infeasible

Key = tuple[str, str, str, tuple[int, int]]
_TRIED = 2  # compositions with which motion and rules are tried for one flipped operator
_TRIED_BY_PROOF = 6  # and each declared proof


@dataclass(frozen=True, slots=True)
class ProofGround:
    """What flipped operators are looked for with.

    Attributes:
        source: of numbers.
        calculations: with printed results, of the whole course.
        declared: proofs, and operators that nothing can show.
        trials: numbers of the schemes in question.
    """

    source: SampleSource
    calculations: Sequence[PrintedCalculation]
    declared: DeclaredProofs
    trials: Sequence[Trial]


@dataclass(frozen=True, slots=True)
class Flipped:
    """A flipped operator, a plan that has it, and what noticed it."""

    formula: FlippedFormula
    plan: Plan
    noticed: Noticed


def prove_operators(ground: ProofGround) -> Iterator[ProofResult]:
    """Flip every operator of every formula, and tell what nothing notices.

    Returns:
        A result for each file that declares formulas. It fails where a printed number of a
        quantity stays the same; where nothing printed depends on a formula, it is open.
    """
    found = survey(ground)
    printed = {
        (one.plan.quantities[name].file, name)
        for one in ground.calculations
        for name in one.expected
    }
    by_file: dict[str, list[Flipped]] = {}
    for one in found.values():
        by_file.setdefault(one.formula.quantity.file, []).append(one)
    for file, flipped in by_file.items():
        proof = Proof(ProofKind.OPERATORS, short_name(file), file, "")
        left = [one for one in flipped if one.noticed is Noticed.NOTHING]
        is_printed = [
            (one.formula.quantity.file, one.formula.quantity.id) in printed for one in left
        ]
        verdict = Verdict.HOLDS
        if left:
            verdict = Verdict.FAILS if any(is_printed) else Verdict.OPEN
        counted = Counter(one.noticed for one in flipped)
        note = message(
            "Noticed by printed numbers {numbers}, proofs {proofs}, dimensions {dimensions}, rules"
            " for variants {refused}; by nothing {nothing}.",
            numbers=counted[Noticed.PRINTED_NUMBER],
            proofs=counted[Noticed.PROOF],
            dimensions=counted[Noticed.DIMENSION],
            refused=counted[Noticed.REFUSED],
            nothing=counted[Noticed.NOTHING],
        )
        problems = tuple(
            _problem(one, is_of_number=of_number)
            for one, of_number in zip(left, is_printed, strict=True)
        )
        yield ProofResult(proof, verdict, len(flipped), problems, note)


def survey(ground: ProofGround) -> dict[Key, Flipped]:
    """Flip every operator once, and find what notices it."""
    found = _by_numbers(ground)
    for trial in ground.trials:
        for one in flipped_formulas(trial.plan):
            found.setdefault(one.key, Flipped(one, trial.plan, Noticed.NOTHING))
    columns = column_dimensions(ground.source.course)
    proofs = [(one, tuple(trials_for(one, ground.source, None))) for one in ground.declared.proofs]
    for key, left in found.items():
        if left.noticed is Noticed.NOTHING:
            noticed = _noticed(left, ground, columns, proofs)
            found[key] = Flipped(left.formula, left.plan, noticed)
    return found


def _by_numbers(ground: ProofGround) -> dict[Key, Flipped]:
    """Flip the operators of every calculation with printed results."""
    schemes = {one.plan.scheme.id for one in ground.trials}
    found: dict[Key, Flipped] = {}
    for one in ground.calculations:
        flipped = [f for f in flipped_formulas(one.plan) if f.quantity.id not in one.known]
        for formula, is_noticed in zip(flipped, noticed_by(one, flipped), strict=True):
            if is_noticed or (formula.key not in found and one.plan.scheme.id in schemes):
                noticed = Noticed.PRINTED_NUMBER if is_noticed else Noticed.NOTHING
                found[formula.key] = Flipped(formula, one.plan, noticed)
    return found


def _noticed(
    one: Flipped,
    ground: ProofGround,
    columns: Columns,
    proofs: Sequence[tuple[DeclaredProof, tuple[Trial, ...]]],
) -> Noticed:
    if not is_measurable(one.formula, one.plan, columns):
        return Noticed.DIMENSION
    # Proofs are about what is right, not about what a source prints.
    is_right = one.formula.convention is Convention.CORRECTED
    own = [trial for trial in ground.trials if is_right and is_formula_of(one.formula, trial.plan)][
        :_TRIED
    ]
    if any(_breaks_motion(trial, one.formula) for trial in own) or (
        is_right and _breaks_declared(one.formula, proofs)
    ):
        return Noticed.PROOF
    if any(_is_refused(trial, one.formula) for trial in own):
        return Noticed.REFUSED
    if any(_is_about(reason, one.formula) for reason in ground.declared.unshown):
        return Noticed.UNSHOWN
    return Noticed.NOTHING


def _is_about(reason: Unshown, formula: FlippedFormula) -> bool:
    return (reason.quantity, reason.operator) == (formula.quantity.id, formula.operator)


def _breaks_motion(trial: Trial, formula: FlippedFormula) -> bool:
    motion = trial.plan.scheme.kinematics
    if motion is None or formula.quantity.id not in _upstream(trial.plan, names_of(motion)):
        return False
    plan = with_formula(trial.plan, formula)
    return state_differs(trial, plan, motion) or any(
        bool(ratio_differs(trial, plan, motion, position).any()) for position in motion.ratio
    )


def _breaks_declared(
    formula: FlippedFormula, proofs: Sequence[tuple[DeclaredProof, tuple[Trial, ...]]]
) -> bool:
    for proof, trials in proofs:
        fitting = [
            trial
            for trial in trials
            if is_formula_of(formula, trial.plan)
            and formula.quantity.id in _upstream(trial.plan, names_used(proof))
        ]
        for trial in fitting[:_TRIED_BY_PROOF]:
            if not compare(proof, trial, with_formula(trial.plan, formula))[2].all():
                return True
    return False


def _upstream(plan: Plan, names: frozenset[str]) -> set[str]:
    """Return quantities and everything that they are computed from."""
    found = set(names)
    for name in reversed(tuple(plan.quantities)):
        if name in found:
            found.update(plan.inputs[name])
    return found


def _is_refused(trial: Trial, formula: FlippedFormula) -> bool:
    """Tell whether every variant would be refused: the tables of the course could not be read."""
    plan = with_formula(trial.plan, formula)
    count = len(trial.variants)
    given = {
        name: np.broadcast_to(value, count) / factor(plan.quantities[name].unit)
        for name, value in trial.known.items()
        if plan.quantities[name].kind in {Kind.GIVEN, Kind.CONSTANT}
    }
    return not reasons_infeasible(plan, given).feasible.any()


def _problem(one: Flipped, *, is_of_number: bool) -> Problem:
    formula = one.formula
    what = (
        message(
            "'{operator}' could be another sign: the printed numbers of {name} stay the same.",
            operator=formula.operator,
            name=formula.quantity.id,
        )
        if is_of_number
        else message(
            "'{operator}' could be another sign: no printed number and no proof depends on it.",
            operator=formula.operator,
        )
    )
    return Problem(
        formula.quantity.file,
        f"quantity.{formula.quantity.id}",
        what,
        message(
            "Add a number to a worked example, a published case or a proof; where none can show it,"
            " say why under [[unshown]] of variants/proofs.toml."
        ),
        caret(formula.right.text, formula.span),
    )
