"""Every scheme with every choice of its options, and numbers to try them with.

Contracts are generated from the declarations: a scheme that is added to the course is checked
without a line written here. A failure names the scheme, the options and the quantities.

One scheme may have hundreds of combinations of options. Tried are as few as hold every choice of
every option; `gripcourse validate` composes and checks all of them.
"""

from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.course.option_sets import option_sets
from gripcourse.course.quantity import Convention, Kind
from gripcourse.policy.model import Policy
from gripcourse.proofs.calculations import PrintedCalculation, calculations
from gripcourse.proofs.check_declared import load_declared_proofs
from gripcourse.proofs.declared import DeclaredProof
from gripcourse.proofs.equilibrium.check import load_mechanisms
from gripcourse.proofs.prove import Subject
from gripcourse.proofs.published_cases import load_published_cases
from gripcourse.proofs.samples import SampleSource, Trial
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import Values, evaluate, to_si
from gripcourse.variants.cases import Cases
from gripcourse.variants.draw import DrawingOrder, draw, draw_space
from gripcourse.variants.model import Variant
from gripcourse.variants.screening import sifter
from gripcourse.variants.space import Space, load_spaces
from support.issued_table import issued_table

REPOSITORY = Path(__file__).parents[2]
DRAWN = 12  # variants of each combination of options, besides the worked example
COUNT = 3  # variants of each combination of options that a proof is tried with
SEED = 26063


@dataclass(frozen=True, slots=True)
class Reference:
    """One set of numbers for a plan.

    Attributes:
        name: `worked example`, or the id of a variant.
        given: what is known, in declared units: givens, constants, design decisions.
        values: of every quantity, SI.
        is_example: whether it is the published example with its own options.
    """

    name: str
    given: Mapping[str, float]
    values: Values
    is_example: bool


@dataclass(frozen=True, slots=True)
class Composition:
    """A scheme with options in a convention, and numbers to try it with: at least one set."""

    plan: Plan
    references: tuple[Reference, ...]

    @property
    def name(self) -> str:
        """The scheme and the choices of its options."""
        return _name(self.plan.scheme.id, tuple(sorted(self.plan.options.items())))

    @property
    def example(self) -> Reference:
        """The worked example where there is one for these options, else a variant."""
        return self.references[0]


@cache
def reference_course() -> Course:
    """Load the reference course once for the collection and for the tests."""
    return load_course(REPOSITORY)


@cache
def drawable() -> dict[str, list[Mapping[str, str]]]:
    """Return the combinations of options that variants are drawn with, by scheme."""
    return {
        scheme: [
            options
            for space in all_spaces()
            if space.scheme == scheme
            for options in space.cases.combinations
        ]
        for scheme in reference_course().schemes
    }


@cache
def all_spaces() -> tuple[Space, ...]:
    """Load what variants of the reference course are drawn from, once."""
    return tuple(load_spaces(reference_course()))


@cache
def covering_sets(scheme_id: str) -> tuple[dict[str, str], ...]:
    """Choose few combinations of options that hold every choice of every option, once.

    The first is the worked example's; then always the one with the most choices still missing,
    and of those the one whose other choices were tried least, so that they come in new company.
    There are numbers only for what variants are drawn from, and near the worked example.
    """
    scheme = reference_course().schemes[scheme_id]
    usual = {} if scheme.example is None else scheme.example.options
    candidates = [
        options
        for options in option_sets(scheme)
        if options in drawable()[scheme.id] or len(options.items() - usual.items()) <= 1
    ]
    tried = Counter(
        {(option.id, choice.id): 0 for option in scheme.options for choice in option.choices}
    )
    chosen = [] if scheme.example is None else [dict(scheme.example.options)]
    tried.update(pair for options in chosen for pair in options.items())
    while not chosen or min(tried.values(), default=1) == 0:
        best = max(
            candidates,
            key=lambda options: (
                sum(tried[pair] == 0 for pair in options.items()),
                -sum(tried[pair] for pair in options.items()),
            ),
        )
        chosen.append(best)
        tried.update(best.items())
    return tuple(chosen)


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """Give every composition, and everything that is proved, a test of its own."""
    schemes = reference_course().schemes
    if "scheme_id" in metafunc.fixturenames:
        metafunc.parametrize("scheme_id", list(schemes))
    if "composition_key" in metafunc.fixturenames:
        keys = [
            (scheme.id, tuple(sorted(example.options.items())))
            for scheme in schemes.values()
            if (example := scheme.example) is not None and example.source.work == "guide"
        ]
        metafunc.parametrize("composition_key", keys, ids=[_name(*key) for key in keys])
    if "declared_proof" in metafunc.fixturenames:
        proofs = declared_proofs()
        metafunc.parametrize("declared_proof", proofs, ids=[one.scope.id for one in proofs])
    if "calculation" in metafunc.fixturenames:
        printed = printed_calculations()
        metafunc.parametrize("calculation", printed, ids=[one.name for one in printed])


