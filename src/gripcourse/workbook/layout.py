"""Where everything stands in the answer workbook: the only place that knows its cells.

The first sheet tells the student what to do and shows the given data; each section of the course
has a sheet of its own with one row per quantity; a hidden sheet says whose workbook it is.
"""

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from enum import IntEnum
from typing import Final

from gripcourse.course.model import Section
from gripcourse.course.quantity import Quantity
from gripcourse.solver.asked import deciding
from gripcourse.solver.plan import Plan
from gripcourse.text.units import unit_text
from gripcourse.text.words import Words, message
from gripcourse.workbook.guidance import HOW_TO
from gripcourse.workbook.names import FIELDS, HIDDEN_SHEET

LONGEST_SHEET_NAME: Final = 31
_NOT_IN_SHEET_NAMES: Final = re.compile(r"[\[\]:*?/\\]")
_SHORT_WORD: Final = 2  # letters of a word that must not end a shortened name


class SheetColumn(IntEnum):
    """Columns of every table, counted from zero."""

    NUMBER = 0
    SYMBOL = 1
    TITLE = 2
    UNIT = 3
    VALUE = 4
    CHECK = 5


COVER_TITLE: Final = 0
IDENTITY: Final = 2
"""First row of the student's particulars on the cover."""

PARTICULARS: Final = 6
"""Student, group, variant, scheme, day of issue, deadline; the options follow."""

SECTION_HEADER: Final = 4
"""Row of a section's sheet with the headings; the quantities follow."""


@dataclass(frozen=True, slots=True)
class CellPlace:
    """A cell; row and column count from zero."""

    sheet: str
    row: int
    column: int

    @property
    def address(self) -> str:
        """The cell inside its sheet: `E6`."""
        return f"{_letters(self.column)}{self.row + 1}"

    @property
    def reference(self) -> str:
        """The cell from anywhere in the workbook: `'1. Scheme'!$E$6`."""
        return f"{quoted(self.sheet)}!${_letters(self.column)}${self.row + 1}"


@dataclass(frozen=True, slots=True)
class SheetLine:
    """The row of one quantity.

    Attributes:
        quantity: its declaration.
        number: as printed, `2.3` or `12`.
        symbol: as declared, in the reader's language.
        title, unit: in the reader's language.
        decides: what decides the answer where the title leaves it open; empty for nothing.
        place: of the value: given, answered or marked by hand.
    """

    quantity: Quantity
    number: str
    symbol: str
    title: str
    unit: str
    decides: str
    place: CellPlace


@dataclass(frozen=True, slots=True)
class SectionSheet:
    """A sheet with the quantities of one section.

    Attributes:
        name: of the sheet, unique.
        number: of the section, from one.
        section: what it is about.
        task: what is to be done in it, in the reader's language.
        answered: rows that the student fills, one below the other.
        manual: rows of what a person marks; they follow.
    """

    name: str
    number: int
    section: Section
    task: str
    answered: tuple[SheetLine, ...]
    manual: tuple[SheetLine, ...]


@dataclass(frozen=True, slots=True)
class Cover:
    """The first sheet: four blocks one below the other.

    Attributes:
        name: of the sheet.
        guidance: row of the heading of how to fill in; the sentences follow.
        progress: row of the headings of the progress; one row per section sheet follows.
        given_header: row of the headings of the given data.
        givens, constants: rows of the given data.
    """

    name: str
    guidance: int
    progress: int
    given_header: int
    givens: tuple[SheetLine, ...]
    constants: tuple[SheetLine, ...]


@dataclass(frozen=True, slots=True)
class WorkbookLayout:
    """The whole workbook.

    Attributes:
        cover: the first sheet.
        sheets: of the sections, in the order of the course.
        series: name of the sheet with the series and tables.
        meta: cells of the hidden sheet by field.
    """

    cover: Cover
    sheets: tuple[SectionSheet, ...]
    series: str
    meta: Mapping[str, CellPlace]

    @property
    def answers(self) -> dict[str, CellPlace]:
        """Answer cells by the id of their quantity."""
        lines = (line for sheet in self.sheets for line in sheet.answered)
        return {line.quantity.id: line.place for line in lines}

    @property
    def givens(self) -> dict[str, CellPlace]:
        """Cells of given values by the id of their quantity."""
        return {line.quantity.id: line.place for line in self.cover.givens}


