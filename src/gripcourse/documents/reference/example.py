"""The worked example of a scheme: what is given, and what both conventions compute from it."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

from gripcourse.course.compose import part_ids
from gripcourse.course.model import WorkedExample
from gripcourse.course.quantity import Convention, Kind, Quantity
from gripcourse.documents.reference.entry import citation, link_to
from gripcourse.documents.reference.model import BringingOption, Citation, Link
from gripcourse.documents.reference.occurrence import Content, Occurrence
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import solve_variant
from gripcourse.text.units import unit_text
from gripcourse.text.words import Words, message

_GIVEN_FIGURES: Final = 12  # as it was given


_CONVENTIONS: Final = {
    Convention.CORRECTED: message("Corrected"),
    Convention.AS_PRINTED: message("As printed"),
}


@dataclass(frozen=True, slots=True)
class ExampleDatum:
    """A given value."""

    link: Link
    value: str
    unit: str


@dataclass(frozen=True, slots=True)
class ExampleOutcome:
    """What one convention computes, what is published, and whether the example decided it."""

    computed: str
    published: str
    decided: bool


@dataclass(frozen=True, slots=True)
class ExampleLine:
    """A computed quantity, with an outcome for each convention of the course."""

    link: Link
    unit: str
    outcomes: tuple[ExampleOutcome, ...]


@dataclass(frozen=True, slots=True)
class Example:
    """A worked example, ready to print."""

    source: Citation
    options: tuple[BringingOption, ...]
    given: tuple[ExampleDatum, ...]
    conventions: tuple[str, ...]
    lines: tuple[ExampleLine, ...]


def example_of(content: Content, words: Words) -> Example | None:
    """Compute the worked example of a scheme; None where it has none."""
    example = content.scheme.example
    if example is None:
        return None
    course, scheme = content.course, content.scheme
    plans = {one: make_plan(course, scheme.id, example.options, one) for one in course.conventions}
    values = {one: _values(plan, example) for one, plan in plans.items()}
    places = _places(content, plans[Convention.CORRECTED])
    return Example(
        citation(example.source, content.course, words.language),
        _options(content, example, words),
        _given(plans[Convention.CORRECTED], content, places, words),
        tuple(words.say(_CONVENTIONS[one]) for one in plans),
        tuple(
            ExampleLine(
                link_to(places[quantity.id], content, words.language),
                unit_text(quantity.unit, words.language),
                tuple(_outcome(quantity, one, values, example, words) for one in plans),
            )
            for quantity in plans[Convention.CORRECTED].answered
        ),
    )


def _values(plan: Plan, example: WorkedExample) -> Mapping[str, float]:
    return solve_variant(plan, {**example.given, **example.chosen[plan.convention]})


def _places(content: Content, plan: Plan) -> dict[str, Occurrence]:
    """Return the declaration of each quantity that a plan uses."""
    used = {*part_ids(plan.scheme, plan.options), ""}
    return {one.quantity.id: one for one in content.occurrences if one.part in used}


def _options(content: Content, example: WorkedExample, words: Words) -> tuple[BringingOption, ...]:
    return tuple(
        BringingOption(option.title.of(words.language), choice.title.of(words.language))
        for option in content.scheme.options
        for choice in option.choices
        if example.options.get(option.id) == choice.id
    )


def _given(
    plan: Plan, content: Content, places: Mapping[str, Occurrence], words: Words
) -> tuple[ExampleDatum, ...]:
    given = {} if content.scheme.example is None else content.scheme.example.given
    return tuple(
        ExampleDatum(
            link_to(places[quantity.id], content, words.language),
            words.number(given[quantity.id], _GIVEN_FIGURES),
            unit_text(quantity.unit, words.language),
        )
        for quantity in (*plan.constants, *plan.givens)
        if quantity.id in given
    )


def _outcome(
    quantity: Quantity,
    convention: Convention,
    values: Mapping[Convention, Mapping[str, float]],
    example: WorkedExample,
    words: Words,
) -> ExampleOutcome:
    published = example.expected[convention].get(quantity.id)
    return ExampleOutcome(
        _written(quantity, values[convention].get(quantity.id, math.nan), words),
        "" if published is None else _written(quantity, published[0], words),
        quantity.id in example.chosen[convention],
    )


def _written(quantity: Quantity, value: float, words: Words) -> str:
    if quantity.kind is Kind.VERDICT and not math.isnan(value):
        return words.say(message("yes") if value else message("no"))
    return words.number(value)
