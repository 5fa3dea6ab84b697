"""From a TOML table to the declaration of a quantity."""

import math
from collections.abc import Mapping

from gripcourse.course.model import (
    AsPrinted,
    Choice,
    Kind,
    Quantity,
    Rounding,
    Slip,
    Source,
    Tolerance,
)
from gripcourse.course.toml_table import Table
from gripcourse.formula.functions import FUNCTIONS
from gripcourse.formula.parse import FormulaFault, caret, parse
from gripcourse.formula.tree import CONSTANTS, Formula, names
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.units import known as known_unit
from gripcourse.text.words import LANGUAGES, Texts, message

_COMMON = {"section", "kind", "symbol", "unit", "title", "explain", "source"}
_BOUNDED = {"bounds", "integer"}
_JUDGED = {"valid", "tolerance", "slip", "as_printed", "evaluated_in"}
_KEYS: dict[Kind, set[str]] = {
    Kind.GIVEN: _COMMON | _BOUNDED,
    Kind.CONSTANT: _COMMON | _BOUNDED | {"value"},
    Kind.FORMULA: _COMMON | _BOUNDED | _JUDGED | {"formula"},
    Kind.CHOICE: _COMMON
    | _BOUNDED
    | _JUDGED
    | {"series", "also", "at_least", "condition", "at_most_steps", "rounding"},
    Kind.PICK: _COMMON | _BOUNDED | _JUDGED | {"formula"},
    Kind.VERDICT: _COMMON | {"condition", "must_hold"},
    Kind.MANUAL: _COMMON | {"rubric"},
}
_FORMULA_KEY = {
    Kind.FORMULA: "formula",
    Kind.PICK: "formula",
    Kind.CHOICE: "at_least",
    Kind.VERDICT: "condition",
}
_NO_BOUNDS = (float("-inf"), float("inf"))
_TRUTH_BOUNDS = (0.0, 1.0)


def declare(identifier: str, table: Table, *, constant: bool = False) -> Quantity:
    """Read one quantity; its faults are recorded."""
    _check_id(identifier, table)
    kind = Kind.CONSTANT if constant else _kind(table)
    if kind is None:
        return _stand_in(identifier, table)
    table.known_keys(_KEYS[kind])
    units = _evaluated_in(table)
    return Quantity(
        id=identifier,
        section="" if constant else table.text("section"),
        kind=kind,
        symbol=table.texts("symbol", may_be_empty=kind is Kind.MANUAL),
        unit=_unit(table, kind),
        title=table.texts("title"),
        explain=table.texts("explain") if table.has("explain") else None,
        source=source(table.required_table("source")),
        formula=_formula(table, _FORMULA_KEY[kind], units) if kind in _FORMULA_KEY else None,
        choice=_choice(table) if kind is Kind.CHOICE else None,
        value=table.number("value") if kind is Kind.CONSTANT else None,
        valid=_formula(table, "valid", {}) if table.has("valid") else None,
        tolerance=_tolerance(table),
        bounds=_bounds(table, kind),
        integer=table.flag("integer"),
        slips=tuple(_slip(slip, units) for slip in table.tables("slip")),
        as_printed=tuple(_as_printed(printed, units) for printed in table.tables("as_printed")),
        must_hold=kind is Kind.VERDICT and table.flag("must_hold", default=True),
        rubric=_rubric(table) if kind is Kind.MANUAL else "",
        file=table.file,
    )


def _rubric(table: Table) -> str:
    name = table.text("rubric")
    if not name and table.values.get("rubric") == "":
        table.add(
            "rubric",
            message("A person needs a rubric to mark this item."),
            message("Write the name of a file in grader/rubric, without .toml."),
        )
    return name


def source(table: Table) -> Source:
    """Read where something comes from."""
    table.known_keys({"work", "equation", "note"})
    note = table.texts("note") if "note" in table.values else None
    return Source(table.text("work"), table.text("equation", ""), note)


def _check_id(identifier: str, table: Table) -> None:
    """Refuse an id that a formula would not take for a name."""
    if not (identifier.isascii() and identifier.isidentifier()) or identifier in {
        *FUNCTIONS,
        *CONSTANTS,
    }:
        table.add(
            "",
            message("A formula cannot use the name '{name}'.", name=identifier),
            message("Take Latin letters, digits and _, and no function's name."),
        )


