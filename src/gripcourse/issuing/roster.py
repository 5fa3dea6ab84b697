"""The roster: who gets a variant.

An office's list is taken as it is: titles above it, columns that nobody here needs, a name in one
column or in three, no ids. Who has no id gets one, the same again whenever the list is read.
"""

import re
import unicodedata
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from gripcourse.errors import Problem, TableError
from gripcourse.issuing.group_titles import GroupTitles, group_titles
from gripcourse.issuing.made_ids import with_ids
from gripcourse.issuing.office_list import (
    PARTS_OF_NAME,
    with_addresses,
    with_names,
    with_somebody,
    without_numbers,
)
from gripcourse.machine.content import Readable
from gripcourse.machine.enclosed import LONGEST_NAME, is_file_name
from gripcourse.text.spelling import plain
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import LANGUAGES, Message, message
from gripcourse.variants.headings import (
    TableColumn,
    declared_names,
    find_columns,
    roster_vocabulary,
    without_strange,
)
from gripcourse.variants.model import Student
from gripcourse.variants.sheet import Sheet, SheetRow, cell_place, read_sheet

_ID = re.compile(r"[\w-][\w.-]*")
# Signs of what is printed beside a student's work: nobody's name is longer, and a word of ten
# thousand letters takes half a minute to lay out.
_LONGEST = {"name": 255, "group": 100, "email": 254, "variant": LONGEST_NAME}
# Cyrillic letters that look like Latin ones, in small or in capital letters.
_ALIKE = str.maketrans("авсенһіјкмоԛрѕтухԝԁѵ", "abcehhijkmoqpstyxwdv")


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
    source: Readable, known: Iterable[Student] = (), languages: Sequence[str] = LANGUAGES
) -> Roster:
    """Read a roster from a `.csv` or `.xlsx` file.

    Args:
        source: the file, or its bytes; its headings may be English, Russian or Ukrainian, with
            titles above and other columns beside them.
        known: students of earlier lists: who has no id here and is one of them keeps that id.
        languages: that the course is written in.

    Returns:
        The students in the order of the rows.

    Raises:
        TableError: with every problem: no column of names, doubled ids, ids that cannot be names
            of folders, empty names, unknown languages, a variant fixed twice.
    """
    vocabulary = roster_vocabulary()
    whole = read_sheet(source, vocabulary.is_heading)
    sheet = with_names(without_strange(whole, vocabulary), vocabulary)
    problems: list[Problem] = []
    columns = find_columns(sheet, vocabulary, problems)
    if not columns.keys() & {"name", *PARTS_OF_NAME}:
        problems.append(_without_names(whole, columns))
    students: tuple[Student, ...] = ()
    made: tuple[Message, ...] = ()
    groups = GroupTitles() if "group" in columns else group_titles(whole)
    sheet = replace(sheet, rows=tuple(row for row in sheet.rows if row.number not in groups.rows))
    sheet, left_out = with_somebody(sheet, columns, vocabulary)
    sheet, no_addresses = with_addresses(without_numbers(sheet, columns), columns)
    if not problems:
        reader = _Reader(sheet, columns, languages, groups, problems)
        students = tuple(reader.student(row) for row in sheet.rows)
        reader.refuse_doubles(students)
    if columns and not sheet.rows:
        what = message("The roster has headings but no students.")
        problems.append(Problem(sheet.file, "", what, message("Write a row for each student.")))
    if not problems:
        students, made, doubles = with_ids(students, tuple(known))
        problems += (
            Problem(sheet.file, message("row {row}", row=sheet.rows[place].number), *said)
            for place, said in doubles
        )
    if problems:
        raise TableError(problems)
    return Roster(students, (*sheet.notes, *groups.note(), *left_out, *no_addresses, *made))


