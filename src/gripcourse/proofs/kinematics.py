"""What the declared motion of a scheme proves: its force ratios, its positions, its joints.

The closed form of a force ratio is compared with a numerical derivative of the declared position of
the output: the two share nothing but the geometry.
"""

from collections.abc import Iterator, Mapping

import numpy as np
from numpy.typing import NDArray

from gripcourse.course.kinematics import Direction, Kinematics
from gripcourse.course.model import Scheme
from gripcourse.errors import Problem
from gripcourse.proofs.model import Proof, ProofKind, ProofResult, Verdict, concluded
from gripcourse.proofs.samples import Trial
from gripcourse.proofs.tried import in_sets
from gripcourse.solver.motion import coordinates, declared_ratio, drive_at, work_ratio
from gripcourse.solver.plan import Plan
from gripcourse.solver.solve import Values, evaluate, to_si
from gripcourse.text.words import Message, message

Array = NDArray[np.float64]

_PLACES = 5  # of the drive between the first and the last position that has a ratio
_STEPS = 25  # of the drive over its whole path
_STEP = 1e-3  # of the path between those positions, for the derivative
_DERIVED, _SAME = 1e-6, 1e-9
_NOTHING_MOVES = message("Nothing moves in this scheme.")


def prove_ratios(scheme: Scheme, trials: tuple[Trial, ...]) -> Iterator[ProofResult]:
    """Compare each declared force ratio of a scheme with the virtual work of its links."""
    motion = scheme.kinematics
    if motion is None:
        return
    for position in motion.ratio:
        key = f"kinematics.ratio.{position}"
        proof = Proof(ProofKind.VIRTUAL_WORK, f"{scheme.id}, {position}", motion.file, key)
        problems = []
        for trial in trials:
            wrong = ratio_differs(trial, trial.plan, motion, position)
            if wrong.any():
                what = message(
                    "{quantity} is not the virtual work of the links {tried} ({where}), for"
                    " example in {variant}.",
                    quantity=motion.ratio[position],
                    **_where(trial, wrong),
                )
                problems.append(_problem(proof, what))
        yield concluded(proof, sum(len(one.variants) for one in trials), tuple(problems))


def names_of(motion: Kinematics) -> frozenset[str]:
    """Return the quantities that a declared motion reads, and those that it is compared with."""
    formulas = (
        motion.outputs,
        *motion.at.values(),
        *(one.formula for one in motion.coordinates),
    )
    named = {name for formula in formulas for name in formula.names}
    states = (name for state in motion.state.values() for name in state)
    own = {motion.drive, *(one.id for one in motion.coordinates)}
    return frozenset({*(named - own), *motion.ratio.values(), *states})


def ratio_differs(trial: Trial, plan: Plan, motion: Kinematics, position: str) -> NDArray[np.bool_]:
    """Tell for which sets of numbers a force ratio is not the virtual work of the links.

    Args:
        trial: the numbers.
        plan: of the trial, or one with other formulas.
        motion: of the scheme.
        position: whose ratio.
    """
    known = _lossless(trial, plan, motion)
    places = _places(motion, evaluate(plan, known).values, len(trial.variants))
    step = _STEP * np.abs(places[-1] - places[0])
    wrong = np.zeros(len(trial.variants), dtype=np.bool_)
    for drive in places:
        declared = declared_ratio(plan, motion, known, position, drive)
        worked = work_ratio(plan, motion, known, position, drive, step)
        wrong |= ~np.isclose(declared, worked, rtol=_DERIVED, atol=0)
    return wrong


def prove_motion(scheme: Scheme, trials: tuple[Trial, ...]) -> ProofResult:
    """Compare what describes the positions with the coordinates there; the output moves one way."""
    motion = scheme.kinematics
    proof = Proof(
        ProofKind.MOTION, scheme.id, scheme.file if motion is None else motion.file, "kinematics"
    )
    if motion is None:
        return ProofResult(proof, Verdict.OPEN, 0, (), _NOTHING_MOVES)
    problems = []
    for trial in trials:
        values = trial.values
        for key, wrong, what in (
            *_state_faults(motion, values),
            *_order_faults(motion, values),
            *_joint_faults(motion, values),
        ):
            if wrong.any():
                said = message(
                    "{what} So it is {tried} ({where}), for example in {variant}.",
                    what=what,
                    **_where(trial, wrong),
                )
                problems.append(Problem(proof.file, f"kinematics.{key}", said, _REMEDY))
    return concluded(proof, sum(len(one.variants) for one in trials), tuple(problems))


