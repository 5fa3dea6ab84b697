"""What grading and marking need of a course, loaded and checked."""

from pathlib import Path

from gripcourse.batch.one_file import GradingContext
from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.issuing.store import read_register
from gripcourse.machine.office import office_command
from gripcourse.policy.load import load_policy
from gripcourse.policy.model import Policy
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
    earlier = {student: versions[:-1] for student, versions in register.versions().items()}
    return GradingContext(
        course,
        policy,
        register.by_student(),
        office=office_command(),
        earlier=earlier,
        declared=kept_declarations(course.root, register),
    )
