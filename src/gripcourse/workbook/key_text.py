"""What the key says about a quantity in words: its formula on one line, source, tolerance."""

from gripcourse.course.column_symbols import column_symbols
from gripcourse.course.quantity import Kind, Quantity, Rounding
from gripcourse.formula.boxes import Box
from gripcourse.formula.plain import text
from gripcourse.formula.prose import without_looks
from gripcourse.formula.tree import Call, Formula, names, walk
from gripcourse.formula.typeset import symbol_box, typeset
from gripcourse.solver.band_text import band_text
from gripcourse.solver.condition_text import condition_text
from gripcourse.solver.plan import Plan
from gripcourse.solver.sizes import reference_rounding, reference_steps_up
from gripcourse.text.units import unit_text
from gripcourse.text.words import Words, message


def formula_text(quantity: Quantity, plan: Plan, words: Words) -> str:
    """Return the reference formula on one line, with symbols; empty where there is none."""
    formula = plan.reference_formula(quantity.id)
    if formula is None or quantity.kind in {Kind.GIVEN, Kind.CONSTANT}:
        return ""
    own = quantity.symbol.of(words.language)
    written = text(typeset(formula.tree, _symbols(formula, quantity, plan, words), words.language))
    if quantity.kind is Kind.VERDICT:
        return written
    if quantity.choice is None:
        return f"{own} = {written}{_units(formula, plan, words)}"
    if reference_rounding(quantity, plan.convention) is Rounding.NEAREST:
        rule = message(
            "{own} ≈ {required}, from {series}",
            own=own,
            required=written,
            series=_series(quantity, plan, words),
        )
    else:
        rule = message(
            "{own} ≥ {required}, from {series}",
            own=own,
            required=written,
            series=_series(quantity, plan, words),
        )
    if reference_steps_up(quantity, plan.convention):
        condition = condition_text(quantity, plan, words.language)
        rule = message("{rule}: the smallest for which {condition}", rule=rule, condition=condition)
    return words.say(rule)


def source_text(quantity: Quantity, plan: Plan, words: Words) -> str:
    """Return where a quantity comes from: the work's number in the list, equation, note."""
    source, cited = quantity.source, cited_works(plan)
    number = f"[{cited.index(source.work) + 1}]" if source.work in cited else ""
    note = source.told(words.language)
    return "; ".join(part for part in (f"{number} {source.equation}".strip(), note) if part)


def cited_works(plan: Plan) -> tuple[str, ...]:
    """Return the ids of the works that a plan's quantities come from, in the course's order."""
    cited = {quantity.source.work for quantity in plan.quantities.values()}
    return tuple(id_ for id_ in plan.course.works if id_ in cited)


def tolerance_text(quantity: Quantity, words: Words) -> str:
    """Return the band of a quantity's own, or how else it is judged."""
    if quantity.kind is Kind.MANUAL:
        return words.say(message("marked by the instructor"))
    if quantity.kind is Kind.VERDICT:
        return words.say(message("yes or no"))
    if quantity.choice is not None:
        return words.say(message("by its rule"))
    if quantity.kind in {Kind.GIVEN, Kind.CONSTANT}:
        return ""
    if quantity.tolerance is None:
        return words.say(message("by the policy"))
    return band_text(quantity.tolerance, quantity.unit, words)


def _symbols(formula: Formula, quantity: Quantity, plan: Plan, words: Words) -> dict[str, Box]:
    """Return the symbol of every name, and what stands for the tables that are read."""
    own = symbol_box(quantity.symbol.of(words.language))
    calls = (node for node in walk(formula.tree) if isinstance(node, Call))
    columns = {call.column: own for call in calls if call.column is not None}
    catalogues = plan.course.catalogues
    read = column_symbols(formula.tree, quantity, plan.quantities, catalogues, words.language)
    return (
        columns
        | read
        | {
            name: symbol_box(plan.quantities[name].symbol.of(words.language))
            for name in names(formula.tree)
        }
    )


def _units(formula: Formula, plan: Plan, words: Words) -> str:
    """Say in which units the bare numbers of an empirical formula stand."""
    listed = [
        f"{plan.quantities[name].symbol.of(words.language)}, {unit_text(unit, words.language)}"
        for name, unit in formula.units.items()
        if unit
    ]
    return f"  [{'; '.join(listed)}]" if listed else ""


def _series(quantity: Quantity, plan: Plan, words: Words) -> str:
    """Return what a person calls the series that a size is taken from."""
    if quantity.choice is None:
        return ""
    catalogue = plan.course.catalogues[quantity.choice.column.partition(".")[0]]
    title = catalogue.source if catalogue.title is None else catalogue.title
    return words.say(message("“{title}”", title=without_looks(title.of(words.language))))
