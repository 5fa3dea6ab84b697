"""Tracing numbers: which variant, and so which student, they come from."""

import math
from collections.abc import Container, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from gripcourse.course.compose import compose
from gripcourse.course.composition import Composition
from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind, Quantity
from gripcourse.errors import NextStep, Problem, UsageError
from gripcourse.gradebook.fingerprint import fingerprints
from gripcourse.issuing.register import Register
from gripcourse.issuing.store import read_register
from gripcourse.likeness.issued import issued_values
from gripcourse.likeness.trace import Clue, Origin, rank
from gripcourse.machine.content import Readable
from gripcourse.submission.measure import Understood, from_text
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import Message, message
from gripcourse.usecases.issuing.declarations import kept_declarations
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
        notes: what was computed by other declarations than it was issued with.
    """

    origins: tuple[Origin, ...]
    variants: Mapping[str, Variant]
    students: Mapping[str, tuple[str, ...]]
    declared: Mapping[str, Mapping[str, Quantity]]
    notes: tuple[Message, ...] = ()


@dataclass(frozen=True, slots=True)
class Sought:
    """Where to look: in a table of variants, or in what was issued.

    Attributes:
        variants: by id.
        students: to whom they were issued, by variant id.
        kept: the declarations that a variant's works are judged by where they are not today's.
        changed: ids of variants that today's declarations compute, though issued with others.
    """

    variants: Mapping[str, Variant]
    students: Mapping[str, tuple[str, ...]]
    kept: Mapping[str, Course] = field(default_factory=dict)
    changed: tuple[str, ...] = ()


def in_table(source: Readable, course: Course) -> Sought:
    """Look in a table of variants.

    Raises:
        TableError: it cannot be used.
    """
    return Sought({one.id: one for one in read_table(source, course)}, {})


def in_register(root: Path, course: Course) -> Sought:
    """Look in what was issued from a course folder.

    A version that was replaced by other declarations is computed by its own, as its works are
    graded; everything else by today's.

    Raises:
        RegisterError: the register is damaged or of another course.
        UsageError: nothing was issued there.
    """
    register = read_register(root, course.id)
    if not register.entries and not register.earlier:
        what = message("Nothing was issued from this course.")
        remedy = message("Name another folder, or a table of variants.")
        raise UsageError([Problem(str(root), "", what, remedy, step=NextStep.NAME_TABLE)])
    kept = kept_declarations(root, register.by_student(), register.earlier)
    return among_issued(register, kept, fingerprints(course.root).course)


def among_issued(register: Register, states: Mapping[str, Course], today: str) -> Sought:
    """Look among the versions of a register.

    A variant that was issued again with other numbers bears the number of its version: `019/2`.

    Args:
        register: what was issued.
        states: the declarations that versions were issued with, by their fingerprints.
        today: the fingerprint of the course's declarations.
    """
    entries = [(one, True) for one in register.earlier]
    entries += [(one, False) for one in register.entries]
    variants: dict[str, Variant] = {}
    students: dict[str, tuple[str, ...]] = {}
    kept: dict[str, Course] = {}
    changed: dict[str, None] = {}
    for entry, is_replaced in sorted(entries, key=lambda one: one[0].version):
        # As works are graded: only a version that was replaced has declarations of its own.
        state = states.get(entry.declarations) if is_replaced else None
        same = (
            key for key, one in variants.items() if one == entry.variant and kept.get(key) is state
        )
        # An id can be issued again with other values, after the table was changed.
        key = next(same, _free(entry.variant.id, entry.version, variants))
        variants[key] = entry.variant
        if state is not None:
            kept[key] = state
        elif entry.declarations not in {"", today}:
            changed[key] = None
        named = entry.student.name or entry.student.id
        students[key] = (*students.get(key, ()), f"{named} ({entry.student.id})")
    return Sought(variants, students, kept, tuple(changed))


def _free(name: str, version: int, taken: Mapping[str, Variant]) -> str:
    if name not in taken:
        return name
    numbers = range(max(version, 2), version + len(taken) + 2)
    return next(one for one in (f"{name}/{number}" for number in numbers) if one not in taken)


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
    declared = _declared(course, sought)
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
    kept = {
        row: sought.kept[name] for row, name in enumerate(sought.variants) if name in sought.kept
    }
    issued = issued_values(course, list(sought.variants.items()), kept)
    origins = rank(clues, issued, {name: who[0] for name, who in sought.students.items()})
    notes = tuple(_notes(sought, {one.owner for one in origins}))
    return Traced(origins, sought.variants, sought.students, declared, notes)


def _notes(sought: Sought, found: Container[str]) -> Iterator[Message]:
    kept = [one for one in sought.kept if one in found]
    if kept:
        yield message(
            "Computed by the declarations that they were issued with, which were replaced since: "
            "{variants}.",
            variants=", ".join(kept),
        )
    changed = [one for one in sought.changed if one in found]
    if changed:
        yield message(
            "Computed by today's declarations, as they are graded, though issued with others: "
            "{variants}. A formula that was corrected since may give other numbers than on the "
            "sheet.",
            variants=", ".join(changed),
        )


def _declared(course: Course, sought: Sought) -> dict[str, Mapping[str, Quantity]]:
    """Return for each variant every declaration that a number can belong to."""
    composed = dict[tuple[int, Composition], Mapping[str, Quantity]]()
    # What nobody kept the declarations of, and today's course lacks, has none any more.
    declared: dict[str, Mapping[str, Quantity]] = {}
    for name, one in sought.variants.items():
        state = sought.kept.get(name, course)
        kind = id(state), one.composition
        if kind not in composed and one.scheme in state.schemes:
            found = compose(state, state.schemes[one.scheme], one.options)
            composed[kind] = {name: each for name, each in found.items() if each.kind in _TRACED}
        declared[name] = composed.get(kind, {})
    return declared


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
