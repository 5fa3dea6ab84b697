"""Where the course is: the folder with `variants`, `templates` and `grader`.

A wheel carries the reference course inside the package; in an editable installation it is the
repository itself; `gripcourse init` makes a copy that an instructor owns.
"""

from pathlib import Path

from gripcourse.errors import NextStep, Problem, UsageError
from gripcourse.text.words import message

COURSE_FOLDERS = ("variants", "templates", "grader")

_PACKAGE = Path(__file__).parents[1]


def course_root(given: Path | None = None, package: Path = _PACKAGE) -> Path:
    """Find the course that a command works on.

    Args:
        given: the folder that the user named; it always wins.
        package: the folder of this package.

    Returns:
        The named folder, or else the reference course.

    Raises:
        UsageError: the named folder is no course, or the reference course is not to be found.
    """
    if given is not None:
        return _checked(given)
    candidates = (package / "_course", package.parent.parent)
    for candidate in candidates:
        if not _missing(candidate):
            return candidate
    problem = Problem(
        file=str(package),
        key="",
        what=message("The reference course is not installed with this package."),
        remedy=message("Name the folder of a course, or install gripcourse again."),
        step=NextStep.NAME_COURSE,
    )
    raise UsageError([problem])


def is_course(folder: Path) -> bool:
    """Tell whether a folder is a course that a command may work on without being told."""
    return not _missing(folder) and (folder / "variants" / "course.toml").is_file()


def _checked(folder: Path) -> Path:
    missing = _missing(folder)
    if not missing:
        return folder
    if not folder.is_dir():
        what = message("There is no such folder.")
    else:
        what = message("This folder is not a course: it lacks {folders}.", folders=missing)
    remedy = message("Name the folder of a course, or make one.")
    problem = Problem(str(folder), "", what, remedy, parameter="course", step=NextStep.MAKE_COURSE)
    raise UsageError([problem])


def _missing(folder: Path) -> str:
    """Name the folders of a course that `folder` lacks, separated by commas."""
    return ", ".join(name for name in COURSE_FOLDERS if not (folder / name).is_dir())
