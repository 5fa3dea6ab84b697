"""What a student has on the table: given values, options and tables of an issued workbook."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from openpyxl import load_workbook
from openpyxl.workbook import Workbook
from openpyxl.worksheet.worksheet import Worksheet

# Numbers of the whole course have no name in the workbook: they are found by their symbols.
_CONSTANTS: Final = {
    "g": "gravity",
    "b0": "least_jaw_width",
    "a0": "least_jaw_thickness",
    "ke": "eye_factor",
    "ks": "slenderness_allowed",
    "μ0": "magnetic_constant",
}

Columns = Mapping[str, tuple[float, ...]]


@dataclass(frozen=True)
class Table:
    """A table of the workbook.

    Attributes:
        title: as printed, without its number.
        columns: numbers by the title of their column; of a plain series under an empty title.
    """

    title: str
    columns: Columns

    def column(self, title: str) -> tuple[float, ...]:
        """Return the column whose title begins so."""
        return next(values for name, values in self.columns.items() if name.startswith(title))


@dataclass(frozen=True)
class Sheet:
    """An issued workbook, as its student reads it.

    Attributes:
        scheme: id of the scheme.
        options: what the variant chooses, by id.
        given: given values in the units that are printed beside them, by id.
        tables: series and tables.
        asked: ids of the quantities that have an answer cell.
    """

    scheme: str
    options: Mapping[str, str]
    given: Mapping[str, float]
    tables: tuple[Table, ...]
    asked: frozenset[str]

    def table(self, title: str) -> Table:
        """Return the table whose title has this in it."""
        return next(one for one in self.tables if title in one.title)


def read_sheet(file: Path) -> Sheet:
    """Read an issued workbook in English with an ordinary library."""
    book = load_workbook(file)
    meta, given = _named(book, "meta."), _named(book, "given.")
    options = dict(one.split("=") for one in str(meta["options"]).split("; ") if one)
    constants = {
        _CONSTANTS[str(symbol)]: float(value)
        for _, symbol, _, _, value, *_ in book["Assignment"].iter_rows(values_only=True)
        if symbol in _CONSTANTS and isinstance(value, int | float)
    }
    return Sheet(
        scheme=str(meta["scheme"]),
        options=options,
        given=constants | {name: float(str(value)) for name, value in given.items()},
        tables=_tables(book["Series"]),
        asked=frozenset(_named(book, "answer.")),
    )


def fill_in(file: Path, typed: Callable[[str], float | str], asked: frozenset[str]) -> None:
    """Type the answers that are asked for into the workbook, in place."""
    book = load_workbook(file)
    for quantity in asked:
        for sheet, address in book.defined_names[f"answer.{quantity}"].destinations:
            book[sheet][address] = typed(quantity)
    book.save(file)


def _named(book: Workbook, prefix: str) -> dict[str, object]:
    """Return the contents of the named cells whose name begins so, by the rest of it."""
    found = {}
    for name, defined in book.defined_names.items():
        if name.startswith(prefix):
            ((sheet, address),) = defined.destinations
            found[name.removeprefix(prefix)] = book[sheet][address].value
    return found


def _tables(sheet: Worksheet) -> tuple[Table, ...]:
    """Read titles, headings and numbers below each other; a wide table has headings twice."""
    tables, title, columns = list[Table](), "", dict[str, list[float]]()
    heads: list[str] = []
    for row in sheet.iter_rows(values_only=True):
        cells = [one for one in row if one is not None]
        texts = [one for one in cells if isinstance(one, str)]
        if texts and "→" in texts[0]:
            tables.append(_table(title, columns))
            title, columns, heads = texts[0].split(". ", 1)[1].split(" →")[0], {}, []
        elif texts:
            heads = [one for one in texts if one not in columns]
            width = len(texts) - len(heads)
            heads = [""] * width + heads  # the first column of a continuation is there already
            columns |= {one: [] for one in heads if one}
        elif cells:
            numbers = [float(str(one)) for one in cells]
            for head, number in zip(heads, numbers, strict=False) if heads else ():
                if head:
                    columns[head].append(number)
            if not heads:
                columns.setdefault("", []).extend(numbers)
    return (*tables[1:], _table(title, columns))


def _table(title: str, columns: Mapping[str, list[float]]) -> Table:
    return Table(title, {name: tuple(numbers) for name, numbers in columns.items()})
