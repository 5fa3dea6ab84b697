"""The table of variants: CSV that a person can open and change, or a spreadsheet to import.

For example:

    variant,scheme,drive,mass [kg],ratio,...
    001,flat,electric,60,1.5,...

A cell is blank where the scheme of its row has no such quantity.
"""

import csv
import io
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path

from gripcourse.course.compose import compose
from gripcourse.course.model import Course
from gripcourse.course.option_sets import pair_option_sets
from gripcourse.course.quantity import Kind, Quantity
from gripcourse.errors import Problem, TableError
from gripcourse.machine.content import Readable
from gripcourse.machine.files import write_bytes
from gripcourse.machine.table_bounds import MOST_CELLS
from gripcourse.text.words import Message, message
from gripcourse.variants.cells import converted, number_text
from gripcourse.variants.defaults import Defaults
from gripcourse.variants.headings import (
    TableColumn,
    find_columns,
    given_quantities,
    table_vocabulary,
)
from gripcourse.variants.model import Variant
from gripcourse.variants.named_choices import language_of
from gripcourse.variants.readable import CSV, Room, expect_kind, expect_readable
from gripcourse.variants.rows import RowReader
from gripcourse.variants.sheet import Sheet, read_sheet
from gripcourse.variants.table_workbook import declared_units, write_table_workbook


@dataclass(frozen=True, slots=True)
class OwnTable:
    """An instructor's own table as it was understood.

    Attributes:
        variants: in the order of the rows, values in declared units.
        notes: what the table does not say and was taken from elsewhere.
    """

    variants: tuple[Variant, ...]
    notes: tuple[Message, ...]


def read_table(source: Readable, course: Course) -> tuple[Variant, ...]:
    """Read variants from a `.csv` or `.xlsx` file and judge each.

    Args:
        source: the file, or its bytes; headings may be ids, symbols or titles, with or without a
            unit.
        course: whose variants they are.

    Returns:
        The variants in the order of the rows, values in declared units.

    Raises:
        TableError: with every problem of the table: headings, cells, and variants that cannot be
            solved, each with its row as a spreadsheet shows it.
    """
    return _read(source, course, None).variants


def read_own_table(source: Readable, course: Course) -> OwnTable:
    """Read an instructor's own table, which may leave out columns; else as `read_table`.

    A choice or number without a column is that of the scheme's worked example, else the middle of
    the range that variants are drawn from. Variants without names are numbered.
    """
    return _read(source, course, Defaults.of(course))


def _read(source: Readable, course: Course, defaults: Defaults | None) -> OwnTable:
    vocabulary = table_vocabulary(course)
    sheet = read_sheet(source, vocabulary.is_heading)
    problems: list[Problem] = []
    columns = find_columns(sheet, vocabulary, problems)
    absent = _absent_columns(sheet, columns, course, problems, defaults)
    language = language_of(course, columns)
    reader = RowReader(course, sheet, columns, absent, problems, defaults, language=language)
    variants = reader.read()
    if not sheet.rows:
        what = message("The table has headings but no variants.")
        problems.append(Problem(sheet.file, "", what, message("Write or draw some.")))
    if problems:
        raise TableError(problems)
    return OwnTable(tuple(variants), (*sheet.notes, *_filled_note(sheet, reader, course.language)))


def _filled_note(sheet: Sheet, reader: RowReader, language: str) -> tuple[Message, ...]:
    if not reader.filled:
        return ()
    note = message(
        "{file} has no columns for these; the worked example or the middle of the range was taken:"
        " {columns}.",
        file=sheet.file,
        columns=", ".join(title.of(language) for title in reader.filled.values()),
    )
    return (note,)


def write_table(path: Path, variants: Iterable[Variant], course: Course) -> None:
    """Write variants as a spreadsheet, or as CSV that Excel shows every letter of.

    Args:
        path: of the file: `.xlsx` for a spreadsheet with titles, units and lists of choices in the
            course's language, `.csv` for ids.
        variants: with values in declared units.
        course: whose variants they are; it decides the columns.

    Raises:
        TableError: the name says neither, or the table would be larger than any that is read.
    """
    listed = tuple(variants)
    if expect_kind(path) == CSV:
        _write_csv(path, listed, course)
    else:
        write_table_workbook(path, listed, course)


def _write_csv(path: Path, listed: tuple[Variant, ...], course: Course) -> None:
    options = list(dict.fromkeys(id_ for variant in listed for id_ in variant.options))
    used = {id_ for variant in listed for id_ in variant.given}
    givens = [one for one in given_quantities(course).values() if one.id in used]
    units = declared_units(course)
    header = ["variant", "scheme", *options, *(_heading(quantity) for quantity in givens)]
    rows = [
        [
            variant.id,
            variant.scheme,
            *(variant.options.get(id_, "") for id_ in options),
            *(_text(variant, quantity, units) for quantity in givens),
        ]
        for variant in listed
    ]
    text = io.StringIO(newline="")
    csv.writer(text, lineterminator="\n").writerows([header, *rows])
    content = text.getvalue().encode("utf-8-sig")
    lines = len(rows) + 1
    expect_readable(path, lines, len(header), Room(lines * len(header), MOST_CELLS), len(content))
    write_bytes(path, content)


def _heading(quantity: Quantity) -> str:
    return f"{quantity.id} [{quantity.unit}]" if quantity.unit else quantity.id


def _text(variant: Variant, quantity: Quantity, units: dict[tuple[str, str], str]) -> str:
    """Write a value in the unit of the heading; schemes may declare the id in different ones."""
    if quantity.id not in variant.given:
        return ""
    unit = units[variant.scheme, quantity.id]
    return number_text(converted(variant.given[quantity.id], unit, quantity.unit))


def _absent_columns(
    sheet: Sheet,
    columns: Mapping[str, TableColumn],
    course: Course,
    problems: list[Problem],
    defaults: Defaults | None,
) -> frozenset[str]:
    """Name once each column that every variant of the course needs and nothing stands for."""
    needed = [
        {f"option:{id_}" for id_ in options}
        | {one.id for one in compose(course, scheme, options).values() if one.kind is Kind.GIVEN}
        for scheme in course.schemes.values()
        for options in pair_option_sets(scheme)
    ]
    always = set.intersection(*needed) if needed else set()
    scheme_column = ("scheme",) if len(course.schemes) > 1 else ()
    demanded = scheme_column if defaults else ("variant", *scheme_column, *sorted(always))
    absent = [id_ for id_ in demanded if id_ not in columns]
    for id_ in absent:
        name = id_.removeprefix("option:")
        what = message("There is no column '{column}'.", column=name)
        remedy = message("Add it: every variant needs it.")
        problems.append(Problem(sheet.file, "", what, remedy))
    return frozenset(absent)
