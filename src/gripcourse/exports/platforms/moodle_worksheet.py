"""Moodle's offline grading worksheet with the grades filled in.

Its import fails silently in many ways, so the instructor's own export is the base: numbers of the
participants, headings, encoding and order come from it. Only the grade and the comment are filled
in, the grade with a decimal point, which every language of Moodle reads, the comment beside what a
person wrote there; a row without a work stays byte for byte. A date of the last grade that Moodle
wrote and cannot read again would make it skip the row: it is written so that it can.
"""

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

from gripcourse.errors import Problem, UsageError
from gripcourse.exports.platforms.matching import Matching, match
from gripcourse.exports.platforms.moodle_comment import beside_others, grade_with
from gripcourse.exports.platforms.moodle_grade import grade_of, is_other_grade
from gripcourse.exports.platforms.moodle_words import (
    HEADINGS,
    MONTHS,
    NOT_CHANGEABLE,
    REQUIRED,
    MoodleColumn,
)
from gripcourse.exports.platforms.raw_table import RawTable, read_raw_table
from gripcourse.exports.platforms.works import GradedWork, PlatformRow
from gripcourse.machine.content import Readable
from gripcourse.text.words import Message, message

_USUAL: Final = (",", {"utf-8", "utf-8-sig"})  # what Moodle takes a worksheet for
_NUMBER: Final = re.compile(r"(\d+)$")
_DATE: Final = re.compile(
    r"(?P<day>\d{1,2})\s+(?P<month>[^\W\d_]+)\s+(?P<year>\d{4})\D+"
    r"(?P<hour>\d{1,2}):(?P<minute>\d\d)\s*(?P<half>[AaPp][Mm])?"
)
_NONE: Final = {"", "-"}
_NOON: Final = 12


@dataclass(frozen=True, slots=True)
class Worksheet:
    """A worksheet as it was understood.

    Attributes:
        table: as it came.
        language: of its headings.
        columns: where each known column stands.
    """

    table: RawTable
    language: str
    columns: Mapping[MoodleColumn, int]

    def cell(self, row: Sequence[str], column: MoodleColumn) -> str:
        """Return what a row has in a column; nothing where there is no such column."""
        return row[self.columns[column]].strip() if column in self.columns else ""

    def rows(self) -> Iterator[tuple[int, tuple[str, ...], PlatformRow]]:
        """Yield the place of each person's row, its cells and who it is about."""
        key_columns = tuple(self._key_columns())
        for place, cells in enumerate(self.table.rows[1:], start=1):
            if not any(cells):
                continue
            number = _NUMBER.search(self.cell(cells, MoodleColumn.IDENTIFIER))
            keys = [cells[at] for at in key_columns]
            name = self.cell(cells, MoodleColumn.NAME)
            yield (
                place,
                cells,
                PlatformRow(place + 1, number[1] if number else "", tuple(keys), name),
            )

    def _key_columns(self) -> Iterator[int]:
        """Yield the columns that tell people apart.

        Moodle writes what it knows of a person before the grade. What comes after it a student may
        have typed, and what many share is a group.
        """
        people = [cells for cells in self.table.rows[1:] if any(cells)]
        for at in range(self.columns[MoodleColumn.GRADE]):
            shown = [key for cells in people if (key := cells[at].strip().casefold())]
            if at not in self.columns.values() and 2 * len(set(shown)) > len(shown):
                yield at


@dataclass(frozen=True, slots=True)
class FilledWorksheet:
    """A worksheet with its grades.

    Attributes:
        content: the file for Moodle.
        filled: how many rows have a grade now.
        updates: in how many of them it is another one than before: Moodle counts only these.
        notes: works without a row, rows that were left alone, each with the reason, and grades of
            a person's that become others.
        matching: which row is whose.
        worksheet: as it was.
    """

    content: bytes
    filled: int
    updates: int
    notes: tuple[Message, ...]
    matching: Matching
    worksheet: Worksheet