def layout(plan: Plan, words: Words) -> WorkbookLayout:
    """Lay out the answer workbook of a plan.

    Args:
        plan: which quantities are given, asked and marked by hand.
        words: the student's language.
    """
    name = _sheet_name(words.say(message("Assignment")), ())
    sheets = tuple(_section_sheets(plan, words, name))
    taken = [name, HIDDEN_SHEET, *(sheet.name for sheet in sheets)]
    return WorkbookLayout(
        cover=_cover(plan, words, name, len(sheets)),
        sheets=sheets,
        series=_sheet_name(words.say(message("Series")), taken),
        meta={field: CellPlace(HIDDEN_SHEET, row, 1) for row, field in enumerate(FIELDS)},
    )


def _cover(plan: Plan, words: Words, name: str, sections: int) -> Cover:
    """Stack the blocks of the cover, one empty row between two."""
    guidance = IDENTITY + PARTICULARS + len(plan.scheme.options) + 1
    progress = guidance + len(HOW_TO) + 2
    given_header = progress + sections + 3
    first = given_header + 1
    return Cover(
        name=name,
        guidance=guidance,
        progress=progress,
        given_header=given_header,
        givens=_lines(plan, plan.givens, name, first, words),
        constants=_lines(
            plan, plan.constants, name, first + len(plan.givens), words, before=len(plan.givens)
        ),
    )


def quoted(sheet: str) -> str:
    """Write the name of a sheet as formulas do."""
    return "'" + sheet.replace("'", "''") + "'"


def _section_sheets(plan: Plan, words: Words, cover: str) -> Iterator[SectionSheet]:
    """Yield a sheet for each section that asks for anything."""
    taken = [cover, HIDDEN_SHEET]
    for section in plan.course.sections:
        answered = [quantity for quantity in plan.answered if quantity.section == section.id]
        manual = [quantity for quantity in plan.manual if quantity.section == section.id]
        if not answered and not manual:
            continue
        number = len(taken) - 1
        name = _sheet_name(f"{number}. {section.short.of(words.language)}", taken)
        taken.append(name)
        first = SECTION_HEADER + 1
        prefix = f"{number}."
        yield SectionSheet(
            name=name,
            number=number,
            section=section,
            task=section.task_of(plan.quantities, words.language),
            answered=_lines(plan, answered, name, first, words, prefix=prefix),
            manual=_lines(
                plan,
                manual,
                name,
                first + len(answered),
                words,
                prefix=prefix,
                before=len(answered),
            ),
        )


def _lines(  # noqa: PLR0913 (where rows stand, and what is in them)
    plan: Plan,
    quantities: Iterable[Quantity],
    sheet: str,
    first: int,
    words: Words,
    *,
    prefix: str = "",
    before: int = 0,
) -> tuple[SheetLine, ...]:
    """Make rows one below the other, from row `first` on."""
    return tuple(
        SheetLine(
            quantity=quantity,
            number=f"{prefix}{before + index + 1}",
            symbol=quantity.symbol.of(words.language),
            title=quantity.title.of(words.language),
            unit=unit_text(quantity.unit, words.language),
            decides=deciding(quantity, plan, words) if quantity.kind.answered else "",
            place=CellPlace(sheet, first + index, SheetColumn.VALUE),
        )
        for index, quantity in enumerate(quantities)
    )


def _sheet_name(title: str, taken: Iterable[str]) -> str:
    """Shorten a title to what a sheet's name may be, at a word's end, unlike the others."""
    plain = _NOT_IN_SHEET_NAMES.sub(" ", title).strip("' ")
    kept = plain.split()
    while kept and len(" ".join(kept)) > LONGEST_SHEET_NAME:
        kept.pop()
    if kept != plain.split():
        while len(kept) > 1 and len(kept[-1]) <= _SHORT_WORD:
            kept.pop()
    name = " ".join(kept) or plain[:LONGEST_SHEET_NAME]
    used = {other.casefold() for other in taken}
    return (
        name if name.casefold() not in used else f"{name[: LONGEST_SHEET_NAME - 4]} ({len(used)})"
    )


def _letters(column: int) -> str:
    """Return the letters of a column: A to Z, then AA, AB and so on."""
    before, last = divmod(column, 26)
    return (_letters(before - 1) if before else "") + chr(ord("A") + last)
