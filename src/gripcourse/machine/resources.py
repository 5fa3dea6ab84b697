"""Where the course is: the folder with `variants` and `grader`, and `templates` if it has a look.

What a course's `templates` lacks is taken from those that come with the engine, file by file.

A wheel carries the reference course inside the package; in an editable installation it is the
repository itself; `gripcourse init` makes a copy that an instructor owns.
"""

import os
from pathlib import Path

from gripcourse.errors import NextStep, Problem, UsageError
from gripcourse.text.words import message

VARIANTS = "variants"
TEMPLATES = "templates"
REQUIRED_FOLDERS = (VARIANTS, "grader")
COURSE_FOLDERS = (VARIANTS, TEMPLATES, "grader")
_OWN_FOLDERS = (*COURSE_FOLDERS, "private")

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


def skeleton_root(package: Path = _PACKAGE) -> Path:
    """Return the folder of the small course that new courses begin with."""
    return package / "skeleton"


def template_folders(templates: Path, package: Path = _PACKAGE) -> tuple[Path, ...]:
    """Return the folders in which a template or a style sheet is looked for, in order.

    Args:
        templates: the folder of a course; it need not exist.
        package: the folder of this package.

    Returns:
        That folder, if there is one, and the folder with the engine's own.
    """
    shipped = (package / "_course" / TEMPLATES, package.parent.parent / TEMPLATES)
    found = (one for one in (templates, *shipped) if one.is_dir())
    return tuple({one.resolve(): one for one in found}.values())


def engine_template(name: str, package: Path = _PACKAGE) -> Path | None:
    """Return the engine's own template or style sheet of a name; None where it has none.

    A course's file of the same name goes before it; see `template_folders`.
    """
    shipped = template_folders(package / "nowhere", package)
    return next((path for folder in shipped if (path := folder / name).is_file()), None)


def template_file(templates: Path, name: str) -> Path:
    """Return the file of a template or a style sheet: the course's, else the engine's.

    Where neither has it, the path at which the course should have it.
    """
    candidates = (folder / name for folder in template_folders(templates))
    return next((path for path in candidates if path.is_file()), templates / name)


def is_course(folder: Path) -> bool:
    """Tell whether a folder is meant as a course: a command works on it without being told.

    One that lacks its main file, or a folder, is a course with a fault; another must not be judged
    in its place.
    """
    return not _missing(folder) or (folder / VARIANTS / "course.toml").is_file()


def deadlines_path(root: Path) -> Path:
    """Where a course keeps its deadlines, if it has any besides those that it issued with."""
    return root / VARIANTS / "deadlines.csv"


def expect_apart(out: Path, course: Path) -> None:
    """See that results do not get among the files that a course is made of.

    A folder of their own inside that of the course is apart.

    Raises:
        UsageError: they would.
    """
    # Unlike `Path.resolve` this follows links that lead nowhere, or round and round, too.
    inside, root = Path(os.path.realpath(out)), Path(os.path.realpath(course))
    own = (root / name for name in _OWN_FOLDERS)
    if inside != root and not any(map(inside.is_relative_to, own)):
        return
    what = message("The course's own files are in this folder: results would get among them.")
    remedy = message("Name another folder, for example {folder}.", folder=str(course / "out"))
    raise UsageError([Problem(str(out), "", what, remedy, parameter="out")])


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
    return ", ".join(name for name in REQUIRED_FOLDERS if not (folder / name).is_dir())
