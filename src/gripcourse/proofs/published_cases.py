"""Published cases of a course: `variants/published_cases.toml`, which a course may do without.

A case is a calculation printed elsewhere, or made by another method than the course's formulas. It
needs other givens or options than the worked example of its scheme, whose numbers it starts from.

Its keys stand in `course.keys`.
"""

from collections.abc import Mapping
from dataclasses import dataclass

from gripcourse.course.compose import compose
from gripcourse.course.declare import source
from gripcourse.course.keys import PUBLISHED_CASES
from gripcourse.course.model import Course, Scheme
from gripcourse.course.quantity import Kind, Source
from gripcourse.course.toml_table import Table, read_toml
from gripcourse.errors import CourseError, Problem
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import message

FILE = "published_cases.toml"
_COLLECTED = "case"


@dataclass(frozen=True, slots=True)
class PublishedCase:
    """A calculation of others.

    Attributes:
        id: its name.
        scheme: that it solves.
        source: where it is printed, or the method that it was made by.
        options: of the scheme, complete.
        given: givens and constants, in declared units; those of the worked example among them.
        chosen: answers that it starts from, in declared units.
        expected: value and tolerated difference by quantity, in declared units.
        file, key: where it stands, for messages.
    """

    id: str
    scheme: str
    source: Source
    options: Mapping[str, str]
    given: Mapping[str, float]
    chosen: Mapping[str, float]
    expected: Mapping[str, tuple[float, float]]
    file: str
    key: str


def load_published_cases(course: Course) -> tuple[PublishedCase, ...]:
    """Read the published cases of a course; a course without the file has none.

    Raises:
        CourseError: with every problem of the file.
    """
    cases, problems = read_published_cases(course)
    if problems:
        raise CourseError(problems)
    return cases


def read_published_cases(course: Course) -> tuple[tuple[PublishedCase, ...], list[Problem]]:
    """Read the published cases that can be used, and list what is wrong with the others."""
    problems: list[Problem] = []
    path = course.root / "variants" / FILE
    if not path.exists():
        return (), []
    table = read_toml(path, course.root, problems, PUBLISHED_CASES, course.languages)
    if table is None:
        return (), problems
    table.known_keys()
    found: dict[str, PublishedCase] = {}
    for one in table.tables(_COLLECTED):
        before = len(problems)
        case = _case(course, one)
        if case is not None and case.id in found:
            one.add(
                "id",
                message("Two cases are named '{id}'.", id=case.id),
                message("Give each a name of its own."),
            )
        if case is not None and len(problems) == before:
            found[case.id] = case
    return tuple(found.values()), problems


def _case(course: Course, table: Table) -> PublishedCase | None:
    table.known_keys()
    identifier, scheme_id = table.text("id"), table.text("scheme")
    cited = source(table.required_table("source"))
    if cited.work and cited.work not in course.works:
        table.add(
            "source.work",
            message("The course cites no work '{work}'.", work=cited.work),
            did_you_mean(cited.work, course.works),
        )
    scheme = course.schemes.get(scheme_id)
    if scheme is None:
        if scheme_id:
            table.add(
                "scheme",
                message("The course has no scheme '{scheme}'.", scheme=scheme_id),
                did_you_mean(scheme_id, course.schemes),
            )
        return None
    options = _options(scheme, table)
    if options is None:
        return None
    quantities = compose(course, scheme, options)
    usual = {} if scheme.example is None else scheme.example.given
    inputs = {
        name: one for name, one in quantities.items() if one.kind in {Kind.GIVEN, Kind.CONSTANT}
    }
    answers = {name: one for name, one in quantities.items() if one.kind.answered}
    own = _named(table, "given", inputs)
    given = {**{name: value for name, value in usual.items() if name in inputs}, **own}
    for name, one in inputs.items():
        if one.kind is Kind.GIVEN and name not in given:
            table.add(
                f"given.{name}",
                message("Neither the case nor the worked example gives a value of '{name}'.",
                        name=name),
                message("Write it."),
            )  # fmt: skip
    return PublishedCase(
        identifier,
        scheme_id,
        cited,
        options,
        given,
        _named(table, "chosen", answers),
        _expected(table, answers),
        table.file,
        table.key,
    )


def _options(scheme: Scheme, table: Table) -> dict[str, str] | None:
    """Read the options of a case beside those of the worked example; None if one is unknown."""
    written = table.table("options")
    own = {} if written is None else {name: written.text(name) for name in written.values}
    choices = {one.id: [choice.id for choice in one.choices] for one in scheme.options}
    is_known = True
    for name, choice in own.items():
        if choice not in choices.get(name, ()):
            is_known = False
            table.add(
                f"options.{name}",
                message("There is no choice '{choice}'.", choice=choice)
                if name in choices
                else message("The scheme {scheme} has no option '{option}'.",
                             scheme=scheme.id, option=name),
                did_you_mean(choice, choices[name]) if name in choices
                else did_you_mean(name, choices),
            )  # fmt: skip
    usual = {} if scheme.example is None else scheme.example.options
    options = {**usual, **own}
    for name, known in choices.items():
        if name not in options:
            is_known = False
            table.add(
                f"options.{name}",
                message("Neither the case nor the worked example chooses '{option}'.", option=name),
                message("Write one of {choices}.", choices=", ".join(known)),
            )
    return options if is_known else None


def _named(table: Table, key: str, known: Mapping[str, object]) -> dict[str, float]:
    """Read numbers by quantity; an unknown name is a problem."""
    found = table.numbers(key, {})
    for name in found:
        _check_name(table, key, name, known)
    return {name: value for name, value in found.items() if name in known}


def _check_name(table: Table, key: str, name: str, known: Mapping[str, object]) -> None:
    if name not in known:
        table.add(
            f"{key}.{name}",
            message("The scheme has no given '{name}'.", name=name)
            if key == "given"
            else message("The scheme computes no '{name}'.", name=name),
            did_you_mean(name, known),
        )


def _expected(table: Table, answers: Mapping[str, object]) -> dict[str, tuple[float, float]]:
    written = table.required_table("expected")
    found: dict[str, tuple[float, float]] = {}
    for name, value in written.values.items():
        _check_name(table, "expected", name, answers)
        match value:
            case [int() | float() as number, int() | float() as difference] if difference >= 0:
                if name in answers:
                    found[name] = (float(number), float(difference))
            case _:
                written.add(
                    name,
                    message("The value has the wrong type."),
                    message("Write the value and its tolerated difference: [3900, 0.5]."),
                )
    return found