@cache
def declared_proofs() -> tuple[DeclaredProof, ...]:
    """Read what the course declares, once for the collection and for the tests."""
    return load_declared_proofs(reference_course()).proofs


@cache
def printed_calculations() -> tuple[PrintedCalculation, ...]:
    """Plan every calculation with printed results, once."""
    course = reference_course()
    return tuple(calculations(course, load_published_cases(course)))


@pytest.fixture(scope="session")
def subject(course: Course, policy: Policy) -> Subject:
    """What is proved of the reference course."""
    return Subject(
        SampleSource(course, all_spaces(), COUNT, SEED, load_published_cases(course)),
        policy,
        load_declared_proofs(course),
        load_mechanisms(course),
        printed_calculations(),
        None,
    )


@pytest.fixture(scope="session")
def trials(subject: Subject) -> dict[str, tuple[Trial, ...]]:
    """Numbers to try each scheme with."""
    return subject.trials()


@pytest.fixture(scope="session")
def few_trials(trials: dict[str, tuple[Trial, ...]]) -> dict[str, tuple[Trial, ...]]:
    """As few of the trials as hold every quantity with each of its formulas; some of every scheme.

    What schemes share is tried in one of them. What the fewest trials hold is looked for first, in
    the trial with most that is new.
    """
    contents = {
        (scheme, place): _formulas_of(trial.plan)
        for scheme, own in trials.items()
        for place, trial in enumerate(own)
    }
    holders = Counter(formula for held in contents.values() for formula in held)
    chosen = set[tuple[str, int]]()
    left = frozenset(holders)
    while left:
        rarest = min(left, key=lambda one: (holders[one], str(one)))
        there = [one for one, held in contents.items() if rarest in held]
        best = max(there, key=lambda one: len(contents[one] & left))
        chosen.add(best)
        left -= contents[best]
    assert {scheme for scheme, _ in chosen} == trials.keys()
    return {
        scheme: tuple(trial for place, trial in enumerate(own) if (scheme, place) in chosen)
        for scheme, own in trials.items()
    }


def _formulas_of(plan: Plan) -> frozenset[object]:
    """Name every quantity of a plan with the formula that computes it, if any."""
    found = ((one, plan.reference_formula(one.id)) for one in plan.quantities.values())
    return frozenset(
        (one.file, one.id, None if formula is None else formula.text) for one, formula in found
    )


@pytest.fixture(scope="session")
def course() -> Course:
    """The reference course, the same that the collection has loaded."""
    return reference_course()


def _name(scheme: str, options: tuple[tuple[str, str], ...]) -> str:
    return "-".join((scheme, *(choice for _, choice in options)))


@pytest.fixture(scope="session")
def spaces() -> tuple[Space, ...]:
    """What variants are drawn from."""
    return all_spaces()


@pytest.fixture(scope="session")
def issued(course: Course) -> tuple[Variant, ...]:
    """The variants of the course's table."""
    return issued_table(course)


@pytest.fixture(scope="session")
def drawn_of(
    course: Course, spaces: tuple[Space, ...]
) -> Callable[[str, int], tuple[Variant, ...]]:
    """Draw variants of a scheme, its options mixed; the same count gives the same variants."""

    def find(scheme: str, count: int) -> tuple[Variant, ...]:
        own = [space for space in spaces if space.scheme == scheme]
        assert own, f"there is nothing to draw variants of {scheme} from"
        return draw(course, own, count, SEED).variants

    return find


