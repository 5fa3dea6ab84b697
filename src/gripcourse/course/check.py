"""Checking a course as a whole: what no single file can know.

Every scheme is composed with every combination of its options, and each composition is checked. A
fault of a shared part shows in many compositions and is reported once.
"""

from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from graphlib import CycleError, TopologicalSorter

from gripcourse.course.catalogue import columns_of
from gripcourse.course.check_example import check_example
from gripcourse.course.check_formulas import check_formulas
from gripcourse.course.check_kinematics import check_kinematics, kinematic_names
from gripcourse.course.check_series import check_series
from gripcourse.course.check_view import check_view
from gripcourse.course.compose import compose, direct_inputs, option_sets, part_ids, used_names
from gripcourse.course.model import Convention, Course, Kind, Quantity, Scheme
from gripcourse.course.toml_table import did_you_mean
from gripcourse.errors import Problem
from gripcourse.units import dimension
from gripcourse.units import known as known_unit
from gripcourse.words import LANGUAGES, message


def check_course(course: Course) -> list[Problem]:
    """Return every problem that shows only when the files of a course are put together."""
    columns = columns_of(course.catalogues)
    dimensions = {
        f"{catalogue.id}.{name}": (
            dimension(next(iter(catalogue.units.values()))),
            dimension(unit),
        )
        for catalogue in course.catalogues.values()
        for name, unit in catalogue.units.items()
    }
    found: list[Problem] = []
    seen: set[object] = set()
    for scheme in course.schemes.values():
        found += _check_parts(course, scheme)
        if not _all_parts(scheme) <= course.parts.keys():
            continue  # else all that uses the missing part would be reported too
        motion = sorted(kinematic_names(scheme))
        knot = _knot(_all_inputs(course, scheme))
        every: dict[str, Quantity] = dict(course.constants)
        for options in option_sets(scheme):
            quantities = compose(course, scheme, options)
            every |= quantities
            new = _not_checked_yet(quantities, seen)
            found += _check_declarations(course, new)
            found += _check_use(course, quantities)
            found += check_formulas(new, quantities, columns, dimensions)
            found += _check_graph(scheme, quantities, knot, seen)
            found += check_series(new, columns, dimensions)
            found += _check_symbols(scheme, quantities, seen)
            found += _check_motion(scheme, quantities, motion, seen)
        if all(known_unit(one.unit) for one in every.values()):
            found += check_view(scheme, every, dimensions)
        found += check_example(course, scheme)
    found += _check_used_parts(course)
    return list({(one.file, one.key, str(one.what)): one for one in found}.values())


def _not_checked_yet(quantities: Mapping[str, Quantity], seen: set[object]) -> list[Quantity]:
    """Return the declarations that no composition has shown with the same units of what they use.

    Shared parts come back in dozens of compositions; their formulas need one look.
    """
    new: list[Quantity] = []
    units = {name: one.unit for name, one in quantities.items()}
    for one in quantities.values():
        key = (one.id, one.file, tuple(map(units.get, one.uses)))
        if key not in seen:
            seen.add(key)
            new.append(one)
    return new


def _check_parts(course: Course, scheme: Scheme) -> Iterator[Problem]:
    for options in option_sets(scheme):
        ids = part_ids(scheme, options)
        for part in ids:
            if part not in course.parts:
                yield Problem(
                    scheme.file,
                    "parts",
                    message("There is no part '{part}'.", part=part),
                    did_you_mean(part, course.parts),
                )
        declared = set(course.constants)
        parts = [course.parts[part] for part in ids if part in course.parts]
        for file, own in (
            *((one.file, one.quantities) for one in parts),
            (scheme.file, scheme.quantities),
        ):
            yield from (_doubled(file, name) for name in own if name in declared)
            declared |= own.keys()


def _doubled(file: str, name: str) -> Problem:
    return Problem(
        file,
        f"quantity.{name}",
        message("'{name}' is declared more than once.", name=name),
        message("Remove a part, or change single keys under [override.{name}].", name=name),
    )


def _all_parts(scheme: Scheme) -> set[str]:
    """Return the parts that a scheme uses with any of its options."""
    choices = (choice for option in scheme.options for choice in option.choices)
    return {*scheme.parts, *(part for choice in choices for part in choice.parts)}


def _check_used_parts(course: Course) -> Iterator[Problem]:
    used = {part for scheme in course.schemes.values() for part in _all_parts(scheme)}
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


def _check_use(course: Course, quantities: Mapping[str, Quantity]) -> Iterator[Problem]:
    """Yield the givens of a composition that nothing in it uses."""
    used = used_names(quantities.values())
    idle = [one for one in quantities.values() if one.kind is Kind.GIVEN and one.id not in used]
    if not idle:
        return
    if not (_is_readable(quantities.values()) and used <= {*quantities, *course.constants}):
        return
    for one in idle:
        yield Problem(
            one.file,
            f"quantity.{one.id}",
            message("No formula uses the given '{name}'.", name=one.id),
            message("Use it, or remove it: students would look for its purpose."),
        )