def read_worksheet(source: Readable) -> Worksheet:
    """Read a grading worksheet as Moodle exports it.

    Raises:
        UsageError: headings that Moodle must have are in no known language or missing, or two
            columns have one that is read or filled: Moodle itself would take the last.
        OSError: it cannot be read.
    """
    table = read_raw_table(source, lambda header: max(map(len, _all_columns(header).values())))
    by_language = _all_columns(table.header)
    language = max(by_language, key=lambda one: len(by_language[one]))
    columns = by_language[language]
    missing = [one for one in REQUIRED if one not in columns]
    if missing:
        raise UsageError([_unknown(table, one) for one in missing])
    twice = [one for one in columns if _count(table, HEADINGS[language][one]) > 1]
    if twice:
        raise UsageError([_ambiguous(table, HEADINGS[language][one]) for one in twice])
    return Worksheet(table, language, columns)


def to_choose(worksheet: Worksheet) -> Message | None:
    """Say what has to be chosen where a worksheet is uploaded; None where Moodle's choice is right.

    A program that saved it may have taken another separator or encoding, and both stay.
    """
    separator, encodings = _USUAL
    table = worksheet.table
    if table.separator == separator and table.encoding in encodings:
        return None
    return message(
        "Where you upload it, choose the separator {separator} and the encoding {encoding}.",
        separator="TAB" if table.separator == "\t" else table.separator,
        encoding=table.encoding.removesuffix("-sig").upper(),
    )


def handed_in_moments(worksheet: Worksheet) -> dict[str, tuple[str, str]]:
    """Return who handed in and when, by Moodle's number: a name and `2026-12-01 18:00`.

    It is the clock of whoever exported the worksheet. Who handed in nothing is not in it.
    """
    found = {}
    for _, cells, row in worksheet.rows():
        written = worksheet.cell(cells, MoodleColumn.HANDED_IN_AT)
        if row.number and written not in _NONE:
            found[row.number] = row.name, _readable_date(written, worksheet.language)
    return found


def fill_worksheet(
    worksheet: Worksheet,
    works: Sequence[GradedWork],
    comment: Callable[[GradedWork], str],
    people: Mapping[str, str] = MappingProxyType({}),
) -> FilledWorksheet:
    """Fill the grades of works into a worksheet.

    Args:
        worksheet: as it was exported.
        works: that count.
        comment: makes the HTML of a comment, one paragraph without its tags.
        people: the name of everybody in the register, by id.

    Raises:
        UsageError: rows that Moodle could not tell apart, or a scale instead of points.
    """
    rows = tuple(worksheet.rows())
    matching = match(works, [row for _, _, row in rows], worksheet.table.file, people)
    changed: dict[int, tuple[str, ...]] = {}
    nameless = _without_names(worksheet, matching)
    notes = [*_without_maximum(worksheet, matching), *nameless, *matching.notes]
    grade = worksheet.columns[MoodleColumn.GRADE]
    for place, cells, row in rows:
        work = matching.works.get(row.line)
        if work is None:
            continue
        if worksheet.cell(cells, MoodleColumn.CHANGEABLE) in NOT_CHANGEABLE:
            notes.append(_locked(work, row))
            continue
        scale, maximum = (
            worksheet.cell(cells, one) for one in (MoodleColumn.SCALE, MoodleColumn.MAXIMUM)
        )
        value = grade_of(work, scale, maximum, worksheet.table.file, row)
        if not value:
            notes.append(_waiting(work, row))
            continue
        changed[place] = _filled(worksheet, cells, value, comment(work))
        if _is_from_a_person(worksheet, cells, value):
            notes.append(_replaced(work, row, cells[grade], value))
        date = worksheet.columns[MoodleColumn.GRADED_AT]
        if changed[place][date].strip() not in _NONE and not _is_readable(changed[place][date]):
            notes.append(_odd_date(work, row, changed[place][date]))
    updates = sum(
        is_other_grade(cells[grade], worksheet.table.rows[place][grade])
        for place, cells in changed.items()
    )
    content = worksheet.table.with_rows(changed)
    return FilledWorksheet(content, len(changed), updates, tuple(notes), matching, worksheet)


def _without_names(worksheet: Worksheet, matching: Matching) -> Iterator[Message]:
    """Say that nobody was looked for by name, where somebody was not found."""
    if matching.notes and MoodleColumn.NAME not in worksheet.columns:
        heading = HEADINGS[worksheet.language][MoodleColumn.NAME]
        yield message(
            "The worksheet has no column '{column}', so nobody was looked for by name.",
            column=heading,
        )


def _all_columns(header: Sequence[str]) -> dict[str, dict[MoodleColumn, int]]:
    """Find the columns of a row of headings, for each language."""
    places = {cell.strip(): place for place, cell in enumerate(header)}
    return {
        language: {column: places[word] for column, word in words.items() if word in places}
        for language, words in HEADINGS.items()
    }


