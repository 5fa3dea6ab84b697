"""Checking mechanisms: names, options, and as many unknown reactions as equations."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import TypeAlias

from gripcourse.course.compose import compose, part_ids
from gripcourse.course.model import Course, Scheme
from gripcourse.course.option_sets import pair_option_sets
from gripcourse.errors import CourseError, Problem
from gripcourse.proofs.equilibrium.dimensions import Columns, dimension_faults
from gripcourse.proofs.equilibrium.model import (
    Circles,
    Claim,
    Condition,
    Mechanism,
    acting_formulas,
    judged_of,
    judging_formulas,
    names_used,
)
from gripcourse.proofs.equilibrium.places import order_of, ordered_formulas
from gripcourse.proofs.equilibrium.read import read_mechanisms
from gripcourse.proofs.operators import column_dimensions
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.units import dimension
from gripcourse.text.words import message

_RENAME = message("Give the joint, the point or the let another name.")


@dataclass(frozen=True, slots=True)
class Named:
    """Choices of all options of a scheme, and the ids of the quantities that they bring."""

    options: Mapping[str, str]
    names: frozenset[str]


Compositions: TypeAlias = dict[tuple[object, ...], Named]


def load_mechanisms(course: Course) -> tuple[Mechanism, ...]:
    """Read the mechanisms that a course declares; a course without the folder declares none.

    Raises:
        CourseError: with every problem of the files.
    """
    found, problems = read_mechanisms(course)
    problems += check_mechanisms(course, found)
    if problems:
        raise CourseError(problems)
    return found


def check_mechanisms(course: Course, mechanisms: Iterable[Mechanism]) -> list[Problem]:
    """Return what is wrong with the mechanisms that a course declares."""
    columns = column_dimensions(course)
    compositions: Compositions = {}
    found: list[Problem] = []
    for one in mechanisms:
        own = [*_structure_faults(one)] or [*_faults(course, one, columns, compositions)]
        # Each once, whatever schemes show it.
        found += [fault for place, fault in enumerate(own) if fault not in own[:place]]
    return found


def schemes_of(course: Course, mechanism: Mechanism) -> tuple[Scheme, ...]:
    """Return the schemes that a mechanism may be about: those that have its options."""
    named = mechanism.schemes or tuple(course.schemes)
    schemes = (course.schemes[name] for name in named if name in course.schemes)
    return tuple(
        one for one in schemes if mechanism.options.keys() <= {option.id for option in one.options}
    )


def _structure_faults(one: Mechanism) -> Iterator[Problem]:
    if not judged_of(one):
        what = message("Nothing is claimed.")
        remedy = message("Write a [[claim]]: a quantity, and what it must be.")
        yield Problem(one.file, "claim", what, remedy)
    yield from _count_faults(one)
    yield from _own_name_faults(one)
    for name in sorted(order_of(one)[1]):
        what = message("'{name}' cannot be found: it follows from itself.", name=name)
        key = f"{'let' if name in one.lets else 'point'}.{name}"
        yield Problem(
            one.file, key, what, message("Begin with points that follow from quantities.")
        )


def _count_faults(one: Mechanism) -> Iterator[Problem]:
    """Equilibrium solves as many unknowns as there are equations."""
    counts = {"unknowns": len(one.unknowns), "equations": one.equation_count}
    if counts["unknowns"] > counts["equations"]:
        what = message(
            "There are {unknowns} unknown reactions and {equations} equations: equilibrium alone"
            " leaves some open.",
            **counts,
        )
        remedy = message("Declare fewer or weaker joints, or a [relation].")
        yield Problem(one.file, "joint", what, remedy)
    if counts["unknowns"] < counts["equations"]:
        what = message(
            "There are {unknowns} unknown reactions and {equations} equations: nothing holds the"
            " bodies.",
            **counts,
        )
        remedy = message("Each body has three equations: declare its joints.")
        yield Problem(one.file, "joint", what, remedy)


def _own_name_faults(one: Mechanism) -> Iterator[Problem]:
    """Names that a mechanism gives are its own, and those that it takes from itself are given."""
    for name in sorted(one.placed & one.reactions):
        what = message("The name '{name}' is given twice.", name=name)
        yield Problem(one.file, "joint", what, _RENAME)
    for name, point in one.points.items():
        for centre in point.around if isinstance(point, Circles) else ():
            if centre not in one.points:
                what = message("The name '{name}' is not known.", name=centre)
                remedy = did_you_mean(centre, one.points)
                yield Problem(one.file, f"point.{name}.around", what, remedy)
    for relation in one.relations:
        for name in relation.factors:
            if name not in one.unknowns:
                what = message("There is no unknown reaction '{name}'.", name=name)
                remedy = did_you_mean(name, one.unknowns)
                yield Problem(one.file, f"relation.{relation.id}.of.{name}", what, remedy)


def _faults(
    course: Course, one: Mechanism, columns: Columns, compositions: Compositions
) -> Iterator[Problem]:
    """Yield faults of names and dimensions, those that several schemes show several times."""
    fitting = schemes_of(course, one)
    if not fitting:
        what = message("No scheme that it is about has these options.")
        known = {option.id for scheme in course.schemes.values() for option in scheme.options}
        yield Problem(one.file, "options", what, did_you_mean(next(iter(one.options), ""), known))
        return
    untried = {judged.key: judged for judged in judged_of(one)}
    nearest: frozenset[str] = frozenset()
    for scheme in fitting:
        tried: dict[tuple[str, ...], list[Claim | Condition]] = {}
        for judged in judged_of(one):
            wanted = names_used(one, judged)
            found = _with_names(course, scheme, one.options, wanted, compositions)
            if wanted <= found.names:
                tried.setdefault(tuple(found.options.values()), []).append(judged)
                untried.pop(judged.key, None)
            elif len(wanted & found.names) >= len(wanted & nearest):
                nearest = found.names
        for choices, several in tried.items():
            options = dict(zip((option.id for option in scheme.options), choices, strict=True))
            quantities = {**course.constants, **compose(course, scheme, options)}
            yield from _hidden(one, scheme, frozenset(quantities))
            dimensions = {name: dimension(q.unit) for name, q in quantities.items()}
            yield from dimension_faults(one, several, dimensions, columns)
    for judged in untried.values():
        yield from _name_faults(one, judged, names_used(one, judged), nearest)


def _hidden(one: Mechanism, scheme: Scheme, known: frozenset[str]) -> Iterator[Problem]:
    for name in sorted((one.placed | one.reactions) & known):
        what = message("'{name}' is a quantity of {scheme} already.", name=name, scheme=scheme.id)
        yield Problem(one.file, "joint" if name in one.reactions else "let", what, _RENAME)


def _with_names(
    course: Course,
    scheme: Scheme,
    options: Mapping[str, str],
    wanted: frozenset[str],
    compositions: Compositions,
) -> Named:
    """Return the choices, with these options, that hold all names, else as many as possible."""
    best = Named({}, frozenset())
    for plain in pair_option_sets(scheme):
        chosen = {**plain, **options}
        key = (scheme.id, *chosen.items())
        if key not in compositions:
            compositions[key] = _named(course, scheme, chosen)
        one = compositions[key]
        if len(wanted & one.names) >= len(wanted & best.names):
            best = one
            if wanted <= one.names:
                break
    return best


def _named(course: Course, scheme: Scheme, options: Mapping[str, str]) -> Named:
    parts = (course.parts[part].quantities for part in part_ids(scheme, options))
    names = {name for part in parts for name in part}
    return Named(options, frozenset({*course.constants, *scheme.quantities, *names}))


def _name_faults(
    one: Mechanism, judged: Claim | Condition, wanted: frozenset[str], known: frozenset[str]
) -> Iterator[Problem]:
    everything = {*known, *one.placed, *one.reactions}
    formulas = [*ordered_formulas(one), *acting_formulas(one), *judging_formulas(judged)]
    for name in sorted(wanted - known):
        key = next((key for key, formula in formulas if name in formula.names), "")
        what = message("The name '{name}' is not known.", name=name)
        yield Problem(one.file, key, what, did_you_mean(name, everything))
