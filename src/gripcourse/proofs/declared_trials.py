"""Trying what a course declares: identities, inequalities, virtual work, paths."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gripcourse.errors import Problem
from gripcourse.formula.evaluate import evaluate as evaluate_formula
from gripcourse.formula.tree import Formula
from gripcourse.proofs.check_declared import schemes_of
from gripcourse.proofs.declared import (
    DeclaredProof,
    IdentityProof,
    Inequality,
    Travel,
    VirtualWork,
    names_used,
)
from gripcourse.proofs.model import Proof, ProofKind, ProofResult, Verdict, concluded
from gripcourse.proofs.samples import SampleSource, Trial, trials_with
from gripcourse.proofs.tried import in_sets
from gripcourse.solver.motion import coordinates, drive_at
from gripcourse.solver.plan import Plan
from gripcourse.solver.solve import Values, evaluate, to_si
from gripcourse.text.units import factor
from gripcourse.text.words import message

Array = NDArray[np.float64]

_KINDS = {
    IdentityProof: ProofKind.IDENTITY,
    Inequality: ProofKind.INEQUALITY,
    VirtualWork: ProofKind.VIRTUAL_WORK,
    Travel: ProofKind.TRAVEL,
}


def proof_of(one: DeclaredProof) -> Proof:
    """Return the head of a declared proof."""
    return Proof(_KINDS[type(one)], one.scope.id, one.scope.file, one.scope.key)


def trials_for(one: DeclaredProof, source: SampleSource, scheme: str | None) -> Iterator[Trial]:
    """Yield the numbers that a declared proof is tried with; only of one scheme, if it is named."""
    for candidate in schemes_of(source.course, one):
        if scheme in {None, candidate.id}:
            yield from trials_with(source, candidate, one.scope.options, names_used(one))


def prove_declared(one: DeclaredProof, source: SampleSource, scheme: str | None) -> ProofResult:
    """Try a declared proof with drawn variants of the schemes that it is about."""
    proof, compared = proof_of(one), 0
    problems: list[Problem] = []
    for trial in trials_for(one, source, scheme):
        sides = compare(one, trial, trial.plan)
        compared += len(trial.variants)
        problems += _faults(one, trial, sides)
    if not compared:
        said = message("There is neither a worked example nor a range to draw such variants from.")
        return ProofResult(proof, Verdict.OPEN, 0, (), said)
    return concluded(proof, compared, tuple(problems))


def compare(one: DeclaredProof, trial: Trial, plan: Plan) -> tuple[Array, Array, NDArray[np.bool_]]:
    """Compute both sides of a proof for each set of numbers.

    Args:
        one: the proof.
        trial: the numbers.
        plan: of the trial, or one with other formulas.

    Returns:
        Left and right in SI (of an inequality 1 where it holds, and 1), and where they agree.
    """
    count = len(trial.variants)
    set_: dict[str, ArrayLike] = {
        name: np.full(count, value) for name, value in to_si(plan, one.scope.settings).items()
    }
    values = (
        trial.values
        if plan is trial.plan and not set_
        else evaluate(plan, {**trial.known, **set_}).values
    )
    with np.errstate(all="ignore"):
        left, right, tolerance = _sides(one, plan, values)
        left, right = np.broadcast_to(left, count), np.broadcast_to(right, count)
        size = np.maximum(np.abs(left), np.abs(right))
        holds = np.abs(left - right) <= tolerance * size + np.finfo(np.float64).tiny
    return left, right, holds


def _sides(one: DeclaredProof, plan: Plan, values: Values) -> tuple[Array, Array, float]:
    match one:
        case IdentityProof(_, left, right, tolerance):
            known = with_lets(one, plan, values)
            return _value(left, plan, known), _value(right, plan, known), tolerance
        case Inequality(_, condition):
            met = _value(condition, plan, with_lets(one, plan, values))
            return met, np.ones_like(met), 0.0
        case VirtualWork():
            at = _value(one.at, plan, values)
            known = with_lets(one, plan, {**values, one.parameter: at})
            return _value(one.ratio, plan, known), _work(one, plan, values, at), one.tolerance
        case Travel():
            declared = _value(one.quantity, plan, with_lets(one, plan, values))
            return declared, _travelled(one, plan, values), one.tolerance


def with_lets(one: DeclaredProof, plan: Plan, values: Values) -> Values:
    """Add the names that a proof lets stand for parts of its formulas."""
    known = dict(values)
    for name, formula in one.scope.lets.items():
        known[name] = _value(formula, plan, known)
    return known


def _work(one: VirtualWork, plan: Plan, values: Values, at: Array) -> Array:
    """Return the derivative of the output by the input: a central difference of fourth order."""
    step = one.step * factor(one.unit)

    def paths(times: int) -> tuple[Array, Array]:
        known = with_lets(one, plan, {**values, one.parameter: at + times * step})
        return _value(one.input, plan, known), _value(one.output, plan, known)

    near = [after - before for after, before in zip(paths(1), paths(-1), strict=True)]
    far = [after - before for after, before in zip(paths(2), paths(-2), strict=True)]
    moved_in, moved_out = (8 * close - wide for close, wide in zip(near, far, strict=True))
    return np.asarray(moved_out / moved_in)


def _travelled(one: Travel, plan: Plan, values: Values) -> Array:
    motion = plan.scheme.kinematics
    if motion is None:
        return np.asarray(np.nan)
    ends = (drive_at(motion, values, position) for position in (one.start, one.end))
    start, end = (coordinates(motion, values, drive)[one.coordinate] for drive in ends)
    return np.asarray(start - end)


def _value(formula: Formula, plan: Plan, values: Values) -> Array:
    return evaluate_formula(formula, "", values, plan.columns)


def _faults(
    one: DeclaredProof, trial: Trial, sides: tuple[Array, Array, NDArray[np.bool_]]
) -> Iterator[Problem]:
    """Yield one problem for all variants of a composition that do not satisfy a proof."""
    left, right, holds = sides
    wrong = np.flatnonzero(~holds)
    if not len(wrong):
        return
    first = int(wrong[0])
    where = {
        "where": trial.name,
        "variant": trial.variants[first].id,
        "tried": in_sets(len(wrong), len(holds)),
    }
    if isinstance(one, Inequality):
        what = message(
            "It does not hold {tried} ({where}), for example in {variant}.",
            **where,
        )
    else:
        what = message(
            "The sides differ {tried} ({where}), for example in {variant}: {left}"
            " and {right}, in SI.",
            **where,
            left=float(left[first]),
            right=float(right[first]),
        )
    yield Problem(
        one.scope.file,
        one.scope.key,
        what,
        message("Correct the formulas that it is about, or the proof '{id}'.", id=one.scope.id),
    )
