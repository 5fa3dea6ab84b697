"""Trying mechanisms with drawn variants: what the course computes against the reactions."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gripcourse.errors import Problem
from gripcourse.formula.evaluate import evaluate as evaluate_formula
from gripcourse.formula.tree import Formula
from gripcourse.proofs.equilibrium.check import schemes_of
from gripcourse.proofs.equilibrium.model import Claim, Condition, Joint, Mechanism, names_used
from gripcourse.proofs.equilibrium.places import placed
from gripcourse.proofs.equilibrium.statics import solve
from gripcourse.proofs.model import Proof, ProofKind, ProofResult, Verdict, concluded
from gripcourse.proofs.samples import SampleSource, Trial, trials_with
from gripcourse.text.words import Message, message

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
    mechanism: Mechanism, source: SampleSource, scheme: str | None
) -> ProofResult:
    """Try a mechanism with drawn variants of the schemes that it is about."""
    proof, compared = proof_of(mechanism), 0
    problems: list[Problem] = []
    done: dict[tuple[object, ...], dict[str, Solved]] = {}
    for judged in (*mechanism.claims, *mechanism.conditions):
        for trial in _trials(mechanism, judged, source, scheme):
            key = _key(trial)
            if key not in done:
                done[key] = solved_of(mechanism, trial)
                problems += _unsolved(mechanism, trial, done[key])
                problems += _pressing(mechanism, trial, done[key])
            compared += len(trial.variants)
            problems += _judge(mechanism, judged, trial, done[key])
    if not compared:
        note = message("There is neither a worked example nor a range to draw such variants from.")
        return ProofResult(proof, Verdict.OPEN, 0, (), note)
    return concluded(proof, compared, tuple(problems))


def _key(trial: Trial) -> tuple[object, ...]:
    plan = trial.plan
    variants = (one.id for one in trial.variants)
    return (plan.scheme.id, *sorted(plan.options.items()), *variants)


def _trials(
    mechanism: Mechanism, judged: Claim | Condition, source: SampleSource, scheme: str | None
) -> Iterator[Trial]:
    names = names_used(mechanism, judged)
    for candidate in schemes_of(source.course, mechanism):
        if scheme in {None, candidate.id}:
            yield from trials_with(source, candidate, mechanism.options, names, _MOST_CASES)


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


def _judge(
    mechanism: Mechanism,
    judged: Claim | Condition,
    trial: Trial,
    solved: Mapping[str, Solved],
) -> Iterator[Problem]:
    if isinstance(judged, Condition):
        for name, one in solved.items():
            if judged.at in {"", name}:
                met = evaluate_formula(judged.that, "", one.known, trial.plan.columns)
                yield from _unmet(mechanism, f"{judged.key}.that", trial, name, met != 1)
        return
    for name, declared, actual, agrees in compare(judged, trial, solved):
        wrong = np.flatnonzero(~agrees)
        if len(wrong):
            with np.errstate(all="ignore"):
                ratio = actual[wrong] / declared[wrong]
            first = int(wrong[0])
            what = message(
                "{quantity} is not in equilibrium{where} in {wrong} of {count} sets of numbers of"
                " {scheme} ({options}): bodies give {low} to {high} times as much, for"
                " example in {variant} {actual} instead of {declared}, in SI.",
                quantity=judged.quantity.text,
                low=_figures(np.nanmin(ratio)),
                high=_figures(np.nanmax(ratio)),
                actual=_figures(actual[first]),
                declared=_figures(declared[first]),
                **_place(trial, name, wrong),
            )
            yield Problem(mechanism.file, f"{judged.key}.quantity", what, _REMEDY)


_REMEDY: Final = message("Correct the formula of the quantity, or the declared mechanism.")


def _figures(value: float) -> float:
    return float(f"{value:.5g}")


def _place(trial: Trial, position: str, wrong: NDArray[np.intp]) -> dict[str, object]:
    where = message(" ({position})", position=position) if position else message("")
    return {
        "where": where,
        "wrong": len(wrong),
        "count": len(trial.variants),
        "scheme": trial.plan.scheme.id,
        "options": ", ".join(f"{name}={choice}" for name, choice in trial.plan.options.items()),
        "variant": trial.variants[int(wrong[0])].id,
    }


def _unmet(
    mechanism: Mechanism, key: str, trial: Trial, position: str, wrong: NDArray[np.bool_]
) -> Iterator[Problem]:
    if wrong.any():
        what = message(
            "It does not hold{where} in {wrong} of {count} sets of numbers of {scheme}"
            " ({options}), for example in {variant}.",
            **_place(trial, position, np.flatnonzero(wrong)),
        )
        yield Problem(mechanism.file, key, what, _REMEDY)


def _unsolved(
    mechanism: Mechanism, trial: Trial, solved: Mapping[str, Solved]
) -> Iterator[Problem]:
    for name, one in solved.items():
        if not one.is_solved.all():
            what: Message = message(
                "Equilibrium has no single solution{where} in {wrong} of {count} sets of numbers"
                " of {scheme} ({options}), for example in {variant}; open are: {open}.",
                open=", ".join(sorted(one.loose)) or "—",
                **_place(trial, name, np.flatnonzero(~one.is_solved)),
            )
            remedy = message("Look for points without a place, and for joints that do not hold.")
            yield Problem(mechanism.file, "joint", what, remedy)


def _pressing(
    mechanism: Mechanism, trial: Trial, solved: Mapping[str, Solved]
) -> Iterator[Problem]:
    """A contact presses, and friction that is found does not exceed what it can be."""
    contacts = [one for one in mechanism.joints if one.kind == "contact"]
    for name, one in solved.items():
        for joint in contacts:
            normal = one.known[f"{joint.id}_normal"]
            wrong = normal < -_EXACT * one.size
            wrong |= _slips(joint, trial, one)
            yield from _unmet(mechanism, f"joint.{joint.id}", trial, name, wrong)


def _slips(joint: Joint, trial: Trial, one: Solved) -> NDArray[np.bool_]:
    if not joint.is_rough:
        return np.zeros(len(trial.variants), dtype=np.bool_)
    friction: Formula = joint.formulas["friction"]
    limit = evaluate_formula(friction, "", one.known, trial.plan.columns)
    tangent, normal = one.known[f"{joint.id}_tangent"], one.known[f"{joint.id}_normal"]
    return np.asarray(np.abs(tangent) > limit * np.abs(normal) * (1 + _EXACT) + _NOTHING * one.size)
