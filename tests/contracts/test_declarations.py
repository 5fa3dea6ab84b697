"""What every declaration of every scheme must be, with every combination of options."""

import math
import re
from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np

from gripcourse.course.quantity import Kind, Quantity
from gripcourse.formula.dimension import check_dimension
from gripcourse.formula.evaluate import evaluate
from gripcourse.formula.tree import Formula
from gripcourse.solver.asked import NOTED
from gripcourse.text.units import dimension, factor, known, unit_text
from gripcourse.text.words import LANGUAGES, Texts
from support.each import each

if TYPE_CHECKING:
    from conftest import Composition

_WORD = re.compile(r"(?<!\w)(?!arc|sqrt)[a-z]{4,}")  # else it may be a formula in any language
_TOKEN = re.compile(r"[\w’.]+")
_CYRILLIC = re.compile("[а-яіїєґ]", re.IGNORECASE)
# A letter that one of the two languages does not have betrays a text in the wrong place.
_FOREIGN = {"ru": re.compile("[іїєґ]", re.IGNORECASE), "uk": re.compile("[ыэъё]", re.IGNORECASE)}


def sentences(one: Quantity) -> dict[str, Texts]:
    """Everything of a declaration that a person reads as a sentence or a name."""
    found = {"title": one.title}
    if one.explain is not None:
        found["explain"] = one.explain
    found |= {f"hint of {slip.id}": slip.hint for slip in one.slips}
    return found | {f"note of {printed.erratum}": printed.note for printed in one.as_printed}


@each("compositions", "composition")
def test_sentences_are_there_in_every_language(composition: "Composition") -> None:
    faults = [
        f"{one.id}: {name} in {language}"
        for one in composition.plan.quantities.values()
        for name, texts in sentences(one).items()
        for language in LANGUAGES
        if not texts.of(language).strip()
    ]
    assert faults == []


@each("compositions", "composition")
def test_each_language_is_itself(composition: "Composition") -> None:
    faults = [
        f"{one.id}: {name} in {language}: {texts.of(language)}"
        for one in composition.plan.quantities.values()
        for name, texts in sentences(one).items()
        for language, foreign in _FOREIGN.items()
        if (_WORD.search(texts.of("en")) and not _CYRILLIC.search(texts.of(language)))
        or foreign.search(texts.of(language))
    ]
    faults += [
        f"{one.id}: {name} in en: {texts.of('en')}"
        for one in composition.plan.quantities.values()
        for name, texts in sentences(one).items()
        if _CYRILLIC.search(texts.of("en"))
    ]
    assert faults == []


@each("compositions", "composition")
def test_what_stands_beside_a_question_says_nothing_twice(composition: "Composition") -> None:
    faults = {
        f"{one.id}: {said} / {again}"
        for one in composition.plan.answered
        for language in LANGUAGES
        for said, again in combinations(read_beside(one, language), 2)
        if says_again(said, again)
    }
    assert faults == set()


def read_beside(one: Quantity, language: str) -> list[str]:
    """Return the texts of a question as the sheet has them one after the other."""
    note = one.source.note
    printed = one.note_decides or one.kind in NOTED
    texts = (one.title, one.decides, note if printed else None)
    return [text.of(language).casefold() for text in texts if text is not None]


def says_again(said: str, again: str) -> bool:
    """Tell whether one text stands in the other, or five words of it do in their order."""
    words = [_TOKEN.findall(text) for text in (said, again)]
    length = min(5, *map(len, words))
    runs = [{tuple(of[at : at + length]) for at in range(len(of) - length + 1)} for of in words]
    return not runs[0].isdisjoint(runs[1])


@each("compositions", "composition")
def test_symbols_are_there_and_differ(composition: "Composition") -> None:
    shown = [one for one in composition.plan.quantities.values() if one.kind is not Kind.MANUAL]
    for language in LANGUAGES:
        symbols = [one.symbol.of(language) for one in shown]
        assert all(symbols)
        assert len(set(symbols)) == len(symbols)


@each("compositions", "composition")
def test_units_are_known_and_can_be_written(composition: "Composition") -> None:
    faults = [
        one.id
        for one in composition.plan.quantities.values()
        if not known(one.unit) or bool(unit_text(one.unit, "ru")) != bool(one.unit)
    ]
    assert faults == []


@each("compositions", "composition")
def test_formulas_measure_what_their_units_do(composition: "Composition") -> None:
    plan = composition.plan
    dimensions = {name: dimension(one.unit) for name, one in plan.quantities.items()}
    columns = {
        f"{catalogue.id}.{name}": (
            dimension(next(iter(catalogue.units.values()))),
            dimension(unit),
        )
        for catalogue in plan.course.catalogues.values()
        for name, unit in catalogue.units.items()
    }
    checked = 0
    for one in plan.quantities.values():
        conditions = (one.valid, one.choice.condition if one.choice else None)
        for formula in one.formulas():
            is_condition = formula in conditions or one.kind is Kind.VERDICT
            check_dimension(formula, "" if is_condition else one.unit, dimensions, columns)
            checked += 1
    assert checked >= len(plan.answered)


@each("compositions", "composition")
def test_every_answer_has_a_finite_reference(composition: "Composition") -> None:
    faults = [
        f"{reference.name}: {one.id}"
        for reference in composition.references
        for one in composition.plan.answered
        if not math.isfinite(reference.values[one.id])
    ]
    assert faults == []


@each("compositions", "composition")
def test_bounds_hold_the_reference(composition: "Composition") -> None:
    faults = []
    for reference in composition.references:
        for name, value in reference.values.items():
            one = composition.plan.quantities[name]
            declared = float(value) / factor(one.unit)
            low, high = one.bounds
            if not low * (1 - 1e-9) <= declared <= high * (1 + 1e-9):
                faults.append(f"{reference.name}: {name} = {declared} {one.unit}")
    assert faults == []


@each("compositions", "composition")
def test_bounds_leave_room_for_a_wrong_answer(composition: "Composition") -> None:
    faults = [
        one.id
        for one in composition.plan.answered
        if one.kind is not Kind.VERDICT
        and not np.isinf(one.bounds).any()
        and one.bounds[1] < 2 * one.bounds[0]
        and one.bounds[0] >= 0
    ]
    assert faults == []


@each("compositions", "composition")
def test_whole_numbers_are_whole(composition: "Composition") -> None:
    faults = [
        f"{reference.name}: {one.id}"
        for reference in composition.references
        for one in composition.plan.quantities.values()
        if one.integer and not float(reference.values[one.id]).is_integer()
    ]
    assert faults == []


@each("compositions", "composition")
def test_guards_let_the_reference_pass(composition: "Composition") -> None:
    faults = [
        f"{reference.name}: {one.id}: {guard.text}"
        for reference in composition.references
        for one in composition.plan.quantities.values()
        for guard in guards(one)
        if evaluate(guard, "", reference.values, composition.plan.columns) != 1
    ]
    assert faults == []


def guards(one: Quantity) -> list[Formula]:
    """What a value must satisfy to be carried on, or to be a sound decision."""
    condition = one.choice.condition if one.choice is not None else None
    return [guard for guard in (one.valid, condition) if guard is not None]


@each("compositions", "composition")
def test_every_answer_belongs_to_a_section_with_points(composition: "Composition") -> None:
    sections = {section.id for section in composition.plan.course.sections}
    assert {one.section for one in composition.plan.answered} <= sections
