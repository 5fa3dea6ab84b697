"""The roster: who gets a variant."""

import re
import unicodedata
from collections.abc import Mapping
from dataclasses import dataclass

from gripcourse.errors import Problem, TableError
from gripcourse.machine.content import Readable
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import LANGUAGES, Message, message
from gripcourse.variants.headings import (
    TableColumn,
    declared_names,
    find_columns,
    plain,
    roster_vocabulary,
)
from gripcourse.variants.model import Student
from gripcourse.variants.sheet import Sheet, SheetRow, cell_place, read_sheet

_ID = re.compile(r"[\w-][\w.-]*")
# Names that Windows keeps for devices, whatever follows the dot: no folder can be called so.
_DEVICE = re.compile(r"(con|prn|aux|nul|com\d|lpt\d)(\..*)?", re.IGNORECASE)
_LONGEST_ID = 64


def read_roster(source: Readable) -> tuple[Student, ...]:
    """Read a roster from a `.csv` or `.xlsx` file.

    Args:
        source: the file, or its bytes; its headings may be English, Russian or Ukrainian.

    Returns:
        The students in the order of the rows.

    Raises:
        TableError: with every problem: missing columns, empty or doubled ids, ids that cannot be
            names of folders, empty names, unknown languages, a variant fixed twice.
    """
    sheet = read_sheet(source)
    problems: list[Problem] = []
    columns = find_columns(sheet, roster_vocabulary(), problems)
    for id_ in ("student", "name"):
        if id_ not in columns:
            what = message("There is no column '{column}'.", column=id_)
            problems.append(Problem(sheet.file, "", what, did_you_mean(id_, sheet.header)))
    students: tuple[Student, ...] = ()
    if not problems:
        reader = _Reader(sheet, columns, problems)
        students = tuple(reader.student(row) for row in sheet.rows)
        reader.refuse_doubles(students)
    if not sheet.rows:
        what = message("The roster has headings but no students.")
        problems.append(Problem(sheet.file, "", what, message("Write a row for each student.")))
    if problems:
        raise TableError(problems)
    return students


@dataclass(frozen=True, slots=True)
class _Reader:
    sheet: Sheet
    columns: Mapping[str, TableColumn]
    problems: list[Problem]

    def student(self, row: SheetRow) -> Student:
        """Read a row; what is wrong with it is recorded."""
        student = Student(
            # One letter can be written as one sign or as two, and folders would differ.
            id=unicodedata.normalize("NFC", self._cell(row, "student")),
            name=" ".join(self._cell(row, "name").split()),
            group=self._cell(row, "group"),
            email=self._cell(row, "email"),
            language=self._language(row),
            variant=self._cell(row, "variant"),
        )
        self._check_id(row, student.id)
        if not student.name:
            self._add(
                row, "name", message("The student has no name."), message("Write it as printed.")
            )
        return student

    def refuse_doubles(self, students: tuple[Student, ...]) -> None:
        """Record ids and fixed variants that stand in two rows."""
        ids: dict[str, int] = {}
        variants: dict[str, int] = {}
        for row, student in zip(self.sheet.rows, students, strict=True):
            # Windows and macOS take names that differ in capitals for one folder.
            key = student.id.casefold()
            if key and ids.setdefault(key, row.number) != row.number:
                self._add(
                    row,
                    "student",
                    message("The student '{student}' is in row {row} already.",
                            student=student.id, row=ids[key]),
                    message("Give each student one row and an id of their own."),
                )  # fmt: skip
            if student.variant and variants.setdefault(student.variant, row.number) != row.number:
                self._add(
                    row,
                    "variant",
                    message("The variant '{variant}' is fixed in row {row} already.",
                            variant=student.variant, row=variants[student.variant]),
                    message("Fix another one, or leave the cell blank for the next free one."),
                )  # fmt: skip

    def _check_id(self, row: SheetRow, id_: str) -> None:
        if not id_:
            what = message("The student has no id.")
            self._add(row, "student", what, message("Write one: it names the student's folder."))
        elif (
            not _ID.fullmatch(id_)
            or id_.endswith(".")
            or _DEVICE.fullmatch(id_)
            or len(id_) > _LONGEST_ID
        ):
            self._add(
                row,
                "student",
                message("The id '{student}' cannot name a folder.", student=id_),
                message("Use at most {most} letters, digits and the signs - _ . inside.",
                        most=_LONGEST_ID),
            )  # fmt: skip

    def _language(self, row: SheetRow) -> str:
        written = self._cell(row, "language")
        if not written:
            return ""
        found = declared_names("language").get(plain(written), frozenset())
        if len(found) == 1:
            return next(iter(found))
        what = message("There is no language '{language}'.", language=written)
        self._add(row, "language", what, did_you_mean(written, LANGUAGES))
        return ""

    def _cell(self, row: SheetRow, id_: str) -> str:
        column = self.columns.get(id_)
        return row.cells[column.position] if column is not None else ""

    def _add(self, row: SheetRow, id_: str, what: Message, remedy: Message) -> None:
        place = cell_place(row.number, self.columns[id_].name)
        self.problems.append(Problem(self.sheet.file, place, what, remedy))