def _check_declarations(course: Course, declared: Iterable[Quantity]) -> Iterator[Problem]:
    """Yield what is wrong with declarations wherever they are used."""
    sections = {section.id for section in course.sections}
    for one in declared:
        key = f"quantity.{one.id}"
        if one.section and one.section not in sections:
            yield Problem(
                one.file,
                f"{key}.section",
                message("The course has no section '{name}'.", name=one.section),
                did_you_mean(one.section, sections),
            )
        if one.source.work and one.source.work not in course.works:
            yield Problem(
                one.file,
                f"{key}.source.work",
                message("The course cites no work '{work}'.", work=one.source.work),
                did_you_mean(one.source.work, course.works),
            )
        for printed in one.as_printed:
            if printed.erratum not in course.errata:
                yield Problem(
                    one.file,
                    f"{key}.as_printed.{printed.erratum}",
                    message("The course lists no erratum '{erratum}'.", erratum=printed.erratum),
                    did_you_mean(printed.erratum, course.errata),
                )
        if one.rubric and not _rubric_exists(course, one.rubric):
            yield Problem(
                one.file,
                f"{key}.rubric",
                message("There is no rubric '{rubric}'.", rubric=one.rubric),
                message("Write grader/rubric/{rubric}.toml.", rubric=one.rubric),
            )


def _is_readable(quantities: Iterable[Quantity]) -> bool:
    """Tell whether every formula could be read: else nobody knows what is used."""
    return all(one.formula is not None for one in quantities if one.kind.answered)


def _rubric_exists(course: Course, rubric: str) -> bool:
    return (course.root / "grader" / "rubric" / f"{rubric}.toml").is_file()


def _all_inputs(course: Course, scheme: Scheme) -> dict[str, set[str]]:
    """Return what each id is computed from in any composition and convention of a scheme."""
    inputs: dict[str, set[str]] = {}
    parts = [course.parts[part].quantities for part in _all_parts(scheme)]
    for quantities in (*parts, scheme.quantities, scheme.overrides):
        for name, one in quantities.items():
            own = inputs.setdefault(name, set())
            for convention in Convention:
                own.update(direct_inputs(one, convention))
    return inputs


def _knot(inputs: Mapping[str, Iterable[str]]) -> frozenset[str]:
    """Return the ids that circles may run through; mostly none: one look at a scheme is enough.

    What needs nothing of the rest is left out, and then what nothing of the rest needs.
    """
    behind = _stuck(inputs)
    users: dict[str, set[str]] = {name: set() for name in behind}
    for name in behind:
        for used in behind.intersection(inputs.get(name, ())):
            users[used].add(name)
    return _stuck(users)


def _stuck(inputs: Mapping[str, Iterable[str]]) -> frozenset[str]:
    """Return the ids that no order of calculation reaches."""
    sorter = TopologicalSorter(inputs)
    with suppress(CycleError):  # it goes on with what is not part of a circle
        sorter.prepare()
    reached: set[str] = set()
    while ready := sorter.get_ready():
        reached.update(ready)
        sorter.done(*ready)
    return frozenset({*inputs, *(name for used in inputs.values() for name in used)} - reached)


def _check_graph(
    scheme: Scheme, quantities: Mapping[str, Quantity], knot: frozenset[str], seen: set[object]
) -> Iterator[Problem]:
    """Yield the circle of a composition; the same declarations of the knot are judged once."""
    tied = tuple(id(quantities[name]) for name in sorted(knot) if name in quantities)
    if not tied or (scheme.id, tied) in seen:
        return
    seen.add((scheme.id, tied))
    for convention in Convention:
        graph = {name: direct_inputs(one, convention) for name, one in quantities.items()}
        try:
            tuple(TopologicalSorter(graph).static_order())
        except CycleError as fault:
            circle = list(dict.fromkeys(reversed(fault.args[1])))
            first = min(circle)  # the same circle of another scheme shall read the same
            circle = circle[circle.index(first) :] + circle[: circle.index(first)]
            yield Problem(
                quantities[first].file if first in quantities else scheme.file,
                f"quantity.{first}.formula",
                message(
                    "The formulas run in a circle: {circle}.",
                    circle=" → ".join([*circle, circle[0]]),
                ),
                message("Express one of them without the others."),
            )


def _check_motion(
    scheme: Scheme, quantities: Mapping[str, Quantity], used: Iterable[str], seen: set[object]
) -> Iterator[Problem]:
    """Yield the problems of the kinematics, once for the same units of what it uses."""
    units = tuple(quantities[name].unit if name in quantities else None for name in used)
    if (scheme.id, units) in seen:
        return
    seen.add((scheme.id, units))
    if all(known_unit(one.unit) for one in quantities.values()):
        yield from check_kinematics(scheme, quantities)


def _check_symbols(
    scheme: Scheme, quantities: Mapping[str, Quantity], told: set[object]
) -> Iterator[Problem]:
    """Yield every symbol that two quantities share; `told` are those of earlier compositions."""
    doubled: dict[tuple[str, str, str], list[str]] = {}
    for language in LANGUAGES:
        shown = [one.symbol.of(language) for one in quantities.values()]
        if len(set(shown)) == len(shown) - max(shown.count("") - 1, 0):
            continue  # mostly all differ but those that are empty
        seen: dict[str, str] = {}
        for one in quantities.values():
            symbol = one.symbol.of(language)
            if symbol and symbol in seen:
                doubled.setdefault((one.id, seen[symbol], symbol), []).append(language)
            seen[symbol] = one.id
    for (name, other, symbol), languages in doubled.items():
        if (name, other, symbol, *languages) in told:
            continue
        told.add((name, other, symbol, *languages))
        yield Problem(
            quantities[name].file,
            f"quantity.{name}.symbol",
            message(
                "'{symbol}' ({language}) is the symbol of {other} too, in {scheme}.",
                symbol=symbol,
                language=", ".join(languages),
                other=other,
                scheme=scheme.id,
            ),
            message("Give each quantity a symbol of its own."),
        )