def _stand_in(identifier: str, table: Table) -> Quantity:
    """Return what is known of a quantity whose kind is not, lest all its users be reported too."""
    silent = Table(table.values, table.file, table.key, [])
    nothing = Texts(dict.fromkeys(LANGUAGES, ""))
    return Quantity(
        id=identifier,
        section="",
        kind=Kind.FORMULA,
        symbol=nothing,
        unit=_unit(silent, Kind.FORMULA),
        title=nothing,
        explain=None,
        source=Source(""),
        formula=None,
        choice=None,
        value=None,
        valid=None,
        tolerance=None,
        bounds=_NO_BOUNDS,
        integer=False,
        slips=(),
        as_printed=(),
        must_hold=False,
        rubric="",
        file=table.file,
    )


def _kind(table: Table) -> Kind | None:
    written = table.text("kind")
    kinds = [kind for kind in Kind if kind is not Kind.CONSTANT]
    if written in kinds:
        return Kind(written)
    if written:
        table.add(
            "kind",
            message("There is no kind '{kind}'.", kind=written),
            did_you_mean(written, kinds),
        )
    return None


def _unit(table: Table, kind: Kind) -> str:
    unit = table.text("unit", "" if kind in {Kind.VERDICT, Kind.MANUAL} else None)
    if not known_unit(unit):
        table.add(
            "unit",
            message("The unit '{unit}' is not known.", unit=unit),
            message("Write it as in units.csv of the package, for example 'N*m'."),
        )
    return unit  # as written, so that the check knows what cannot be compared with it


def _bounds(table: Table, kind: Kind) -> tuple[float, float]:
    if kind is Kind.VERDICT:
        return _TRUTH_BOUNDS
    if kind is not Kind.MANUAL and not table.has("bounds"):
        table.add(
            "bounds",
            message("This key is missing."),
            message("Write the lowest and the highest value that is physically thinkable."),
        )
    return table.pair("bounds", _NO_BOUNDS)


def _formula(table: Table, name: str, units: Mapping[str, str]) -> Formula | None:
    text = table.text(name)
    if not text:
        return None
    try:
        return Formula(text, parse(text), dict(units))
    except FormulaFault as fault:
        table.add(name, fault.what, message("Mend the formula."), caret(text, fault.span))
        return None


def _evaluated_in(table: Table) -> dict[str, str]:
    written = table.table("evaluated_in")
    if written is None:
        return {}
    units = {name: written.text(name) for name in written.values}
    for name, unit in units.items():
        if not known_unit(unit):
            written.add(
                name,
                message("The unit '{unit}' is not known.", unit=unit),
                message("Write it as in units.csv of the package, for example 'N*m'."),
            )
            units[name] = ""
    return units


def _tolerance(table: Table) -> Tolerance | None:
    written = table.table("tolerance")
    if written is None:
        return None
    written.known_keys({"relative", "absolute"})
    return tolerance(written)


def tolerance(table: Table) -> Tolerance:
    """Read a band; neither part may be negative."""
    band = Tolerance(table.number("relative", 0.0), table.number("absolute", 0.0))
    for name, value in (("relative", band.relative), ("absolute", band.absolute)):
        if value < 0:
            table.add(
                name,
                message("The tolerance {value} is negative.", value=value),
                message("Write 0 or a positive number."),
            )
    return band


def _choice(table: Table) -> Choice:
    steps = table.number("at_most_steps") if table.has("at_most_steps") else None
    if steps is not None and math.isnan(steps):
        steps = None  # reported as no number
    if steps is not None and (steps < 0 or steps != int(steps)):
        table.add(
            "at_most_steps",
            message("The number of steps is {steps}.", steps=steps),
            message("Write a whole number from 0 on."),
        )
    return Choice(
        column=table.text("series"),
        also=table.strings("also"),
        rounding=_rounding(table),
        condition=_formula(table, "condition", {}) if table.has("condition") else None,
        steps=None if steps is None else int(steps),
    )


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
    formula = _formula(table, "formula", {})
    if formula is None:
        return None
    used = {name: unit for name, unit in units.items() if name in names(formula.tree)}
    return Formula(formula.text, formula.tree, used)


def _slip(table: Table, units: Mapping[str, str]) -> Slip:
    table.known_keys({"id", "formula", "credit", "hint"})
    credit = table.number("credit")
    if credit < 0 or credit > 1:
        table.add(
            "credit",
            message("The credit is {credit}.", credit=credit),
            message("Write a share of the points from 0 to 1."),
        )
    fallback = Formula("0", parse("0"), {})
    formula = _wrong_formula(table, units) or fallback
    return Slip(table.text("id"), formula, credit, table.texts("hint"))


def _as_printed(table: Table, units: Mapping[str, str]) -> AsPrinted:
    table.known_keys({"erratum", "formula", "rounding", "note"})
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
