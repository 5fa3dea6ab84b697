"""Loading the mix of virtual students from `grader/virtual.toml`."""

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import MISSING, fields, replace
from pathlib import Path
from typing import TypeVar

from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind
from gripcourse.course.toml_table import Table, read_toml
from gripcourse.errors import CourseError, Problem
from gripcourse.grading.model import FlagCode
from gripcourse.machine.resources import skeleton_root
from gripcourse.simulation.arithmetic import DISPLAY, DigitRounding
from gripcourse.simulation.keys import MIX
from gripcourse.simulation.model import Carrying, Conduct, Mix, Required, Style
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import LANGUAGES, message

_Value = TypeVar("_Value")


def mix_path(root: Path) -> Path:
    """Return where a course declares its virtual students."""
    return root / "grader" / "virtual.toml"


def load_mix(course: Course) -> Mix:
    """Load and check the mix of a course; one that declares none has the usual students.

    Raises:
        CourseError: with all problems of the file.
    """
    if not mix_path(course.root).exists():
        return _usual_mix(course)
    mix, problems = read_mix(course)
    if mix is None or problems:
        raise CourseError(problems)
    return mix


def _usual_mix(course: Course) -> Mix:
    """Return the students of a new course, who speak the languages of this one."""
    usual, problems = read_mix(replace(course, root=skeleton_root()))
    if usual is None or problems:
        raise RuntimeError(problems)  # ours
    spoken = {name: one for name, one in usual.language.items() if name in course.languages}
    return replace(usual, language=spoken)


def read_mix(course: Course) -> tuple[Mix | None, list[Problem]]:
    """Read the mix with all its problems."""
    problems: list[Problem] = []
    table = read_toml(mix_path(course.root), course.root, problems, MIX, course.languages)
    if table is None:
        return None, problems
    table.known_keys()
    share, slip = table.required_table("share"), table.required_table("slip")
    share.known_keys()
    slip.known_keys()
    tolerance = table.required_table("tolerance")
    tolerance.known_keys()
    flags, required = table.required_table("flags"), table.required_table("required")
    flags.known_keys()
    required.known_keys()
    mix = Mix(
        conduct=_named(table, "conduct", Conduct),
        figures={int(key): weight for key, weight in _numbered(table, "figures").items()},
        rounding=_named(table, "rounding", DigitRounding),
        carrying=_named(table, "carrying", Carrying),
        style=_named(table, "style", Style),
        pi=_numbered(table, "pi") if table.has("pi") else {math.pi: 1.0},
        language=_weights(table, "language", str, LANGUAGES),
        constants=_constants(table, course),
        blank=share.share("blank"),
        copied=share.share("copied"),
        apart=slip.number("apart"),
        tries=_whole(slip, "tries"),
        answers=_whole(tolerance, "answers"),
        bands=_bands(tolerance),
        wide=tolerance.number("wide"),
        copying_flags=_flags(flags, "copying"),
        required=_required(required),
    )
    _check_figures(table, mix)
    return mix, problems


def _required(table: Table) -> Required:
    """Read what the grader is held to; what is not written is as we hold it ourselves."""
    return Required(
        **{
            one.name: table.share(one.name)
            for one in fields(Required)
            if one.default is MISSING or table.has(one.name)
        }
    )


_Named = TypeVar("_Named", Conduct, DigitRounding, Carrying, Style)


def _named(table: Table, name: str, kind: type[_Named]) -> Mapping[_Named, float]:
    return _weights(table, name, kind, [str(one) for one in kind])


def _weights(
    table: Table, name: str, kind: Callable[[str], _Value], known: Iterable[str]
) -> Mapping[_Value, float]:
    """Read weights by name; what is not named never happens."""
    weights: dict[_Value, float] = {}
    for key, weight in _positive(table, name).items():
        if key in known:
            weights[kind(key)] = weight
        else:
            what = message("There is no '{name}' here.", name=key)
            table.add(f"{name}.{key}", what, did_you_mean(key, known))
    return weights


def _flags(table: Table, name: str) -> frozenset[FlagCode]:
    known, found = [str(one) for one in FlagCode], table.strings(name)
    for code in found:
        if code not in known:
            what = message("There is no '{name}' here.", name=code)
            table.add(name, what, did_you_mean(code, known))
    return frozenset(FlagCode(code) for code in found if code in known)


def _numbered(table: Table, name: str) -> Mapping[float, float]:
    """Read weights by number; TOML keeps the numbers as names."""
    weights: dict[float, float] = {}
    for key, weight in _positive(table, name).items():
        try:
            weights[float(key)] = weight
        except ValueError:
            what = message("'{name}' is no number.", name=key)
            table.add(f"{name}.{key}", what, message("Write a number in quotes."))
    return weights


def _positive(table: Table, name: str) -> Mapping[str, float]:
    """Read a table of weights of which at least one is above zero."""
    weights = table.numbers(name)
    negative = [key for key, weight in weights.items() if weight < 0]
    for key in negative:
        what = message("The weight {value} is negative.", value=weights[key])
        table.add(f"{name}.{key}", what, message("Write 0 or a positive number."))
    if table.has(name) and not math.fsum(weights.values()) > 0:
        what = message("No weight is above zero.")
        table.add(name, what, message("Write a positive number."))
    return weights


def _constants(table: Table, course: Course) -> Mapping[str, Mapping[float, float]]:
    found: dict[str, Mapping[float, float]] = {}
    outer = table.table("constant")
    if outer is None:
        return found
    for name in outer.values:
        if name not in course.constants or course.constants[name].kind is not Kind.CONSTANT:
            what = message("The course has no constant '{name}'.", name=name)
            outer.add(name, what, did_you_mean(name, course.constants))
            continue
        found[name] = _numbered(outer, name)
    return found


def _bands(table: Table) -> tuple[float, ...]:
    bands = table.number_list("bands")
    if not bands or min(bands) <= 0 or list(bands) != sorted(bands):
        what = message("The bands are not in order.")
        table.add("bands", what, message("Write positive numbers, the narrowest first."))
    return bands or (math.inf,)


def _whole(table: Table, name: str) -> int:
    value = table.number(name)
    if math.isnan(value) or value < 1 or not value.is_integer():
        what = message("The number is {value}.", value=value)
        table.add(name, what, message("Write a whole number from 1 on."))
        return 1
    return int(value)


def _check_figures(table: Table, mix: Mix) -> None:
    for figures in mix.figures:
        if not 1 <= figures <= DISPLAY:
            what = message("Nobody writes so many figures: {value}.", value=figures)
            table.add("figures", what, message("Write 1 to {most}.", most=DISPLAY))
