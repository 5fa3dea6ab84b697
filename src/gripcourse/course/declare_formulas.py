"""From a TOML table to the formulas of a quantity: right ones, wrong ones, rules of a choice."""

import math
from collections.abc import Mapping

from gripcourse.course.multiples import MOST, Multiples, between
from gripcourse.course.quantity import Alternative, AsPrinted, Choice, Rounding, Slip
from gripcourse.course.toml_table import Table
from gripcourse.course.unit_words import unit_remedy
from gripcourse.course.written_formula import read_formula
from gripcourse.formula.parse import formula_of
from gripcourse.formula.tree import Formula
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.units import known as known_unit
from gripcourse.text.words import Texts, message

_TAKE_SERIES = message(
    "Write the catalogue and column whose sizes are chosen from: 'rod.size'; or multiple_of = 1 "
    "for whole numbers."
)
_WRITE_CONDITION = message("Write the condition that the size must satisfy, or leave step_up out.")
_ROUND_UP = message(
    "Leave rounding out: the first size is the next one above, or leave step_up out."
)


def optional_formula(table: Table, name: str) -> Formula | None:
    """Read a formula that may be left out."""
    return read_formula(table, name, {}) if table.has(name) else None


def read_evaluated_in(table: Table) -> dict[str, str]:
    """Read the units in which the names of an empirical formula enter."""
    written = table.table("evaluated_in")
    if written is None:
        return {}
    units = {name: written.text(name) for name in written.values}
    for name, unit in units.items():
        if not known_unit(unit):
            written.add(
                name,
                message("The unit '{unit}' is not known.", unit=unit),
                unit_remedy(unit),
            )
            units[name] = ""
    return units


def read_choice(table: Table, unit: str, bounds: tuple[float, float]) -> Choice:
    """Read the rule of a design decision.

    Args:
        table: of its quantity.
        unit: of the quantity.
        bounds: of the quantity, which end a series of multiples.
    """
    steps = table.number("at_most_steps") if table.has("at_most_steps") else None
    if steps is not None and math.isnan(steps):
        steps = None  # reported as no number
    if steps is not None and (steps < 0 or steps != int(steps)):
        table.add(
            "at_most_steps",
            message("The number of steps is {steps}.", steps=steps),
            message("Write a whole number from 0 on."),
        )
    multiples = _multiples(table, unit, bounds) if table.has("multiple_of") else None
    if not (table.has("series") or table.has("multiple_of")):
        table.add("series", message("This key is missing."), _TAKE_SERIES)
    if table.has("series") and table.has("multiple_of"):
        what = message("A size is taken from a series or is a multiple, not both.")
        table.add("multiple_of", what, message("Remove one of the keys."))
    series = table.text("series") if table.has("series") else ""
    rounding, step_up = _rounding(table), table.flag("step_up")
    if step_up and not table.has("condition"):
        table.add("step_up", message("There is no condition to step up by."), _WRITE_CONDITION)
    if step_up and rounding is Rounding.NEAREST:
        table.add("step_up", message("The nearest size does not step up."), _ROUND_UP)
    return Choice(
        column=series if multiples is None else multiples.column,
        also=table.strings("also"),
        rounding=rounding,
        condition=optional_formula(table, "condition"),
        steps=None if steps is None else int(steps),
        step_up=step_up,
        multiples=multiples,
    )


def _multiples(table: Table, unit: str, bounds: tuple[float, float]) -> Multiples | None:
    """Read of what number the sizes are multiples; None (and a problem) for what gives no sizes."""
    step = table.number("multiple_of")
    if not (math.isfinite(step) and all(map(math.isfinite, bounds))):
        return None  # reported as no number
    if step <= 0:
        what = message("Nothing is a multiple of {number}.", number=step)
        table.add("multiple_of", what, message("Write a number greater than 0."))
        return None
    found = between(step, unit, bounds)
    count = max(found.last - found.first + 1, 0)
    if not 0 < count <= MOST:
        what = message("Between the bounds of the quantity it has {count} multiples.", count=count)
        remedy = message("Write bounds or a number that leave 1 to {most}.", most=MOST)
        table.add("multiple_of", what, remedy)
        return None
    return found


def _rounding(table: Table) -> Rounding:
    written = table.text("rounding", Rounding.UP)
    if written in list(Rounding):
        return Rounding(written)
    table.add(
        "rounding",
        message("There is no rounding '{rounding}'.", rounding=written),
        did_you_mean(written, list(Rounding)),
    )
    return Rounding.UP


def _wrong_formula(table: Table, units: Mapping[str, str]) -> Formula | None:
    """Read a wrong version of a formula; of an empirical one it need not use every name."""
    formula = read_formula(table, "formula", {})
    if formula is None:
        return None
    used = {name: unit for name, unit in units.items() if name in formula.names}
    return Formula(formula.text, formula.tree, used)


def read_slips(table: Table, units: Mapping[str, str]) -> tuple[Slip, ...]:
    """Read the anticipated wrong methods of a quantity."""
    return tuple(_slip(slip, units) for slip in table.tables("slip"))


def read_versions(table: Table, units: Mapping[str, str]) -> tuple[AsPrinted, ...]:
    """Read the versions of a quantity that sources print."""
    return tuple(_as_printed(printed, units) for printed in table.tables("as_printed"))


def read_alternatives(table: Table, units: Mapping[str, str]) -> tuple[Alternative, ...]:
    """Read the other honest readings of a quantity."""
    return tuple(_alternative(one, units) for one in table.tables("alternative"))


def _alternative(table: Table, units: Mapping[str, str]) -> Alternative:
    table.known_keys()
    formula = _wrong_formula(table, units) or formula_of("0", {})
    return Alternative(table.text("id"), formula, table.texts("remark"))


def _slip(table: Table, units: Mapping[str, str]) -> Slip:
    table.known_keys()
    credit = table.number("credit")
    if credit < 0 or credit > 1:
        table.add(
            "credit",
            message("The credit is {credit}.", credit=credit),
            message("Write a share of the points from 0 to 1."),
        )
    fallback = formula_of("0", {})
    formula = _wrong_formula(table, read_evaluated_in(table) or units) or fallback
    hint = table.texts("hint")
    return Slip(table.text("id"), formula, credit, hint, table.flag("seldom"))


def _as_printed(table: Table, units: Mapping[str, str]) -> AsPrinted:
    table.known_keys()
    if table.has("formula") == table.has("rounding"):
        table.add(
            "",
            message("A printed version differs in its formula or in its rounding."),
            message("Write exactly one of 'formula' and 'rounding'."),
        )
    note: Texts = table.texts("note")
    return AsPrinted(
        erratum=table.text("erratum"),
        formula=_wrong_formula(table, units) if table.has("formula") else None,
        rounding=_rounding(table) if table.has("rounding") else None,
        note=note,
    )
