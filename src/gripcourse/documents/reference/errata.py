"""The errata of the sources: what is printed, what is right, and who computes the printed."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from gripcourse.course.errata import Erratum
from gripcourse.course.model import Course
from gripcourse.course.quantity import Source
from gripcourse.documents.reference.entry import citation
from gripcourse.documents.reference.model import Citation
from gripcourse.documents.reference.notation import symbol_of
from gripcourse.documents.reference.occurrence import Content
from gripcourse.formula.boxes import Box
from gripcourse.text.words import Words, message


@dataclass(frozen=True, slots=True)
class Version:
    """A quantity with a version as printed: its name, and where it stands, page by page."""

    id: str
    symbol: Box
    title: str
    places: tuple[tuple[str, str], ...]


@dataclass(frozen=True, slots=True)
class ReferenceErratum:
    """An erratum, ready to print; `reason` is why there is no version as printed."""

    id: str
    source: Citation
    printed: str
    right: str
    versions: tuple[Version, ...]
    reason: str


def faults_of(
    course: Course, contents: Iterable[Content], words: Words
) -> tuple[ReferenceErratum, ...]:
    """Return the errata of a course in their order.

    Args:
        course: whose sources have them.
        contents: of every scheme, in the order of their pages.
        words: the language of the page.
    """
    known = tuple(contents)
    return tuple(_fault(one, course, known, words) for one in course.errata.values())


def _fault(
    erratum: Erratum, course: Course, contents: tuple[Content, ...], words: Words
) -> ReferenceErratum:
    versions = tuple(_versions(erratum, contents, words.language))
    return ReferenceErratum(
        erratum.id,
        citation(Source(erratum.work, erratum.equation), course, words.language),
        erratum.printed.of(words.language),
        erratum.right.of(words.language),
        versions,
        "" if versions else _reason(erratum, words),
    )


def _reason(erratum: Erratum, words: Words) -> str:
    if erratum.no_version is not None:
        return erratum.no_version.of(words.language)
    return words.say(message("No quantity of the course declares a version as printed."))


def _versions(erratum: Erratum, contents: tuple[Content, ...], language: str) -> Iterator[Version]:
    """Yield the quantities with a version of an erratum; one of a shared part once."""
    found: dict[str, Version] = {}
    for content in contents:
        for one in content.occurrences:
            quantity = one.quantity
            if erratum.id not in {printed.erratum for printed in quantity.as_printed}:
                continue
            before = found.get(quantity.id)
            place = (content.scheme.id, one.anchor)
            found[quantity.id] = Version(
                quantity.id,
                symbol_of(quantity, language),
                quantity.title.of(language),
                (*(() if before is None else before.places), place),
            )
    yield from found.values()
