"""Publishing results: a copy that stays as it was, whatever is graded afterwards."""

import json
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

from gripcourse.access.desk.model import Publication
from gripcourse.errors import NextStep, Problem, UsageError
from gripcourse.exports.report_result import GradesResult, ReportResult
from gripcourse.gradebook.joined import ever_joined, family
from gripcourse.gradebook.journal import Signed
from gripcourse.gradebook.store import Gradebook
from gripcourse.grading.model import KnownBy
from gripcourse.issuing.withdrawal import persons_of
from gripcourse.machine.database.home import home_of
from gripcourse.machine.files import make_private_folder, write_bytes, write_text
from gripcourse.text.words import message
from gripcourse.usecases.grading.batch_tables import GRADES_CSV, GRADES_JSON
from gripcourse.usecases.grading.grade import REPORTS
from gripcourse.usecases.marks.regrade import publish as keep_told
from gripcourse.usecases.serving.counted import counted_works
from gripcourse.usecases.serving.desk import DeskContext


@dataclass(frozen=True, slots=True)
class ShownResult:
    """What a student may see: the judgement, and the printed report where there is one."""

    report: ReportResult
    pdf: Path | None


def publish(context: DeskContext, graded: Path, by: str, why: str, now: datetime) -> Publication:
    """Let students see the results of a graded batch.

    Args:
        context: of the course.
        graded: the folder that grading wrote.
        by: who does it.
        why: in a few words; may be empty.
        now: with its zone.

    Raises:
        UsageError: the folder holds no results.
        OSError: something cannot be read or written; nothing was published.
    """
    if not (graded / GRADES_JSON).is_file():
        what = message("There are no results in this folder.")
        remedy = message("Name the folder that grading wrote.")
        raise UsageError(
            [Problem(str(graded), "", what, remedy, parameter="graded", step=NextStep.GRADE)]
        )
    publication = None
    while publication is None:
        number = _free_number(context)
        _copy(context, graded, _folder(context, number))
        # Somebody may have withdrawn the results before, meanwhile: that has a number, too.
        publication = context.desk.add_publication(number, by, why, now)
    # Who has been told a result must not lose it by grading again: the gradebook keeps that, too.
    keep_told(home_of(context.course.root), (), Signed(by, now, why), context.joins())
    return publication


def _free_number(context: DeskContext) -> int:
    """Make the folder of the next publication, and return its number.

    Who publishes at the same time, by a second click for example, gets another one: both are whole,
    and the last one counts.
    """
    known = context.desk.publications()
    number = known[-1].number + 1 if known else 1
    make_private_folder(_folder(context, number).parent)
    while True:
        try:
            _folder(context, number).mkdir(mode=0o700)
        except FileExistsError:
            number += 1
        else:
            return number


def _copy(context: DeskContext, graded: Path, folder: Path) -> None:
    """Copy what students of the register are told, and the table of grades."""
    plain = json.loads((graded / GRADES_JSON).read_text(encoding="utf-8"))
    told = dict[str, ReportResult]()
    # What was graded before two ids were joined is kept under the id of then; see `published_to`.
    listed = {*context.register(), *persons_of(context.joins())}
    # Of a student's works the one whose printed report has no number: see `student_reports`.
    for report in sorted(GradesResult.from_dict(plain).reports, key=_certainty):
        if report.student in listed:
            told.setdefault(report.student, report)
    for student, report in told.items():
        text = json.dumps(report.to_dict(), ensure_ascii=False, allow_nan=False)
        write_text(folder / f"{student}.json", text, private=True)
        printed = graded / REPORTS / f"{student}.pdf"
        if printed.is_file():
            write_bytes(folder / printed.name, printed.read_bytes(), private=True)
    write_bytes(folder / GRADES_CSV, (graded / GRADES_CSV).read_bytes(), private=True)


def _certainty(report: ReportResult) -> tuple[bool, bool, int]:
    return report.counts is False, not report.judged, tuple(KnownBy).index(report.known_by)


def withdraw(context: DeskContext, by: str, why: str, now: datetime) -> Publication:
    """Let students see no results any more; what was published is kept.

    Raises:
        UsageError: nothing is published.
    """
    if current(context) is None:
        what = message("Nothing is published.")
        raise UsageError([Problem("", "", what, message("There is nothing to withdraw."))])
    return context.desk.add_withdrawal(by, why, now)


def current(context: DeskContext) -> Publication | None:
    """Return the publication that students see now."""
    known = context.desk.publications()
    return known[-1] if known and known[-1].published else None


def published_to(context: DeskContext, student: str) -> ShownResult | None:
    """Return what a student of the register may see; None where nothing is published.

    What was published under an id that was joined with the student's is the student's, too, and
    what was published while two were joined goes with the work where they are two again. Where
    there are results under several, it is the one of the work that counts, else the student's own.
    """
    publication = current(context)
    if publication is None:
        return None
    folder = _folder(context, publication.number)
    register = context.issued.read()
    others = sorted(ever_joined(student, register.withdrawals) - {student})
    found = [one for id_ in (student, *others) if (one := _shown(folder, id_)) is not None]
    if others:
        found = [one for one in found if _is_of(one.report, student, others, context)]
    if len(found) > 1:
        counted = counted_works(context, {student}).get(student)
        digest = "" if counted is None else counted.attempt.digest
        found.sort(key=lambda one: one.report.digest != digest)
    return found[0] if found else None


def _is_of(report: ReportResult, student: str, others: Sequence[str], context: DeskContext) -> bool:
    """Tell whether a result that was published is a student's, as ids are joined now.

    Args:
        report: that was published under the student's id, or one of the others.
        student: id.
        others: ids that were ever joined with it.
        context: of the course.
    """
    joins = context.joins()
    book = Gradebook(context.desk.engine, joins)
    works = {(one.student, one.digest) for one in book.attempts({student, *others})}
    if (student, report.digest) in works:
        return True
    # Of what no gradebook knows the id alone tells whose it is.
    is_known = any(digest == report.digest for _, digest in works)
    return not is_known and report.student in family({student}, joins)


def _shown(folder: Path, id_: str) -> ShownResult | None:
    path = folder / f"{id_}.json"
    if not path.is_file():
        return None
    report = ReportResult.from_dict(json.loads(path.read_text(encoding="utf-8")))
    printed = folder / f"{id_}.pdf"
    return ShownResult(report, printed if printed.is_file() else None)


def published_grades(context: DeskContext) -> Path | None:
    """Return the table of grades as it was published."""
    publication = current(context)
    return None if publication is None else _folder(context, publication.number) / GRADES_CSV


def _folder(context: DeskContext, number: int) -> Path:
    return context.private / "published" / str(number)
