"""A quantity as the reference prints it: everything that its declaration says."""

from collections.abc import Iterator
from typing import Final

from gripcourse.course.model import Course
from gripcourse.course.quantity import AsPrinted, Choice, Kind, Quantity, Rounding, Source
from gripcourse.documents.reference.model import (
    BringingOption,
    Citation,
    EntryRule,
    Link,
    NamedValue,
    Printed,
    ReferenceEntry,
    WrongMethod,
)
from gripcourse.documents.reference.notation import Symbols, statement, symbol_of, symbols_for
from gripcourse.documents.reference.occurrence import (
    Content,
    Occurrence,
    OptionCondition,
    inputs_of,
)
from gripcourse.formula.boxes import Box
from gripcourse.formula.tree import Formula
from gripcourse.formula.typeset import typeset
from gripcourse.text.amounts import amount_text, percent_text
from gripcourse.text.units import unit_text
from gripcourse.text.words import LANGUAGES, Message, Texts, Words, counted, message

_FIGURES: Final = 12  # a declared number is printed as it was declared
_KINDS: Final = {
    Kind.GIVEN: message("given"),
    Kind.CONSTANT: message("constant"),
    Kind.FORMULA: message("computed"),
    Kind.CHOICE: message("decision"),
    Kind.PICK: message("read from a table"),
    Kind.VERDICT: message("verdict"),
    Kind.MANUAL: message("marked by the instructor"),
}
_ROUNDED: Final = {
    Rounding.UP: message("the smallest entry that is not below the required value"),
    Rounding.NEAREST: message("the entry nearest to the required value"),
}
_STEPPED_UP: Final = message(
    "the smallest entry, not below the required value, for which the condition holds"
)


def entry_of(one: Occurrence, content: Content, words: Words) -> ReferenceEntry:
    """Put a declaration into words and boxes."""
    quantity, language = one.quantity, words.language
    symbols = symbols_for(one, content, language)
    formula = quantity.formula
    return ReferenceEntry(
        anchor=one.anchor,
        id=quantity.id,
        kind=words.say(_KINDS[quantity.kind]),
        unit=unit_text(quantity.unit, language),
        bounds=_bounds(quantity, words),
        tolerance=_tolerance(quantity, words),
        symbol=symbol_of(quantity, language) if quantity.symbol.of(language) else None,
        title=quantity.title.of(language),
        others=_others(quantity, content.course, language),
        part=one.part,
        when=tuple(bringing_option(each, language) for each in one.conditions),
        changed=one.changed,
        of_course=quantity.id in content.course.constants,
        formula=None if formula is None else statement(quantity, formula, symbols, language),
        entering=_entering(formula, symbols, language),
        value=_value(quantity, words),
        guard=_condition(quantity.valid, symbols, language),
        rule=_rule(quantity, symbols, words),
        rubric=quantity.rubric,
        explain="" if quantity.explain is None else quantity.explain.of(language),
        source=citation(quantity.source, content.course, language),
        inputs=tuple(_links(inputs_of(quantity), one, content, language)),
        users=tuple(_users(one, content, language)),
        slips=tuple(
            WrongMethod(
                statement(quantity, slip.formula, symbols, language),
                slip.hint.of(language),
                percent_text(slip.credit, words) if slip.credit else "",
            )
            for slip in quantity.slips
        ),
        printed=tuple(_printed(each, quantity, symbols, words) for each in quantity.as_printed),
    )


def titles_elsewhere(title: Texts, course: Course, language: str) -> tuple[NamedValue, ...]:
    """Return a title in the course's languages that are not the page's."""
    return tuple(NamedValue(one, None, title.of(one)) for one in _elsewhere(course, language))


def _elsewhere(course: Course, language: str) -> tuple[str, ...]:
    return tuple(one for one in LANGUAGES if one in course.languages and one != language)


def citation(source: Source, course: Course, language: str) -> Citation:
    """Cite a source in full: an equation by its number in brackets."""
    equation = source.equation
    numbered = f"({equation})" if equation[:1].isdigit() else equation
    work = course.works.get(source.work)
    title = source.work if work is None else work.title.of(language)
    return Citation(title, numbered, source.told(language))