def _count(table: RawTable, heading: str) -> int:
    return sum(cell.strip() == heading for cell in table.header)


def _ambiguous(table: RawTable, heading: str) -> Problem:
    what = message("Two columns are called '{name}'.", name=heading)
    return Problem(table.file, "", what, message("Leave one of them."))


def _filled(
    worksheet: Worksheet, cells: Sequence[str], grade: str, comment: str
) -> tuple[str, ...]:
    filled = list(cells)
    filled[worksheet.columns[MoodleColumn.GRADE]] = grade
    if MoodleColumn.COMMENT in worksheet.columns:
        place = worksheet.columns[MoodleColumn.COMMENT]
        filled[place] = beside_others(cells[place], comment, grade)
    date = worksheet.columns[MoodleColumn.GRADED_AT]
    if worksheet.language != "en":
        filled[date] = _readable_date(filled[date], worksheet.language)
    return tuple(filled)


def _is_from_a_person(worksheet: Worksheet, cells: Sequence[str], grade: str) -> bool:
    """Tell whether a grade takes the place of one that did not come from here."""
    before = worksheet.cell(cells, MoodleColumn.GRADE)
    ours = grade_with(worksheet.cell(cells, MoodleColumn.COMMENT))
    return bool(before) and is_other_grade(grade, before) and is_other_grade(ours, before)


def _without_maximum(worksheet: Worksheet, matching: Matching) -> Iterator[Message]:
    """Say by which points grades are written where the worksheet does not say what Moodle's are."""
    if {MoodleColumn.MAXIMUM, MoodleColumn.SCALE} & worksheet.columns.keys():
        return
    for total in sorted({work.total for work in matching.works.values()}):
        yield message(
            "The worksheet has no column '{column}': grades are of {total} points. Where Moodle has"
            " fewer, it leaves grades above them out without a word.",
            column=HEADINGS[worksheet.language][MoodleColumn.MAXIMUM],
            total=total,
        )


def _readable_date(written: str, language: str) -> str:
    """Return a localised date as Moodle can read it; what is no such date stays."""
    found = _DATE.search(written)
    if found is None:
        return written
    month = found["month"].casefold()
    names = next((names for names in (MONTHS[language], MONTHS["en"]) if month in names), None)
    if names is None:
        return written
    hour = int(found["hour"])
    if found["half"] and hour <= _NOON:
        hour = hour % _NOON + _NOON * (found["half"].casefold() == "pm")
    number = names.index(month) + 1
    return f"{found['year']}-{number:02d}-{int(found['day']):02d} {hour:02d}:{found['minute']}"


def _is_readable(written: str) -> bool:
    """Tell whether a date holds nothing but English words and digits."""
    return written.isascii()


def _unknown(table: RawTable, column: MoodleColumn) -> Problem:
    return Problem(
        table.file,
        "",
        message(
            "No heading is {known}. The headings are: {found}.",
            known=" / ".join(f"'{words[column]}'" for words in HEADINGS.values()),
            found=", ".join(table.header),
        ),
        message("Switch Moodle to English, Russian or Ukrainian and export the worksheet again."),
    )


def _locked(work: GradedWork, row: PlatformRow) -> Message:
    return message(
        "Row {row}: the grade of {student} cannot be changed in Moodle; it was left alone.",
        row=row.line,
        student=work.said,
    )


def _waiting(work: GradedWork, row: PlatformRow) -> Message:
    return message(
        "Row {row}: {student} has no grade in words before all points are given; it was left"
        " alone.",
        row=row.line,
        student=work.said,
    )


def _replaced(work: GradedWork, row: PlatformRow, before: str, grade: str) -> Message:
    return message(
        "Row {row}: {student} has {before} in Moodle, and that is not from here; it becomes"
        " {grade}. To keep it, write it into the filled table again.",
        row=row.line,
        student=work.said,
        before=before.strip(),
        grade=grade,
    )


def _odd_date(work: GradedWork, row: PlatformRow, date: str) -> Message:
    return message(
        "Row {row}: Moodle may not understand the date '{date}' and skip {student}; allow it to"
        " update records that were changed since.",
        row=row.line,
        date=date,
        student=work.said,
    )
