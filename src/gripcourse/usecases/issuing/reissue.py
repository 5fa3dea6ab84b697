"""Correcting what was issued: a new version of students' assignments beside the one they have."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from datetime import date
from functools import partial
from pathlib import Path

from gripcourse.course.model import Course
from gripcourse.course.quantity import Quantity
from gripcourse.errors import Problem, UsageError
from gripcourse.gradebook.fingerprint import fingerprints
from gripcourse.issuing.allotment import Extended, Terms
from gripcourse.issuing.register import Register
from gripcourse.issuing.reissue import Correction, reissue
from gripcourse.issuing.signature import key_of, key_path
from gripcourse.issuing.store import extend_register, read_register
from gripcourse.issuing.withdrawal import persons_of
from gripcourse.machine.content import Readable
from gripcourse.machine.files import make_private_folder
from gripcourse.policy.model import Policy
from gripcourse.solver.plan import plan_of
from gripcourse.text.words import message
from gripcourse.usecases.issuing.declarations import declared_otherwise, keep_declarations
from gripcourse.usecases.issuing.handout import IssuingContext, issue_one
from gripcourse.usecases.issuing.issue import (
    IssueOne,
    Issuing,
    links_on_sheets,
    refuse_past,
    write_handouts,
)
from gripcourse.usecases.serving.links import refuse_no_address
from gripcourse.variants.explain import why_infeasible
from gripcourse.variants.model import Issued, Variant
from gripcourse.variants.table import read_table


@dataclass(frozen=True, slots=True)
class CorrectedOrder:
    """What is to be issued anew.

    Attributes:
        correction: to whom, which variant, why, and who does it.
        table: of variants, a file or its bytes.
        out: folder to write the students' folders to.
        today: day of the issue.
        deadline: last day for handing in; None for everybody's own.
        link_days: how many days from `today` the personal link on each sheet is good for; 0 for
            sheets without one.
    """

    correction: Correction
    table: Readable
    out: Path
    today: date
    deadline: date | None
    link_days: int = 0


def reissue_order(  # noqa: PLR0913 (the last two have usual values)
    course: Course,
    policy: Policy,
    order: CorrectedOrder,
    workers: int,
    on_done: Callable[[str], None],
    *,
    on_counted: Callable[[int], None] = lambda _: None,
    issue_one: IssueOne = issue_one,
) -> Issuing:
    """Issue new versions to students and write their documents; what they had stays on record.

    Args:
        course: its folder holds the key and the register.
        policy: printed in the documents.
        order: what to issue.
        workers: how many processes lay out documents; 0 for none but this one.
        on_done: called with each student's id.
        on_counted: called before, with how many students there are.
        issue_one: writes one student's documents.

    Raises:
        GripcourseError: something cannot be used or cannot be done; nothing was written.
    """
    refuse_past(order.deadline, order.today)
    if order.link_days:
        refuse_no_address(course.address)
    before = read_register(course.root, course.id)
    order = replace(order, correction=_of_persons(order.correction, before))
    key = key_of(key_path(course.root), issued=bool(before.entries))
    if key is None:
        what = message("Nothing was issued from this course.")
        remedy = message("Issue first; what was issued can be corrected.")
        raise UsageError([Problem(str(course.root), "", what, remedy)])
    terms = Terms(key, order.today, order.deadline, fingerprints(course.root).course)
    variants = read_table(order.table, course)

    otherwise = declared_otherwise(course)

    def change(register: Register) -> Extended:
        return reissue(
            register,
            order.correction,
            variants,
            terms,
            partial(_quantity, course),
            otherwise,
        )

    _refuse_infeasible(course, _fresh(change(before).register, order))
    # Before anything is kept: a folder that cannot be written must not cost a version.
    make_private_folder(order.out)
    keep_declarations(course.root)
    extended = extend_register(course.root, course.id, change)
    links = links_on_sheets(course, policy, key, order.today, order.link_days)
    context = IssuingContext(course, policy, partial(plan_of, course), order.out, links)
    entries = _fresh(extended.register, order)
    on_counted(len(entries))
    return Issuing(write_handouts(context, entries, workers, on_done, issue_one), extended.notes)


def _of_persons(correction: Correction, register: Register) -> Correction:
    """Return a correction that names persons by the ids that stand for them now."""
    persons = persons_of(register.joins)
    students = tuple(persons.get(one, one) for one in correction.students)
    return replace(correction, students=students)


def _quantity(course: Course, variant: Variant, name: str) -> Quantity | None:
    return plan_of(course, variant.composition).quantities.get(name)


def _fresh(register: Register, order: CorrectedOrder) -> list[Issued]:
    known = register.by_student()
    return [known[student] for student in dict.fromkeys(order.correction.students)]


def _refuse_infeasible(course: Course, entries: Sequence[Issued]) -> None:
    """Refuse numbers that no sheet can be made of, before they are kept for good."""
    problems = [
        Problem(
            "",
            message("student {student}", student=entry.student.id),
            reason,
            message("Nothing was issued; name another variant, or correct the row."),
        )
        for entry in entries
        for reason in why_infeasible(
            plan_of(course, entry.variant.composition), entry.variant.given
        )
    ]
    if problems:
        raise UsageError(problems)
