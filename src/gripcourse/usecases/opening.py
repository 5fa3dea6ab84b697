"""What grading and marking need of a course, loaded and checked."""

from dataclasses import replace
from pathlib import Path

from gripcourse.batch.one_file import GradingContext
from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.errors import NextStep, Problem, UsageError
from gripcourse.issuing.store import read_register
from gripcourse.machine.office import office_command
from gripcourse.policy.load import load_policy
from gripcourse.policy.model import Policy
from gripcourse.text.words import message
from gripcourse.usecases.declarations import kept_declarations


def open_grading(root: Path) -> GradingContext:
    """Load a course, its policy and its register.

    Raises:
        CourseError: with all problems of course or policy.
        RegisterError: the register cannot be used.
    """
    course = load_course(root)
    return grading_of(course, load_policy(course))


def grading_of(course: Course, policy: Policy) -> GradingContext:
    """Read the register of a loaded course.

    Raises:
        RegisterError: the register cannot be used.
    """
    register = read_register(course.root, course.id)
    versions = register.versions() if register.earlier else {}
    earlier = {student: all_[:-1] for student, all_ in versions.items() if all_[1:]}
    return GradingContext(
        course,
        policy,
        register.by_student(),
        office=office_command(),
        earlier=earlier,
        declared=kept_declarations(course.root, register),
    )


def recalculating(context: GradingContext, workers: int) -> GradingContext:
    """Return the same where LibreOffice computes every formula once more.

    Args:
        context: what grading needs.
        workers: how many processes read files; without any, no other program is let near them.

    Raises:
        UsageError: there is no LibreOffice, or no worker.
    """
    if context.office is None:
        what = message("LibreOffice is not installed: nothing can be recalculated.")
        remedy = message("Install it, or leave the option out; a check of the machine says how.")
        raise UsageError(
            [Problem("", "", what, remedy, parameter="recalculate", step=NextStep.CHECK_MACHINE)]
        )
    if not workers:
        what = message("Formulas are recalculated by workers, and there is none.")
        remedy = message("Give one worker or more.")
        raise UsageError([Problem("", "", what, remedy, parameter="workers")])
    return replace(context, recalculate=True)
