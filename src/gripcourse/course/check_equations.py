"""Checking that a course accounts for every numbered equation of the works that list them."""

from collections.abc import Iterator, Mapping

from gripcourse.course.equations import equations_in
from gripcourse.course.model import Course, Work
from gripcourse.course.quantity import Quantity, Source
from gripcourse.errors import Problem
from gripcourse.text.words import message

_FILE = "variants/course.toml"


def check_equations(course: Course) -> Iterator[Problem]:
    """Yield equations that nothing cites and nothing excuses, idle excuses, and unknown numbers."""
    citing = citing_quantities(course)
    faulty = {
        (one.work, number)
        for one in course.errata.values()
        for number in equations_in(one.equation)
    }
    for work in course.works.values():
        if not work.equations.numbers:
            continue
        yield from _unaccounted(work, citing, faulty)
        yield from _idle(work, citing)
        yield from _unknown(work, citing)


def citing_quantities(course: Course) -> Mapping[tuple[str, str], tuple[Quantity, ...]]:
    """Return the declarations that cite an equation, by work and number, each declaration once."""
    found: dict[tuple[str, str], list[Quantity]] = {}
    for one in _declared(course):
        for key in _cited(one.source):
            same = found.setdefault(key, [])
            if all(each is not one for each in same):
                same.append(one)
    return {key: tuple(quantities) for key, quantities in found.items()}


def _declared(course: Course) -> Iterator[Quantity]:
    yield from course.constants.values()
    for part in course.parts.values():
        yield from part.quantities.values()
    for scheme in course.schemes.values():
        for changed in scheme.overrides.values():
            yield from changed.values()
        yield from scheme.quantities.values()


def _cited(source: Source) -> Iterator[tuple[str, str]]:
    return ((source.work, number) for number in equations_in(source.equation))


def _unaccounted(
    work: Work, citing: Mapping[tuple[str, str], object], faulty: set[tuple[str, str]]
) -> Iterator[Problem]:
    for number in work.equations.numbers:
        key = (work.id, number)
        if key not in citing and key not in faulty and number not in work.equations.not_used:
            yield Problem(
                _FILE,
                f"work.{work.id}.equations",
                message("No quantity and no erratum cites equation {number}.", number=number),
                message("Cite it where it is used, or say under not_used why it is not."),
            )


def _idle(work: Work, citing: Mapping[tuple[str, str], object]) -> Iterator[Problem]:
    for number in work.equations.not_used:
        if (work.id, number) in citing:
            what = message("Equation {number} is used: a quantity cites it.", number=number)
        elif number not in work.equations.numbers:
            what = message("The work lists no equation {number}.", number=number)
        else:
            continue
        key = f"work.{work.id}.equations.not_used.{number}"
        yield Problem(_FILE, key, what, message("Remove the reason, or correct the number."))


def _unknown(
    work: Work, citing: Mapping[tuple[str, str], tuple[Quantity, ...]]
) -> Iterator[Problem]:
    for (cited, number), quantities in citing.items():
        if cited == work.id and number not in work.equations.numbers:
            for one in quantities:
                yield Problem(
                    one.file,
                    f"quantity.{one.id}.source.equation",
                    message("The work lists no equation {number}.", number=number),
                    message("Correct the number, or add it to work.{work}.equations.numbers.",
                            work=work.id),
                )  # fmt: skip
