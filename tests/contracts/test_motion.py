"""Force ratios, forces and paths follow from how the links move and from equilibrium.

What is not the motion of a scheme itself is declared in `variants/proofs.toml`.
"""

from gripcourse.course.model import Course, Scheme
from gripcourse.proofs.declared import DeclaredProof
from gripcourse.proofs.declared_trials import prove_declared
from gripcourse.proofs.kinematics import names_of, prove_motion, prove_ratios
from gripcourse.proofs.model import Verdict
from gripcourse.proofs.prove import Subject
from gripcourse.proofs.samples import Trial
from gripcourse.solver.plan import Plan
from gripcourse.text.units import factor

STILL = {"vacuum_cups", "electromagnet"}  # nothing moves in them


def of_other_motion(scheme: Scheme, trials: tuple[Trial, ...]) -> tuple[Trial, ...]:
    """Return those trials in which something is computed by another formula that the links need.

    Whether a gripper stands on a flange or hangs on a bayonet, its links move the same way.
    """
    if scheme.kinematics is None:
        return trials
    read = names_of(scheme.kinematics)
    found = {needed(trial.plan, read): trial for trial in reversed(trials)}
    return tuple(found.values())


def needed(plan: Plan, wanted: frozenset[str]) -> frozenset[tuple[str, str]]:
    """Name what these quantities are computed from, with the formula of each."""
    left, seen = [name for name in wanted if name in plan.quantities], set[str]()
    while left:
        name = left.pop()
        seen.add(name)
        left += [one for one in plan.inputs[name] if one not in seen]
    formulas = ((name, plan.reference_formula(name)) for name in seen)
    return frozenset((name, "" if one is None else one.text) for name, one in formulas)


def test_the_force_ratio_is_the_virtual_work_of_the_links(
    course: Course, scheme_id: str, trials: dict[str, tuple[Trial, ...]]
) -> None:
    scheme = course.schemes[scheme_id]
    results = tuple(prove_ratios(scheme, of_other_motion(scheme, trials[scheme_id])))
    assert bool(results) is (scheme_id not in STILL)
    assert [problem for one in results for problem in one.problems] == []


def test_positions_follow_each_other_and_joints_have_a_place(
    course: Course, scheme_id: str, trials: dict[str, tuple[Trial, ...]]
) -> None:
    result = prove_motion(course.schemes[scheme_id], trials[scheme_id])
    assert result.problems == ()
    assert result.verdict is (Verdict.OPEN if scheme_id in STILL else Verdict.HOLDS)


def test_what_the_course_declares_holds(declared_proof: DeclaredProof, subject: Subject) -> None:
    result = prove_declared(declared_proof, subject.source, None)
    assert result.problems == ()
    assert result.verdict is Verdict.HOLDS


def test_what_does_not_move_is_known(course: Course) -> None:
    assert {one.id for one in course.schemes.values() if one.kinematics is None} == STILL
    assert all(
        factor(one.kinematics.unit) > 0
        for one in course.schemes.values()
        if one.kinematics is not None
    )
