"""Checking every formula of a composed scheme: names, dimensions, conditions, slips."""

from collections.abc import Collection, Iterator, Mapping
from typing import Final

import numpy as np

from gripcourse.course.check_bare import bare_numbers
from gripcourse.course.check_guards import check_guard
from gripcourse.course.check_slips import alternative_faults, slip_faults
from gripcourse.course.dashes import dashed_names
from gripcourse.course.quantity import Kind, Quantity
from gripcourse.errors import Problem
from gripcourse.formula.dimension import check_dimension
from gripcourse.formula.evaluate import Column
from gripcourse.formula.parse import FormulaFault, caret
from gripcourse.formula.tree import CONSTANTS, Call, Formula, Name, Operation, walk
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.units import Dimension, dimension, known
from gripcourse.text.words import Message, message

_COMPARISONS = {"<", "<=", ">", ">=", "==", "and"}
_FORMULA_KEY = {Kind.CHOICE: "at_least", Kind.VERDICT: "condition"}


_SEARCHED: Final[Mapping[str, Message]] = {
    "at_least": message("Only a growing column can be searched for the next larger value."),
    "nearest": message("Only a growing column can be searched for the nearest value."),
}


def check_formulas(
    checked: Collection[Quantity],
    quantities: Mapping[str, Quantity],
    columns: Mapping[str, Column],
    column_dimensions: Mapping[str, tuple[Dimension, Dimension]],
    elsewhere: Mapping[str, Collection[str]],
    constants: Collection[str],
) -> Iterator[Problem]:
    """Yield the problems of every formula of the checked declarations.

    Args:
        checked: whose formulas.
        quantities: all of the composition, which the formulas may use.
        columns: catalogue columns.
        column_dimensions: of the sizes and of the column, by `catalogue.column`.
        elsewhere: files of parts, by the names that they declare, for what is not known here.
        constants: of the course: a composition has those that some formula uses.
    """
    if not checked:
        return
    dimensions = {name: dimension(one.unit) for name, one in quantities.items() if known(one.unit)}
    usable = {name for name, other in quantities.items() if other.kind is not Kind.MANUAL}
    usable |= set(constants)
    for one in checked:
        for key, formula, is_condition in _keyed_formulas(one):
            faults = list(_name_faults(one, key, formula, usable, columns, elsewhere))
            yield from faults
            if faults:
                continue
            if is_condition != _is_condition(formula):
                yield _wrong_sort(one, key, is_condition)
                continue
            if not {one.id, *formula.names} <= dimensions.keys():
                continue  # an unknown unit is reported where it is declared
            yield from bare_numbers(one, key, formula, quantities)
            try:
                unit = "" if is_condition else one.unit
                check_dimension(formula, unit, dimensions, column_dimensions)
            except FormulaFault as fault:
                if _follows(one, key, formula, quantities, dimensions, column_dimensions):
                    continue
                yield Problem(
                    one.file,
                    f"quantity.{one.id}.{key}",
                    fault.what,
                    _units_remedy(key, formula, quantities),
                    caret(formula.text, fault.span),
                )
        yield from slip_faults(one, columns)
        yield from alternative_faults(one, columns)
        yield from check_guard(one)


def _follows(
    one: Quantity,
    key: str,
    formula: Formula,
    quantities: Mapping[str, Quantity],
    dimensions: Mapping[str, Dimension],
    column_dimensions: Mapping[str, tuple[Dimension, Dimension]],
) -> bool:
    """Tell whether another fault of units may be the root of this one: it alone is told.

    That is the formula of something that is used, or of the quantity itself where this is a slip.
    """
    roots = [quantities[name] for name in formula.names if name in quantities]
    if key.startswith(("route", "slip.", "alternative.", "as_printed.")):
        roots.append(one)
    for root in roots:
        main = root.formula
        if main is None or root.kind in {Kind.VERDICT, Kind.MANUAL}:
            continue
        if (root is one and key == _FORMULA_KEY.get(root.kind, "formula")) or not {
            root.id,
            *main.names,
        } <= dimensions.keys():
            continue
        try:
            check_dimension(main, root.unit, dimensions, column_dimensions)
        except FormulaFault:
            return True
    return False


