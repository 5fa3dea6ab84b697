"""Submissions built in memory: a variant, its reference answers, and what a student wrote."""

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass, replace
from datetime import date
from functools import cache
from pathlib import Path
from typing import TypeAlias

import pytest

from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.course.quantity import Convention, Kind
from gripcourse.grading.diagnose import CandidatesOf
from gripcourse.grading.judge import judge
from gripcourse.grading.model import Finding, Report
from gripcourse.grading.rounding import figure_half_unit
from gripcourse.policy.load import load_policy
from gripcourse.policy.model import Policy
from gripcourse.slips.candidates import candidates_of
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import solve_variant
from gripcourse.submission.model import Answer, Identity, Reading, Submission
from gripcourse.text.words import message
from gripcourse.variants.draw import draw
from gripcourse.variants.model import Issued, Student, Variant
from gripcourse.variants.space import load_spaces
from support.issued_table import issued_table

SIGNATURE = "a1" * 32
BELTS = Path(__file__).parents[2] / "examples" / "belt_drive"

Written: TypeAlias = float | str | Answer | None
"""What stands in an answer cell: a number, text that is none, nothing; or an answer as read."""


DrawMore: TypeAlias = Callable[[Collection[str]], "Iterator[Case]"]

_METHODS: dict[tuple[int, int], tuple[Plan, Policy, CandidatesOf]] = {}


def methods_of(plan: Plan, policy: Policy) -> CandidatesOf:
    """Make the wrong methods of a composition's quantities once, not for every answer or policy."""
    key = (id(plan), id(policy.slips))
    if key not in _METHODS:  # with what its numbers are of, which is thus not given away
        methods = cache(lambda name: candidates_of(plan, name, policy.slips))
        _METHODS[key] = (plan, policy, methods)
    return _METHODS[key][2]


@dataclass(frozen=True, slots=True, repr=False)
class Case:
    """One issued variant and its judge."""

    plan: Plan
    issued: Issued
    policy: Policy
    reference: Mapping[str, float]

    @property
    def answers(self) -> dict[str, float]:
        """The reference answers."""
        return {one.id: self.reference[one.id] for one in self.plan.answered}

    @property
    def given(self) -> Mapping[str, float]:
        return self.issued.variant.given

    def with_policy(self, **changes: object) -> "Case":
        return replace(self, policy=replace(self.policy, **changes))  # type: ignore[arg-type]

    def following(self, **known: float) -> dict[str, float]:
        """The answers of a student who computes on faultlessly from these values."""
        values = solve_variant(self.plan, {**self.given, **known})
        return {one.id: values[one.id] for one in self.plan.answered}

    def printed(self) -> dict[str, float]:
        """The answers of a student who computes as the source prints it."""
        guide = make_plan(
            self.plan.course, self.plan.scheme.id, self.plan.options, Convention.AS_PRINTED
        )
        values = solve_variant(guide, self.given)
        return {one.id: values[one.id] for one in self.plan.answered}

    @property
    def label(self) -> str:
        return f"{self.plan.scheme.id}, {dict(self.plan.options)}, {self.issued.variant.id}"

    @property
    def without_errata(self) -> "Case":
        """A policy that refuses errata: an answer near a printed one is a question of its own."""
        return self.with_policy(printed_credit=None)

    def needing(self, wanted: str) -> set[str]:
        """Everything that is computed from a quantity, directly or not."""
        found = {wanted}
        for name in self.plan.quantities:
            if found.intersection(self.plan.inputs[name]):
                found.add(name)
        return found - {wanted}

    def submission(self, answers: Mapping[str, Written], **changes: object) -> Submission:
        """What was read of a workbook in which only these cells are filled."""
        variant = self.issued.variant
        whole = Submission(
            file="inbox/s01.xlsx",
            digest="0" * 64,
            identity=Identity(
                student=self.issued.student.id,
                variant=variant.id,
                scheme=variant.scheme,
                options=variant.options,
                signature=self.issued.signature,
            ),
            creator="",
            givens=dict(variant.given),
            answers={one.id: answer(one.id, answers.get(one.id)) for one in self.plan.answered},
            remarks=(),
        )
        return replace(whole, **changes)  # type: ignore[arg-type]

    def judge(self, answers: Mapping[str, Written], **changes: object) -> Report:
        methods = methods_of(self.plan, self.policy)
        read = self.submission(answers, **changes)
        return judge(read, self.issued, self.plan, self.policy, methods)

    def findings(self, answers: Mapping[str, Written], **changes: object) -> dict[str, Finding]:
        return {one.quantity: one for one in self.judge(answers, **changes).findings}

    def lost(self, answers: Mapping[str, Written]) -> set[str]:
        """The quantities that do not earn all their points."""
        return {
            one.quantity
            for one in self.judge(answers).findings
            if one.points < one.max_points - 1e-9
            and self.plan.quantities[one.quantity].kind.answered
        }


def answer(quantity: str, written: Written, *, unit: str = "", unit_fits: bool = True) -> Answer:
    """Make an answer as it is read from a cell."""
    if isinstance(written, Answer):
        return written
    if isinstance(written, float | int):
        reading, remarks = Reading.READ, ()
    else:
        reading = Reading.BLANK if written is None else Reading.UNREADABLE
        remarks = () if written is None else (message("A number is needed here."),)
    return Answer(
        quantity=quantity,
        reading=reading,
        value=float(written) if isinstance(written, float | int) else None,
        typed="" if written is None else str(written),
        cell=f"Ответы!D{sum(map(ord, quantity))}",
        half_unit=0.0,
        unit=unit,
        unit_fits=unit_fits,
        remarks=remarks,
    )


