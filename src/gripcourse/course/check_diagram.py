"""Checking the diagram of a scheme: the points, sizes, quantities and options it refers to."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from gripcourse.course.diagram import Diagram, Element
from gripcourse.course.diagram_words import VOCABULARY, Sort
from gripcourse.course.model import Scheme
from gripcourse.course.quantity import Quantity
from gripcourse.course.shared_drawing import unknown_name
from gripcourse.errors import Problem
from gripcourse.formula.dimension import check_dimension
from gripcourse.formula.parse import FormulaFault, caret
from gripcourse.formula.tree import Formula, Number
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
    yield from _point_faults(scheme.id, diagram, drawn, known)
    for element in drawn:
        is_shared = element.file != diagram.file
        yield from _unknown_points(element, joints, scheme.id, is_shared=is_shared)
        yield from _unknown_positions(element, scheme)
        yield from _size_faults(scheme.id, element, known, is_shared=is_shared)
        if element.quantity and element.quantity not in quantities:
            name = element.quantity
            what = message("There is no quantity '{name}'.", name=name)
            said = unknown_name(what, name, quantities, scheme.id, is_shared=is_shared)
            yield Problem(element.file, f"{element.key}.quantity", *said)


def _point_faults(
    scheme: str, diagram: Diagram, drawn: Sequence[Element], known: Mapping[str, Dimension]
) -> Iterator[Problem]:
    """Yield the problems of points that some drawn element uses."""
    used = {name for one in drawn for names_ in one.points.values() for name in names_}
    for name in (one for one in diagram.points if one in used):
        place = _FormulaPlace(scheme, diagram.file, f"point.{name}", is_shared=False)
        for formula in diagram.points[name]:
            yield from _formula_faults(place, formula, "mm", known)


def _size_faults(
    scheme: str, element: Element, known: Mapping[str, Dimension], *, is_shared: bool
) -> Iterator[Problem]:
    """Yield the problems of an element's sizes."""
    for role, formula in element.sizes.items():
        wanted = VOCABULARY[element.kind].roles[role]
        if wanted.default == "" and not known.keys() >= set(formula.names):
            continue  # not a size of this composition
        place = _FormulaPlace(scheme, element.file, f"{element.key}.{role}", is_shared)
        yield from _formula_faults(place, formula, _UNITS[wanted.sort], known)


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


def check_diagram_use(scheme: Scheme, every: Mapping[str, Quantity]) -> Iterator[Problem]:
    """Yield points that no element uses, options and quantities that the scheme does not have.

    Args:
        scheme: with its diagram, if it has one.
        every: quantity that the scheme has with any options.
    """
    diagram = scheme.diagram
    if diagram is None:
        return
    for name in diagram.nominal.keys() - every.keys():
        what = message("There is no quantity '{name}'.", name=name)
        yield Problem(diagram.file, f"nominal.{name}", what, did_you_mean(name, every))
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


def _unknown_points(
    element: Element, joints: set[str], scheme: str, *, is_shared: bool
) -> Iterator[Problem]:
    for role, written in element.points.items():
        for name in written:
            if name and name not in joints:
                what = message("There is no point '{name}'.", name=name)
                said = unknown_name(what, name, joints, scheme, is_shared=is_shared)
                yield Problem(element.file, f"{element.key}.{role}", *said)


@dataclass(frozen=True, slots=True)
class _FormulaPlace:
    """Where a formula stands, and for which scheme."""

    scheme: str
    file: str
    key: str
    is_shared: bool


def _unknown_positions(element: Element, scheme: Scheme) -> Iterator[Problem]:
    known = scheme.kinematics.at if scheme.kinematics is not None else {}
    for one in element.positions:
        if one not in known:
            what = message("There is no position '{position}'.", position=one)
            is_shared = scheme.diagram is not None and element.file != scheme.diagram.file
            said = unknown_name(what, one, known, scheme.id, is_shared=is_shared)
            yield Problem(element.file, f"{element.key}.positions", *said)


def _formula_faults(
    place: _FormulaPlace, formula: Formula, unit: str, known: Mapping[str, Dimension]
) -> Iterator[Problem]:
    unknown = [name for name in formula.names if name not in known]
    for name in unknown:
        what = message("The name '{name}' is not known.", name=name)
        said = unknown_name(what, name, known, place.scheme, is_shared=place.is_shared)
        yield Problem(place.file, place.key, *said)
    if unknown or _is_zero(formula):
        return
    try:
        check_dimension(formula, unit, known, {})
    except FormulaFault as fault:
        remedy = message("Compare the units of both sides.")
        yield Problem(place.file, place.key, fault.what, remedy, caret(formula.text, fault.span))


def _is_zero(formula: Formula) -> bool:
    """Tell whether a formula is a plain 0, which is nothing in every unit."""
    return isinstance(formula.tree, Number) and formula.tree.value == 0