def state_differs(trial: Trial, plan: Plan, motion: Kinematics) -> bool:
    """Tell whether another plan breaks what is declared of positions, their order and joints."""
    values = {
        name: np.broadcast_to(value, len(trial.variants))
        for name, value in evaluate(plan, trial.known).values.items()
    }
    return any(
        bool(wrong.any())
        for _, wrong, _ in (
            *_state_faults(motion, values),
            *_order_faults(motion, values),
            *_joint_faults(motion, values),
        )
    )


_REMEDY = message("Compare the declared motion with the formulas of the scheme.")


def _problem(proof: Proof, what: Message) -> Problem:
    return Problem(proof.file, proof.key, what, _REMEDY)


def _where(trial: Trial, wrong: NDArray[np.bool_]) -> dict[str, object]:
    return {
        "tried": in_sets(int(wrong.sum()), len(wrong)),
        "where": trial.name,
        "variant": trial.variants[int(np.flatnonzero(wrong)[0])].id,
    }


def _lossless(trial: Trial, plan: Plan, motion: Kinematics) -> dict[str, Array]:
    """Return what is known, without friction where the scheme says so."""
    lossless = to_si(plan, motion.lossless)
    count = len(trial.variants)
    return {**trial.known, **{name: np.full(count, value) for name, value in lossless.items()}}


def _places(motion: Kinematics, values: Values, count: int) -> Array:
    """Return places of the drive between the positions that have a ratio, shape (places, n)."""
    positions = list(motion.ratio) if len(motion.ratio) > 1 else list(motion.at)
    ends = [drive_at(motion, values, one) for one in (positions[0], positions[-1])]
    first, last = (np.broadcast_to(end, count) for end in ends)
    return np.linspace(first, last, _PLACES)


def _state_faults(
    motion: Kinematics, values: Values
) -> Iterator[tuple[str, NDArray[np.bool_], Message]]:
    """What is declared for a position must be the coordinate there."""
    for position, state in motion.state.items():
        where = coordinates(motion, values, drive_at(motion, values, position))
        for quantity, coordinate in state.items():
            if not quantity.endswith(f"_{position}"):  # the others are set for the ratio alone
                continue
            same = np.isclose(where[coordinate], values[quantity], rtol=_SAME, atol=_SAME)
            what = message(
                "{quantity} is not the coordinate {coordinate}.",
                quantity=quantity,
                coordinate=coordinate,
            )
            yield f"state.{position}.{quantity}", ~same, what


def _order_faults(
    motion: Kinematics, values: Values
) -> Iterator[tuple[str, NDArray[np.bool_], Message]]:
    """Positions follow each other, and the output moves one way between first and last."""
    stops = _stops(motion, values)
    wrong = (np.diff(stops, axis=0) < 0).any(axis=0) | ~(stops[-1] > stops[0])
    yield "at", np.asarray(wrong), message("The drive goes back between its positions.")
    path = np.linspace(stops[0], stops[-1], 2 * _STEPS)
    if not motion.output:
        return
    output = coordinates(motion, values, path)[motion.output]
    falls = motion.direction is Direction.FALLS
    wrong = np.asarray(~((np.diff(output, axis=0) < 0) == falls).all(axis=0))
    what = (
        message("{coordinate} does not fall all the way.", coordinate=motion.output)
        if falls
        else message("{coordinate} does not grow all the way.", coordinate=motion.output)
    )
    yield "output", wrong, what


def _joint_faults(
    motion: Kinematics, values: Values
) -> Iterator[tuple[str, NDArray[np.bool_], Message]]:
    """Every joint has a place wherever the drive stands."""
    stops = _stops(motion, values)
    path = np.linspace(stops[0], stops[-1], _STEPS)
    where = coordinates(motion, values, path)
    for point, pair in motion.points.items():
        wrong = np.zeros(stops.shape[1], dtype=np.bool_)
        for name in pair:
            wrong |= ~np.isfinite(np.broadcast_to(where[name], path.shape)).all(axis=0)
        yield f"point.{point}", wrong, message("The joint {point} has no place.", point=point)


def _stops(motion: Kinematics, values: Mapping[str, Array]) -> Array:
    """Return where the drive stands at each position, in order, shape (positions, n)."""
    count = max(np.size(one) for one in values.values())
    return np.array([np.broadcast_to(drive_at(motion, values, one), count) for one in motion.at])
