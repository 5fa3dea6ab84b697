"""Checking the diagram of a scheme: the points, sizes, quantities and options it refers to."""

from collections.abc import Iterator, Mapping

from gripcourse.course.diagram import Diagram, Element
from gripcourse.course.diagram_words import VOCABULARY, Sort
from gripcourse.course.model import Quantity, Scheme
from gripcourse.errors import Problem
from gripcourse.formula.dimension import check_dimension
from gripcourse.formula.parse import FormulaFault, caret
from gripcourse.formula.tree import Formula, Number, names
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.units import Dimension, dimension
from gripcourse.text.units import known as known_unit
from gripcourse.text.words import message

_UNITS = {Sort.LENGTH: "mm", Sort.ANGLE: "deg", Sort.NUMBER: ""}


def check_diagram(
    scheme: Scheme,
    quantities: Mapping[str, Quantity],
    options: Mapping[str, str],
    seen: set[object],
) -> Iterator[Problem]:
    """Yield the problems of a scheme's diagram.

    Args:
        scheme: with its diagram, if it has one.
        quantities: of the scheme composed with `options`.
        options: that decide which elements are drawn.
        seen: what compositions that were checked gave the diagram; equal ones need one look.
    """
    diagram = scheme.diagram
    if diagram is None or (facts := _facts(scheme.id, diagram, quantities, options)) in seen:
        return
    seen.add(facts)
    known = _dimensions(scheme, quantities)
    joints = {*diagram.points, *(scheme.kinematics.points if scheme.kinematics else ())}
    drawn = [one for one in diagram.elements if one.is_drawn(options)]
    used = {name for one in drawn for names_ in one.points.values() for name in names_}
    for name, pair in diagram.points.items():
        for formula in pair if name in used else ():
            yield from _formula_faults(diagram.file, f"point.{name}", formula, "mm", known)
    for element in drawn:
        yield from _unknown_points(element, joints)
        yield from _unknown_positions(element, scheme)
        for role, formula in element.sizes.items():
            wanted = VOCABULARY[element.kind].roles[role]
            if wanted.default == "" and not known.keys() >= set(formula.names):
                continue  # not a size of this composition
            key = f"{element.key}.{role}"
            yield from _formula_faults(element.file, key, formula, _UNITS[wanted.sort], known)
        if element.quantity and element.quantity not in quantities:
            what = message("There is no quantity '{name}'.", name=element.quantity)
            remedy = did_you_mean(element.quantity, quantities)
            yield Problem(element.file, f"{element.key}.quantity", what, remedy)


def _facts(
    scheme: str, diagram: Diagram, quantities: Mapping[str, Quantity], options: Mapping[str, str]
) -> object:
    """Return all that a diagram takes from a composition: what is drawn, and units of names."""
    formulas = [formula for pair in diagram.points.values() for formula in pair]
    formulas += [formula for element in diagram.elements for formula in element.sizes.values()]
    used = [name for formula in formulas for name in formula.names]
    used += [element.quantity for element in diagram.elements]
    units = tuple(quantities[name].unit if name in quantities else None for name in used)
    return scheme, units, tuple(element.is_drawn(options) for element in diagram.elements)


def check_diagram_use(scheme: Scheme) -> Iterator[Problem]:
    """Yield points that no element uses, and options that the scheme does not have."""
    diagram = scheme.diagram
    if diagram is None:
        return
    used = {name for one in diagram.elements for names_ in one.points.values() for name in names_}
    for name in diagram.points:
        if name not in used:
            what = message("No element uses the point '{name}'.", name=name)
            remedy = message("Use it, or remove it.")
            yield Problem(diagram.file, f"point.{name}", what, remedy)
    choices = {one.id: [choice.id for choice in one.choices] for one in scheme.options}
    for element in diagram.elements:
        for option, among in element.options.items():
            key = f"{element.key}.options.{option}"
            if option not in choices:
                what = message("The scheme has no option '{option}'.", option=option)
                yield Problem(element.file, key, what, did_you_mean(option, choices))
                continue
            for one in among:
                # What several schemes share may name a choice that one of them does not offer.
                if one not in choices[option] and element.file == diagram.file:
                    what = message("The option has no choice '{choice}'.", choice=one)
                    yield Problem(diagram.file, key, what, did_you_mean(one, choices[option]))


def _dimensions(scheme: Scheme, quantities: Mapping[str, Quantity]) -> dict[str, Dimension]:
    known = {name: dimension(one.unit) for name, one in quantities.items() if known_unit(one.unit)}
    motion = scheme.kinematics
    if motion is not None and known_unit(motion.unit):
        known[motion.drive] = dimension(motion.unit)
        known |= {one.id: dimension(one.unit) for one in motion.coordinates if known_unit(one.unit)}
    return known


def _unknown_points(element: Element, joints: set[str]) -> Iterator[Problem]:
    for role, written in element.points.items():
        for name in written:
            if name and name not in joints:
                what = message("There is no point '{name}'.", name=name)
                yield Problem(
                    element.file, f"{element.key}.{role}", what, did_you_mean(name, joints)
                )


def _unknown_positions(element: Element, scheme: Scheme) -> Iterator[Problem]:
    known = scheme.kinematics.at if scheme.kinematics is not None else {}
    for one in element.positions:
        if one not in known:
            what = message("There is no position '{position}'.", position=one)
            remedy = did_you_mean(one, known)
            yield Problem(element.file, f"{element.key}.positions", what, remedy)


def _formula_faults(
    file: str, key: str, formula: Formula, unit: str, known: Mapping[str, Dimension]
) -> Iterator[Problem]:
    unknown = [name for name in names(formula.tree) if name not in known]
    for name in unknown:
        what = message("The name '{name}' is not known.", name=name)
        yield Problem(file, key, what, did_you_mean(name, known))
    if unknown or _is_zero(formula):
        return
    try:
        check_dimension(formula, unit, known, {})
    except FormulaFault as fault:
        remedy = message("Compare the units of both sides.")
        yield Problem(file, key, fault.what, remedy, caret(formula.text, fault.span))


def _is_zero(formula: Formula) -> bool:
    """Tell whether a formula is a plain 0, which is nothing in every unit."""
    return isinstance(formula.tree, Number) and formula.tree.value == 0
