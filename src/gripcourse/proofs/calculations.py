"""Calculations with printed results: worked examples and published cases, computed and compared."""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from gripcourse.course.model import Course
from gripcourse.course.quantity import Convention
from gripcourse.errors import Problem
from gripcourse.formula.evaluate import evaluate_number
from gripcourse.proofs.model import Proof, ProofKind, ProofResult, Verdict, concluded
from gripcourse.proofs.published_cases import PublishedCase
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import evaluate, solve_variant, to_si
from gripcourse.text.amounts import amount_texts
from gripcourse.text.units import factor
from gripcourse.text.words import Message, message

_SAME = 1e-12  # relative: what floating point leaves of an equal number
_ONE_VALUE = 1e-3  # relative: constants of handbooks are rounded, 9550 for 30000/π
_EXPECTS_NOTHING = message("it expects no number that was computed elsewhere")
_FIGURES = 10  # shown: the expected digits must be seen to differ


@dataclass(frozen=True, slots=True)
class PrintedCalculation:
    """A calculation whose results are printed somewhere.

    Attributes:
        kind: worked example or published case.
        name: for a line of output.
        plan: what is computed, in one convention.
        known: givens, constants and decisions, in declared units.
        expected: value and tolerated difference by quantity, in declared units.
        file, key: of the table `expected`, for messages.
    """

    kind: ProofKind
    name: str
    plan: Plan
    known: Mapping[str, float]
    expected: Mapping[str, tuple[float, float]]
    file: str
    key: str


def calculations(
    course: Course, cases: Sequence[PublishedCase], scheme: str | None = None
) -> Iterator[PrintedCalculation]:
    """Yield the worked examples in both conventions and the published cases.

    Args:
        course: a course without problems.
        cases: its published cases.
        scheme: only of this scheme; None for all.
    """
    for one in course.schemes.values():
        example = one.example
        if example is None or scheme not in {None, one.id}:
            continue
        for convention in course.conventions:
            if not example.expected[convention]:
                continue
            plan = make_plan(course, one.id, example.options, convention)
            yield PrintedCalculation(
                ProofKind.EXAMPLE,
                f"{one.id}, {convention}",
                plan,
                _in_plan(plan, {**example.given, **example.chosen[convention]}),
                example.expected[convention],
                f"{one.file.removesuffix('scheme.toml')}worked_example.toml",
                f"{convention}.expected",
            )
    for case in cases:
        if scheme in {None, case.scheme}:
            plan = make_plan(course, case.scheme, case.options, Convention.CORRECTED)
            yield PrintedCalculation(
                ProofKind.PUBLISHED_CASE,
                case.id,
                plan,
                {**case.given, **case.chosen},
                case.expected,
                case.file,
                f"{case.key}.expected",
            )


def silent_examples(course: Course, scheme: str | None = None) -> Iterator[ProofResult]:
    """Yield the worked examples that expect no number, as what is open: nothing believes them.

    Args:
        course: a course without problems.
        scheme: only of this scheme; None for all.
    """
    for one in course.schemes.values():
        if scheme in {None, one.id} and one.example and not any(one.example.expected.values()):
            file = f"{one.file.removesuffix('scheme.toml')}worked_example.toml"
            proof = Proof(ProofKind.EXAMPLE, one.id, file, "corrected.expected")
            yield ProofResult(proof, Verdict.OPEN, 0, (), _EXPECTS_NOTHING)


def prove_calculation(one: PrintedCalculation) -> ProofResult:
    """Compute a calculation and compare it with what is printed."""
    proof = Proof(one.kind, one.name, one.file, one.key)
    return concluded(proof, len(one.expected), tuple(differences(one)))


