"""The roster: who gets a variant.

An office's list is taken as it is: titles above it, columns that nobody here needs, a name in one
column or in three, no ids. Who has no id gets one, the same again whenever the list is read.
"""

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from gripcourse.errors import Problem, TableError
from gripcourse.issuing.asked_about import ADDED, IdColumn
from gripcourse.issuing.group_titles import GroupTitles, groups_note
from gripcourse.issuing.made_ids import NOBODY, Joined, with_ids
from gripcourse.issuing.office_list import PARTS_OF_NAME
from gripcourse.issuing.people_list import lists_in
from gripcourse.issuing.written_ids import as_folder, lost_note, written_note
from gripcourse.machine.content import Readable
from gripcourse.machine.enclosed import LONGEST_NAME, is_file_name
from gripcourse.text.spelling import as_seen, plain
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import LANGUAGES, Message, message
from gripcourse.variants.cells import is_formula, said_of_formula
from gripcourse.variants.headings import TableColumn, declared_names
from gripcourse.variants.model import Student
from gripcourse.variants.sheet import Sheet, SheetRow, cell_place

_ID = re.compile(r"[\w-][\w.-]*")
_DAY = re.compile(r"\d{4}-\d{2}-\d{2}T")  # as the reader of spreadsheets writes one
_NO_DAYS = frozenset({"student", "group", "variant"})
_CYRILLIC = re.compile("[\u0400-\u04ff]")
_CYRILLIC_HEADING = "код студента"  # of a column of ids, the same in Russian and in Ukrainian
# Signs of what is printed beside a student's work: nobody's name is longer, and a word of ten
# thousand letters takes half a minute to lay out.
_LONGEST = {"name": 255, "group": 100, "email": 254, "variant": LONGEST_NAME}


@dataclass(frozen=True, slots=True)
class Roster:
    """A list of students as it was understood.

    Attributes:
        students: in the order of the rows; each has an id.
        notes: what was left out, guessed or made.
    """

    students: tuple[Student, ...]
    notes: tuple[Message, ...]


def read_roster(
    source: Readable,
    known: Iterable[Student] = (),
    languages: Sequence[str] = LANGUAGES,
    joined: Joined = NOBODY,
) -> Roster:
    """Read a roster from a `.csv`, `.xlsx`, `.ods` or `.xls` file.

    Args:
        source: the file, or its bytes; its headings may be English, Russian or Ukrainian, with
            titles above and other columns beside them. Of a workbook each sheet with names is
            read; where no column says it, the group is the title of the sheet.
        known: students of earlier lists: who has no id here and is one of them keeps that id.
        languages: that the course is written in.
        joined: which of these have been called otherwise.

    Returns:
        The students in the order of the rows.

    Raises:
        TableError: with every problem: no column of names, doubled ids, ids that cannot be names
            of folders, empty names, unknown languages, a variant fixed twice.
    """
    lists, of_file = lists_in(source)
    problems = [problem for one in lists for problem in one.problems]
    if not problems and not any(one.sheet.rows for one in lists):
        what = message("The roster has headings but no students.")
        remedy = message("Write a row for each student.")
        problems.append(Problem(lists[0].sheet.file, "", what, remedy))
    read: tuple[_Read, ...] = ()
    if not problems:
        readers = [
            _Reader(one.sheet, one.columns, languages, one.groups, problems) for one in lists
        ]
        read = tuple(_Read(one, row, one.student(row)) for one in readers for row in one.sheet.rows)
        _refuse_doubles(read)
    students: tuple[Student, ...] = tuple(one.student for one in read)
    made: tuple[Message, ...] = ()
    if not problems:
        students, made, doubles = with_ids(
            students, tuple(known), joined, lambda place: read[place].reader.id_column
        )
        problems += (
            Problem(
                read[place].reader.sheet.file,
                message("row {row}", row=read[place].row_name),
                *said,
            )
            for place, said in doubles
        )
    if problems:
        raise TableError(problems)
    unused = (note for one in lists for note in one.sheet.notes)
    left_out = (note for one in lists for note in one.left_out)
    groups = groups_note([one.groups for one in lists])
    ids = ((one.reader.cell(one.row, "student"), one.student.id) for one in read)
    said = (*written_note(ids), *lost_note(students))
    return Roster(students, _each_once((*unused, *of_file, *groups, *left_out, *said, *made)))


def _each_once(notes: Iterable[Message]) -> tuple[Message, ...]:
    return tuple({str(one): one for one in notes}.values())


