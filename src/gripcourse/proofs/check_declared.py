"""Checking declared proofs: names, dimensions, options, and whether any composition has them."""

from collections.abc import Iterator, Mapping
from typing import TypeAlias

from gripcourse.course.compose import compose
from gripcourse.course.model import Course, Scheme
from gripcourse.course.option_sets import pair_option_sets
from gripcourse.course.quantity import Quantity
from gripcourse.errors import CourseError, Problem
from gripcourse.formula.dimension import is_condition, measured_by
from gripcourse.formula.parse import FormulaFault, caret
from gripcourse.formula.rules import ColumnDimensions
from gripcourse.formula.tree import Formula
from gripcourse.proofs.declared import (
    DeclaredProof,
    DeclaredProofs,
    IdentityProof,
    Inequality,
    Travel,
    VirtualWork,
    formulas_of,
    names_used,
    read_declared_proofs,
)
from gripcourse.proofs.operators import OPERATORS, column_dimensions
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.units import PLAIN, Dimension, dimension
from gripcourse.text.words import message

Composed: TypeAlias = dict[tuple[str, tuple[tuple[str, str], ...]], dict[str, Quantity]]
"""What schemes have with choices of options: many proofs ask for the same."""


def load_declared_proofs(course: Course) -> DeclaredProofs:
    """Read the proofs that a course declares; a course without the file declares none.

    Raises:
        CourseError: with every problem of the file.
    """
    found, problems = read_declared_proofs(course)
    problems += check_declared(course, found)
    if problems:
        raise CourseError(problems)
    return found


def check_declared(course: Course, declared: DeclaredProofs) -> list[Problem]:
    """Return what is wrong with the proofs that a course declares."""
    columns = column_dimensions(course)
    composed: Composed = {}
    found = [
        one for proof in declared.proofs for one in _proof_faults(course, proof, columns, composed)
    ]
    known = {name for one in course.parts.values() for name in one.quantities}
    known |= {name for one in course.schemes.values() for name in one.quantities}
    for one in declared.unshown:
        if one.quantity not in known:
            what = message("The name '{name}' is not known.", name=one.quantity)
            remedy = did_you_mean(one.quantity, known)
            found.append(Problem(one.file, f"{one.key}.quantity", what, remedy))
        if one.operator not in OPERATORS:
            what = message("There is no operator '{operator}'.", operator=one.operator)
            remedy = message("Write one of {operators}.", operators=" ".join(OPERATORS))
            found.append(Problem(one.file, f"{one.key}.operator", what, remedy))
    return found


def schemes_of(course: Course, proof: DeclaredProof) -> tuple[Scheme, ...]:
    """Return the schemes that a proof may be about."""
    named = proof.scope.schemes or tuple(course.schemes)
    return tuple(course.schemes[name] for name in named if name in course.schemes)


def _proof_faults(
    course: Course,
    proof: DeclaredProof,
    columns: Mapping[str, ColumnDimensions],
    composed: Composed,
) -> Iterator[Problem]:
    scope, wanted = proof.scope, names_used(proof)
    fitting = [
        one
        for one in schemes_of(course, proof)
        if scope.options.keys() <= {o.id for o in one.options}
    ]
    if not fitting:
        yield Problem(
            scope.file,
            f"{scope.key}.options",
            message("No scheme that it is about has these options."),
            did_you_mean(
                next(iter(scope.options)),
                {o.id for s in course.schemes.values() for o in s.options},
            ),
        )
        return
    nearest: dict[str, Quantity] = {}
    is_tried = False
    for scheme in fitting:
        quantities = _with_names(course, scheme, scope.options, wanted, composed)
        if wanted <= quantities.keys():
            is_tried = True
            yield from _dimension_faults(proof, scheme, quantities, columns)
        elif scope.schemes:
            yield from _name_faults(proof, scheme, wanted, quantities)
        if len(wanted & quantities.keys()) >= len(wanted & nearest.keys()):
            nearest = quantities
    if not (is_tried or scope.schemes):
        yield from _name_faults(proof, None, wanted, nearest)