def differences(one: PrintedCalculation) -> Iterator[Problem]:
    """Yield every printed number that does not come out; what only follows from it, beside it."""
    values = solve_variant(one.plan, one.known)
    known = dict(one.known)
    wrong = _unmet(one, values, [name for name in one.plan.quantities if name in one.expected])
    while wrong:
        name, *others = wrong
        printed, difference = one.expected[name]
        known[name] = printed
        wrong = _unmet(one, solve_variant(one.plan, known), others) if others else []
        what = _what(one.plan, name, values[name], printed, difference)
        follow = [other for other in others if other not in wrong]
        yield Problem(
            one.file,
            f"{one.key}.{name}",
            _with_followers(what, follow) if follow else what,
            message(
                "Compare the formula of {name} and of what it uses with the source; if they"
                " are right, correct the printed number or what is given.",
                name=name,
            ),
        )
    # A published case may give numbers of its own for both ways.
    if one.kind is ProofKind.EXAMPLE and one.plan.convention is Convention.CORRECTED:
        yield from _other_routes(one.plan, values)


def _other_routes(plan: Plan, values: Mapping[str, float]) -> Iterator[Problem]:
    """Yield the declared routes that do not lead to the value of their quantity."""
    known = to_si(plan, values)
    for quantity in plan.answered:
        if quantity.route is None or not math.isfinite(values[quantity.id]):
            continue  # a formula without a value is told as such
        unit = factor(quantity.unit)
        found = evaluate_number(quantity.route, quantity.unit, known, plan.columns) / unit
        if not math.isclose(found, values[quantity.id], rel_tol=_ONE_VALUE):
            yield Problem(
                quantity.file,
                f"quantity.{quantity.id}.route",
                message(
                    "The route gives {found}, the formula {value}.",
                    found=found,
                    value=values[quantity.id],
                ),
                message("Write a way to the same value, or declare it as an alternative."),
            )


def _unmet(one: PrintedCalculation, values: Mapping[str, float], names: Sequence[str]) -> list[str]:
    """Return which numbers do not come out as they are printed."""
    return [name for name in names if not is_met(values[name], *one.expected[name])]


def _with_followers(what: Message, names: Sequence[str]) -> Message:
    return message(
        "{what} With the printed number these would come out, too: {names}.",
        what=what,
        names=", ".join(names),
    )


def is_met(value: float, printed: float, difference: float) -> bool:
    """Tell whether a computed value is the printed one, as far as its digits say."""
    return bool(np.isclose(value, printed, rtol=_SAME, atol=difference))


def broken_by(
    one: PrintedCalculation, changed: Mapping[str, Sequence[float]]
) -> Mapping[str, tuple[bool, ...]]:
    """Tell which changed values of single quantities break a calculation.

    Args:
        one: the calculation.
        changed: for each quantity the values, in SI, that it might have instead, one at a time;
            NaN where it would have none.

    Returns:
        For each value whether some printed number does not come out with it.
    """
    tried = [(name, place) for name, values in changed.items() for place in range(len(values))]
    known = {name: np.full(len(tried), value) for name, value in to_si(one.plan, one.known).items()}
    for name, values in changed.items():
        if name in one.known:
            continue  # decided by the calculation itself: its formula is not used
        # Infinite is "supplied, but no number": what uses it has no value either.
        wrong = [math.inf if math.isnan(value) else value for value in values]
        known[name] = np.array(
            [wrong[place] if name == other else math.nan for other, place in tried]
        )
    values_of = evaluate(one.plan, known).values
    broken = np.zeros(len(tried), dtype=np.bool_)
    for name, (printed, difference) in one.expected.items():
        declared = values_of[name] / factor(one.plan.quantities[name].unit)
        broken |= ~np.isclose(declared, printed, rtol=_SAME, atol=difference)
    flags = iter(broken.tolist())
    return {name: tuple(next(flags) for _ in values) for name, values in changed.items()}


def _in_plan(plan: Plan, known: Mapping[str, float]) -> dict[str, float]:
    return {name: value for name, value in known.items() if name in plan.quantities}


def _what(plan: Plan, name: str, value: float, printed: float, difference: float) -> Message:
    unit = plan.quantities[name].unit
    if not math.isfinite(value):
        return message(
            "{title} has no value here; {printed} is printed.",
            title=plan.quantities[name].title,
            printed=amount_texts(printed, unit, _FIGURES),
        )
    return message(
        "{title} comes out as {value}; {printed} is printed, ±{difference}.",
        title=plan.quantities[name].title,
        value=amount_texts(value, unit, _FIGURES),
        printed=amount_texts(printed, unit, _FIGURES),
        difference=amount_texts(difference, unit, _FIGURES),
    )