def link_to(one: Occurrence, content: Content, language: str) -> Link:
    """Make a link to a declaration on the same page."""
    quantity = one.quantity
    version = one.part if len(content.by_id[quantity.id]) > 1 else ""
    return Link(one.anchor, symbol_of(quantity, language), quantity.title.of(language), version)


def bringing_option(condition: OptionCondition, language: str) -> BringingOption:
    """Name an option and those of its choices that bring a part."""
    choices = " / ".join(one.title.of(language) for one in condition.choices)
    return BringingOption(condition.option.title.of(language), choices)


def _others(quantity: Quantity, course: Course, language: str) -> tuple[NamedValue, ...]:
    """Return titles in the other languages, with the symbols that are not the page's own."""
    own = quantity.symbol.of(language)
    return tuple(
        NamedValue(
            each,
            symbol_of(quantity, each) if quantity.symbol.of(each) != own else None,
            quantity.title.of(each),
        )
        for each in _elsewhere(course, language)
    )


def _bounds(quantity: Quantity, words: Words) -> str:
    if quantity.kind in {Kind.VERDICT, Kind.MANUAL}:
        return ""
    low, high = (words.number(bound, _FIGURES) for bound in quantity.bounds)
    place = message("{low} to {high}", low=low, high=high)
    if quantity.integer:
        place = message("{low} to {high}, whole numbers", low=low, high=high)
    return words.say(place)


def _tolerance(quantity: Quantity, words: Words) -> str:
    if quantity.tolerance is None:
        return ""
    band = quantity.tolerance
    relative = percent_text(band.relative, words)
    absolute = amount_text(band.absolute, quantity.unit, words, _FIGURES)
    if not band.absolute:
        return relative
    if not band.relative:
        return absolute
    wider = message("{relative} or {absolute}, the wider", relative=relative, absolute=absolute)
    return words.say(wider)


def _value(quantity: Quantity, words: Words) -> str:
    if quantity.value is None:
        return ""
    return amount_text(quantity.value, quantity.unit, words, _FIGURES)


def _entering(
    formula: Formula | None, symbols: Symbols, language: str
) -> tuple[tuple[Box, str], ...]:
    units = {} if formula is None else formula.units
    return tuple((symbols[name], unit_text(unit, language)) for name, unit in units.items() if unit)


def _condition(formula: Formula | None, symbols: Symbols, language: str) -> Box | None:
    return None if formula is None else typeset(formula.tree, symbols, language)


def _rule(quantity: Quantity, symbols: Symbols, words: Words) -> EntryRule | None:
    choice = quantity.choice
    if choice is None:
        return None
    return EntryRule(
        choice.column,
        choice.also,
        words.say(_STEPPED_UP if quantity.steps_up else _ROUNDED[choice.rounding]),
        words.say(_accepted(choice)),
        _condition(choice.condition, symbols, words.language),
    )


def _accepted(choice: Choice) -> Message:
    """Say which other entries are accepted."""
    if choice.rounding is Rounding.NEAREST:
        if not choice.steps:
            return message("no other entry is accepted")
        return counted(
            "accepted {count} step on either side of it",
            "accepted up to {count} steps on either side of it",
            choice.steps,
        )
    if choice.steps is None:
        return message("any larger entry is accepted")
    return counted(
        "accepted {count} step above it", "accepted up to {count} steps above it", choice.steps
    )


def _printed(one: AsPrinted, quantity: Quantity, symbols: Symbols, words: Words) -> Printed:
    formula = one.formula
    return Printed(
        one.erratum,
        None if formula is None else statement(quantity, formula, symbols, words.language),
        "" if one.rounding is None else words.say(_ROUNDED[one.rounding]),
        one.note.of(words.language),
    )


def _links(
    ids: tuple[str, ...], one: Occurrence, content: Content, language: str
) -> Iterator[Link]:
    for name in ids:
        yield from (link_to(each, content, language) for each in content.meant(name, one))


def _users(one: Occurrence, content: Content, language: str) -> Iterator[Link]:
    """Yield links to what is computed from this declaration."""
    for other in content.using.get(one.quantity.id, ()):
        if one in content.meant(one.quantity.id, other):
            yield link_to(other, content, language)
