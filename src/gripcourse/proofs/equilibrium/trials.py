"""Trying mechanisms with drawn variants: what the course computes against the reactions."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gripcourse.formula.evaluate import evaluate as evaluate_formula
from gripcourse.proofs.equilibrium.check import schemes_of
from gripcourse.proofs.equilibrium.faults import Fault, problems
from gripcourse.proofs.equilibrium.model import (
    Claim,
    Condition,
    Joint,
    Mechanism,
    judged_of,
    names_used,
)
from gripcourse.proofs.equilibrium.places import placed
from gripcourse.proofs.equilibrium.statics import solve
from gripcourse.proofs.model import Proof, ProofKind, ProofResult, Verdict, concluded
from gripcourse.proofs.samples import SampleSource, Trial, trials_with
from gripcourse.text.words import message

Array = NDArray[np.float64]

_EXACT: Final = 1e-9  # relative, of a claim
_NOTHING: Final = 1e-12  # of the largest reaction: what is left where forces cancel
_MOST_CASES: Final = 3  # combinations of options that a claim is tried with, in one scheme


@dataclass(frozen=True, slots=True)
class Solved:
    """A mechanism in one position with the numbers of a trial.

    Attributes:
        known: quantities, lets, points and reactions in SI, each of shape (n,).
        size: of the largest reaction of each variant.
        is_solved: where there is a solution.
        loose: reactions that are left open where there is none.
    """

    known: Mapping[str, Array]
    size: Array
    is_solved: NDArray[np.bool_]
    loose: frozenset[str]


def proof_of(mechanism: Mechanism) -> Proof:
    """Return the head of the proof that a mechanism is."""
    return Proof(ProofKind.EQUILIBRIUM, mechanism.id, mechanism.file, "")


def prove_equilibrium(
    mechanism: Mechanism, source: SampleSource, scheme: str | None, most: int = _MOST_CASES
) -> ProofResult:
    """Try a mechanism with drawn variants of the schemes that it is about.

    Args:
        mechanism: to try.
        source: of numbers.
        scheme: only variants of this one; None for all.
        most: how many combinations of options a claim is tried with, in one scheme.
    """
    proof, compared = proof_of(mechanism), 0
    faults: list[Fault] = []
    done: dict[tuple[object, ...], dict[str, Solved]] = {}
    for judged in judged_of(mechanism):
        for trial in _trials(mechanism, judged, source, scheme, most):
            key = _key(trial)
            if key not in done:
                done[key] = solved_of(mechanism, trial)
                faults += faults_of_solution(mechanism, trial, done[key])
            compared += len(trial.variants)
            faults += faults_of(judged, trial, done[key])
    if not compared:
        note = message("There is neither a worked example nor a range to draw such variants from.")
        return ProofResult(proof, Verdict.OPEN, 0, (), note)
    return concluded(proof, compared, tuple(problems(mechanism.file, faults)))


def _key(trial: Trial) -> tuple[object, ...]:
    plan = trial.plan
    variants = (one.id for one in trial.variants)
    return (plan.scheme.id, *sorted(plan.options.items()), *variants)


def _trials(
    mechanism: Mechanism,
    judged: Claim | Condition,
    source: SampleSource,
    scheme: str | None,
    most: int,
) -> Iterator[Trial]:
    names = names_used(mechanism, judged)
    for candidate in schemes_of(source.course, mechanism):
        if scheme in {None, candidate.id}:
            yield from trials_with(source, candidate, mechanism.options, names, most)


def solved_of(mechanism: Mechanism, trial: Trial) -> dict[str, Solved]:
    """Solve a mechanism in each of its positions."""
    found = {}
    columns, count = trial.plan.columns, len(trial.variants)
    quantities = {name: np.broadcast_to(one, count) for name, one in trial.values.items()}
    for position in mechanism.positions:
        known = {
            name: np.broadcast_to(one, count)
            for name, one in placed(mechanism, position, quantities, columns).items()
        }
        solution = solve(mechanism, known, columns)
        size = np.zeros(count)
        for name in mechanism.unknowns:
            size = np.fmax(size, np.abs(solution.reactions[name]))
        found[position] = Solved(
            {**known, **solution.reactions}, size, solution.is_solved, solution.loose
        )
    return found


def compare(
    claim: Claim, trial: Trial, solved: Mapping[str, Solved]
) -> Iterator[tuple[str, Array, Array, NDArray[np.bool_]]]:
    """Yield position, declared and true value, and where they agree; one without a position."""
    columns = trial.plan.columns
    values = {
        name: (
            evaluate_formula(claim.quantity, "", one.known, columns),
            evaluate_formula(claim.actual, "", one.known, columns),
            one.size,
        )
        for name, one in solved.items()
        if claim.at in {"", name}
    }
    if claim.largest:
        sides = zip(*values.values(), strict=True)
        declared, actual, size = (np.max(np.array(one), axis=0) for one in sides)
        values = {"": (declared, actual, size)}
    for name, (declared, actual, size) in values.items():
        scale = np.maximum(np.abs(declared), np.abs(actual))
        agrees = np.abs(declared - actual) <= _EXACT * scale + _NOTHING * size
        yield name, declared, actual, agrees


def faults_of(
    judged: Claim | Condition, trial: Trial, solved: Mapping[str, Solved]
) -> Iterator[Fault]:
    """Yield what a trial shows of a claim that is not so, or of a condition that is not met."""
    if isinstance(judged, Condition):
        for name, one in solved.items():
            if judged.at in {"", name}:
                met = evaluate_formula(judged.that, "", one.known, trial.plan.columns)
                wrong = one.is_solved & (met != 1)
                yield Fault(f"{judged.key}.that", judged.that.text, trial, name, wrong)
        return
    # Where there is no solution is told by itself.
    is_solved = np.all([one.is_solved for one in solved.values()], axis=0)
    for name, declared, actual, agrees in compare(judged, trial, solved):
        text, wrong = judged.quantity.text, is_solved & ~agrees
        yield Fault(f"{judged.key}.quantity", text, trial, name, wrong, declared, actual)


def faults_of_solution(
    mechanism: Mechanism, trial: Trial, solved: Mapping[str, Solved]
) -> Iterator[Fault]:
    """Yield where there is no solution, or a contact pulls, or slips though it should hold."""
    contacts = [one for one in mechanism.joints if one.kind == "contact"]
    for name, one in solved.items():
        loose = ", ".join(sorted(one.loose))
        yield Fault("joint", loose, trial, name, ~one.is_solved)
        for joint in contacts:
            normal = one.known[f"{joint.id}_normal"]
            wrong = (normal < -_EXACT * one.size) | _slips(joint, trial, one)
            yield Fault(f"joint.{joint.id}", joint.id, trial, name, wrong & one.is_solved)


def _slips(joint: Joint, trial: Trial, one: Solved) -> NDArray[np.bool_]:
    if not joint.is_rough:
        return np.zeros(len(trial.variants), dtype=np.bool_)
    limit = evaluate_formula(joint.formulas["friction"], "", one.known, trial.plan.columns)
    tangent, normal = one.known[f"{joint.id}_tangent"], one.known[f"{joint.id}_normal"]
    return np.asarray(np.abs(tangent) > limit * np.abs(normal) * (1 + _EXACT) + _NOTHING * one.size)