def make_case(plan: Plan, given: Mapping[str, float], policy: Policy, variant: str = "001") -> Case:
    issued = Issued(
        student=Student("s01", "Иванова Ольга", "РТК-41", "", "ru", ""),
        variant=Variant(variant, plan.scheme.id, dict(plan.options), dict(given)),
        issued_on=date(2026, 9, 7),
        deadline=date(2026, 12, 1),
        signature=SIGNATURE,
    )
    return Case(plan, issued, policy, solve_variant(plan, given))


@pytest.fixture(scope="session")
def table(course: Course, policy: Policy) -> tuple[Case, ...]:
    """Every variant of the course's main table."""
    return tuple(
        make_case(make_plan(course, one.scheme, one.options), one.given, policy, one.id)
        for one in issued_table(course)
    )


@pytest.fixture(scope="session")
def drawn(course: Course, policy: Policy) -> tuple[Case, ...]:
    """Some variants of every scheme, drawn from its own space, with every choice of its options."""
    spaces = load_spaces(course)
    assert {space.scheme for space in spaces} == set(course.schemes)
    variants = [one for space in spaces for one in draw(course, [space], 3, 20260907).variants]
    return tuple(
        make_case(make_plan(course, one.scheme, one.options), one.given, policy, one.id)
        for one in variants
    )


@pytest.fixture(scope="session")
def draw_more(course: Course, policy: Policy) -> DrawMore:
    """Draw many variants of a few schemes, for what few of them show."""

    def more(schemes: Collection[str]) -> Iterator[Case]:
        spaces = [space for space in load_spaces(course) if space.scheme in schemes]
        for one in draw(course, spaces, 40 * len(spaces), 20260908).variants if spaces else ():
            plan = make_plan(course, one.scheme, one.options)
            yield make_case(plan, one.given, policy, one.id)

    return more


@pytest.fixture(scope="session")
def hydraulic(plan: Plan, policy: Policy) -> Case:
    """The guide's own example (§5), with the course's gravity."""
    assert plan.scheme.example is not None
    given = {one.id: plan.scheme.example.given[one.id] for one in plan.givens}
    return make_case(plan, given, policy)


@pytest.fixture(scope="session")
def flat_belt() -> Case:
    """The worked example of a flat belt that slips at the first width that is wide enough."""
    return _belt_example("flat_belt")


@pytest.fixture(scope="session")
def v_belt() -> Case:
    """The worked example of a V-belt drive."""
    return _belt_example("v_belt")


@pytest.fixture(scope="session")
def belt_table() -> tuple[Case, ...]:
    """Every variant that the second course issues."""
    belts = load_course(BELTS)
    policy = load_policy(belts)
    return tuple(
        make_case(make_plan(belts, one.scheme, one.options), one.given, policy, one.id)
        for one in issued_table(belts)
    )


def _belt_example(name: str) -> Case:
    belts = load_course(BELTS)
    scheme = belts.schemes[name]
    assert scheme.example is not None
    plan = make_plan(belts, scheme.id, scheme.example.options)
    given = {one.id: scheme.example.given[one.id] for one in plan.givens}
    return make_case(plan, given, load_policy(belts))


@pytest.fixture(scope="session")
def square(course: Course, plan: Plan, policy: Policy) -> Case:
    """The guide's example with 140 kg on a square flange."""
    example = plan.scheme.example
    assert example is not None
    heavy = make_plan(course, plan.scheme.id, {**example.options, "mounting": "square_flange"})
    given = {one.id: example.given[one.id] for one in heavy.givens}
    return make_case(heavy, {**given, "mass": 140.0}, policy)


@pytest.fixture(scope="session")
def pneumatic(table: tuple[Case, ...]) -> Case:
    return next(
        case
        for case in table
        if case.plan.scheme.id == "rack_parallelogram" and case.plan.options["drive"] == "pneumatic"
    )


@pytest.fixture(scope="session", params=["hydraulic", "pneumatic"])
def case(request: pytest.FixtureRequest, hydraulic: Case, pneumatic: Case) -> Case:
    """A variant with each drive."""
    return hydraulic if request.param == "hydraulic" else pneumatic


@pytest.fixture(scope="session")
def computed(case: Case) -> tuple[str, ...]:
    """The quantities of a variant that are computed."""
    return tuple(one.id for one in case.plan.answered if one.kind is Kind.FORMULA)


@pytest.fixture(scope="session")
def read_answer() -> object:
    """Make an answer as it is read from a cell: `read_answer(quantity, written, unit_fits=…)`."""
    return answer


@pytest.fixture(scope="session")
def typed() -> object:
    """Make an answer that was typed with so many significant figures: `typed(name, value, 4)`."""

    def make(quantity: str, value: float, figures: int) -> Answer:
        rounded = float(f"{value:.{figures - 1}e}")
        half_unit = figure_half_unit(rounded, figures)
        return replace(answer(quantity, rounded), half_unit=half_unit)

    return make
