"""What grading and marking need of a course, loaded and checked."""

from pathlib import Path

from gripcourse.batch.one_file import GradingContext
from gripcourse.course.load import load_course
from gripcourse.issuing.store import read_register
from gripcourse.policy.load import load_policy


def open_grading(root: Path) -> GradingContext:
    """Load a course, its policy and its register.

    Raises:
        CourseError: with all problems of course or policy.
        RegisterError: the register cannot be used.
    """
    course = load_course(root)
    register = read_register(course.root, course.id).by_student()
    return GradingContext(course, load_policy(course), register)
