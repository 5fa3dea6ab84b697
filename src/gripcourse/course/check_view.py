"""Checking the general view of a scheme: names, dimensions, and what they refer to."""

from collections.abc import Collection, Iterator, Mapping
from graphlib import CycleError, TopologicalSorter

from gripcourse.course.model import Scheme
from gripcourse.course.quantity import Kind, Quantity
from gripcourse.course.shared_drawing import unknown_name
from gripcourse.course.view import SHAPES, Expression, Need, Ring, View, ViewPart
from gripcourse.errors import Problem
from gripcourse.formula.dimension import check_dimension
from gripcourse.formula.parse import FormulaFault, caret
from gripcourse.formula.tree import Formula, Negation, Node, Operation
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.units import Dimension, dimension
from gripcourse.text.words import message

_NO_NUMBERS = {Kind.VERDICT, Kind.MANUAL}
_LENGTH, _ANGLE, _COUNT, _STRESS = "mm", "deg", "", "MPa"

Place = tuple[str, str, Formula, str]  # file, key, formula and the unit that it must have


def check_view(
    scheme: Scheme,
    quantities: Mapping[str, Quantity],
    columns: Mapping[str, tuple[Dimension, Dimension]],
    parts: Collection[str],
) -> Iterator[Problem]:
    """Yield the problems of a scheme's view.

    Args:
        scheme: whose view it is.
        quantities: of all its options together: a part may belong to one of them only.
        columns: dimensions of the sizes and of the values of each catalogue's column.
        parts: ids of the parts of all views together.
    """
    view = scheme.view
    if view is None:
        return
    if not view.parts:
        what = message("The view has no part.")
        yield Problem(view.file, "part", what, message("Write its parts, or remove the file."))
    yield from _reference_faults(scheme.id, view, quantities)
    known = {name: dimension(one.unit) for name, one in quantities.items()}
    if scheme.kinematics is not None:
        known[scheme.kinematics.drive] = dimension(scheme.kinematics.unit)
        for one in scheme.kinematics.coordinates:
            known[one.id] = dimension(one.unit)
        yield from _unknown_positions(view, scheme.kinematics.at)
    elif view.position or view.other or any(part.positions for part in view.parts):
        what = message("The scheme has no positions: it declares no kinematics.")
        yield Problem(view.file, "position", what, message("Remove the key."))
    yield from _unknown_parts(view, parts)
    for name, measure in view.measures.items():
        if name in known:
            what = message("'{name}' is declared more than once.", name=name)
            yield Problem(measure.file, measure.key, what, message("Give it another name."))
    known |= {name: dimension(one.unit) for name, one in view.measures.items()}
    for file, key, formula, unit in _places(view):
        unknown = _unknown_names(scheme.id, view, (file, key, formula, unit), known)
        yield from unknown or _formula_faults((file, key, formula, unit), known, columns)
    yield from _behind_the_plane(view)
    yield from _circle(view)
    yield from _grade_faults(view)


def _unknown_positions(view: View, positions: Collection[str]) -> Iterator[Problem]:
    named = [(view.file, "position", view.position), (view.file, "other", view.other)]
    for part in view.parts:
        named += [(part.file, f"{part.key}.positions", name) for name in part.positions]
        named.append((part.file, f"{part.key}.placed_at", part.placed_at))
    for file, key, name in named:
        if name and name not in positions:
            what = message("The name '{name}' is not known.", name=name)
            yield Problem(file, key, what, did_you_mean(name, positions))


def _unknown_parts(view: View, parts: Collection[str]) -> Iterator[Problem]:
    """Yield what is met but is not there; a shared part may meet what other views have."""
    own = {part.id for part in view.parts}
    for part in view.parts:
        named = [("meets", name) for name in part.meets]
        named += [("touches", name) for name in part.touches]
        named += [("piece_of", part.piece_of)] if part.piece_of else []
        for key, name in named:
            if name not in (own if part.file == view.file else parts):
                what = message("The view has no part '{name}'.", name=name)
                yield Problem(part.file, f"{part.key}.{key}", what, did_you_mean(name, own))


def _reference_faults(
    scheme: str, view: View, quantities: Mapping[str, Quantity]
) -> Iterator[Problem]:
    named = [(view.file, "characteristics", name) for name in view.characteristics]
    named += [(part.file, f"{part.key}.sizes", name) for part in view.parts for name in part.sizes]
    named += [(one.file, f"{one.key}.quantity", one.quantity) for one in view.dimensions]
    shown = [*quantities, *view.measures]
    for label in view.labels:
        for place, name in label.values.items():
            if name not in shown:
                what = message("The name '{name}' is not known.", name=name)
                is_shared = label.file != view.file
                said = unknown_name(what, name, shown, scheme, is_shared=is_shared)
                yield Problem(label.file, f"{label.key}.values.{place}", *said)
    for file, key, name in named:
        if name not in quantities:
            what = message("The scheme has no quantity '{name}'.", name=name)
            said = unknown_name(what, name, quantities, scheme, is_shared=file != view.file)
            yield Problem(file, key, *said)
        elif quantities[name].kind in _NO_NUMBERS:
            what = message("A drawing shows numbers, and '{name}' is none.", name=name)
            yield Problem(file, key, what, message("Leave it out."))


