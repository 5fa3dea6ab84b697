"""Numbers to try a course with: its worked examples, and variants drawn for few combinations.

One scheme may have thousands of combinations of options. Tried are as few as hold every choice of
every option; the check of the course composes all of them.
"""

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from gripcourse.course.compose import part_ids
from gripcourse.course.composition import Composition
from gripcourse.course.model import Course, Scheme
from gripcourse.course.quantity import Convention, Kind
from gripcourse.errors import TableError
from gripcourse.proofs.published_cases import PublishedCase
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import Values, evaluate
from gripcourse.text.units import factor
from gripcourse.variants.cases import Cases
from gripcourse.variants.draw import DrawingOrder, draw_space
from gripcourse.variants.model import Variant
from gripcourse.variants.space import Space

EXAMPLE = "worked example"
_MOST_CASES = 2  # combinations of options that a declared proof is tried with, in one scheme

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class SampleSource:
    """What numbers are drawn from.

    Attributes:
        course: a course without problems.
        spaces: ranges of its schemes.
        count: variants of each combination of options.
        seed: the same seed draws the same variants.
        cases: published ones, for what no variants are drawn of.
        drawn: variants of combinations that were drawn already, None where there are none.
        names: ids of quantities by parts that were asked for already.
        mixes: combinations of options of the schemes that were asked for already.
    """

    course: Course
    spaces: tuple[Space, ...]
    count: int
    seed: int
    cases: tuple[PublishedCase, ...] = ()
    drawn: dict[Composition, "Trial | None"] = field(default_factory=dict, compare=False)
    names: dict[tuple[str, ...], frozenset[str]] = field(default_factory=dict, compare=False)
    mixes: dict[str, tuple["Mixed", ...]] = field(default_factory=dict, compare=False)

    def mixed(self, scheme: str) -> tuple["Mixed", ...]:
        """Return the combinations of options that variants of a scheme are drawn with."""
        if scheme not in self.mixes:
            declared = self.course.schemes[scheme]
            self.mixes[scheme] = tuple(
                Mixed(space, place, options, _known_names(self, declared, options))
                for space in self.spaces
                if space.scheme == scheme
                for place, options in enumerate(space.cases.combinations)
            )
        return self.mixes[scheme]


@dataclass(frozen=True, slots=True)
class Mixed:
    """A combination of options that a space mixes, its place there, and ids of its quantities."""

    space: Space
    place: int
    options: Mapping[str, str]
    names: frozenset[str]

    @property
    def composition(self) -> Composition:
        """Its scheme with these options."""
        return Composition.of(self.space.scheme, self.options)


@dataclass(frozen=True, slots=True)
class Trial:
    """A scheme with options, and sets of numbers to try it with: at least one.

    Attributes:
        plan: of the corrected convention.
        variants: in the order of the numbers; the worked example comes first where there is one.
        known: givens, constants and decisions of all variants in SI, arrays of shape (n,).
        values: of every quantity in SI, arrays of shape (n,).
    """

    plan: Plan
    variants: tuple[Variant, ...]
    known: Mapping[str, Array]
    values: Values

    @property
    def name(self) -> str:
        """The scheme, and what is chosen of its options."""
        options = (f"{name}={choice}" for name, choice in self.plan.options.items())
        return ", ".join((self.plan.scheme.id, *options))


def make_trial(plan: Plan, variants: tuple[Variant, ...]) -> Trial:
    """Solve variants of one composition."""
    names = {name: None for one in variants for name in one.given}
    known = {
        name: np.array([one.given.get(name, np.nan) for one in variants])
        * factor(plan.quantities[name].unit)
        for name in names
    }
    found = evaluate(plan, known).values
    return Trial(
        plan,
        variants,
        known,
        {name: np.broadcast_to(one, len(variants)) for name, one in found.items()},
    )


def trials_of(source: SampleSource, scheme: Scheme) -> Iterator[Trial]:
    """Yield few compositions of a scheme that hold every choice of every option, with numbers.

    The worked example's options come first. A scheme without an example and without a space has
    none.
    """
    example = _example_of(source.course, scheme)
    mixed = source.mixed(scheme.id)
    used = () if example is None else (example.options,)
    if example is not None:
        same = next((one for one in mixed if one.options == example.options), None)
        (drawn,) = (None,) if same is None else _drawn(source, [same])
        variants = (example, *(() if drawn is None else drawn.variants))
        yield make_trial(_plan(source.course, example), variants)
    covering = tuple(_covering(mixed, scheme, used))
    yield from (one for one in _drawn(source, covering) if one is not None)


