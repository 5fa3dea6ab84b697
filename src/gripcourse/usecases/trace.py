"""Tracing numbers: which variant, and so which student, they come from."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from gripcourse.course.compose import compose
from gripcourse.course.composition import Composition
from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind, Quantity
from gripcourse.errors import NextStep, Problem, UsageError
from gripcourse.issuing.store import read_register
from gripcourse.likeness.issued import issued_values
from gripcourse.likeness.trace import Clue, Origin, rank
from gripcourse.machine.content import Readable
from gripcourse.submission.measure import Understood, from_text
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import Message, message
from gripcourse.variants.model import Variant
from gripcourse.variants.table import read_table

_TRACED = {Kind.GIVEN, Kind.FORMULA, Kind.CHOICE, Kind.PICK}


@dataclass(frozen=True, slots=True)
class Traced:
    """What numbers come from.

    Attributes:
        origins: variants, the likeliest first.
        variants: by id.
        students: names by variant id; none where a table was searched.
        declared: declarations by id, by variant id.
    """

    origins: tuple[Origin, ...]
    variants: Mapping[str, Variant]
    students: Mapping[str, tuple[str, ...]]
    declared: Mapping[str, Mapping[str, Quantity]]


@dataclass(frozen=True, slots=True)
class Sought:
    """Where to look: in a table of variants, or in what was issued."""

    variants: Mapping[str, Variant]
    students: Mapping[str, tuple[str, ...]]


def in_table(source: Readable, course: Course) -> Sought:
    """Look in a table of variants.

    Raises:
        TableError: it cannot be used.
    """
    return Sought({one.id: one for one in read_table(source, course)}, {})


def in_register(root: Path, course: Course) -> Sought:
    """Look in what was issued from a course folder.

    Raises:
        RegisterError: the register is damaged or of another course.
        UsageError: nothing was issued there.
    """
    register = read_register(root, course.id)
    entries = (*register.entries, *register.earlier)
    if not entries:
        what = message("Nothing was issued from this course.")
        remedy = message("Name another folder, or a table of variants.")
        raise UsageError([Problem(str(root), "", what, remedy, step=NextStep.NAME_TABLE)])
    variants: dict[str, Variant] = {}
    students: dict[str, tuple[str, ...]] = {}
    for entry in entries:
        same = (key for key, one in variants.items() if one == entry.variant)
        # An id can be issued again with other values, after the table was changed.
        key = next(same, _free(entry.variant.id, variants))
        variants[key] = entry.variant
        named = entry.student.name or entry.student.id
        students[key] = (*students.get(key, ()), f"{named} ({entry.student.id})")
    return Sought(variants, students)


def _free(name: str, taken: Mapping[str, Variant]) -> str:
    suffixes = (f"{name}/{number}" for number in range(2, len(taken) + 3))
    return next(one for one in (name, *suffixes) if one not in taken)


def trace(
    numbers: Sequence[str], named: Sequence[tuple[str, str]], course: Course, sought: Sought
) -> Traced:
    """Rank the variants that numbers may come from.

    Args:
        numbers: as people type them, with or without a unit, of unknown meaning.
        named: ids of quantities, each with its number.
        course: its declarations say what a number can be.
        sought: where to look.

    Raises:
        UsageError: with every text that is no number or no quantity.
    """
    declared = _declared(course, sought.variants)
    # Where schemes declare a quantity differently, a number is read as the first of them asks.
    quantities: dict[str, Quantity] = {}
    for one in declared.values():
        quantities = dict(one) | quantities
    problems: list[Problem] = []
    clues = [_clue(text, text, quantities, problems) for text in numbers]
    clues += [_named_clue(*pair, quantities, problems) for pair in named]
    if not clues:
        what = message("There is no number to trace.")
        problems.append(Problem("", "", what, message("Write some, for example 1843 22,6 0,37.")))
    if problems:
        raise UsageError(problems)
    issued = issued_values(course, list(sought.variants.items()))
    return Traced(rank(clues, issued), sought.variants, sought.students, declared)


def _declared(course: Course, variants: Mapping[str, Variant]) -> dict[str, Mapping[str, Quantity]]:
    """Return for each variant every declaration that a number can belong to."""
    composed = dict[Composition, Mapping[str, Quantity]]()
    for one in variants.values():
        kind = one.composition
        if kind not in composed and one.scheme in course.schemes:
            found = compose(course, course.schemes[one.scheme], one.options)
            composed[kind] = {name: each for name, each in found.items() if each.kind in _TRACED}
    # What was issued from an earlier version of the course has no declarations any more.
    return {name: composed.get(one.composition, {}) for name, one in variants.items()}


def _named_clue(
    name: str, number: str, quantities: Mapping[str, Quantity], problems: list[Problem]
) -> Clue:
    text = f"{name}={number}"
    if name not in quantities:
        what = message("There is no quantity '{name}' that could be traced.", name=name)
        remedy = did_you_mean(name, quantities)
        problems.append(Problem("", "", what, remedy, parameter="quantities"))
        return Clue(text, {})
    return _clue(text, number, {name: quantities[name]}, problems)


def _clue(
    shown: str, number: str, quantities: Mapping[str, Quantity], problems: list[Problem]
) -> Clue:
    """Read a number for every quantity that its unit fits."""
    read = {name: from_text(quantity, number) for name, quantity in quantities.items()}
    refused = [one for one in read.values() if isinstance(one, Message)]
    fitting = {
        name: (one.value, one.half_unit)
        for name, one in read.items()
        if isinstance(one, Understood) and one.unit_fits and math.isfinite(one.value)
    }
    if refused and not fitting:
        remedy = message("Write one number, with or without a unit, for example '2,26 kN'.")
        problems.append(Problem("", shown, refused[0], remedy))
    elif not fitting:
        what = message("The unit fits no quantity that is meant.")
        problems.append(Problem("", shown, what, message("Leave the unit out, or correct it.")))
    return Clue(shown, fitting)
