"""An atlas: published figures and tables that a course reproduces from its own formulas."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from gripcourse.course.toml_table import Table, read_toml
from gripcourse.errors import CourseError, Problem
from gripcourse.formula.parse import FormulaFault, caret, parse
from gripcourse.formula.tree import Formula
from gripcourse.text.units import known as known_unit
from gripcourse.text.words import Texts, message

ATLAS_KEYS: Final = ("scheme", "work", "title", "size", "input", "figure", "row")
ATLAS_SIZE_KEYS: Final = ("symbol", "unit")
ATLAS_FIGURE_KEYS: Final = ("number", "title", "against", "from", "to", "curves")
ATLAS_ROW_KEYS: Final = ("number", "title", "size", "example")


@dataclass(frozen=True, slots=True)
class Curve:
    """One numbered line of a figure: a quantity, at fixed values of others in declared units."""

    number: int
    quantity: str
    at: Mapping[str, float]


@dataclass(frozen=True, slots=True)
class AtlasFigure:
    """A figure: its curves against one given quantity, from and to in its declared unit."""

    number: int
    title: Texts
    against: str
    low: float
    high: float
    curves: tuple[Curve, ...]


@dataclass(frozen=True, slots=True)
class AtlasSize:
    """A size of the table of cases that is no quantity of the course."""

    id: str
    symbol: str
    unit: str


@dataclass(frozen=True, slots=True)
class AtlasRow:
    """A row of a table of cases: formulas of the atlas's sizes, and an example.

    Attributes:
        sizes: as the source gives them, by id; each may use those before it and the inputs.
        example: values of quantities and inputs, in declared units.
    """

    number: int
    title: Texts
    sizes: Mapping[str, Formula]
    example: Mapping[str, float]


@dataclass(frozen=True, slots=True)
class Atlas:
    """Figures and rows of one source, about one scheme.

    Attributes:
        sizes: what every row computes, in order.
        inputs: what the examples of rows know besides quantities.
    """

    id: str
    scheme: str
    work: str
    title: Texts
    sizes: Mapping[str, AtlasSize]
    inputs: Mapping[str, AtlasSize]
    figures: tuple[AtlasFigure, ...]
    rows: tuple[AtlasRow, ...]


def load_atlas(root: Path, identifier: str) -> Atlas:
    """Load `variants/atlas/<identifier>.toml`.

    Raises:
        CourseError: with all problems of the file.
    """
    problems: list[Problem] = []
    path = root / "variants" / "atlas" / f"{identifier.replace('-', '_')}.toml"
    table = read_toml(path, root, problems)
    if table is None:
        raise CourseError(problems)
    table.known_keys(ATLAS_KEYS)
    sizes = _sizes(table, "size")
    atlas = Atlas(
        identifier,
        table.text("scheme"),
        table.text("work"),
        table.texts("title"),
        sizes,
        _sizes(table, "input"),
        tuple(_figure(one) for one in table.tables("figure")),
        tuple(_row(one, sizes) for one in table.tables("row")),
    )
    if problems:
        raise CourseError(problems)
    return atlas


def _figure(table: Table) -> AtlasFigure:
    table.known_keys(ATLAS_FIGURE_KEYS)
    return AtlasFigure(
        int(table.number("number")),
        table.texts("title"),
        table.text("against"),
        table.number("from"),
        table.number("to"),
        tuple(
            Curve(int(one.number("number")), one.text("quantity"), one.numbers("at"))
            for one in table.tables("curves")
        ),
    )


def _sizes(table: Table, name: str) -> dict[str, AtlasSize]:
    found: dict[str, AtlasSize] = {}
    for key, one in table.named_tables(name).items():
        one.known_keys(ATLAS_SIZE_KEYS)
        unit = one.text("unit")
        if not known_unit(unit):
            one.add(
                "unit",
                message("The unit '{unit}' is not known.", unit=unit),
                message("Write it as in units.csv of the package, for example 'N*m'."),
            )
        found[key] = AtlasSize(key, one.text("symbol"), unit)
    return found


def _row(table: Table, sizes: Collection[str]) -> AtlasRow:
    table.known_keys(ATLAS_ROW_KEYS)
    written = table.required_table("size")
    written.known_keys(sizes)
    return AtlasRow(
        int(table.number("number")),
        table.texts("title"),
        {name: _formula(written, name) for name in sizes},
        table.numbers("example"),
    )


def _formula(table: Table, name: str) -> Formula:
    text = table.text(name)
    try:
        return Formula(text, parse(text), {})
    except FormulaFault as fault:
        table.add(name, fault.what, message("Mend the formula."), caret(text, fault.span))
        return Formula("0", parse("0"), {})
