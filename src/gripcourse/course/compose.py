"""Composing a scheme: its parts and those of a variant's options, with the scheme's own changes."""

from collections.abc import Collection, Iterable, Mapping
from dataclasses import replace

from gripcourse.course.composition import Composition
from gripcourse.course.model import Course, Scheme
from gripcourse.course.quantity import Convention, Kind, Quantity
from gripcourse.formula.tree import Formula


def part_ids(scheme: Scheme, options: Mapping[str, str]) -> tuple[str, ...]:
    """Return the parts that a scheme uses with these options, in order.

    A part that two choices bring, as the size of a key, is there once.
    """
    chosen = (
        choice.parts
        for option in scheme.options
        for choice in option.choices
        if options.get(option.id) == choice.id
    )
    return tuple(dict.fromkeys((*scheme.parts, *(part for parts in chosen for part in parts))))


def all_part_ids(scheme: Scheme) -> dict[str, None]:
    """Return the parts that a scheme uses with any of its options, in order, each once."""
    optional = (part for one in scheme.options for choice in one.choices for part in choice.parts)
    return dict.fromkeys((*scheme.parts, *optional))


def compose(course: Course, scheme: Scheme, options: Mapping[str, str]) -> dict[str, Quantity]:
    """Return all quantities of a scheme with these options, in order of declaration.

    Constants come first, of them only those that some formula of the scheme uses.
    """
    declared: dict[str, Quantity] = {}
    chosen = part_ids(scheme, options)
    for part in chosen:
        if part in course.parts:
            declared |= {**course.parts[part].quantities, **scheme.overrides.get(part, {})}
    for part in chosen:
        for changed, own in scheme.optional_overrides.get(part, {}).items():
            declared |= own if changed in chosen else {}
    declared |= scheme.quantities
    used = used_names(declared.values())
    constants = {name: one for name, one in course.constants.items() if name in used}
    return constants | declared


def of_schemes(course: Course, ids: Collection[str]) -> Course:
    """Return the course with some of its schemes only, and with all that schemes may share."""
    return replace(course, schemes={id_: one for id_, one in course.schemes.items() if id_ in ids})


def inherited(course: Course) -> Course:
    """Return the course with every worked example completed by the defaults of its givens."""
    schemes = {name: _completed(course, scheme) for name, scheme in course.schemes.items()}
    return replace(course, schemes=schemes)


def _completed(course: Course, scheme: Scheme) -> Scheme:
    if scheme.example is None:
        return scheme
    defaults = default_values(compose(course, scheme, scheme.example.options).values())
    example = replace(scheme.example, given=defaults | dict(scheme.example.given))
    return replace(scheme, example=example)


def default_values(quantities: Iterable[Quantity]) -> dict[str, float]:
    """Return the defaults of given quantities that have one, in declared units."""
    return {one.id: one.default for one in quantities if one.default is not None}


def declaring_files(course: Course) -> dict[str, tuple[str, ...]]:
    """Return the files of parts that declare each id: a formula may lack one of these parts."""
    found: dict[str, tuple[str, ...]] = {}
    for part in course.parts.values():
        for name in part.quantities:
            found[name] = (*found.get(name, ()), part.file)
    return found


def declared_in(course: Course, compositions: Iterable[Composition]) -> dict[str, Quantity]:
    """Return the declaration of every quantity that occurs, by id; the first composition's counts.

    A scheme that the course has no longer brings none.
    """
    declared: dict[str, Quantity] = {}
    for one in dict.fromkeys(compositions):
        if one.scheme in course.schemes:
            declared = compose(course, course.schemes[one.scheme], one.options) | declared
    return declared


def used_names(quantities: Iterable[Quantity]) -> set[str]:
    """Return every id that some formula of some quantity uses."""
    return set[str]().union(*(one.uses for one in quantities))


def reference_formula(quantity: Quantity, convention: Convention) -> Formula | None:
    """Return the formula that gives the reference in a convention."""
    if convention is Convention.AS_PRINTED:
        printed = (one.formula for one in quantity.as_printed if one.formula is not None)
        return next(printed, quantity.formula)
    return quantity.formula


def direct_inputs(quantity: Quantity, convention: Convention) -> tuple[str, ...]:
    """Return the ids that the value of a quantity is computed from, each once."""
    formula = reference_formula(quantity, convention)
    if formula is None or quantity.kind in {Kind.GIVEN, Kind.CONSTANT, Kind.MANUAL}:
        return ()
    return formula.names
