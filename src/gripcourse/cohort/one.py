"""Grading one file, whatever it is: reading, identifying, judging."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from gripcourse.course.model import Course
from gripcourse.course.policy import Policy
from gripcourse.grading.identify import submitter
from gripcourse.grading.judge import judge
from gripcourse.grading.model import Report
from gripcourse.grading.unjudged import rejected_report, unknown_student_report
from gripcourse.solver.plan import make_plan
from gripcourse.submission.interpret import interpret
from gripcourse.submission.model import Rejected
from gripcourse.submission.read import read_workbook
from gripcourse.variants.model import Issued


@dataclass(frozen=True, slots=True)
class Desk:
    """What grading needs: the course, its policy and the register by student."""

    course: Course
    policy: Policy
    register: Mapping[str, Issued]


def grade_file(file: Path, desk: Desk) -> Report:
    """Grade one file; the student's faults are in the report, only ours are exceptions."""
    raw = read_workbook(file)
    if isinstance(raw, Rejected):
        return rejected_report(raw, submitter(str(file), "", desk.register))
    issued = submitter(str(file), raw.identity.student, desk.register)
    if issued is None:
        return unknown_student_report(str(file), raw.identity.student, raw.digest)
    plan = make_plan(desk.course, issued.variant.scheme, issued.variant.options)
    submission = interpret(raw, plan.quantities.values())
    report = judge(submission, issued, plan, desk.policy)
    return replace(report, givens=submission.givens, creator=submission.creator)
