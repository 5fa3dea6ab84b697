"""The table of variants as a workbook that a person fills in: titles, units, lists of choices."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from gripcourse.course.compose import compose
from gripcourse.course.model import Course
from gripcourse.course.option_sets import pair_option_sets
from gripcourse.course.quantity import Kind, Quantity
from gripcourse.machine.files import replacing
from gripcourse.machine.spreadsheet.table_page import set_no_moment, set_table_page
from gripcourse.machine.table_bounds import MOST_OF_WORKBOOK
from gripcourse.text.units import unit_text
from gripcourse.text.words import Words, message
from gripcourse.variants.cells import converted
from gripcourse.variants.headings import Vocabulary, given_quantities, table_vocabulary
from gripcourse.variants.model import Variant
from gripcourse.variants.readable import Room, expect_readable

if TYPE_CHECKING:
    from xlsxwriter import Workbook
    from xlsxwriter.format import Format
    from xlsxwriter.worksheet import Worksheet

_LISTS = "lists"
_SPARE_ROWS = 200  # below the last variant, in which the lists still help
_NARROWEST, _WIDEST = 9, 34  # of a column, in digits


@dataclass(frozen=True, slots=True)
class _Column:
    """A column of the workbook.

    Attributes:
        heading: in the course's language, understood when the table is read.
        cells: one for each variant; None for blank.
        choices: what may be written; empty for anything.
    """

    heading: str
    cells: tuple[str | float | None, ...]
    choices: tuple[str, ...] = ()


def write_table_workbook(path: Path, variants: Sequence[Variant], course: Course) -> None:
    """Write variants into the first sheet of a workbook; see `table.write_table`.

    Raises:
        TableError: it would be larger than any that is read.
    """
    import xlsxwriter  # noqa: PLC0415 (not for tables as CSV)

    columns = tuple(_columns(variants, course))
    room = Room(_cells(columns, len(variants)), MOST_OF_WORKBOOK)
    expect_readable(path, len(variants) + 1, len(columns), room)
    with replacing(path) as temporary, xlsxwriter.Workbook(str(temporary)) as book:
        sheet = book.add_worksheet(Words(course.language).say(message("Variants"))[:31])
        lists = book.add_worksheet(_LISTS)
        lists.hide()
        set_no_moment(book)
        bold = book.add_format({"bold": True, "text_wrap": True, "valign": "top", "border": 1})
        for place, column in enumerate(columns):
            sheet.write_string(0, place, column.heading, bold)
            sheet.set_column(place, place, _width(column), _cell_format(book, column))
            for row, cell in enumerate(column.cells, start=1):
                if isinstance(cell, str):
                    sheet.write_string(row, place, cell)
                elif cell is not None:
                    sheet.write_number(row, place, cell)
            if column.choices:
                _offer(sheet, lists, place, column.choices, len(variants))
        sheet.freeze_panes(1, 1)
        set_table_page(sheet, in_front=1)


def _cells(columns: Sequence[_Column], rows: int) -> int:
    """Count the cells: the headings, and of each row those as far as its last."""
    last = [0] * rows
    for number, column in enumerate(columns, start=1):
        last = [
            was if cell is None else number for was, cell in zip(last, column.cells, strict=True)
        ]
    return len(columns) + sum(last)


def declared_units(course: Course) -> dict[tuple[str, str], str]:
    """Return the declared unit of every given quantity by scheme and id."""
    return {
        (scheme.id, quantity.id): quantity.unit
        for scheme in course.schemes.values()
        for options in pair_option_sets(scheme)
        for quantity in compose(course, scheme, options).values()
        if quantity.kind is Kind.GIVEN
    }


def _columns(variants: Sequence[Variant], course: Course) -> Iterator[_Column]:
    words, vocabulary = Words(course.language), table_vocabulary(course)
    yield _Column(words.say(message("Variant")), tuple(one.id for one in variants))
    schemes = {one.scheme: course.schemes[one.scheme] for one in variants}
    yield _choice_column(
        words.say(message("Scheme")),
        [schemes[one.scheme].title.of(course.language) for one in variants],
        [one.title.of(course.language) for one in schemes.values()],
    )
    options = {option.id: option for scheme in schemes.values() for option in scheme.options}
    for id_, option in options.items():
        # Schemes may call one choice by other names: each row has those of its own.
        titles = {
            (scheme.id, choice.id): choice.title.of(course.language)
            for scheme in schemes.values()
            for one in scheme.options
            if one.id == id_
            for choice in one.choices
        }
        yield _choice_column(
            _heading(vocabulary, f"option:{id_}", id_, option.title.of(course.language), ""),
            [titles.get((one.scheme, one.options.get(id_, ""))) for one in variants],
            titles.values(),
        )
    yield from _given_columns(variants, course, vocabulary)


def _choice_column(heading: str, cells: Iterable[str | None], choices: Iterable[str]) -> _Column:
    return _Column(heading, tuple(cells), tuple(dict.fromkeys(choices)))


def _given_columns(
    variants: Sequence[Variant], course: Course, vocabulary: Vocabulary
) -> Iterator[_Column]:
    units = declared_units(course)
    used = {id_ for variant in variants for id_ in variant.given}
    for quantity in given_quantities(course).values():
        if quantity.id not in used:
            continue
        title = _own_title(quantity, variants, course)
        unit = unit_text(quantity.unit, course.language)
        yield _Column(
            _heading(vocabulary, quantity.id, quantity.id, title, unit),
            tuple(
                converted(one.given[quantity.id], units[one.scheme, quantity.id], quantity.unit)
                if quantity.id in one.given
                else None
                for one in variants
            ),
        )


def _own_title(quantity: Quantity, variants: Sequence[Variant], course: Course) -> str:
    """Return title and symbol in the first scheme that uses a given; schemes may differ."""
    first = next(one for one in variants if quantity.id in one.given)
    scheme = course.schemes[first.scheme]
    declared = compose(course, scheme, first.options)[quantity.id]
    return f"{declared.title.of(course.language)}, {declared.symbol.of(course.language)}"


def _heading(vocabulary: Vocabulary, id_: str, name: str, title: str, unit: str) -> str:
    """Return the title where it means this column alone, else the id; with the unit."""
    said = title if vocabulary.find(title) == {id_} else name
    return f"{said} [{unit}]" if unit else said


def _offer(
    sheet: "Worksheet", lists: "Worksheet", place: int, choices: Sequence[str], variants: int
) -> None:
    """Let a column be filled from a list; it stands on a sheet, for a rule holds 255 signs."""
    for row, choice in enumerate(choices):
        lists.write_string(row, place, choice)
    letter = _letters(place)
    source = f"={_LISTS}!${letter}$1:${letter}${len(choices)}"
    sheet.data_validation(
        1, place, variants + _SPARE_ROWS, place, {"validate": "list", "source": source}
    )


def _letters(place: int) -> str:
    from xlsxwriter.utility import xl_col_to_name  # noqa: PLC0415 (as above)

    return str(xl_col_to_name(place))


def _width(column: _Column) -> int:
    longest = max((len(str(cell)) for cell in column.cells if cell is not None), default=0)
    return min(max(longest + 2, _NARROWEST, len(column.heading) // 2), _WIDEST)


def _cell_format(book: "Workbook", column: _Column) -> "Format | None":
    """Names stay text: a program would make 1 of 001."""
    is_text = all(isinstance(cell, str) for cell in column.cells)
    return book.add_format({"num_format": "@"}) if is_text else None
