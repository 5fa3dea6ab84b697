"""A student's self-check of one workbook."""

from dataclasses import dataclass, replace

from gripcourse.course.model import Course
from gripcourse.errors import Problem, UsageError
from gripcourse.grading.self_check import AnswerCheck, self_check
from gripcourse.machine.content import Readable, is_there, shown_name
from gripcourse.policy.model import Policy
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.submission.apart import Read
from gripcourse.submission.interpret import interpret
from gripcourse.submission.model import Rejected
from gripcourse.submission.read import read_workbook
from gripcourse.text.words import Message, message


@dataclass(frozen=True, slots=True)
class CheckedWorkbook:
    """What is said about a workbook before the deadline."""

    plan: Plan
    checks: tuple[AnswerCheck, ...]
    remarks: tuple[Message, ...]


def check_file(
    source: Readable, course: Course, policy: Policy, read: Read = read_workbook
) -> CheckedWorkbook:
    """Check a workbook against itself.

    Args:
        source: a file, or its bytes.
        course: whose workbook it is.
        policy: for the bands.
        read: reads the file; `read_apart` where it may be anybody's.

    Raises:
        UsageError: the file is no workbook that we can read, or not one that was issued.
    """
    file = shown_name(source)
    if not is_there(source):
        raise _refusal(file, message("There is no such file."), message("Name a workbook."))
    raw = read(source)
    if isinstance(raw, Rejected):
        raise _refusal(
            file, raw.reason, message("Hand in the answer workbook that you were given.")
        )
    if not raw.identity.scheme:
        raise _refusal(
            file,
            message("The workbook does not say which variant it belongs to."),
            message("Use the answer workbook that you were given."),
        )
    try:
        plan = make_plan(course, raw.identity.scheme, raw.identity.options)
    except UsageError as error:
        named = [replace(problem, file=file) for problem in error.problems]
        raise UsageError(named) from error
    submission = interpret(raw, plan.quantities.values())
    return CheckedWorkbook(plan, self_check(submission, plan, policy), submission.remarks)


def _refusal(file: str, what: Message, remedy: Message) -> UsageError:
    return UsageError([Problem(file, "", what, remedy)])
