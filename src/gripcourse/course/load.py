"""Loading a course: the checked one that is kept, else every file of it, every fault collected."""

from dataclasses import replace
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING

from gripcourse.course.digest import course_digest
from gripcourse.course.model import Course
from gripcourse.errors import CourseError, Problem
from gripcourse.machine.enclosed import strange_files
from gripcourse.machine.kept import keep, read_kept
from gripcourse.machine.resources import COURSE_FOLDERS

if TYPE_CHECKING:
    from gripcourse.course.source_files import SourceFiles


def load_course(root: Path) -> Course:
    """Load a course and check it, any two choices of its options together.

    Args:
        root: the folder that holds `variants`, `templates` and `grader`.

    Returns:
        A course whose every formula has been checked.

    Raises:
        CourseError: with all problems of the course at once.
    """
    return load_with_digest(root)[0]


def load_with_digest(root: Path) -> tuple[Course, str | None]:
    """Load a course as `load_course` does, and return the digest that it was found under.

    Returns:
        The course and its digest: see `course_digest`. It was taken before the course was read.

    Raises:
        CourseError: with all problems of the course at once.
    """
    course, problems, digest = judge_course(root)
    if course is None or problems:
        raise CourseError(problems)
    return course, digest


def kept_course(root: Path) -> Course | None:
    """Return a course that was found sound before, None where some file has changed since."""
    digest = None if strange_files(root, COURSE_FOLDERS) else course_digest(root)
    return None if digest is None else _kept_at(digest, root)


def judge_course(
    root: Path, files: "SourceFiles | None" = None
) -> tuple[Course | None, list[Problem], str | None]:
    """Return a course with every problem of its files; one that is kept has none.

    Args:
        root: of the course.
        files: of it, where who asks has looked at them already.

    Returns:
        The course, None where a file could not be read at all; its problems; and the digest that
        it was found under, taken before it was read.
    """
    strange = strange_files(root, COURSE_FOLDERS)
    if strange:
        return None, strange, None
    digest = course_digest(root)
    kept = None if digest is None else _kept_at(digest, root)
    if kept is not None:
        return kept, [], digest
    # Only who finds nothing kept reads and checks: 50 modules.
    from gripcourse.course.check import check_course, view_parts  # noqa: PLC0415 (as said)
    from gripcourse.course.read import read_course  # noqa: PLC0415
    from gripcourse.course.sound_schemes import NOT_READ, judgement  # noqa: PLC0415
    from gripcourse.course.source_files import source_files  # noqa: PLC0415

    files = files or source_files(root)
    course, problems = read_course(root)
    if course is None:
        return None, problems, digest
    # All else that is looked at of another scheme.
    beside = ("declarations", *sorted(view_parts(course)))
    judged = None if files is None else judgement(course, files, NOT_READ, *beside)
    problems = [*problems, *check_course(course, only=None if judged is None else judged.alone)]
    if not problems and judged is not None:
        judged.remember()
    # What changed while it was read is not kept under the digest of what was there before.
    if not problems and digest is not None and digest == course_digest(root):
        keep(digest, course)
        for remembered in (_kept, _kept_at):  # that there was none
            remembered.cache_clear()
    return course, problems, digest


@lru_cache(maxsize=4)
def _kept(digest: str) -> Course | None:
    found = read_kept(digest)
    return found if isinstance(found, Course) else None


@lru_cache(maxsize=4)
def _kept_at(digest: str, root: Path) -> Course | None:
    """Return the same course to who loads it again, with all that was made of it since."""
    kept = _kept(digest)
    return None if kept is None else replace(kept, root=root)
