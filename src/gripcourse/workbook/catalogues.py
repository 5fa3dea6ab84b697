"""The sheet with the tables of standard sizes, in SI, that the formulas of a key look up."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from gripcourse.course.columns_read import columns_of_formula
from gripcourse.course.model import Catalogue
from gripcourse.formula.prose import without_looks
from gripcourse.solver.plan import Plan
from gripcourse.text.units import factor, unit_text
from gripcourse.text.words import Words, message
from gripcourse.workbook.layout import CellPlace
from gripcourse.workbook.style import Styles, set_page

if TYPE_CHECKING:
    from xlsxwriter import Workbook
    from xlsxwriter.worksheet import Worksheet

_SOURCES: Final = 2  # first row of the sources
_GAP: Final = 1  # empty columns between two tables


@dataclass(frozen=True, slots=True)
class CatalogueTable:
    """A catalogue on the sheet: its first column and the columns that are used."""

    catalogue: Catalogue
    first: int


@dataclass(frozen=True, slots=True)
class Tables:
    """The sheet: its name and its tables side by side."""

    sheet: str
    tables: tuple[CatalogueTable, ...]

    @property
    def ranges(self) -> dict[str, tuple[str, str]]:
        """Ranges of the sizes and of the column, by `catalogue.column`."""
        return {
            f"{table.catalogue.id}.{name}": (
                self._range(table, 0),
                self._range(table, index),
            )
            for table in self.tables
            for index, name in enumerate(table.catalogue.columns)
        }

    @property
    def header(self) -> int:
        """Row of the headings of the columns; one row per source and the ids stand above it."""
        return _SOURCES + len(self.tables) + 2

    def _range(self, table: CatalogueTable, index: int) -> str:
        rows = len(next(iter(table.catalogue.columns.values())))
        top = CellPlace(self.sheet, self.header + 1, table.first + index)
        bottom = CellPlace(self.sheet, self.header + rows, table.first + index)
        return f"{top.reference}:{bottom.reference.rpartition('!')[2]}"


def place_tables(plan: Plan, words: Words) -> Tables:
    """Place the catalogues that a plan reads side by side."""
    sheet = words.say(message("Catalogues"))
    tables: list[CatalogueTable] = []
    first = 0
    for catalogue in _used(plan).values():
        tables.append(CatalogueTable(catalogue, first))
        first += len(catalogue.columns) + _GAP
    return Tables(sheet, tuple(tables))


def _used(plan: Plan) -> Mapping[str, Catalogue]:
    """Return the catalogues that formulas and choices of a plan read, by id, each once."""
    columns: list[str] = []
    for name, quantity in plan.quantities.items():
        if quantity.choice is not None:
            columns.append(quantity.choice.column)
            columns += columns_of_formula(quantity.choice.condition) if quantity.steps_up else ()
        columns += columns_of_formula(plan.reference_formula(name))
    ids = dict.fromkeys(column.partition(".")[0] for column in columns)
    return {identifier: plan.course.catalogues[identifier] for identifier in ids}


def write_tables(book: "Workbook", tables: Tables, words: Words, styles: Styles) -> None:
    """Write the sheet; sizes are shown in SI, their declared unit stands in the heading.

    Args:
        book: that the sheet is added to.
        tables: where everything stands.
        words: the reader's language.
        styles: of `book`.
    """
    sheet = book.add_worksheet(tables.sheet)
    sheet.write_string(0, 0, words.say(message("Catalogues in SI units")), styles.title)
    sheet.set_row(0, 26)
    for row, table in enumerate(tables.tables, start=_SOURCES):
        source = f"{_title(table.catalogue, words)}: {table.catalogue.source.of(words.language)}"
        sheet.write_string(row, 0, source, styles.label)
    sheet.set_row(tables.header, 34)
    for table in tables.tables:
        _write_table(sheet, table, tables.header, words, styles)
    sheet.freeze_panes(tables.header + 1, 0)
    set_page(sheet, words.say(message("Catalogues")), "", landscape=True)


def _write_table(
    sheet: "Worksheet", table: CatalogueTable, header: int, words: Words, styles: Styles
) -> None:
    catalogue = table.catalogue
    sheet.write_string(header - 1, table.first, _title(catalogue, words), styles.heading)
    for column, (name, values) in enumerate(catalogue.columns.items(), start=table.first):
        sheet.set_column(column, column, 13)
        called = catalogue.headings.get(name)
        shown = "" if called is None else without_looks(called.of(words.language))
        heading = f"{shown}\n{_base(catalogue.units[name], words)}".strip()
        sheet.write_string(header, column, heading, styles.head)
        for row, value in enumerate(values, start=header + 1):
            sheet.write_number(row, column, float(value), styles.computed[0])
    gap = table.first + len(catalogue.columns)
    sheet.set_column(gap, gap, 6)


def _title(catalogue: Catalogue, words: Words) -> str:
    """Return what a catalogue is called; one that no student needs may have only its id."""
    return catalogue.id if catalogue.title is None else catalogue.title.of(words.language)


def _base(unit: str, words: Words) -> str:
    """Say how a column in SI relates to its declared unit: `1 мм = 0,001`."""
    return f"1 {unit_text(unit, words.language)} = {words.number(factor(unit))}" if unit else ""
