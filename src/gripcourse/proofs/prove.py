"""Proving a course: every kind of proof, one result after the other."""

from collections.abc import Callable, Collection, Iterator
from dataclasses import dataclass
from typing import Final

from gripcourse.course.model import Course
from gripcourse.machine.office import office_command
from gripcourse.policy.model import Policy
from gripcourse.proofs.calculations import (
    PrintedCalculation,
    calculations,
    prove_calculation,
    silent_examples,
)
from gripcourse.proofs.check_declared import load_declared_proofs
from gripcourse.proofs.declared import DeclaredProofs
from gripcourse.proofs.declared_trials import proof_of, prove_declared
from gripcourse.proofs.equilibrium.check import load_mechanisms
from gripcourse.proofs.equilibrium.model import Mechanism
from gripcourse.proofs.equilibrium.trials import prove_equilibrium
from gripcourse.proofs.interference import prove_interference
from gripcourse.proofs.kinematics import prove_motion, prove_ratios
from gripcourse.proofs.model import ProofKind, ProofResult
from gripcourse.proofs.printed_lines import prove_printed_lines
from gripcourse.proofs.published_cases import load_published_cases
from gripcourse.proofs.samples import SampleSource, Trial, trials_of
from gripcourse.proofs.survivors import ProofGround, prove_operators
from gripcourse.proofs.workbooks import prove_workbooks
from gripcourse.proofs.wrong_methods import prove_wrong_methods
from gripcourse.variants.space import load_spaces

ALL_KINDS: Final = frozenset(ProofKind)
COUNT: Final = 4  # variants of each combination of options
SEED: Final = 26063


@dataclass(frozen=True, slots=True)
class Subject:
    """What is proved of a course: everything loaded, and the schemes in question.

    Attributes:
        source: of numbers.
        policy: by which answers are graded.
        declared: what the course declares.
        mechanisms: free bodies that it declares.
        calculations: with printed results, of the whole course.
        scheme: only this one; None for all.
    """

    source: SampleSource
    policy: Policy
    declared: DeclaredProofs
    mechanisms: tuple[Mechanism, ...]
    calculations: tuple[PrintedCalculation, ...]
    scheme: str | None

    @property
    def course(self) -> Course:
        """The course."""
        return self.source.course

    def trials(self) -> dict[str, tuple[Trial, ...]]:
        """Return numbers to try each scheme with."""
        return {
            one.id: tuple(trials_of(self.source, one))
            for one in self.course.schemes.values()
            if self.scheme in {None, one.id}
        }


def open_subject(
    course: Course,
    policy: Policy,
    count: int = COUNT,
    scheme: str | None = None,
    seed: int = SEED,
) -> Subject:
    """Load what a proof of a course needs.

    Args:
        course: a course without problems.
        policy: by which answers are graded.
        count: variants drawn for each combination of options.
        scheme: prove only this one.
        seed: the same seed draws the same variants.

    Raises:
        CourseError: the spaces, published cases, declared proofs or mechanisms have problems.
    """
    cases = load_published_cases(course)
    return Subject(
        source=SampleSource(course, load_spaces(course), count, seed, cases),
        policy=policy,
        declared=load_declared_proofs(course),
        mechanisms=load_mechanisms(course),
        calculations=tuple(calculations(course, cases)),
        scheme=scheme,
    )


def prove(
    course: Course,
    policy: Policy,
    *,
    kinds: Collection[ProofKind] = ALL_KINDS,
    count: int = COUNT,
    scheme: str | None = None,
) -> Iterator[ProofResult]:
    """Prove a course; each result comes as soon as it is there.

    Args:
        course: a course without problems.
        policy: by which answers are graded.
        kinds: of proofs; all of them where nothing is named.
        count: variants drawn for each combination of options.
        scheme: prove only this one.

    Raises:
        CourseError: the spaces, published cases, declared proofs or mechanisms have problems.
    """
    subject = open_subject(course, policy, count, scheme)
    yield from prove_subject(subject, kinds)


def prove_subject(
    subject: Subject, kinds: Collection[ProofKind] = ALL_KINDS
) -> Iterator[ProofResult]:
    """Prove what was loaded; see `prove`."""
    trials = subject.trials() if set(kinds) - _WITHOUT_TRIALS else {}
    for kind, step in _STEPS:
        if kind in kinds:
            yield from (one for one in step(subject, trials) if one.proof.kind in kinds)


_Trials = dict[str, tuple[Trial, ...]]


def _printed_numbers(subject: Subject, kind: ProofKind) -> Iterator[ProofResult]:
    for one in subject.calculations:
        if one.kind is kind and subject.scheme in {None, one.plan.scheme.id}:
            yield prove_calculation(one)


