"""From a TOML table to the declaration of a quantity."""

import math
from keyword import iskeyword
from typing import Final

from gripcourse.course.dashes import without_dashes
from gripcourse.course.declare_formulas import (
    optional_formula,
    read_alternatives,
    read_choice,
    read_evaluated_in,
    read_slips,
    read_versions,
)
from gripcourse.course.quantity import Kind, Quantity, Source, Tolerance
from gripcourse.course.quantity_keys import WIDEST_TOLERANCE
from gripcourse.course.toml_table import Table
from gripcourse.course.unit_words import unit_remedy
from gripcourse.course.written_formula import read_formula
from gripcourse.formula.functions import FUNCTIONS
from gripcourse.formula.tree import CONSTANTS
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.units import known as known_unit
from gripcourse.text.words import LANGUAGES, Texts, message

_INPUTS = frozenset({Kind.GIVEN, Kind.CONSTANT})
_COMPUTED = frozenset({Kind.FORMULA, Kind.CHOICE, Kind.PICK})
_FORMULA_KEY = {
    Kind.FORMULA: "formula",
    Kind.PICK: "formula",
    Kind.CHOICE: "at_least",
    Kind.VERDICT: "condition",
}
NO_UNIT: Final = "?"
"""Of a quantity whose unit nobody knows: an unknown one, so that nothing is compared with it."""
_NO_BOUNDS = (float("-inf"), float("inf"))
_TRUTH_BOUNDS = (0.0, 1.0)


def declare(identifier: str, table: Table, *, constant: bool = False) -> Quantity:
    """Read one quantity; its faults are recorded.

    One whose name has dashes is known by the name that formulas can use: who uses it is right.
    """
    _check_id(identifier, table)
    identifier = without_dashes(identifier)
    kind = Kind.CONSTANT if constant else _kind(table)
    if kind is None:
        return _stand_in(identifier, table)
    table.known_keys()
    is_computed = kind in _COMPUTED
    units = read_evaluated_in(table) if is_computed else {}
    bounds, unit = _bounds(table, kind), _unit(table, kind)
    return Quantity(
        id=identifier,
        section="" if constant else table.text("section"),
        kind=kind,
        symbol=table.texts("symbol", may_be_empty=kind is Kind.MANUAL),
        unit=unit,
        title=table.texts("title"),
        explain=table.texts("explain") if table.has("explain") else None,
        decides=table.texts("decides") if table.has("decides") else None,
        note_decides=table.flag("note_decides"),
        formula_decides=table.flag("formula_decides"),
        one_end=table.texts("one_end") if table.has("one_end") else None,
        source=source(table.required_table("source")),
        formula=read_formula(table, _FORMULA_KEY[kind], units) if kind in _FORMULA_KEY else None,
        route=optional_formula(table, "route") if kind is Kind.FORMULA else None,
        read_from=table.text("read_from", "") if kind is Kind.FORMULA else "",
        choice=read_choice(table, unit, bounds) if kind is Kind.CHOICE else None,
        value=_thinkable(table, "value", bounds) if kind is Kind.CONSTANT else None,
        valid=optional_formula(table, "valid") if is_computed else None,
        tolerance=_tolerance(table) if is_computed else None,
        default=_default(table, bounds) if kind is Kind.GIVEN else None,
        range=table.table("range") if kind is Kind.GIVEN else None,
        bounds=bounds,
        integer=table.flag("integer") if is_computed or kind in _INPUTS else False,
        slips=read_slips(table, units) if is_computed else (),
        as_printed=read_versions(table, units) if is_computed else (),
        alternatives=read_alternatives(table, units) if is_computed else (),
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
    table.known_keys()
    note = table.texts("note") if "note" in table.values else None
    mark = table.texts("mark") if "mark" in table.values else None
    return Source(table.text("work"), table.text("equation", ""), note, mark)


def _check_id(identifier: str, table: Table) -> None:
    """Refuse an id that a formula would not take for a name."""
    is_name = identifier.isascii() and identifier.isidentifier() and not iskeyword(identifier)
    if not is_name or identifier in {*FUNCTIONS, *CONSTANTS}:
        table.add(
            "",
            message("A formula cannot use the name '{name}'.", name=identifier),
            message(
                "Take Latin letters, digits and _, no dash, no function's name and no word such as"
                " and, if, class."
            ),
        )


def _stand_in(identifier: str, table: Table) -> Quantity:
    """Return what is known of a quantity whose kind is not: its users are not at fault."""
    silent = Table(table.values, table.file, table.key, [])  # of no kind: of no shape
    nothing = Texts(dict.fromkeys(LANGUAGES, ""))
    return Quantity(
        id=identifier,
        section="",
        kind=Kind.FORMULA,
        symbol=nothing,
        unit=_unit(silent, Kind.FORMULA),
        title=nothing,
        explain=None,
        decides=None,
        note_decides=False,
        formula_decides=False,
        one_end=None,
        source=Source(""),
        formula=None,
        route=None,
        read_from="",
        choice=None,
        value=None,
        valid=None,
        tolerance=None,
        default=None,
        range=None,
        bounds=_NO_BOUNDS,
        integer=False,
        slips=(),
        as_printed=(),
        alternatives=(),
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
    if kind not in {Kind.VERDICT, Kind.MANUAL} and not isinstance(table.values.get("unit"), str):
        return NO_UNIT
    if not known_unit(unit):
        table.add(
            "unit",
            message("The unit '{unit}' is not known.", unit=unit),
            unit_remedy(unit),
        )
    return unit  # as written, so that the check knows what cannot be compared with it


def _bounds(table: Table, kind: Kind) -> tuple[float, float]:
    if kind is Kind.VERDICT:
        return _TRUTH_BOUNDS
    if kind is Kind.MANUAL:
        return _NO_BOUNDS
    if not table.has("bounds"):
        table.add(
            "bounds",
            message("This key is missing."),
            message("Write the lowest and the highest value that is physically thinkable."),
        )
    return table.pair("bounds", _NO_BOUNDS)


def _default(table: Table, bounds: tuple[float, float]) -> float | None:
    """Read what a given is where nobody says otherwise; it must be possible."""
    if not table.has("default"):
        return None
    value = _thinkable(table, "default", bounds)
    return None if math.isnan(value) else value


def _thinkable(table: Table, name: str, bounds: tuple[float, float]) -> float:
    """Read a number that lies between the bounds of its quantity."""
    value = table.number(name)
    low, high = bounds
    if value < low or value > high:
        table.add(
            name,
            message("The value {value} is outside the bounds {low} to {high} of the quantity.",
                    value=value, low=low, high=high),
            message("Write a value between the bounds, or correct the bounds."),
        )  # fmt: skip
    return value


def _tolerance(table: Table) -> Tolerance | None:
    written = table.table("tolerance")
    if written is None:
        return None
    written.known_keys()
    return tolerance(written)


def tolerance(table: Table) -> Tolerance:
    """Read a band; neither part may be negative."""
    relative = table.number("relative", 0.0, within=False)
    band = Tolerance(relative, table.number("absolute", 0.0, within=False))
    if band.relative > WIDEST_TOLERANCE:
        table.add(
            "relative",
            message("The tolerance {value} is {percent} % of the value.", value=band.relative,
                    percent=100 * band.relative),
            message("Write a share of 0.5 at most: 0.02 is 2 %."),
        )  # fmt: skip
    for name, value in (("relative", band.relative), ("absolute", band.absolute)):
        if value < 0:
            table.add(
                name,
                message("The tolerance {value} is negative.", value=value),
                message("Write 0 or a positive number."),
            )
    return band
