"""A table of marks that a person filled in: a row for each item, a column for each rubric line."""

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from itertools import chain, combinations

from gripcourse.errors import Problem, TableError
from gripcourse.gradebook.enter import Draft
from gripcourse.machine.content import Readable
from gripcourse.policy.rubric import MOST_TOGETHER, column_heading
from gripcourse.policy.rubric_load import TABLE_COLUMNS
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import LANGUAGES, Message, Texts, message
from gripcourse.variants.cells import exact_number, is_formula, said_of_formula
from gripcourse.variants.headings import by_ids, words_vocabulary
from gripcourse.variants.sheet import Sheet, SheetRow, cell_place, column_name, read_sheet

_REQUIRED = ("student", "quantity")
_FOR_THE_READER = "about:"
_YES = {"yes", "да", "так", "1", "x", "+"}
_NO = {"", "no", "нет", "ні", "0", "-"}


@dataclass(frozen=True, slots=True)
class DraftRow:
    """A draft and the row that it was written in, as a spreadsheet counts."""

    draft: Draft
    row: int


@dataclass(frozen=True, slots=True)
class MarksTable:
    """What a table of marks says.

    Attributes:
        file: the path, as the user typed it.
        rows: those with marks.
        empty: how many rows name an item and give it nothing.
    """

    file: str
    rows: tuple[DraftRow, ...]
    empty: int


def read_marks(source: Readable, lines: Mapping[str, Collection[Texts]]) -> MarksTable:
    """Read a table of marks, `.csv` or `.xlsx`.

    Args:
        source: the file, or its bytes; its headings, in any language, name the columns: `student`,
            `quantity`, lines of rubrics by id or text, and `points`, `credit`, `comment`,
            `override` where they are needed. A comma in a number is a decimal one.
        lines: ids of all lines of all rubrics, with the texts that they have there.

    Raises:
        TableError: with all problems at once, each with row and column.
    """
    vocabulary = words_vocabulary("marks", lines, _titles_of(lines))
    sheet, called = by_ids(read_sheet(source, vocabulary.is_heading), vocabulary)
    problems = list(_heading_problems(sheet, lines))
    if problems:
        raise TableError(problems)
    rows: list[DraftRow] = []
    seen: dict[tuple[str, str], int] = {}
    empty = 0
    for row in sheet.rows:
        cells = _Cells(sheet, row, called, problems)
        draft = _draft(cells)
        if _is_empty(draft):
            empty += 1
            continue
        before = seen.setdefault((draft.student, draft.quantity), row.number)
        if before != row.number:
            cells.add(
                "quantity",
                message("Row {row} marks the same item.", row=before),
                message("Leave one of them."),
            )
        rows.append(DraftRow(draft, row.number))
    if problems:
        raise TableError(problems)
    return MarksTable(sheet.file, tuple(rows), empty)


@dataclass(frozen=True, slots=True)
class _Cells:
    """One row, and the list that its faults go to."""

    sheet: Sheet
    row: SheetRow
    called: Mapping[str, str]
    problems: list[Problem]

    def text(self, column: str) -> str:
        """Return a cell; empty where there is no such column."""
        if column not in self.sheet.header:
            return ""
        return self.row.cells[self.sheet.header.index(column)]

    def number(self, column: str) -> float | None:
        """Read a number; None where the cell is blank, or no number and a fault."""
        text = self.text(column)
        value = exact_number(text, decimal_comma=True) if text else None
        if text and value is None:
            no_number = (
                message("'{text}' is no number.", text=text),
                message("Write a number like 0.5 or 0,5."),
            )
            self.add(column, *(said_of_formula() if is_formula(text) else no_number))
        return value

    def flag(self, column: str) -> bool:
        """Read yes or no."""
        text = self.text(column).lower()
        if text not in _YES | _NO:
            self.add(
                column,
                message("'{text}' is neither yes nor no.", text=text),
                message("Write yes, or leave the cell empty."),
            )
        return text in _YES

    def add(self, column: str, what: Message, remedy: Message) -> None:
        """Record a fault of a cell."""
        place = cell_place(self.row.number, self.called.get(column, column))
        self.problems.append(Problem(self.sheet.file, place, what, remedy))


def _draft(cells: _Cells) -> Draft:
    for name in _REQUIRED:
        if not cells.text(name):
            cells.add(name, message("The cell is empty."), message("Write whose mark it is."))
    lines = {
        name: value
        for name in cells.sheet.header
        if _is_line(name) and (value := cells.number(name)) is not None
    }
    return Draft(
        student=cells.text("student"),
        quantity=cells.text("quantity"),
        lines=lines,
        points=cells.number("points"),
        credit=cells.number("credit"),
        comment=cells.text("comment"),
        override=cells.flag("override"),
    )


def _is_line(name: str) -> bool:
    return bool(name) and name not in TABLE_COLUMNS and not name.startswith(_FOR_THE_READER)


def _is_empty(draft: Draft) -> bool:
    return not (draft.lines or draft.comment or draft.override) and (
        draft.points is None and draft.credit is None
    )


def _heading_problems(sheet: Sheet, lines: Collection[str]) -> Iterator[Problem]:
    known = (*TABLE_COLUMNS, *lines)
    counts: Mapping[str, int] = {name: sheet.header.count(name) for name in sheet.header if name}
    for name in _REQUIRED:
        if name not in counts:
            yield _heading(
                sheet,
                name,
                message("The column '{name}' is missing.", name=name),
                message("Write its name into the first row."),
            )
    for name, count in counts.items():
        if _is_line(name) and name not in known:
            what = message("No rubric has a line '{name}'.", name=name)
            yield _heading(sheet, name, what, did_you_mean(name, known))
        if count > 1:
            what = message("Two columns are called '{name}'.", name=name)
            yield _heading(sheet, name, what, message("Leave one of them."))
    for position, name in enumerate(sheet.header):
        if not name:
            yield _heading(
                sheet,
                column_name(position, sheet.header),
                message("The column has cells, but no heading."),
                message(
                    "Write one; where commas separate the cells, put a number with a decimal comma "
                    "in quotation marks."
                ),
            )


def _heading(sheet: Sheet, column: str, what: Message, remedy: Message) -> Problem:
    return Problem(sheet.file, cell_place(sheet.heading_row, column), what, remedy)


def _titles_of(lines: Mapping[str, Collection[Texts]]) -> Iterator[tuple[str, str]]:
    """Yield what columns may be called: a table has some of the rubrics, maybe not all."""
    for id_, texts in lines.items():
        for language in LANGUAGES:
            written = {text.of(language) for text in texts}
            yield from ((text, id_) for text in written)
            counts = range(2, min(len(written), MOST_TOGETHER) + 1)
            together = chain.from_iterable(combinations(written, count) for count in counts)
            yield from ((column_heading(some), id_) for some in together)