def _examples(subject: Subject, _trials: _Trials) -> Iterator[ProofResult]:
    yield from _printed_numbers(subject, ProofKind.EXAMPLE)
    yield from silent_examples(subject.course, subject.scheme)


def _published_cases(subject: Subject, _trials: _Trials) -> Iterator[ProofResult]:
    return _printed_numbers(subject, ProofKind.PUBLISHED_CASE)


def _ratios(subject: Subject, trials: _Trials) -> Iterator[ProofResult]:
    for scheme, own in trials.items():
        yield from prove_ratios(subject.course.schemes[scheme], own)
    yield from _declared(subject, ProofKind.VIRTUAL_WORK)


def _motion(subject: Subject, trials: _Trials) -> Iterator[ProofResult]:
    for scheme, own in trials.items():
        if subject.course.schemes[scheme].kinematics is not None:
            yield prove_motion(subject.course.schemes[scheme], own)


def _interference(subject: Subject, trials: _Trials) -> Iterator[ProofResult]:
    for scheme, own in trials.items():
        if subject.course.schemes[scheme].view is not None:
            yield prove_interference(subject.course, subject.course.schemes[scheme], own)


def _declared(subject: Subject, kind: ProofKind) -> Iterator[ProofResult]:
    for one in subject.declared.proofs:
        if proof_of(one).kind is kind and (
            subject.scheme is None or subject.scheme in (one.scope.schemes or {subject.scheme})
        ):
            result = prove_declared(one, subject.source, subject.scheme)
            # Of one scheme only: a proof about whichever scheme has its names is about others.
            if result.compared or subject.scheme is None or one.scope.schemes:
                yield result


def _travels(subject: Subject, _trials: _Trials) -> Iterator[ProofResult]:
    return _declared(subject, ProofKind.TRAVEL)


def _identities(subject: Subject, _trials: _Trials) -> Iterator[ProofResult]:
    return _declared(subject, ProofKind.IDENTITY)


def _inequalities(subject: Subject, _trials: _Trials) -> Iterator[ProofResult]:
    return _declared(subject, ProofKind.INEQUALITY)


def _equilibrium(subject: Subject, _trials: _Trials) -> Iterator[ProofResult]:
    for one in subject.mechanisms:
        if subject.scheme is None or subject.scheme in (one.schemes or {subject.scheme}):
            result = prove_equilibrium(one, subject.source, subject.scheme)
            # Of one scheme only: a mechanism of whichever scheme has its names is about others.
            if result.compared or subject.scheme is None or one.schemes:
                yield result


def _every(trials: _Trials) -> tuple[Trial, ...]:
    return tuple(one for own in trials.values() for one in own)


def _operators(subject: Subject, trials: _Trials) -> Iterator[ProofResult]:
    ground = ProofGround(subject.source, subject.calculations, subject.declared, _every(trials))
    return prove_operators(ground)


def _wrong_methods(subject: Subject, trials: _Trials) -> Iterator[ProofResult]:
    return prove_wrong_methods(subject.source, subject.policy, _every(trials))


def _printed_lines(_subject: Subject, trials: _Trials) -> Iterator[ProofResult]:
    return prove_printed_lines(_every(trials))


def _workbooks(_subject: Subject, trials: _Trials) -> Iterator[ProofResult]:
    return prove_workbooks(trials, office_command())


_WITHOUT_TRIALS: Final = frozenset(
    {
        ProofKind.EXAMPLE,
        ProofKind.PUBLISHED_CASE,
        ProofKind.TRAVEL,
        ProofKind.IDENTITY,
        ProofKind.INEQUALITY,
        ProofKind.EQUILIBRIUM,
    }
)
_STEPS: Final[tuple[tuple[ProofKind, Callable[[Subject, _Trials], Iterator[ProofResult]]], ...]] = (
    (ProofKind.EXAMPLE, _examples),
    (ProofKind.PUBLISHED_CASE, _published_cases),
    (ProofKind.VIRTUAL_WORK, _ratios),
    (ProofKind.MOTION, _motion),
    (ProofKind.TRAVEL, _travels),
    (ProofKind.INTERFERENCE, _interference),
    (ProofKind.IDENTITY, _identities),
    (ProofKind.INEQUALITY, _inequalities),
    (ProofKind.EQUILIBRIUM, _equilibrium),
    (ProofKind.PRINTED_LINES, _printed_lines),
    (ProofKind.WRONG_METHODS, _wrong_methods),
    (ProofKind.OPERATORS, _operators),
    (ProofKind.WORKBOOKS, _workbooks),
)