def _without_names(whole: Sheet, columns: Mapping[str, TableColumn]) -> Problem:
    if columns:
        what = message("There is no column '{column}'.", column="name")
        return Problem(whole.file, "", what, did_you_mean("name", whole.header))
    return Problem(
        whole.file,
        "",
        message("No row of the roster has headings."),
        message("Write a row above the names, for example: name, group, e-mail."),
    )


@dataclass(frozen=True, slots=True)
class _Reader:
    sheet: Sheet
    columns: Mapping[str, TableColumn]
    languages: Sequence[str]
    groups: GroupTitles
    problems: list[Problem]

    def student(self, row: SheetRow) -> Student:
        """Read a row; what is wrong with it is recorded."""
        student = Student(
            # One letter can be written as one sign or as two, and folders would differ.
            id=unicodedata.normalize("NFC", self._cell(row, "student")),
            name=self._name(row),
            # A letter has its headings line by line: nobody adds one by a cell of two lines.
            group=" ".join(self._cell(row, "group").split()) or self.groups.above(row.number),
            email=" ".join(self._cell(row, "email").split()),
            language=self._language(row),
            variant=self._cell(row, "variant"),
        )
        if student.id:
            self._check_id(row, student.id)
        self._check_lengths(row, student)
        if not student.name:
            column = next(one for one in ("name", *PARTS_OF_NAME) if one in self.columns)
            self._add(
                row, column, message("The student has no name."), message("Write it as printed.")
            )
        return student

    def _name(self, row: SheetRow) -> str:
        """Return the name from its one column, or from the columns of its parts."""
        whole = self._cell(row, "name")
        parts = [whole] if whole else [self._cell(row, one) for one in PARTS_OF_NAME]
        return " ".join(" ".join(parts).split())

    def refuse_doubles(self, students: tuple[Student, ...]) -> None:
        """Record ids and fixed variants that stand in two rows."""
        ids: dict[str, tuple[int, str]] = {}
        variants: dict[str, int] = {}
        for row, student in zip(self.sheet.rows, students, strict=True):
            first, other = ids.setdefault(_seen(student.id), (row.number, student.id))
            if student.id and first != row.number:
                self._add(row, "student", *_taken(student.id, other, first))
            if student.variant and variants.setdefault(student.variant, row.number) != row.number:
                self._add(
                    row,
                    "variant",
                    message("The variant '{variant}' is fixed in row {row} already.",
                            variant=student.variant, row=variants[student.variant]),
                    message("Fix another one, or leave the cell blank for the next free one."),
                )  # fmt: skip

    def _check_lengths(self, row: SheetRow, student: Student) -> None:
        for what, most in _LONGEST.items():
            count = len(getattr(student, what))
            if count > most:
                column = next(one for one in (what, *PARTS_OF_NAME) if one in self.columns)
                self._add(
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
            self._add(
                row,
                "student",
                message("The id '{student}' cannot name a folder.", student=id_),
                message("Use at most {most} letters, digits and the signs - _ . inside.",
                        most=LONGEST_NAME),
            )  # fmt: skip

    def _language(self, row: SheetRow) -> str:
        written = self._cell(row, "language")
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
        self._add(row, "language", what, did_you_mean(written, self.languages))
        return ""

    def _cell(self, row: SheetRow, id_: str) -> str:
        column = self.columns.get(id_)
        return row.cells[column.position] if column is not None else ""

    def _add(self, row: SheetRow, id_: str, what: Message, remedy: Message) -> None:
        place = cell_place(row.number, self.columns[id_].name)
        self.problems.append(Problem(self.sheet.file, place, what, remedy))


def _seen(id_: str) -> str:
    """Return what a person or a system sees of an id.

    Windows and macOS take names that differ in capitals for one folder, and nobody tells a Cyrillic
    letter from a Latin one of the same look.
    """
    return unicodedata.normalize("NFKC", id_).casefold().translate(_ALIKE)


def _taken(id_: str, other: str, row: int) -> tuple[Message, Message]:
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
