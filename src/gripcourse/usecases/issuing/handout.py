"""Writing what students get: a folder each, with the assignment sheet and the answer workbook."""

import logging
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TypeAlias

from gripcourse.course.composition import Composition
from gripcourse.course.model import Course
from gripcourse.documents.assignment_sheet import assignment_sheet
from gripcourse.errors import GripcourseError, Problem, system_problem
from gripcourse.machine.enclosed import file_below
from gripcourse.machine.files import make_private_folder, replacing, write_bytes
from gripcourse.policy.model import Policy
from gripcourse.solver.plan import Plan
from gripcourse.text.words import Message, Words, message
from gripcourse.variants.explain import why_infeasible
from gripcourse.variants.model import Issued
from gripcourse.workbook.write import write_answer_workbook

PlanFactory: TypeAlias = Callable[[Composition], Plan]
"""Makes the plan of a scheme with its options; it may remember what it made."""

Progress: TypeAlias = Callable[["Handout"], None]
"""Called after each student."""

_log = logging.getLogger(__name__)


@dataclass(frozen=True, slots=True)
class Handout:
    """What became of one student's folder.

    Attributes:
        student: id of the student.
        files: what was written.
        faults: documents that could not be written, each with a sentence.
    """

    student: str
    files: tuple[Path, ...]
    faults: tuple[Message, ...]


@dataclass(frozen=True, slots=True)
class IssuingContext:
    """What all students' documents are made from.

    Attributes:
        course, policy: printed in the documents.
        plan: of a composition.
        out: the folder with one folder per student.
        links: by student, what is printed on the sheet for its owner; empty for none.
    """

    course: Course
    policy: Policy
    plan: PlanFactory
    out: Path
    links: Mapping[str, str] = field(default_factory=dict)


def sheet_path(out: Path, student: str) -> Path:
    """Return where a student's assignment sheet is written."""
    return file_below(file_below(out, student), f"assignment_{student}.pdf")


def workbook_path(out: Path, student: str) -> Path:
    """Return where a student's answer workbook is written.

    It is called like the student, so that a returned file tells whose it is.
    """
    return file_below(file_below(out, student), f"{student}.xlsx")


def issue(
    context: IssuingContext, entries: Sequence[Issued], progress: Progress = lambda _: None
) -> tuple[Handout, ...]:
    """Write the documents of students, one after the other.

    Each file appears whole or not at all. A document that fails is named and the others go on.

    Args:
        context: what the documents are made from.
        entries: of the register, with the values that were issued.
        progress: called after each student.

    Returns:
        A handout per entry, in the same order.
    """
    handouts = []
    for entry in entries:
        handouts.append(issue_one(context, entry))
        progress(handouts[-1])
    return tuple(handouts)


def issue_one(context: IssuingContext, entry: Issued) -> Handout:
    """Write the documents of one student; what fails is said in the handout."""
    student = entry.student.id
    words = Words(entry.student.language or context.course.language)
    try:
        plan = context.plan(entry.variant.composition)
        reasons = why_infeasible(plan, entry.variant.given)
    except Exception as fault:  # noqa: BLE001 - one student's fault must not stop the others
        return Handout(student, (), (_fault(student, context.out / student, fault),))
    if reasons:
        return Handout(student, (), reasons)
    sheet, workbook = sheet_path(context.out, student), workbook_path(context.out, student)

    def write_sheet() -> None:
        make_private_folder(sheet.parent)
        link = context.links.get(student, "")
        pdf = assignment_sheet(entry, plan, context.policy, context.course, words, link)
        write_bytes(sheet, pdf, private=True)

    def write_workbook() -> None:
        make_private_folder(workbook.parent)
        with replacing(workbook) as temporary:
            write_answer_workbook(temporary, plan, entry, context.course, words)

    files: list[Path] = []
    faults: list[Message] = []
    for path, write in ((sheet, write_sheet), (workbook, write_workbook)):
        try:
            write()
        except Exception as fault:  # noqa: BLE001 - as above
            faults.append(_fault(student, path, fault))
        else:
            files.append(path)
    return Handout(student, tuple(files), tuple(faults))


def _fault(student: str, path: Path, fault: Exception) -> Message:
    """Say that a document failed; what nobody foresaw goes into the log with its traceback."""
    if isinstance(fault, GripcourseError):
        return _say(student, path, fault.problems)
    if isinstance(fault, OSError):
        return _say(student, path, (system_problem(fault),))
    _log.error("%s of student %s", path.name, student, exc_info=fault)
    return message(
        "{file} of {student} was not written: {fault}.",
        file=path.name,
        student=student,
        fault=f"{type(fault).__name__}: {fault}",
    )


def _say(student: str, path: Path, problems: Sequence[Problem]) -> Message:
    first = problems[0]
    if first.file and first.key:
        return message(
            "{file} of {student} was not written: {place}: {key}: {what} {remedy}",
            file=path.name,
            student=student,
            place=first.file,
            key=first.key,
            what=first.what,
            remedy=first.remedy,
        )
    return message(
        "{file} of {student} was not written: {what} {remedy}",
        file=path.name,
        student=student,
        what=first.what,
        remedy=first.remedy,
    )