def _with_names(
    course: Course,
    scheme: Scheme,
    options: Mapping[str, str],
    wanted: frozenset[str],
    composed: Composed,
) -> dict[str, Quantity]:
    """Return the composition with these options that holds all names, else as many as possible."""
    best: dict[str, Quantity] = {}
    tried: set[tuple[tuple[str, str], ...]] = set()
    for one in pair_option_sets(scheme):
        chosen = tuple({**one, **options}.items())
        if chosen in tried:
            continue
        tried.add(chosen)
        key = (scheme.id, chosen)
        if key not in composed:
            composed[key] = {**course.constants, **compose(course, scheme, dict(chosen))}
        found = composed[key]
        if wanted <= found.keys():
            return found
        if len(wanted & found.keys()) >= len(wanted & best.keys()):
            best = found
    return best


def _name_faults(
    proof: DeclaredProof,
    scheme: Scheme | None,
    wanted: frozenset[str],
    quantities: Mapping[str, Quantity],
) -> Iterator[Problem]:
    scope = proof.scope
    missing = sorted(wanted - quantities.keys())
    for name in missing:
        key = next((key for key, one in formulas_of(proof) if name in one.names), f"set.{name}")
        what = (
            message("The name '{name}' is not known.", name=name)
            if scheme is None
            else message("The name '{name}' is not known in {scheme}.", name=name, scheme=scheme.id)
        )
        yield Problem(scope.file, f"{scope.key}.{key}", what, did_you_mean(name, quantities))


def _dimension_faults(
    proof: DeclaredProof,
    scheme: Scheme,
    quantities: Mapping[str, Quantity],
    columns: Mapping[str, ColumnDimensions],
) -> Iterator[Problem]:
    scope = proof.scope
    known = {name: dimension(one.unit) for name, one in quantities.items()}
    if isinstance(proof, VirtualWork):
        known[proof.parameter] = dimension(proof.unit)
    measured: dict[str, Dimension] = {}
    for key, formula in formulas_of(proof):
        wants_condition = isinstance(proof, Inequality) and key == "condition"
        if is_condition(formula.tree) != wants_condition:
            what = (
                message("This must be a comparison.")
                if wants_condition
                else message("This must be a value, not a comparison.")
            )
            yield Problem(scope.file, f"{scope.key}.{key}", what, message("Correct the formula."))
            return
        try:
            measured[key] = measured_by(formula.tree, known, columns) or PLAIN
        except FormulaFault as fault:
            yield _fault(proof, key, formula, fault)
            return
        if key.startswith("let."):
            known[key.removeprefix("let.")] = measured[key]
    yield from _unlike(proof, scheme, measured)


def _fault(proof: DeclaredProof, key: str, formula: Formula, fault: FormulaFault) -> Problem:
    return Problem(
        proof.scope.file,
        f"{proof.scope.key}.{key}",
        fault.what,
        message("Compare the units of both sides."),
        caret(formula.text, fault.span),
    )


def _unlike(
    proof: DeclaredProof, scheme: Scheme, measured: Mapping[str, Dimension]
) -> Iterator[Problem]:
    """Yield what cannot agree because it measures something else, or is no coordinate."""
    scope, motion = proof.scope, scheme.kinematics
    match proof:
        case IdentityProof() if measured["left"] != measured["right"]:
            what = message("Left and right measure different things.")
            remedy = message("Compare the units of both sides.")
            yield Problem(scope.file, f"{scope.key}.right", what, remedy)
        case VirtualWork() if measured["at"] != dimension(proof.unit):
            what = message("The place does not measure what the parameter does.")
            remedy = message("Compare 'at' with 'unit'.")
            yield Problem(scope.file, f"{scope.key}.at", what, remedy)
        case Travel():
            coordinates = [] if motion is None else [one.id for one in motion.coordinates]
            positions = [] if motion is None else list(motion.at)
            for key, name, known in (
                ("coordinate", proof.coordinate, coordinates),
                ("start", proof.start, positions),
                ("end", proof.end, positions),
            ):
                if name not in known:
                    what = message(
                        "The motion of {scheme} has no '{name}'.", scheme=scheme.id, name=name
                    )
                    yield Problem(scope.file, f"{scope.key}.{key}", what, did_you_mean(name, known))
