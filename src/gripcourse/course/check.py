"""Checking a course as a whole: what no single file can know.

Every scheme is composed with every combination of its options, and each composition is checked. A
fault of a shared part shows in many compositions and is reported once.
"""

from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass

from gripcourse.course.catalogue import columns_of
from gripcourse.course.check_declarations import check_declarations
from gripcourse.course.check_diagram import check_diagram, check_diagram_use
from gripcourse.course.check_example import check_example
from gripcourse.course.check_formulas import check_formulas
from gripcourse.course.check_graph import check_graph, circular_names
from gripcourse.course.check_kinematics import check_kinematics, moving_units
from gripcourse.course.check_notes import check_notes
from gripcourse.course.check_one_end import check_one_end
from gripcourse.course.check_options import check_option_names, check_option_rules
from gripcourse.course.check_parts import (
    check_empty_parts,
    check_parts,
    lacks_a_part,
    unlike_names,
)
from gripcourse.course.check_series import check_series
from gripcourse.course.check_step_up import check_step_up
from gripcourse.course.check_symbols import check_symbols
from gripcourse.course.check_view import check_view
from gripcourse.course.columns_read import check_titles
from gripcourse.course.compose import (
    all_part_ids,
    compose,
    declaring_files,
    of_schemes,
    used_names,
)
from gripcourse.course.model import Course, Scheme
from gripcourse.course.option_sets import option_sets, pair_option_sets
from gripcourse.course.quantity import Kind, Quantity
from gripcourse.errors import Problem
from gripcourse.formula.evaluate import Column
from gripcourse.text.units import Dimension, dimension
from gripcourse.text.units import known as known_unit
from gripcourse.text.words import message


def check_course(
    course: Course,
    *,
    thorough: bool = False,
    whole: Course | None = None,
    only: Mapping[str, Course] | None = None,
) -> list[Problem]:
    """Return every problem that shows only when the files of a course are put together.

    Args:
        course: as read.
        thorough: look at every combination of options, which takes seconds, and not only at enough
            of them for any two choices to occur together.
        whole: the course with all its schemes, where this one has a few of them only.
        only: the schemes that are looked at by themselves, each with the course that has what it is
            made from and nothing else; the others are known to be sound. What schemes are to each
            other is looked at in any case. None for all, in this course.
    """
    # What is found out about a scheme must not depend on another one: it is remembered.
    alone = course if only is None else of_schemes(course, only)
    unknown = list(check_option_names(course, whole or course))
    beside = _Beside(view_parts(course), knows_rules=not unknown, thorough=thorough)
    tables = _Tables.of(course)
    found: list[Problem] = unknown
    seen: set[object] = set()
    for scheme in alone.schemes.values():
        if only is not None:
            tried, own = set(seen), only[scheme.id]
            if next(_check_alone(own, scheme, _Tables.of(own), beside, tried), None) is None:
                seen = tried
                continue
        # Remedies may name what only the others have.
        found += _check_alone(alone, scheme, tables, beside, seen)
    found += [*_check_used_parts(course), *check_empty_parts(course)]
    found += _check_columns(course)
    found += check_titles(course)
    found += [*check_notes(course), *check_one_end(course)]
    return list({(one.file, str(one.key), str(one.what)): one for one in found}.values())


@dataclass(frozen=True, slots=True)
class _Tables:
    """The catalogues as formulas use them: columns, and the dimensions of sizes and of columns."""

    columns: Mapping[str, Column]
    dimensions: Mapping[str, tuple[Dimension, Dimension]]

    @staticmethod
    def of(course: Course) -> "_Tables":
        dimensions = {
            f"{catalogue.id}.{name}": (
                dimension(next(iter(catalogue.units.values()))),
                dimension(unit),
            )
            for catalogue in course.catalogues.values()
            for name, unit in catalogue.units.items()
        }
        return _Tables(columns_of(course.catalogues), dimensions)


@dataclass(frozen=True, slots=True)
class _Beside:
    """What is known of the whole course where one scheme is checked.

    Attributes:
        drawn: the ids of the parts of all general views.
        knows_rules: whether the rules among options name what exists.
        thorough: whether every combination of options is looked at.
    """

    drawn: Collection[str]
    knows_rules: bool
    thorough: bool


def _check_alone(
    course: Course, scheme: Scheme, tables: _Tables, beside: _Beside, seen: set[object]
) -> Iterator[Problem]:
    """Yield the problems of a scheme: of its rules, its parts, and all that these declare."""
    if beside.knows_rules:
        yield from check_option_rules(course, scheme)
    yield from check_parts(course, scheme)
    is_written = bool(scheme.quantities or all_part_ids(scheme))
    if is_written and not lacks_a_part(course, scheme):
        # else all that uses what is missing would be reported too
        yield from _check_scheme(course, scheme, tables, beside, seen)