def trials_with(
    source: SampleSource,
    scheme: Scheme,
    options: Mapping[str, str],
    names: frozenset[str],
    most: int = _MOST_CASES,
) -> Iterator[Trial]:
    """Yield few compositions that choose these options and hold all these quantities.

    Where variants of none of them are drawn, the published cases stand in.

    Args:
        source: of numbers.
        scheme: whose compositions.
        options: that they have.
        names: of quantities that they have.
        most: how many of them, beside the worked example.
    """
    example = _example_of(source.course, scheme)
    if (
        example is not None
        and options.items() <= example.options.items()
        and names <= _known_names(source, scheme, example.options)
    ):
        yield make_trial(_plan(source.course, example), (example,))
    suited = [
        one
        for one in source.mixed(scheme.id)
        if options.items() <= one.options.items() and names <= one.names
    ]
    if not suited:
        yield from _published(source, scheme, options, names)
    # Neighbours in the list differ in the last option only: some from all over it, and not all of
    # them at the same place of what repeats.
    step = max(1, len(suited) // most)
    some = [one for turn in range(most) for one in suited[turn * (step + 1) :][:1]]
    yield from (one for one in _drawn(source, some) if one is not None)


def _published(
    source: SampleSource, scheme: Scheme, options: Mapping[str, str], names: frozenset[str]
) -> Iterator[Trial]:
    for one in source.cases:
        if one.scheme == scheme.id and options.items() <= one.options.items():
            plan = make_plan(source.course, scheme.id, one.options, Convention.CORRECTED)
            if names <= _known_names(source, scheme, one.options):
                given = {**one.given, **one.chosen}
                yield make_trial(plan, (Variant(one.id, scheme.id, one.options, given),))


def redrawn(source: SampleSource, trial: Trial, count: int) -> Trial | None:
    """Draw more variants of the composition of a trial; None where there is no range for it."""
    for one in source.mixed(trial.plan.scheme.id):
        if one.options == trial.plan.options:
            return _drawn(replace(source, count=count, drawn={}), [one])[0]
    return None


def _known_names(
    source: SampleSource, scheme: Scheme, options: Mapping[str, str]
) -> frozenset[str]:
    """Return the ids of all quantities of a composition and of all constants."""
    parts = part_ids(scheme, options)
    key = (scheme.id, *parts)
    if key not in source.names:
        known = {*source.course.constants, *scheme.quantities}
        known.update(name for part in parts for name in source.course.parts[part].quantities)
        source.names[key] = frozenset(known)
    return source.names[key]


def _example_of(course: Course, scheme: Scheme) -> Variant | None:
    example = scheme.example
    if example is None:
        return None
    chosen = example.chosen[Convention.CORRECTED]
    plan = make_plan(course, scheme.id, example.options, Convention.CORRECTED)
    given = {
        name: value
        for name, value in {**example.given, **chosen}.items()
        if name in plan.quantities and plan.quantities[name].kind is not Kind.MANUAL
    }
    return Variant(EXAMPLE, scheme.id, example.options, given)


def _plan(course: Course, variant: Variant) -> Plan:
    return make_plan(course, variant.scheme, variant.options, Convention.CORRECTED)


def _covering(
    mixed: Sequence[Mixed], scheme: Scheme, used: Sequence[Mapping[str, str]]
) -> Iterator[Mixed]:
    """Choose combinations until every choice that a space draws was tried.

    Always the one with the most choices still missing, and of those the one whose other choices
    were tried least, so that they come in new company.
    """
    tried = Counter({pair: 0 for one in mixed for pair in one.options.items()})
    tried.update(pair for options in used for pair in options.items() if pair in tried)
    if not scheme.options and not used:
        yield from mixed[:1]
    while min(tried.values(), default=1) == 0:
        best = max(
            mixed,
            key=lambda one: (
                sum(tried[pair] == 0 for pair in one.options.items()),
                -sum(tried[pair] for pair in one.options.items()),
            ),
        )
        yield best
        tried.update(best.options.items())


def _drawn(source: SampleSource, mixed: Sequence[Mixed]) -> tuple[Trial | None, ...]:
    """Draw variants of each of some combinations; None where the ranges leave no solution.

    Those of one space are drawn together, which takes little more than one of them.
    """
    missing: dict[int, list[Mixed]] = {}
    for one in mixed:
        if one.composition not in source.drawn:
            missing.setdefault(id(one.space), []).append(one)
    for own in missing.values():
        variants = _variants_of(source, own)
        for one in own:
            suited = tuple(
                replace(variant, id=f"{number:03d}")
                for number, variant in enumerate(
                    (two for two in variants if two.options == one.options), start=1
                )
            )
            source.drawn[one.composition] = (
                make_trial(_plan(source.course, suited[0]), suited) if suited else None
            )
    return tuple(source.drawn[one.composition] for one in mixed)


def _variants_of(source: SampleSource, own: Sequence[Mixed]) -> tuple[Variant, ...]:
    """Draw variants of combinations of one space; none of those that cannot be solved."""
    space = own[0].space
    only = replace(space, cases=Cases.of([space.cases[one.place] for one in own]))
    wanted = dict.fromkeys(range(len(own)), source.count)
    order = DrawingOrder(space.scheme, wanted, np.random.SeedSequence(source.seed))
    try:
        rows = draw_space(source.course, only, order, None).rows
    except TableError:  # whoever draws variants is told; here there is nothing to try
        alone = (_variants_of(source, [one]) for one in own if len(own) > 1)
        return tuple(variant for found in alone for variant in found)
    return tuple(Variant("", space.scheme, *row) for row in rows)
