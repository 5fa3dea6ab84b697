"""The equations of the sources: which quantities and errata cite each, or why none does."""

from collections.abc import Iterable
from dataclasses import dataclass

from gripcourse.course.equations import equations_in
from gripcourse.course.model import Course, Work
from gripcourse.documents.reference.errata import Version
from gripcourse.documents.reference.notation import symbol_of
from gripcourse.documents.reference.occurrence import Content
from gripcourse.text.words import Words


@dataclass(frozen=True, slots=True)
class CoveredEquation:
    """An equation of a work; `reason` is why nothing computes it."""

    number: str
    quantities: tuple[Version, ...]
    errata: tuple[str, ...]
    reason: str


@dataclass(frozen=True, slots=True)
class CoveredWork:
    """A work that lists its equations."""

    id: str
    title: str
    equations: tuple[CoveredEquation, ...]


def coverage_of(
    course: Course, contents: Iterable[Content], words: Words
) -> tuple[CoveredWork, ...]:
    """Return the equations of every work that lists them, in the order of the work.

    Args:
        course: whose declarations cite them.
        contents: of every scheme, in the order of their pages.
        words: the language of the page.
    """
    citing = _citing(tuple(contents), words.language)
    return tuple(
        CoveredWork(
            work.id,
            work.title.of(words.language),
            tuple(_covered(course, work, one, citing, words) for one in work.equations.numbers),
        )
        for work in course.works.values()
        if work.equations.numbers
    )


def _covered(
    course: Course,
    work: Work,
    number: str,
    citing: dict[tuple[str, str], dict[str, Version]],
    words: Words,
) -> CoveredEquation:
    reason = work.equations.not_used.get(number)
    return CoveredEquation(
        number,
        tuple(citing.get((work.id, number), {}).values()),
        tuple(
            one.id
            for one in course.errata.values()
            if one.work == work.id and number in equations_in(one.equation)
        ),
        "" if reason is None else reason.of(words.language),
    )


def _citing(
    contents: tuple[Content, ...], language: str
) -> dict[tuple[str, str], dict[str, Version]]:
    """Return the quantities that cite an equation by their id; one of several schemes once."""
    found: dict[tuple[str, str], dict[str, Version]] = {}
    for content in contents:
        for one in content.occurrences:
            quantity = one.quantity
            for number in equations_in(quantity.source.equation):
                same = found.setdefault((quantity.source.work, number), {})
                before = same.get(quantity.id)
                same[quantity.id] = Version(
                    quantity.id,
                    symbol_of(quantity, language),
                    quantity.title.of(language),
                    (
                        *(() if before is None else before.places),
                        (content.scheme.id, one.anchor),
                    ),
                )
    return found
