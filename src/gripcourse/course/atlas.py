"""An atlas: published figures and tables that a course reproduces from its own formulas."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from gripcourse.course.keys import ATLAS
from gripcourse.course.toml_table import Table, read_toml
from gripcourse.course.unit_words import unit_remedy
from gripcourse.course.written_formula import written_formula
from gripcourse.errors import Problem
from gripcourse.formula.tree import Formula
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.units import known as known_unit
from gripcourse.text.words import Texts, message


@dataclass(frozen=True, slots=True)
class Curve:
    """One numbered line of a figure: a quantity, at fixed values of others in declared units."""

    number: int
    quantity: str
    at: Mapping[str, float]


@dataclass(frozen=True, slots=True)
class AtlasFigure:
    """A figure: its curves against one given quantity, from and to in its declared unit.

    Attributes:
        ordinate: what all curves show; None where the figure does not say it.
    """

    number: int
    title: Texts
    against: str
    low: float
    high: float
    ordinate: Texts | None
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


def atlas_path(root: Path, identifier: str) -> Path:
    """Where a course keeps an atlas."""
    return root / "variants" / "atlas" / f"{identifier.replace('-', '_')}.toml"


def read_atlas(
    root: Path, identifier: str, languages: Sequence[str], problems: list[Problem]
) -> Atlas | None:
    """Read `variants/atlas/<identifier>.toml`; None: its file is missing or no TOML.

    Args:
        root: folder of the course.
        identifier: of the atlas, with hyphens.
        languages: that the course is written in.
        problems: those of the file are added to them.
    """
    path = atlas_path(root, identifier)
    if not path.exists():
        known = [one.stem.replace("_", "-") for one in path.parent.glob("*.toml")]
        what = message("The course has no atlas '{name}'.", name=identifier)
        remedy = (
            did_you_mean(identifier, known)
            if known
            else message("Write one: its keys are on the page that 'gripcourse schema' makes.")
        )
        problems.append(Problem(path.relative_to(root).as_posix(), "", what, remedy))
        return None
    table = read_toml(path, root, problems, ATLAS, languages)
    if table is None:
        return None
    table.known_keys()
    sizes = _sizes(table, "size")
    return Atlas(
        identifier,
        table.text("scheme"),
        table.text("work"),
        table.texts("title"),
        sizes,
        _sizes(table, "input"),
        tuple(_figure(one) for one in table.tables("figure")),
        tuple(_row(one, sizes) for one in table.tables("row")),
    )


def atlas_schemes(root: Path) -> frozenset[str]:
    """Return the schemes that the atlases of a course are about, as far as they can be read."""
    paths = (root / "variants" / "atlas").glob("*.toml")
    tables = (read_toml(path, root, [], ATLAS) for path in paths)
    named = (table.values.get("scheme") for table in tables if table is not None)
    return frozenset(one for one in named if isinstance(one, str))


def _figure(table: Table) -> AtlasFigure:
    table.known_keys()
    return AtlasFigure(
        int(table.number("number")),
        table.texts("title"),
        table.text("against"),
        table.number("from"),
        table.number("to"),
        table.texts("ordinate") if "ordinate" in table.values else None,
        tuple(
            Curve(int(one.number("number")), one.text("quantity"), one.numbers("at"))
            for one in table.tables("curves")
        ),
    )


def _sizes(table: Table, name: str) -> dict[str, AtlasSize]:
    found: dict[str, AtlasSize] = {}
    for key, one in table.named_tables(name).items():
        one.known_keys()
        unit = one.text("unit")
        if not known_unit(unit):
            what = message("The unit '{unit}' is not known.", unit=unit)
            one.add("unit", what, unit_remedy(unit))
        found[key] = AtlasSize(key, one.text("symbol"), unit)
    return found


def _row(table: Table, sizes: Collection[str]) -> AtlasRow:
    table.known_keys()
    written = table.required_table("size")
    written.known_keys(sizes)
    return AtlasRow(
        int(table.number("number")),
        table.texts("title"),
        {name: written_formula(written, name) for name in sizes},
        table.numbers("example"),
    )
