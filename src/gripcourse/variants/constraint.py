"""The constraints of a space: conditions over given and computed quantities."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

from gripcourse.course.toml_table import Table
from gripcourse.course.unit_words import unit_remedy
from gripcourse.formula.dimension import check_dimension
from gripcourse.formula.parse import FormulaFault, caret, parse
from gripcourse.formula.tree import Formula, Name, Node, Number, Operation, names, walk
from gripcourse.solver.plan import Plan
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.units import dimension, factor, known
from gripcourse.text.words import Texts, message

_COMPARISONS = ("<", "<=", ">", ">=", "==")


@dataclass(frozen=True, slots=True)
class Constraint:
    """What a variant must satisfy besides being solvable.

    Attributes:
        formula: the condition.
        title: what it asks for, as a sentence; None where nobody wrote one.
    """

    formula: Formula = field(hash=False)  # its units are a mapping, which has no hash
    title: Texts | None = field(default=None, hash=False)


def read_constraints(table: Table) -> list[tuple[Table, Constraint]]:
    """Read `[[constraint]]`: a formula, `title` and, beside bare numbers, `evaluated_in`.

    Args:
        table: the space; problems are recorded there.

    Returns:
        The constraints that could be read, each with its table.
    """
    found: list[tuple[Table, Constraint]] = []
    for place in table.tables("constraint"):
        place.known_keys()
        text = place.text("formula")
        units = _units(place)
        title = place.texts("title") if place.has("title") else None
        if not text:
            continue
        try:
            found.append((place, Constraint(Formula(text, parse(text), units), title)))
        except FormulaFault as fault:
            place.add(
                "formula", fault.what, message("Correct the formula."), caret(text, fault.span)
            )  # fmt: skip
    return found


def check_constraint(place: Table, constraint: Formula, plans: Sequence[Plan]) -> None:
    """Record what is wrong with a constraint: not a condition, unknown names, unlike units.

    A constraint counts for every combination of options that has all of its quantities; one that
    counts for none is a misspelling.

    Args:
        place: its table.
        constraint: as read.
        plans: of all combinations of options.
    """
    if not _is_condition(constraint.tree):
        place.add(
            "formula",
            message("This is a value, not a condition."),
            message("Write a comparison, like 'width >= 1.5*height'."),
        )
        return
    wanted = set(names(constraint.tree))
    meant = [plan for plan in plans if wanted <= plan.quantities.keys()]
    if not meant:
        _report_unknown(place, wanted, {id_ for plan in plans for id_ in plan.quantities})
        return
    alike = {tuple(plan.quantities[name].unit for name in wanted): plan for plan in meant}
    for plan in alike.values():  # of hundreds of combinations one for each set of units
        if _has_problem(place, constraint, plan):
            return


def _report_unknown(place: Table, wanted: Iterable[str], known_ids: set[str]) -> None:
    for name in sorted(set(wanted) - known_ids):
        place.add(
            "formula",
            message("There is no quantity '{name}' in this scheme.", name=name),
            did_you_mean(name, known_ids),
        )
    if set(wanted) <= known_ids:
        place.add(
            "formula",
            message("No combination of the options has all these quantities."),
            message("Split the constraint."),
        )


def _has_problem(place: Table, constraint: Formula, plan: Plan) -> bool:
    bare = _bare_scaled_name(constraint, plan)
    if bare is not None:
        unit = plan.quantities[bare].unit
        place.add(
            "formula",
            message("'{name}' is compared with a bare number: in '{unit}', or in SI?", name=bare,
                    unit=unit),
            message('Write evaluated_in = {{ {name} = "{unit}" }} beside it.', name=bare,
                    unit=unit),
        )  # fmt: skip
        return True
    dimensions = {id_: dimension(quantity.unit) for id_, quantity in plan.quantities.items()}
    columns = {
        f"{catalogue.id}.{name}": (
            dimension(next(iter(catalogue.units.values()))),
            dimension(unit),
        )
        for catalogue in plan.course.catalogues.values()
        for name, unit in catalogue.units.items()
    }
    try:
        check_dimension(constraint, "", dimensions, columns)
    except FormulaFault as fault:
        place.add(
            "formula",
            fault.what,
            message("Compare like with like, or add evaluated_in."),
            caret(constraint.text, fault.span),
        )
        return True
    return False


def _units(place: Table) -> dict[str, str]:
    written = place.table("evaluated_in")
    units = {} if written is None else {name: written.text(name) for name in written.values}
    for name, unit in units.items():
        if not known(unit):
            place.add(
                f"evaluated_in.{name}",
                message("The unit '{unit}' is not known.", unit=unit),
                unit_remedy(unit),
            )
            units[name] = ""
    return units


def _is_condition(tree: Node) -> bool:
    return isinstance(tree, Operation) and (tree.operator == "and" or tree.operator in _COMPARISONS)


def _bare_scaled_name(constraint: Formula, plan: Plan) -> str | None:
    """Find an angle or a percentage beside a bare number: units cannot tell which is meant."""
    for part in walk(constraint.tree):
        match part:
            case Operation(operator, Name(id_), Number()) if operator in _COMPARISONS:
                pass
            case Operation(operator, Number(), Name(id_)) if operator in _COMPARISONS:
                pass
            case _:
                continue
        unit = plan.quantities[id_].unit
        if id_ not in constraint.units and dimension(unit).dimensionless and factor(unit) != 1.0:
            return id_
    return None
