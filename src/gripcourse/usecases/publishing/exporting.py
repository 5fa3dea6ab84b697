"""Taking graded results to a platform, a table or people; nothing is ever sent anywhere.

Whatever is written here has names and marks, or solutions: only its owner may read it.
"""

import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.errors import NextStep, Problem, UsageError
from gripcourse.exports.analysis_tables import analysis_tables, history_tables
from gripcourse.exports.platforms.canvas import FilledGradebook, fill_gradebook
from gripcourse.exports.platforms.comment import comment_html
from gripcourse.exports.platforms.gradescope import gradescope_results
from gripcourse.exports.platforms.moodle_feedback import feedback_zip
from gripcourse.exports.platforms.moodle_worksheet import (
    FilledWorksheet,
    fill_worksheet,
    read_worksheet,
)
from gripcourse.exports.platforms.moodle_xml import moodle_xml
from gripcourse.exports.platforms.works import GradedWork, works_of
from gripcourse.exports.report_result import GradesResult, ReportResult
from gripcourse.exports.results_tables import csv_tables, results_tables, workbook
from gripcourse.gradebook.journal import regrades
from gripcourse.gradebook.store import open_gradebook
from gripcourse.issuing.store import read_register
from gripcourse.issuing.withdrawal import Join, persons_of
from gripcourse.machine.database.home import exists
from gripcourse.machine.files import write_bytes, write_text, write_together
from gripcourse.policy.load import load_policy
from gripcourse.text.shown import first_of, shown
from gripcourse.text.words import Message, Words, message
from gripcourse.usecases.grading.batch_tables import GRADES_JSON
from gripcourse.usecases.grading.grade import REPORTS
from gripcourse.usecases.grading.points_told import says_other_points
from gripcourse.variants.model import Student
from gripcourse.variants.names import find_variant
from gripcourse.variants.table import read_table

_NAMED = 5  # reports


@dataclass(frozen=True, slots=True)
class Results:
    """What was graded, opened to be taken elsewhere.

    Attributes:
        course: whose results.
        students: of the register, by id.
        grades: of the batch.
        reports: folder of the students' reports.
        works: that count.
        notes: students of whom no work counts, each with the reason.
        left: students who are no longer in the course.
        joins: which ids stand for one person, oldest first.
        outdated: works that were graded as those of an id before it was joined with another's.
    """

    course: Course
    students: dict[str, Student]
    grades: GradesResult
    reports: Path
    works: tuple[GradedWork, ...]
    notes: tuple[Message, ...]
    left: frozenset[str] = frozenset()
    joins: tuple[Join, ...] = ()
    outdated: tuple[Message, ...] = ()

    @property
    def names(self) -> dict[str, str]:
        """The name of everybody in the register, by id."""
        return {id_: one.name for id_, one in self.students.items()}

    def report_of(self, work: GradedWork) -> Path | None:
        """Tell where the report of a work lies; None where none tells the points of the grades."""
        path = self.reports / f"{work.report.student}.pdf"
        return path if path.is_file() and not says_other_points(path, work.report) else None

    def words_of(self, student: str) -> Words:
        """Return the words in which a student is told something: their own, or the course's."""
        known = self.students.get(student)
        return Words((known.language if known is not None else "") or self.course.language)


def open_results(root: Path, grades: Path) -> Results:
    """Read `grades.json` and the register of its course.

    Args:
        root: folder of the course.
        grades: the file, or the folder that grading wrote it into.

    Raises:
        UsageError: the file is none that grading wrote.
        GripcourseError: the course or its register cannot be used.
        OSError: the file cannot be read.
    """
    grades = grades / GRADES_JSON if grades.is_dir() else grades
    try:
        plain = json.loads(grades.read_text(encoding="utf-8"))
    except ValueError as fault:
        what = message("This is not what grading wrote: {reason}.", reason=str(fault))
        remedy = message("Name the grades.json of a grading.")
        raise UsageError([Problem(str(grades), "", what, remedy, step=NextStep.GRADE)]) from fault
    read = _grades_of(plain, grades)
    course = load_course(root)
    known = read_register(course.root, course.id)
    register = known.by_student()
    students = {id_: entry.student for id_, entry in register.items()}
    works, notes = works_of(read, students, {id_: one.joined for id_, one in register.items()})
    left = frozenset(id_ for id_, entry in register.items() if entry.left)
    outdated = tuple(_graded_before(read, persons_of(known.joins)))
    return Results(
        course,
        students,
        read,
        grades.parent / REPORTS,
        works,
        (*notes, *outdated),
        left,
        known.joins,
        outdated,
    )


def _grades_of(plain: Mapping[str, Any], file: Path) -> GradesResult:
    try:
        return GradesResult.from_dict(plain)
    except UsageError as fault:
        raise UsageError([replace(one, file=str(file)) for one in fault.problems]) from fault


def _graded_before(grades: GradesResult, persons: Mapping[str, str]) -> Iterator[Message]:
    for report in grades.reports:
        if report.student in persons:
            yield message(
                "{file} was graded as the work of {student}, who was joined with {person} since:"
                " grade again, so that it is told as that of {person}.",
                file=shown(report.file),
                student=report.student,
                person=persons[report.student],
            )