@dataclass(frozen=True, slots=True)
class _Reader:
    sheet: Sheet
    columns: Mapping[str, TableColumn]
    languages: Sequence[str]
    groups: GroupTitles
    problems: list[Problem]

    @property
    def id_column(self) -> IdColumn:
        """Where an id of a student is written in this list, or would be in its language."""
        column = self.columns.get("student")
        if column is not None:
            return IdColumn(column.name, is_there=True)
        is_cyrillic = any(_CYRILLIC.search(one.name) for one in self.columns.values())
        return IdColumn(_CYRILLIC_HEADING) if is_cyrillic else ADDED

    def student(self, row: SheetRow) -> Student:
        """Read a row; what is wrong with it is recorded."""
        self._check_cells(row)
        student = Student(
            id=as_folder(self.cell(row, "student")),
            name=self._name(row),
            # A letter has its headings line by line: nobody adds one by a cell of two lines.
            group=" ".join(self.cell(row, "group").split()) or self.groups.above(row.number),
            email=" ".join(self.cell(row, "email").split()),
            language=self._language(row),
            variant=self.cell(row, "variant"),
        )
        if student.id:
            self._check_id(row, student.id)
        self._check_lengths(row, student)
        if not student.name:
            column = next(one for one in ("name", *PARTS_OF_NAME) if one in self.columns)
            self.add(
                row, column, message("The student has no name."), message("Write it as printed.")
            )
        return student

    def _name(self, row: SheetRow) -> str:
        """Return the name from its one column, or from the columns of its parts."""
        whole = self.cell(row, "name")
        parts = [whole] if whole else [self.cell(row, one) for one in PARTS_OF_NAME]
        return " ".join(" ".join(parts).split())

    def _check_cells(self, row: SheetRow) -> None:
        """Refuse what a spreadsheet program made of what was meant: a formula, a day."""
        for id_ in self.columns:
            written = self.cell(row, id_)
            if is_formula(written):
                self.add(row, id_, *said_of_formula())
            elif id_ in _NO_DAYS and _DAY.match(written):
                self.add(
                    row,
                    id_,
                    message("The cell holds the day {day}.", day=written[: len("2026-11-10")]),
                    message(
                        "A spreadsheet program made it of what was typed: set the format of the"
                        " column to text and write it again."
                    ),
                )

    def _check_lengths(self, row: SheetRow, student: Student) -> None:
        for what, most in _LONGEST.items():
            count = len(getattr(student, what))
            if count > most:
                column = next(one for one in (what, *PARTS_OF_NAME) if one in self.columns)
                self.add(
                    row,
                    column,
                    message(
                        "The cell has {count} signs; {most} at most are read.",
                        count=count,
                        most=most,
                    ),
                    message("Shorten it."),
                )

    def _check_id(self, row: SheetRow, id_: str) -> None:
        if not _ID.fullmatch(id_) or not is_file_name(id_):
            self.add(
                row,
                "student",
                message("The id '{student}' cannot name a folder.", student=id_),
                message("Use at most {most} letters, digits and the signs - _ . inside.",
                        most=LONGEST_NAME),
            )  # fmt: skip

    def _language(self, row: SheetRow) -> str:
        written = self.cell(row, "language")
        if not written:
            return ""
        found = declared_names("language").get(plain(written), frozenset())
        if len(found) == 1 and found <= set(self.languages):
            return next(iter(found))
        what = (
            message("The course is not written in the language '{language}'.", language=written)
            if found
            else message("There is no language '{language}'.", language=written)
        )
        self.add(row, "language", what, did_you_mean(written, self.languages))
        return ""

    def cell(self, row: SheetRow, id_: str) -> str:
        """Return what a row has in a column; empty where there is none."""
        column = self.columns.get(id_)
        return row.cells[column.position] if column is not None else ""

    def add(self, row: SheetRow, id_: str, what: Message, remedy: Message) -> None:
        """Record what is wrong with a cell."""
        place = cell_place(self.sheet.row_name(row.number), self.columns[id_].name)
        self.problems.append(Problem(self.sheet.file, place, what, remedy))


@dataclass(frozen=True, slots=True)
class _Read:
    """A student, and where it was read."""

    reader: _Reader
    row: SheetRow
    student: Student

    @property
    def row_name(self) -> str:
        return self.reader.sheet.row_name(self.row.number)


def _refuse_doubles(read: Sequence[_Read]) -> None:
    """Record ids and fixed variants that stand in two rows, of one list or of two.

    Windows and macOS take names that differ in capitals for one folder.
    """
    ids: dict[str, _Read] = {}
    variants: dict[str, _Read] = {}
    for one in read:
        student = one.student
        first = ids.setdefault(as_seen(student.id), one)
        if student.id and first is not one:
            said = _taken(student.id, first.student.id, first.row_name)
            one.reader.add(one.row, "student", *said)
        if student.variant and (other := variants.setdefault(student.variant, one)) is not one:
            one.reader.add(
                one.row,
                "variant",
                message("The variant '{variant}' is fixed in row {row} already.",
                        variant=student.variant, row=other.row_name),
                message("Fix another one, or leave the cell blank for the next free one."),
            )  # fmt: skip


def _taken(id_: str, other: str, row: str) -> tuple[Message, Message]:
    """Say that an id is another's already, or looks so."""
    if id_.casefold() == other.casefold():
        return (
            message("The student '{student}' is in row {row} already.", student=id_, row=row),
            message("Give each student one row and an id of their own."),
        )
    return (
        message(
            "The id '{student}' looks like '{other}' in row {row}.",
            student=id_,
            other=other,
            row=row,
        ),
        message(
            "Give each student an id that nobody takes for another's; write all ids with Latin "
            "letters, or all with Cyrillic ones."
        ),
    )
