"""Composing a scheme: its parts and those of a variant's options, with the scheme's own changes."""

from collections.abc import Iterable, Iterator, Mapping
from itertools import product

from gripcourse.course.model import Convention, Course, Kind, Quantity, Scheme
from gripcourse.formula.tree import Formula


def part_ids(scheme: Scheme, options: Mapping[str, str]) -> tuple[str, ...]:
    """Return the parts that a scheme uses with these options, in order.

    A part that two choices bring, as the angle of a prism, is there once.
    """
    chosen = (
        choice.parts
        for option in scheme.options
        for choice in option.choices
        if options.get(option.id) == choice.id
    )
    return tuple(dict.fromkeys((*scheme.parts, *(part for parts in chosen for part in parts))))


def option_sets(scheme: Scheme) -> Iterator[dict[str, str]]:
    """Yield every combination of options of a scheme."""
    ids = [option.id for option in scheme.options]
    for chosen in product(*(option.choices for option in scheme.options)):
        yield dict(zip(ids, (choice.id for choice in chosen), strict=True))


def compose(course: Course, scheme: Scheme, options: Mapping[str, str]) -> dict[str, Quantity]:
    """Return all quantities of a scheme with these options, in order of declaration.

    Constants come first, of them only those that some formula of the scheme uses.
    """
    declared: dict[str, Quantity] = {}
    for part in part_ids(scheme, options):
        if part in course.parts:
            declared |= course.parts[part].quantities
    declared |= scheme.quantities
    declared |= {name: one for name, one in scheme.overrides.items() if name in declared}
    used = used_names(declared.values())
    constants = {name: one for name, one in course.constants.items() if name in used}
    return constants | declared


def used_names(quantities: Iterable[Quantity]) -> set[str]:
    """Return every id that some formula of some quantity uses."""
    return {name for one in quantities for name in one.uses}


def reference_formula(quantity: Quantity, convention: Convention) -> Formula | None:
    """Return the formula that gives the reference in a convention."""
    if convention is Convention.GUIDE:
        printed = (one.formula for one in quantity.as_printed if one.formula is not None)
        return next(printed, quantity.formula)
    return quantity.formula


def direct_inputs(quantity: Quantity, convention: Convention) -> tuple[str, ...]:
    """Return the ids that the value of a quantity is computed from, each once."""
    formula = reference_formula(quantity, convention)
    if formula is None or quantity.kind in {Kind.GIVEN, Kind.CONSTANT, Kind.MANUAL}:
        return ()
    return formula.names
