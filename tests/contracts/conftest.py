"""Every scheme with every combination of its options, and numbers to try them with.

Contracts are generated from the declarations: a scheme that is added to the course is checked
without a line written here. A failure names the scheme, the options and the quantities.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

import pytest

from gripcourse.course.compose import option_sets
from gripcourse.course.load import load_course
from gripcourse.course.model import Convention, Course, Kind, Scheme
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import Values, evaluate, to_si
from gripcourse.variants.draw import draw
from gripcourse.variants.model import Variant
from gripcourse.variants.space import Space, load_spaces
from gripcourse.variants.table import read_table

REPOSITORY = Path(__file__).parents[2]
DRAWN = 12  # variants of each combination of options, besides the worked example
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
    def example(self) -> Reference:
        """The worked example where there is one for these options, else a variant."""
        return self.references[0]


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """Give every composition, and every number of a worked example, a test of its own."""
    if "composition_key" in metafunc.fixturenames:
        only_guide = "of_the_guide" in metafunc.fixturenames
        keys = [
            (scheme.id, tuple(sorted(options.items())))
            for scheme in load_course(REPOSITORY).schemes.values()
            for options in covering(scheme)
            if not only_guide or _is_of_the_guide(scheme, options)
        ]
        metafunc.parametrize("composition_key", keys, ids=[_name(*key) for key in keys])
    if "expected_key" in metafunc.fixturenames:
        expected = [
            (scheme.id, convention, quantity)
            for scheme in load_course(REPOSITORY).schemes.values()
            if scheme.example is not None
            for convention, values in scheme.example.expected.items()
            for quantity in values
        ]
        metafunc.parametrize("expected_key", expected, ids=["-".join(key) for key in expected])


def covering(scheme: Scheme) -> list[Mapping[str, str]]:
    """Choose combinations of options in which every two choices of two options meet.

    The parts of one option know those of another at most by their names: two at a time show what
    goes wrong, and a scheme with five options has hundreds of combinations. The worked example's
    combination comes first.
    """
    left = [dict(options) for options in option_sets(scheme)]
    if scheme.example is not None:
        left.sort(key=lambda options: options != scheme.example.options)
    chosen = [left[0]]
    met = _pairs(left[0])
    while best := max(left, key=lambda options: len(_pairs(options) - met), default=None):
        if _pairs(best) <= met:
            break
        chosen.append(best)
        met |= _pairs(best)
    return chosen


def _pairs(options: Mapping[str, str]) -> set[frozenset[tuple[str, str]]]:
    """Return the choices two by two; a lone option with itself."""
    return {frozenset((one, other)) for one in options.items() for other in options.items()}


def _is_of_the_guide(scheme: Scheme, options: Mapping[str, str]) -> bool:
    example = scheme.example
    return example is not None and example.source.work == "guide" and example.options == options


def _name(scheme: str, options: tuple[tuple[str, str], ...]) -> str:
    return "-".join((scheme, *(choice for _, choice in options)))


@pytest.fixture(scope="session")
def variants_of(course: Course) -> Callable[[str, Mapping[str, str]], tuple[Variant, ...]]:
    """Find variants of a scheme with options: issued ones, then drawn ones; maybe none."""
    table = course.root / "variants" / "tables" / "main.csv"
    issued = read_table(table, course) if table.exists() else ()
    spaces = load_spaces(course)

    def find(scheme: str, options: Mapping[str, str]) -> tuple[Variant, ...]:
        tabled = [one for one in issued if one.scheme == scheme and one.options == options]
        cases = [
            Space(scheme, 1, (case,), space.file)
            for space in spaces
            for case in space.cases
            if space.scheme == scheme and case.options == options
        ]
        drawn = draw(course, cases, DRAWN, SEED).variants if cases else ()
        return (*tabled, *drawn)[:DRAWN]

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


@pytest.fixture
def printed_composition(
    composition_key: tuple[str, tuple[tuple[str, str], ...]], composed: Callable[..., Composition]
) -> Composition:
    """The same as the source prints it, errata included."""
    return composed(composition_key, Convention.GUIDE)


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
            for name, value in (*scheme.example.given.items(),
                                *scheme.example.chosen[convention].items())
            if name in plan.quantities
        }  # fmt: skip
        known.insert(0, ("worked example", given, scheme.example.options == options))
    assert known, f"{scheme.id} {options} has neither an example nor a space to draw from"
    references = tuple(
        Reference(name, given, evaluate(plan, to_si(plan, given)).values, is_example)
        for name, given, is_example in known
    )
    return Composition(plan, references)


def _is_complete(plan: Plan, given: Mapping[str, float]) -> bool:
    return all(one.id in given for one in plan.givens if one.kind is Kind.GIVEN)