def moodle_files(
    results: Results, worksheet: Path, out: Path, feedback: Path | None
) -> tuple[FilledWorksheet, tuple[Message, ...]]:
    """Write the worksheet with its grades and, where wanted, the zip of reports.

    Returns:
        What was filled in, and notes on the works whose report is not in the zip.

    Raises:
        UsageError: the worksheet cannot be used; nothing was written.
        OSError: one of both cannot be written; what was there before is untouched.
    """
    course, words = results.course, Words(results.course.language)
    filled = fill_worksheet(
        read_worksheet(worksheet),
        results.works,
        lambda work: comment_html(work, course, results.words_of(work.report.student)),
        results.names,
    )
    files, notes = {out: (filled.content,)}, tuple[Message, ...]()
    if feedback is not None:
        packed, notes = feedback_zip(filled, results.report_of, words)
        files[feedback] = (packed,)
    write_together(files)
    return filled, notes


def canvas_file(results: Results, gradebook: Path, assignment: str, out: Path) -> FilledGradebook:
    """Write the table that Canvas imports; see `exports.platforms.canvas`."""
    filled = fill_gradebook(gradebook, results.works, assignment, results.names)
    write_bytes(out, filled.content, private=True)
    return filled


def gradescope_file(results: Results, student: str, out: Path, *, published: bool) -> None:
    """Write the `results.json` of one submission.

    Args:
        results: of a grading.
        student: whose; empty where there is only one report.
        out: file to write.
        published: whether students see it at once.

    Raises:
        UsageError: it is not clear whose.
    """
    report = _only_report(results, student)
    words = results.words_of(report.student)
    plain = gradescope_results(report, results.course, words, published=published)
    text = json.dumps(plain, ensure_ascii=False, indent=1, allow_nan=False)
    write_text(out, text, private=True)


def table_files(results: Results, out: Path, gradebook: str) -> tuple[Path, ...]:
    """Write the tables by student, section and quantity, and those of the analysis.

    Args:
        results: of a grading.
        out: a `.xlsx` file with a sheet for each, else a folder with a CSV file for each.
        gradebook: path or database URL; where there is none yet, its tables are left out.

    Raises:
        GradebookError: the gradebook is there and cannot be used.
        OSError: one of them cannot be written there; what was there before is untouched.
    """
    # Nobody waits for the work of who left; one that was handed in before is told all the same.
    told = {one.student for one in results.grades.reports}
    students = {
        id_: one for id_, one in results.students.items() if id_ not in results.left or id_ in told
    }
    tables = results_tables(results.grades, students) | analysis_tables(results.grades)
    if exists(gradebook):
        book = open_gradebook(gradebook, results.joins)
        tables |= history_tables(book.attempts(), regrades(book))
    if out.suffix.lower() == ".xlsx":
        write_bytes(out, workbook(tables), private=True)
        return (out,)
    written = {out / name: (data,) for name, data in csv_tables(tables).items()}
    # Of two gradings, tables would tell different things.
    write_together(written)
    return tuple(written)


def _only_report(results: Results, student: str) -> ReportResult:
    persons = persons_of(results.joins)
    wanted = persons.get(student, student)
    found = [
        one
        for one in results.grades.reports
        if not student or persons.get(one.student, one.student) == wanted
    ]
    # Of several works of one student the policy may say which counts.
    of_one = len({one.student for one in found}) == 1
    counting = [one for one in found if of_one and one.judged and one.counts is not False]
    for chosen in (found, counting):
        if len(chosen) == 1:
            return chosen[0]
    if student and not found:
        what = message("There is no report of {student}.", student=student)
        remedy = message("Name a student whose work is in this grading, by the id.")
        raise UsageError([Problem("", "", what, remedy, parameter="student")])
    named = [f"{shown(one.file)} ({one.student or '—'})" for one in found]
    what = message(
        "There are {count} reports to choose from, not one: {names}.",
        count=len(found),
        names=first_of(named, _NAMED),
    )
    raise UsageError([_to_choose(found, student, persons, what)])


def _to_choose(
    found: Sequence[ReportResult], student: str, persons: Mapping[str, str], what: Message
) -> Problem:
    """Say how one of several reports is chosen."""
    if not student:
        return Problem("", "", what, message("Name the student, or grade one submission alone."))
    former = next((one.student for one in found if one.student in persons), "")
    if former:
        remedy = message(
            "{student} was joined with {person} since: grade again, so that both count as works of"
            " one person.",
            student=former,
            person=persons[former],
        )
        return Problem("", "", what, remedy, step=NextStep.GRADE)
    remedy = message(
        "Say under [attempts] in grader/policy.toml which work of a student counts and grade again,"
        " or grade one submission alone."
    )
    return Problem("", "", what, remedy)


def moodle_questions(
    course: Course, table: Path, chosen: Sequence[str], out: Path, words: Words
) -> int:
    """Write variants of a table as Moodle's questions; the answers are in the file.

    Args:
        course: whose variants.
        table: of variants.
        chosen: their ids; empty for all.
        out: file to write.
        words: the language of the questions.

    Returns:
        How many there are.

    Raises:
        GripcourseError: the table cannot be used, or has no such variant.
    """
    variants = read_table(table, course)
    found = {one: find_variant(variants, one) for one in chosen}
    unknown = {one for one, variant in found.items() if variant is None}
    if unknown:
        what = message("The table has no variant '{variant}'.", variant=min(unknown))
        raise UsageError([Problem(str(table), "", what, message("Name those that it has."))])
    wanted = [one for one in variants if not chosen or one in found.values()]
    write_bytes(out, moodle_xml(wanted, course, load_policy(course), words), private=True)
    return len(wanted)