@pytest.fixture(scope="session")
def variants_of(
    course: Course, policy: Policy, spaces: tuple[Space, ...], issued: tuple[Variant, ...]
) -> Callable[[str, Mapping[str, str]], tuple[Variant, ...]]:
    """Find variants of a scheme with options: issued ones, then drawn ones; maybe none.

    They keep the policy's rules but one: a dozen of one composition may be near each other.
    """
    near = replace(policy.variants, shared_points=1.0, shared_section_points=1.0)
    rules = replace(policy, variants=near)

    def tabled(scheme: str, options: Mapping[str, str]) -> tuple[Variant, ...]:
        found = (one for one in issued if one.scheme == scheme and one.options == options)
        return tuple(found)[:DRAWN]

    @cache
    def drawn(scheme: str) -> tuple[Variant, ...]:
        """Draw what the table lacks of all tried combinations, those of a space at once."""
        found: list[Variant] = []
        for space in (one for one in spaces if one.scheme == scheme):
            there = [space.cases.with_options(one) for one in covering_sets(scheme)]
            cases = [one for one in there if one is not None]
            wanted = {
                place: DRAWN - len(tabled(scheme, case.options)) for place, case in enumerate(cases)
            }
            order = DrawingOrder(scheme, wanted, np.random.SeedSequence(SEED))
            only = replace(space, cases=Cases.of(cases))
            rows = draw_space(course, only, order, sifter(rules, len(course.sections))).rows
            assert all(
                sum(options == case.options for options, _ in rows) == wanted[place]
                for place, case in enumerate(cases)
            )
            found += (
                Variant(f"{number:03d}", scheme, *row) for number, row in enumerate(rows, start=1)
            )
        return tuple(found)

    def find(scheme: str, options: Mapping[str, str]) -> tuple[Variant, ...]:
        assert options in covering_sets(scheme)
        known = tabled(scheme, options)
        return (*known, *(one for one in drawn(scheme) if one.options == options))

    return find


@pytest.fixture(scope="session")
def composed(
    course: Course, variants_of: Callable[[str, Mapping[str, str]], tuple[Variant, ...]]
) -> Callable[..., Composition]:
    """Compose a scheme and compute its references; each composition once."""
    made: dict[object, Composition] = {}

    def compose(
        key: tuple[str, tuple[tuple[str, str], ...]], convention: Convention = Convention.CORRECTED
    ) -> Composition:
        if (key, convention) not in made:
            made[key, convention] = _composition(course, key, convention, variants_of)
        return made[key, convention]

    return compose


@pytest.fixture(scope="session")
def composition_keys() -> tuple[tuple[str, tuple[tuple[str, str], ...]], ...]:
    """Schemes with as few combinations of options as hold every choice.

    A contract looks at each in a subtest: a test of its own takes much longer than most contracts.
    """
    return tuple(
        (scheme, tuple(sorted(options.items())))
        for scheme in reference_course().schemes
        for options in covering_sets(scheme)
    )


@pytest.fixture(scope="session")
def compositions(
    composition_keys: tuple[tuple[str, tuple[tuple[str, str], ...]], ...],
    composed: Callable[..., Composition],
) -> tuple[Composition, ...]:
    """Those combinations of options, in the corrected convention."""
    return tuple(composed(key) for key in composition_keys)


@pytest.fixture
def composition(
    composition_key: tuple[str, tuple[tuple[str, str], ...]], composed: Callable[..., Composition]
) -> Composition:
    """One combination of options of one scheme, in the corrected convention."""
    return composed(composition_key)


@pytest.fixture
def of_the_guide(composition: Composition) -> Composition:
    """Only those combinations of options that the guide has an example of."""
    assert composition.example.is_example
    return composition


def _composition(
    course: Course,
    key: tuple[str, tuple[tuple[str, str], ...]],
    convention: Convention,
    variants_of: Callable[[str, Mapping[str, str]], tuple[Variant, ...]],
) -> Composition:
    scheme, options = course.schemes[key[0]], dict(key[1])
    plan = make_plan(course, scheme.id, options, convention)
    known = [(variant.id, variant.given, False) for variant in variants_of(scheme.id, options)]
    if scheme.example is not None and _is_complete(plan, scheme.example.given):
        given = {
            name: value
            for name, value in (*of_the_plan(plan, scheme.example.given).items(),
                                *scheme.example.chosen[convention].items())
            if name in plan.quantities
        }  # fmt: skip
        is_own = scheme.example.options == options
        if is_own or _has_a_solution(plan, given):
            known.insert(0, ("worked example", given, is_own))
    assert known, f"{scheme.id} {options} has neither an example nor a space to draw from"
    references = tuple(
        Reference(name, given, evaluate(plan, to_si(plan, given)).values, is_example)
        for name, given, is_example in known
    )
    return Composition(plan, references)


def of_the_plan(plan: Plan, given: Mapping[str, float]) -> dict[str, float]:
    """Leave out what is computed with these options, and what they do not have."""
    known = {one.id for one in (*plan.givens, *plan.constants)}
    return {name: value for name, value in given.items() if name in known}


def _has_a_solution(plan: Plan, given: Mapping[str, float]) -> bool:
    """Tell whether numbers suit these options too: a hollow jaw must be wider than the object."""
    values = evaluate(plan, to_si(plan, given)).values
    return all(np.isfinite(values[one.id]) for one in plan.answered)


def _is_complete(plan: Plan, given: Mapping[str, float]) -> bool:
    return all(one.id in given for one in plan.givens if one.kind is Kind.GIVEN)