def _keyed_formulas(one: Quantity) -> Iterator[tuple[str, Formula, bool]]:
    """Yield each formula with its key and whether it must be a condition."""
    if one.formula is not None:
        yield _FORMULA_KEY.get(one.kind, "formula"), one.formula, one.kind is Kind.VERDICT
    if one.route is not None:
        yield "route", one.route, False
    if one.valid is not None:
        yield "valid", one.valid, True
    if one.choice is not None and one.choice.condition is not None:
        yield "condition", one.choice.condition, True
    for slip in one.slips:
        yield f"slip.{slip.id}", slip.formula, False
    for printed in one.as_printed:
        if printed.formula is not None:
            yield f"as_printed.{printed.erratum}", printed.formula, False
    for other in one.alternatives:
        yield f"alternative.{other.id}", other.formula, False


def _units_remedy(key: str, formula: Formula, quantities: Mapping[str, Quantity]) -> Message:
    if formula.units and not formula.units.keys() >= set(formula.names):
        units = {name: quantities[name].unit for name in formula.names} | dict(formula.units)
        written = ", ".join(f'{name} = "{unit}"' for name, unit in units.items())
        return message("Name all of them: evaluated_in = {{ {units} }}.", units=written)
    if not key.startswith("slip."):
        return message("Compare the units of both sides.")
    return message(
        "Compare the units of both sides. A missing root, power or factor needs no slip of its "
        "own: grader/slips.toml tries them on every formula. Where numbers without units are "
        "meant, write evaluated_in beside the formula."
    )


def _is_condition(formula: Formula) -> bool:
    return isinstance(formula.tree, Operation) and formula.tree.operator in _COMPARISONS


def _wrong_sort(one: Quantity, key: str, is_condition: bool) -> Problem:  # noqa: FBT001 (what was wanted)
    what = (
        message("This must be a comparison.")
        if is_condition
        else message("This must be a value, not a comparison.")
    )
    return Problem(one.file, f"quantity.{one.id}.{key}", what, message("Correct the formula."))


def _name_faults(
    one: Quantity,
    key: str,
    formula: Formula,
    usable: Collection[str],
    columns: Mapping[str, Column],
    elsewhere: Mapping[str, Collection[str]],
) -> Iterator[Problem]:
    place = f"quantity.{one.id}.{key}"
    dashed = list(dashed_names(formula.text, usable))
    for each in dashed:
        yield Problem(
            one.file,
            place,
            message("A dash in a name counts as a minus sign."),
            message("Write '{name}'.", name=each.name),
            caret(formula.text, each.span),
        )
    for part in walk(formula.tree):
        match part:
            case Name(_, span) if any(each.holds(span) for each in dashed):
                continue
            case Name(name, span) if name not in CONSTANTS and name not in usable:
                yield Problem(
                    one.file,
                    place,
                    message("The name '{name}' is not known.", name=name),
                    _unbound(name, elsewhere) or did_you_mean(name, usable),
                    caret(formula.text, span),
                )
            case Call(_, _, str(column), span) if column not in columns:
                yield Problem(
                    one.file,
                    place,
                    message("There is no catalogue column '{name}'.", name=column),
                    did_you_mean(column, columns),
                    caret(formula.text, span),
                )
            case Call("at_least" | "nearest" as function, _, str(column), span) if not _grows(
                columns[column]
            ):
                yield Problem(
                    one.file,
                    place,
                    message("The column '{name}' does not grow from row to row.", name=column),
                    _SEARCHED[function],
                    caret(formula.text, span),
                )


def _unbound(name: str, elsewhere: Mapping[str, Collection[str]]) -> Message | None:
    """Return what to do about a name that some part declares; None where none does."""
    files = elsewhere.get(name)
    if not files:
        return None
    return message(
        "The scheme lacks a part that declares it, as {files}: name it in 'parts', or declare "
        "'{name}' in the scheme.",
        files=", ".join(files),
        name=name,
    )


def _grows(column: Column) -> bool:
    return bool(np.all(np.diff(column.values) >= 0))