def _check_scheme(
    course: Course, scheme: Scheme, tables: _Tables, beside: _Beside, seen: set[object]
) -> Iterator[Problem]:
    """Yield the problems of a scheme in the combinations of its options that are looked at."""
    circular = circular_names(course, scheme)
    doubled = unlike_names(course, scheme)
    elsewhere = declaring_files(course)
    every: dict[str, Quantity] = dict(course.constants)
    for options in option_sets(scheme) if beside.thorough else pair_option_sets(scheme):
        quantities = compose(course, scheme, options)
        every |= quantities
        new = _not_checked_yet(quantities, seen)
        yield from check_declarations(course, new)
        if doubled:  # whatever uses one of the two would seem to be wrong with the other
            new = [one for one in new if doubled.isdisjoint((one.id, *one.uses))]
        yield from check_formulas(
            new, quantities, tables.columns, tables.dimensions, elsewhere, course.constants
        )
        yield from check_series(new, tables.columns, tables.dimensions)
        if not circular:  # else what stands in the circle would seem to be without use
            yield from _check_use(course, quantities)
            yield from check_step_up(quantities)
        elif _is_new(("graph", *(id(quantities.get(name)) for name in circular)), seen):
            yield from check_graph(scheme, quantities)
        yield from check_symbols(scheme, quantities, seen)
        yield from _check_pictures(scheme, quantities, course.positions, options, seen)
    yield from check_diagram_use(scheme, every)
    if _units_known(every.values()):
        yield from check_view(scheme, every, tables.dimensions, beside.drawn)
    for one in check_example(course, scheme):
        if str(one.key).rpartition(".")[2] not in doubled:
            yield one


def view_parts(course: Course) -> set[str]:
    """Return the ids of the parts of all general views."""
    views = (scheme.view for scheme in course.schemes.values() if scheme.view is not None)
    return {part.id for view in views for part in view.parts}


def _check_pictures(
    scheme: Scheme,
    quantities: Mapping[str, Quantity],
    positions: Collection[str],
    options: Mapping[str, str],
    seen: set[object],
) -> Iterator[Problem]:
    """Yield the problems of kinematics and diagram; an unknown unit is reported where it stands."""
    units = moving_units(scheme, quantities)
    if all(known_unit(unit) for unit in units if unit is not None) and _is_new(
        ("motion", scheme.id, *units), seen
    ):
        yield from check_kinematics(scheme, quantities, positions)
    if _units_known(quantities.values()):
        yield from check_diagram(scheme, quantities, options, seen)


def _units_known(quantities: Iterable[Quantity]) -> bool:
    return all(known_unit(one.unit) for one in quantities)


def _is_new(key: object, seen: set[object]) -> bool:
    """Tell whether a key comes for the first time, and remember it."""
    is_new = key not in seen
    seen.add(key)
    return is_new


def _not_checked_yet(quantities: Mapping[str, Quantity], seen: set[object]) -> list[Quantity]:
    """Return the declarations that no composition has shown with the same units of what they use.

    Shared parts come back in hundreds of compositions; their formulas need one look.
    """
    unit_of = {name: one.unit for name, one in quantities.items()}
    return [
        one
        for one in quantities.values()
        if _is_new((id(one), *(unit_of.get(name) for name in one.uses)), seen)
    ]


def _check_used_parts(course: Course) -> Iterator[Problem]:
    used = {part for scheme in course.schemes.values() for part in all_part_ids(scheme)}
    if not used <= course.parts.keys():
        return  # a misspelt name is reported, the part that it means is not spare
    for part in course.parts.values():
        if part.id not in used:
            yield Problem(
                part.file,
                "",
                message("No scheme uses this part."),
                message("Name it in the parts of a scheme, or remove the file."),
            )


def _check_columns(course: Course) -> Iterator[Problem]:
    """Yield the givens that two schemes declare in different units: tables have one column."""
    first: dict[str, Quantity] = {}
    for one in course.declarations():
        if one.kind is not Kind.GIVEN or not known_unit(one.unit):
            continue
        other = first.setdefault(one.id, one)
        if other.unit != one.unit:
            yield Problem(
                one.file,
                f"quantity.{one.id}.unit",
                message(
                    "The given '{name}' is in '{unit}' here and in '{other}' in {file}.",
                    name=one.id,
                    unit=one.unit,
                    other=other.unit,
                    file=other.file,
                ),
                message("Write one unit: a table of variants has one column for it."),
            )


def _check_use(course: Course, quantities: Mapping[str, Quantity]) -> Iterator[Problem]:
    """Yield the givens of a composition that nothing in it uses."""
    used = used_names(quantities.values())
    if not (_is_readable(quantities.values()) and used <= {*quantities, *course.constants}):
        return
    for one in quantities.values():
        if one.kind is Kind.GIVEN and one.id not in used:
            yield Problem(
                one.file,
                f"quantity.{one.id}",
                message("No formula uses the given '{name}'.", name=one.id),
                message("Use it, or remove it: students would look for its purpose."),
            )


def _is_readable(quantities: Iterable[Quantity]) -> bool:
    """Tell whether every formula could be read: else nobody knows what is used."""
    return all(one.formula is not None for one in quantities if one.kind.answered)
