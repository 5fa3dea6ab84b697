"""Checking the position kinematics of a scheme: names, dimensions, and what they refer to."""

from collections.abc import Collection, Iterator, Mapping

from gripcourse.course.kinematics import Kinematics
from gripcourse.course.model import Scheme
from gripcourse.course.quantity import Quantity
from gripcourse.errors import Problem
from gripcourse.formula.dimension import check_dimension
from gripcourse.formula.parse import FormulaFault, caret
from gripcourse.formula.tree import Formula
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.units import Dimension, dimension
from gripcourse.text.units import known as known_unit
from gripcourse.text.words import message


def check_kinematics(
    scheme: Scheme, quantities: Mapping[str, Quantity], positions: Collection[str]
) -> Iterator[Problem]:
    """Yield the problems of a scheme's kinematics; `positions` are those of the course."""
    motion = scheme.kinematics
    if motion is None:
        return
    known = {name: dimension(one.unit) for name, one in quantities.items() if known_unit(one.unit)}
    yield from _formula_faults(motion.file, "outputs", motion.outputs, "", known)
    for position, formula in motion.at.items():
        yield from _formula_faults(motion.file, f"at.{position}", formula, motion.unit, known)
    known[motion.drive] = dimension(motion.unit)
    for one in motion.coordinates:
        key = f"coordinate.{one.id}"
        yield from _formula_faults(motion.file, key, one.formula, one.unit, known)
        known[one.id] = dimension(one.unit)
    yield from _reference_faults(motion, quantities, positions)


def moving_units(scheme: Scheme, quantities: Mapping[str, Quantity]) -> tuple[str | None, ...]:
    """Return the unit of each id that the kinematics names, None of what is no quantity.

    Compositions with the same units are alike: one of them needs a look.
    """
    motion = scheme.kinematics
    if motion is None:
        return ()
    used = dict.fromkeys((
        *motion.ratio.values(),
        *(name for state in motion.state.values() for name in state),
        *motion.lossless,
        *(name for one in _motion_formulas(motion) for name in one.names),
    ))  # fmt: skip
    return tuple(quantities[name].unit if name in quantities else None for name in used)


def _motion_formulas(motion: Kinematics) -> Iterator[Formula]:
    yield motion.outputs
    yield from motion.at.values()
    yield from (one.formula for one in motion.coordinates)


def _formula_faults(
    file: str, key: str, formula: Formula, unit: str, known: Mapping[str, Dimension]
) -> Iterator[Problem]:
    unknown = [name for name in formula.names if name not in known]
    for name in unknown:
        what = message("The name '{name}' is not known.", name=name)
        yield Problem(file, f"kinematics.{key}", what, did_you_mean(name, known))
    if unknown:
        return
    try:
        check_dimension(formula, unit, known, {})
    except FormulaFault as fault:
        yield Problem(
            file,
            f"kinematics.{key}",
            fault.what,
            message("Compare the units of both sides."),
            caret(formula.text, fault.span),
        )


def _reference_faults(
    motion: Kinematics, quantities: Mapping[str, Quantity], positions: Collection[str]
) -> Iterator[Problem]:
    for name in motion.at:
        if name not in positions:
            what = message("The course has no position '{position}'.", position=name)
            remedy = (
                did_you_mean(name, positions)
                if positions
                else message("Declare it in variants/course.toml: [position.{name}].", name=name)
            )
            yield Problem(motion.file, f"kinematics.at.{name}", what, remedy)
    coordinates = {one.id for one in motion.coordinates}
    for key, name, allowed in _references(motion, quantities, coordinates):
        if name not in allowed:
            what = message("The name '{name}' is not known.", name=name)
            yield Problem(motion.file, f"kinematics.{key}", what, did_you_mean(name, allowed))


def _references(
    motion: Kinematics, quantities: Collection[str], coordinates: Collection[str]
) -> Iterator[tuple[str, str, Collection[str]]]:
    """Yield each name that refers to something, with its key and what it may refer to."""
    if motion.output:
        yield "output", motion.output, coordinates
    for position, quantity in motion.ratio.items():
        yield "ratio", position, motion.at
        yield f"ratio.{position}", quantity, quantities
    for position, state in motion.state.items():
        yield "state", position, motion.at
        for quantity, coordinate in state.items():
            yield f"state.{position}", quantity, quantities
            yield f"state.{position}.{quantity}", coordinate, coordinates
    for name in motion.lossless:
        yield "lossless", name, quantities
    for point, pair in motion.points.items():
        for coordinate in pair:
            yield f"point.{point}", coordinate, coordinates
