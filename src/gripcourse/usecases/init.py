"""A course of one's own: the reference course copied out for an instructor to own and change."""

import shutil
import tempfile
from pathlib import Path

from gripcourse.errors import Problem, UsageError, system_problem
from gripcourse.issuing.signature import key_path, make_key
from gripcourse.machine.files import write_text
from gripcourse.machine.resources import COURSE_FOLDERS, course_root
from gripcourse.text.words import Message, Words, message

_PURPOSES = {
    "variants": message("schemes, formulas, catalogues and tables of variants"),
    "templates": message("the look of the printed documents"),
    "grader": message("points, tolerances, credits and the rubrics"),
}
_IGNORED = """\
# the key that signs workbooks, the register and the gradebook never leave your machine
private/
# what gripcourse makes
out/
"""


def init_course(target: Path, key: bytes, words: Words, source: Path | None = None) -> None:
    """Copy a course into a new folder, with a key of its own; whole or not at all.

    Args:
        target: the folder to make; it may exist if it is empty.
        key: the secret that signs the workbooks of this course; 32 random bytes.
        words: language of the short guide for the instructor.
        source: the course to copy; None for the reference course.

    Raises:
        UsageError: the folder is in use or cannot be written; nothing was changed.
    """
    origin = course_root(source)
    target = target.absolute()
    _refuse_used(target)
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix=".gripcourse-", dir=target.parent) as workshop:
            course = Path(workshop) / "course"
            _build(course, origin, key, words)
            _put_in_place(course, target)
    except OSError as error:
        what = message("The folder cannot be written. {reason}", reason=system_problem(error).what)
        remedy = message("Name a folder in a place where you may write.")
        raise _refusal(target, what, remedy) from error


def _refuse_used(target: Path) -> None:
    if target.is_symlink() or target.exists():
        if not target.is_dir():
            what = message("This is a file, not a folder.")
        elif any(target.iterdir()):
            what = message("This folder is not empty.")
        else:
            return
        remedy = message("Name a new or empty folder: nothing is ever overwritten.")
        raise _refusal(target, what, remedy)


def _refusal(target: Path, what: Message, remedy: Message) -> UsageError:
    return UsageError([Problem(file=str(target), key="", what=what, remedy=remedy)])


def _build(course: Path, origin: Path, key: bytes, words: Words) -> None:
    course.mkdir()
    for name in COURSE_FOLDERS:
        # Contents only: files of an installation may be read-only, an instructor's are not.
        shutil.copytree(origin / name, course / name, copy_function=shutil.copyfile)
    make_key(key_path(course), key)
    write_text(course / ".gitignore", _IGNORED)
    write_text(course / "README.md", _guide(words))


def _put_in_place(course: Path, target: Path) -> None:
    if not target.exists():
        course.rename(target)
        return
    # The folder may be somebody's working directory: fill it, don't put another one in its place.
    try:
        _move_entries(course, target)
    except OSError:
        _move_entries(target, course)
        raise


def _move_entries(source: Path, target: Path) -> None:
    for entry in sorted(source.iterdir()):
        entry.rename(target / entry.name)


def _guide(words: Words) -> str:
    """Write the short guide that lies in the folder."""
    say = words.say
    title = say(message("Your course"))
    paragraphs = (
        f"# {title}",
        say(message("This folder is yours. Three parts of it change without programming:")),
        "\n".join(f"- `{folder}/`: {say(purpose)}" for folder, purpose in _PURPOSES.items()),
        say(
            message(
                "The folder `private` holds the key that signs the workbooks and the register of "
                "what was issued to whom. Keep a copy of it in a safe place, never publish it and "
                "never give it to students: with another key no workbook that was issued before "
                "can be checked."
            )
        ),
        say(message("After every change check the course:")),
        "    gripcourse validate --course .",
        say(message("All commands are listed by:")),
        "    gripcourse --help",
    )
    return "\n\n".join(paragraphs) + "\n"
