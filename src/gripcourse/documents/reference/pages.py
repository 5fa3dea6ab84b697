"""The pages of the formula reference: one for each scheme, an index, and the errata.

Everything on them comes from the declarations, so the same course gives the same bytes.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Final

from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind
from gripcourse.documents.pdf import Document, render_html
from gripcourse.documents.reference.coverage import coverage_of
from gripcourse.documents.reference.diagram import diagram_of
from gripcourse.documents.reference.entry import (
    bringing_option,
    entry_of,
    link_to,
    titles_elsewhere,
)
from gripcourse.documents.reference.errata import faults_of
from gripcourse.documents.reference.example import example_of
from gripcourse.documents.reference.model import BringingOption, Link, NamedValue, ReferenceEntry
from gripcourse.documents.reference.motion import motion_of
from gripcourse.documents.reference.occurrence import (
    Content,
    Occurrence,
    conditions_of,
    content_of,
    parts_of,
)
from gripcourse.documents.reference.tables import tables_of
from gripcourse.machine.resources import template_file
from gripcourse.text.words import Texts, Words

STYLE: Final = "reference.css"
INDEX: Final = "reference.html.j2"
_SCHEME, _ERRATA, _COVERAGE = (
    f"reference{name}.html.j2" for name in ("_scheme", "_errata", "_coverage")
)
_TABULATED: Final = frozenset({Kind.GIVEN, Kind.CONSTANT})


@dataclass(frozen=True, slots=True)
class ReferenceChoice:
    """A choice of an option and the parts that it brings."""

    id: str
    title: str
    others: tuple[NamedValue, ...]
    parts: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Offered:
    """An option of a scheme."""

    id: str
    title: str
    others: tuple[NamedValue, ...]
    choices: tuple[ReferenceChoice, ...]


@dataclass(frozen=True, slots=True)
class ReferenceRule:
    """A rule among the options: titles of options and choices, ids of givens that are one."""

    when: tuple[tuple[str, tuple[str, ...]], ...]
    requires: tuple[tuple[str, tuple[str, ...]], ...]
    same: tuple[str, ...]
    note: str


@dataclass(frozen=True, slots=True)
class SharedPart:
    """A shared part of a scheme: what brings it, and what it declares."""

    id: str
    when: tuple[BringingOption, ...]
    quantities: tuple[Link, ...]


@dataclass(frozen=True, slots=True)
class ReferenceChapter:
    """The quantities of a section: given numbers in a table, the rest one by one."""

    id: str
    title: str
    others: tuple[NamedValue, ...]
    given: tuple[ReferenceEntry, ...]
    entries: tuple[ReferenceEntry, ...]


@dataclass(frozen=True, slots=True)
class Listed:
    """A scheme on the index page."""

    id: str
    title: str
    others: tuple[NamedValue, ...]
    options: tuple[str, ...]
    answered: int


def pages(course: Course, words: Words, home: str = "") -> dict[str, str]:
    """Return every page of the reference by the name of its file.

    Args:
        course: whose declarations are printed.
        words: the language of the pages; titles stand in the other languages too.
        home: the address that leads out of the reference, to what it is a part of; if any.

    Raises:
        CourseError: a template is missing or cannot be filled.
        OSError: the style sheet cannot be read.
    """
    templates = course.root / "templates"
    return {
        name: render_html(document, templates, words)
        for name, document in page_documents(course, words, home).items()
    }


def page_documents(course: Course, words: Words, home: str = "") -> dict[str, Document]:
    """Return what every page is made of by the name of its file; see `pages`."""
    style = template_file(course.root / "templates", f"style/{STYLE}").read_text(encoding="utf-8")
    contents = [content_of(course, scheme) for scheme in course.schemes.values()]
    common: dict[str, object] = {
        "style": style,
        "course": course.title.of(words.language),
        "home": home,
        "schemes": [_listed(content, words.language) for content in contents],
        "errata": len(course.errata),
        "equations": sum(len(work.equations.numbers) for work in course.works.values()),
    }

    def page(template: str, values: Mapping[str, object]) -> Document:
        return Document(template, (), {**common, **values})

    made = {
        f"{content.scheme.id}.html": page(_SCHEME, scheme_values(content, words))
        for content in contents
    }
    made["index.html"] = page(INDEX, index_values(course, words))
    covered = coverage_of(course, contents, words)
    if covered:
        made["equations.html"] = page(_COVERAGE, {"covered": covered})
    if course.errata:
        made["errata.html"] = page(_ERRATA, {"faults": faults_of(course, contents, words)})
    return made


def index_values(course: Course, words: Words) -> dict[str, object]:
    """Return what the index page needs besides what every page has."""
    return {
        "others": titles_elsewhere(course.title, course, words.language),
        "works": [(work.id, work.title.of(words.language)) for work in course.works.values()],
    }


def scheme_values(content: Content, words: Words) -> dict[str, object]:
    """Return what the page of a scheme needs besides what every page has."""
    scheme, language = content.scheme, words.language
    return {
        "id": scheme.id,
        "title": scheme.title.of(language),
        "others": titles_elsewhere(scheme.title, content.course, language),
        "task": scheme.task.of(language),
        "diagram": diagram_of(content, words),
        "always": scheme.parts,
        "options": _options(content, language),
        "rules": _rules(content, language),
        "pieces": _pieces(content, language),
        "chapters": _chapters(content, words),
        "motion": motion_of(content, words),
        "example": example_of(content, words),
        "tables": tables_of(content, words),
    }


def _listed(content: Content, language: str) -> Listed:
    scheme = content.scheme
    answered = {one.quantity.id for one in content.occurrences if one.quantity.kind.answered}
    return Listed(
        scheme.id,
        scheme.title.of(language),
        titles_elsewhere(scheme.title, content.course, language),
        tuple(option.title.of(language) for option in scheme.options),
        len(answered),
    )


def _options(content: Content, language: str) -> tuple[Offered, ...]:
    return tuple(
        Offered(
            option.id,
            option.title.of(language),
            titles_elsewhere(option.title, content.course, language),
            tuple(
                ReferenceChoice(
                    choice.id,
                    choice.title.of(language),
                    titles_elsewhere(choice.title, content.course, language),
                    choice.parts,
                )
                for choice in option.choices
            ),
        )
        for option in content.scheme.options
    )


def _rules(content: Content, language: str) -> tuple[ReferenceRule, ...]:
    options = {option.id: option for option in content.scheme.options}

    def told(asked: Mapping[str, Sequence[str]]) -> tuple[tuple[str, tuple[str, ...]], ...]:
        return tuple(
            (
                options[id_].title.of(language),
                tuple(one.title.of(language) for one in options[id_].choices if one.id in wanted),
            )
            for id_, wanted in asked.items()
        )

    return tuple(
        ReferenceRule(told(rule.when), told(rule.requires), rule.same, rule.note.of(language))
        for rule in content.scheme.rules
    )


def _pieces(content: Content, language: str) -> tuple[SharedPart, ...]:
    return tuple(
        SharedPart(
            part.id,
            tuple(bringing_option(one, language) for one in conditions_of(content.scheme, part.id)),
            tuple(
                link_to(one, content, language)
                for one in content.occurrences
                if one.part == part.id
            ),
        )
        for part in parts_of(content.course, content.scheme)
    )


def _chapters(content: Content, words: Words) -> tuple[ReferenceChapter, ...]:
    """Arrange the quantities by section; what has none, the course's constants, comes first."""
    loose = [one for one in content.occurrences if not one.quantity.section]
    nameless = Texts({})
    chapters = [_chapter("constants", nameless, loose, content, words)] if loose else []
    for section in content.course.sections:
        inside = [one for one in content.occurrences if one.quantity.section == section.id]
        if inside:
            chapters.append(_chapter(section.id, section.title, inside, content, words))
    return tuple(chapters)


def _chapter(
    identifier: str, title: Texts, inside: list[Occurrence], content: Content, words: Words
) -> ReferenceChapter:
    entries = [(one.quantity.kind, entry_of(one, content, words)) for one in inside]
    entries.sort(key=lambda one: one[0] is Kind.MANUAL)  # a drawing is made of what is computed
    return ReferenceChapter(
        f"section-{identifier}",
        title.by_language.get(words.language, ""),
        titles_elsewhere(title, content.course, words.language) if title.by_language else (),
        tuple(entry for kind, entry in entries if kind in _TABULATED),
        tuple(entry for kind, entry in entries if kind not in _TABULATED),
    )