def _unknown_names(
    scheme: str, view: View, place: Place, known: Mapping[str, Dimension]
) -> list[Problem]:
    file, key, formula, _ = place
    found = []
    for name in formula.names:
        if name not in known:
            what = message("The name '{name}' is not known.", name=name)
            said = unknown_name(what, name, known, scheme, is_shared=file != view.file)
            found.append(Problem(file, key, *said))
    return found


def _formula_faults(
    place: Place,
    known: Mapping[str, Dimension],
    columns: Mapping[str, tuple[Dimension, Dimension]],
) -> Iterator[Problem]:
    file, key, formula, unit = place
    try:
        check_dimension(formula, unit, known, columns)
    except FormulaFault as fault:
        remedy = message("Compare the units of both sides.")
        yield Problem(file, key, fault.what, remedy, caret(formula.text, fault.span))


def _places(view: View) -> Iterator[Place]:
    """Yield every formula of a view."""
    for measure in view.measures.values():
        for formula in measure.formulas:
            yield measure.file, measure.key, formula, measure.unit
    for id_, formulas in view.strength.items():
        yield from _lengths(view.file, f"strength.{id_}", formulas, _STRESS)
    for id_, formulas in view.elastic_modulus.items():
        yield from _lengths(view.file, f"elastic_modulus.{id_}", formulas, _STRESS)
    for part in view.parts:
        yield from _part_places(part)
    for one in view.dimensions:
        yield from _lengths(one.file, f"{one.key}.from", one.start)
        yield from _lengths(one.file, f"{one.key}.to", one.end)
    for label in view.labels:
        yield from _lengths(label.file, f"{label.key}.at", label.at)
    for detail in view.details:
        yield from _lengths(detail.file, f"{detail.key}.at", detail.at)
        yield from _lengths(detail.file, f"{detail.key}.reach", (detail.reach,))


def _part_places(part: ViewPart) -> Iterator[Place]:
    yield from _lengths(part.file, f"{part.key}.mark", part.mark)
    if part.count is not None:
        yield part.file, f"{part.key}.count", part.count, _COUNT
    if part.enters is not None:
        yield part.file, f"{part.key}.enters", part.enters, "mm"
    yield from _lengths(part.file, f"{part.key}.depth", part.depth)
    for shape in part.shapes:
        for name, expressions in shape.needs.items():
            unit = _ANGLE if SHAPES[shape.kind][name] is Need.ANGLES else _LENGTH
            yield from _lengths(part.file, f"{shape.key}.{name}", expressions, unit)
        yield from _lengths(part.file, f"{shape.key}.depth", shape.depth)
        for repeat in shape.repeats:
            key = f"{shape.key}.repeat"
            yield part.file, f"{key}.count", repeat.count, _COUNT
            place = repeat.about if isinstance(repeat, Ring) else repeat.step
            yield from _lengths(part.file, key, place)


def _behind_the_plane(view: View) -> Iterator[Problem]:
    """Yield depths that begin below zero: both sides are meant, and would be counted twice."""
    for part in view.parts:
        depths = [(part.key, part.depth), *((one.key, one.depth) for one in part.shapes)]
        for key, depth in depths:
            if depth and depth[0] is not None and _is_below_zero(depth[0].tree):
                yield Problem(
                    part.file,
                    f"{key}.depth",
                    message("A depth is counted on both sides of the plane of the main view."),
                    message('Write [0, "…"], to half the thickness.'),
                )


def _is_below_zero(node: Node) -> bool:
    """Tell whether a formula of lengths is written with a minus sign before all of it."""
    match node:
        case Negation():
            return True
        case Operation("*" | "/", left, _):
            return _is_below_zero(left)
        case _:
            return False


def _lengths(
    file: str, key: str, expressions: tuple[Expression, ...], unit: str = _LENGTH
) -> Iterator[Place]:
    for formula in expressions:
        if formula is not None:
            yield file, key, formula, unit


def _grade_faults(view: View) -> Iterator[Problem]:
    own = {part.id for part in view.parts}
    for key, asked in (("strength", view.strength), ("elastic_modulus", view.elastic_modulus)):
        for name in asked.keys() - own:
            what = message("The view has no part '{name}'.", name=name)
            yield Problem(view.file, f"{key}.{name}", what, did_you_mean(name, own))
    if view.strength and not view.grades:
        what = message("The view has no material whose strength is known.")
        remedy = message("Declare materials as [[grade]], or take a shared file that does.")
        yield Problem(view.file, "strength", what, remedy)


def _circle(view: View) -> Iterator[Problem]:
    graph = {
        name: {one for formula in measure.formulas for one in formula.names if one in view.measures}
        for name, measure in view.measures.items()
    }
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as fault:
        circle = list(dict.fromkeys(reversed(fault.args[1])))
        turned = circle.index(min(circle))  # so that the same circle always reads the same
        circle = circle[turned:] + circle[:turned]
        measure = view.measures[circle[0]]
        said = " → ".join([*circle, circle[0]])
        what = message("The formulas run in a circle: {circle}.", circle=said)
        remedy = message("Express one of them without the others.")
        yield Problem(measure.file, measure.key, what, remedy)
