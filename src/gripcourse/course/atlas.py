"""An atlas: published figures and tables that a course reproduces from its own formulas."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from gripcourse.course.keys import ATLAS
from gripcourse.course.toml_table import Table, read_toml
from gripcourse.errors import CourseError, Problem
from gripcourse.formula.parse import FormulaFault, caret, parse
from gripcourse.formula.tree import Formula
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import Texts, message


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
class AtlasRow:
    """A row of a table of cases: formulas of the inclination and the diameter, and an example.

    Attributes:
        inclination, diameter: as the source gives them; the diameter may use `inclination`, both
            may use `tilt`, each a size without a sign.
        example: values for them, in declared units; angles of `tilt` in degrees.
    """

    number: int
    title: Texts
    inclination: Formula
    diameter: Formula
    example: Mapping[str, float]


@dataclass(frozen=True, slots=True)
class Atlas:
    """Figures and rows of one source, about one scheme."""

    id: str
    scheme: str
    work: str
    title: Texts
    figures: tuple[AtlasFigure, ...]
    rows: tuple[AtlasRow, ...]


def load_atlas(root: Path, identifier: str) -> Atlas:
    """Load `variants/atlas/<identifier>.toml`.

    Raises:
        CourseError: with all problems of the file.
    """
    problems: list[Problem] = []
    path = root / "variants" / "atlas" / f"{identifier.replace('-', '_')}.toml"
    if not path.exists():
        known = [one.stem.replace("_", "-") for one in path.parent.glob("*.toml")]
        what = message("The course has no atlas '{name}'.", name=identifier)
        remedy = (
            did_you_mean(identifier, known)
            if known
            else message("Write one: its keys are on the page that 'gripcourse schema' makes.")
        )
        raise CourseError([Problem(path.relative_to(root).as_posix(), "", what, remedy)])
    table = read_toml(path, root, problems, ATLAS)
    if table is None:
        raise CourseError(problems)
    table.known_keys()
    atlas = Atlas(
        identifier,
        table.text("scheme"),
        table.text("work"),
        table.texts("title"),
        tuple(_figure(one) for one in table.tables("figure")),
        tuple(_row(one) for one in table.tables("row")),
    )
    if problems:
        raise CourseError(problems)
    return atlas


def _figure(table: Table) -> AtlasFigure:
    table.known_keys()
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


def _row(table: Table) -> AtlasRow:
    table.known_keys()
    return AtlasRow(
        int(table.number("number")),
        table.texts("title"),
        _formula(table, "inclination"),
        _formula(table, "diameter"),
        table.numbers("example"),
    )


def _formula(table: Table, name: str) -> Formula:
    text = table.text(name)
    try:
        return Formula(text, parse(text), {})
    except FormulaFault as fault:
        table.add(name, fault.what, message("Mend the formula."), caret(text, fault.span))
        return Formula("0", parse("0"), {})
