"""A student's self-check of one workbook."""

from collections.abc import Collection
from dataclasses import dataclass, replace

from gripcourse.course.model import Course
from gripcourse.errors import Problem, UsageError
from gripcourse.gradebook.checks import CheckLedger, left_of, take_one
from gripcourse.grading.self_check import (
    AnswerCheck,
    SectionCheck,
    SectionState,
    State,
    self_check,
)
from gripcourse.machine.content import Readable, is_there, shown_name
from gripcourse.policy.model import Policy, Tells
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.submission.apart import Read
from gripcourse.submission.interpret import interpret
from gripcourse.submission.model import Rejected, Submission
from gripcourse.submission.read import read_workbook
from gripcourse.text.words import Message, message


@dataclass(frozen=True, slots=True)
class CheckedWorkbook:
    """What is said about a workbook before the deadline.

    Attributes:
        plan: of the variant that it names.
        checks: of each answer.
        sections: whether numbers fit each other; none where only the reading is told.
        remarks: about the workbook as a whole.
        left: how often more than the reading will be told; None where nobody counts.
    """

    plan: Plan
    checks: tuple[AnswerCheck, ...]
    sections: tuple[SectionCheck, ...]
    remarks: tuple[Message, ...]
    left: int | None

    @property
    def compares(self) -> bool:
        """Whether it tells of any numbers that they fit each other, or do not: only that counts."""
        compared = (State.CONSISTENT, State.INCONSISTENT)
        return any(one.state is not SectionState.OPEN for one in self.sections) or any(
            one.state in compared for one in self.checks
        )


def check_file(
    source: Readable,
    course: Course,
    policy: Policy,
    read: Read = read_workbook,
    ledger: CheckLedger | None = None,
) -> CheckedWorkbook:
    """Check a workbook against itself.

    Whether numbers fit each other is told only where somebody counts how often: without a ledger
    any number of questions could be asked.

    Args:
        source: a file, or its bytes.
        course: whose workbook it is.
        policy: for the bands.
        read: reads the file; `read_apart` where it may be anybody's.
        ledger: where a server counts; None tells the reading alone.

    Raises:
        UsageError: the file is no workbook that we can read, or not one that was issued.
    """
    plan, submission = _understood(source, course, read)
    alone = _checked(submission, plan, policy, Tells.READING)
    if ledger is None or policy.check.tells is Tells.READING:
        return alone
    told, times = _checked(submission, plan, policy, policy.check.tells), policy.check.times
    left = take_one(ledger, times) if told.compares else left_of(ledger, times)
    return replace(alone, left=0) if left is None else replace(told, left=left)


def check_both_ways(
    source: Readable,
    course: Course,
    policy: Policy,
    ids: Collection[str],
    read: Read = read_workbook,
) -> tuple[CheckedWorkbook, CheckedWorkbook | None]:
    """Check a workbook for who counts afterwards, and then shows one of the two.

    Of a workbook that was issued to somebody else the reading is told, and whose it is not.

    Args:
        source: a file, or its bytes.
        course: whose workbook it is.
        policy: for the bands.
        ids: of the student who asks.
        read: reads the file.

    Returns:
        What is said of the reading alone, and all that the policy may tell; None for that where
        it tells no more.

    Raises:
        UsageError: see `check_file`.
    """
    plan, submission = _understood(source, course, read)
    if submission.identity.student not in {"", *ids}:
        said = message(
            "This workbook was issued to another student: its numbers are not compared. Choose "
            "your own."
        )
        other = replace(submission, remarks=(said, *submission.remarks))
        return _checked(other, plan, policy, Tells.READING), None
    alone = _checked(submission, plan, policy, Tells.READING)
    if policy.check.tells is Tells.READING:
        return alone, None
    return alone, _checked(submission, plan, policy, policy.check.tells)


def _understood(source: Readable, course: Course, read: Read) -> tuple[Plan, Submission]:
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
    return plan, interpret(raw, plan.quantities.values())


def _checked(submission: Submission, plan: Plan, policy: Policy, tells: Tells) -> CheckedWorkbook:
    checked = self_check(submission, plan, policy, tells)
    return CheckedWorkbook(plan, checked.answers, checked.sections, submission.remarks, None)


def _refusal(file: str, what: Message, remedy: Message) -> UsageError:
    return UsageError([Problem(file, "", what, remedy)])
