"""A course of one's own: a copy of another course, or a small one to begin with."""

import re
import shutil
import tempfile
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Final, TypeAlias

from gripcourse.errors import Problem, UsageError, system_problem
from gripcourse.issuing.signature import key_path, make_key
from gripcourse.machine.files import write_text
from gripcourse.machine.resources import (
    COURSE_FOLDERS,
    TEMPLATES,
    VARIANTS,
    course_root,
    engine_template,
    skeleton_root,
    template_folders,
)
from gripcourse.text.words import Message, Words, message

_PURPOSES = {
    "variants": message("schemes, formulas, catalogues and tables of variants"),
    "templates": message("the look of the printed documents"),
    "grader": message("points, tolerances, credits and the rubrics"),
}
LeftOut: TypeAlias = Callable[[str, list[str]], Iterable[str]]
"""Says which names of a folder are not copied."""

_TABLES: Final = (".csv", ".xlsx", ".ods", ".tsv")
_OF_TABLES: Final = (f"{VARIANTS}/catalogues", f"{VARIANTS}/tables")
_COMMENT: Final = re.compile(r"\s*#(en|ru|uk) ")
_LANGUAGE: Final = 'language = "{}"\n'  # the line that the skeleton has in English
_IGNORED = """\
# the key that signs workbooks, the register and the gradebook never leave your machine
private/
# what gripcourse makes
out/
"""


def init_course(
    target: Path,
    key: bytes,
    words: Words,
    source: Path | None = None,
    *,
    with_templates: bool = False,
) -> tuple[str, ...]:
    """Copy a course into a new folder, with a key of its own; whole or not at all.

    Who the students are, what was issued to them and what they got stays where it is. Of the
    reference course the sample of a roster is copied too. Templates that are the engine's are not:
    a copy would stay as it is when the engine's become others, and fail with them.

    Args:
        target: the folder to make; it may exist if it is empty.
        key: the secret that signs the workbooks of this course; 32 random bytes.
        words: language of the short guide for the instructor.
        source: the course to copy; None for the reference course.
        with_templates: copy the engine's templates too, for whoever changes the look.

    Returns:
        Names of what was not copied of the other course, as it belongs to its term or to no course:
        rosters, deadlines, and what else an instructor keeps beside it.

    Raises:
        UsageError: the folder is in use or cannot be written; nothing was changed.
    """
    origin = course_root(source)
    left: list[str] = []

    def others(folder: str, names: list[str]) -> set[str]:
        found = {name for name in names if not _is_of_a_course(origin, Path(folder) / name)}
        left.extend(_told(origin, Path(folder) / name) for name in found)
        return found

    def fill(course: Path) -> None:
        _copy(origin, course, others if source else None)
        _copy_look(origin, course, whole=with_templates)

    _make(target, key, words, fill)
    return tuple(sorted(left))


def empty_course(target: Path, key: bytes, words: Words) -> None:
    """Make a small valid course to begin with: one scheme, two sections, comments that explain.

    Args:
        target: the folder to make; it may exist if it is empty.
        key: see `init_course`.
        words: language of the comments, of the guide and of students' documents.

    Raises:
        UsageError: the folder is in use or cannot be written; nothing was changed.
    """
    _make(target, key, words, lambda course: _skeleton(course, words.language))


def _make(target: Path, key: bytes, words: Words, fill: Callable[[Path], None]) -> None:
    """Make a course in a place of its own and move it where it belongs; whole or not at all."""
    target = target.absolute()
    _refuse_used(target)
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix=".gripcourse-", dir=target.parent) as workshop:
            course = Path(workshop) / "course"
            course.mkdir()
            fill(course)
            _finish(course, key, words)
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


def _copy(origin: Path, course: Path, left_out: LeftOut | None) -> None:
    for name in COURSE_FOLDERS:
        if name != TEMPLATES and (origin / name).is_dir():
            # Contents only: files of an installation may be read-only, an instructor's are not.
            shutil.copytree(
                origin / name, course / name, ignore=left_out, copy_function=shutil.copyfile
            )


def _copy_look(origin: Path, course: Path, *, whole: bool) -> None:
    """Copy the templates of a course: those that are not the engine's, or all of either."""
    for folder in template_folders(origin / TEMPLATES):
        for path in sorted(folder.rglob("*")):
            name = path.relative_to(folder)
            copy = course / TEMPLATES / name
            if path.is_file() and not copy.exists() and (whole or not _is_engines(path, name)):
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(path, copy)


def _is_engines(path: Path, name: Path) -> bool:
    shipped = engine_template(name.as_posix())
    return shipped is not None and shipped.read_bytes() == path.read_bytes()


def _is_of_a_course(origin: Path, path: Path) -> bool:
    """Tell whether a file, or some file in a folder, is one that a course consists of.

    Everything else may say who the students are: a roster of any kind, a copy of one that an
    editor left, a table of marks.
    """
    if path.is_dir():
        inside = list(path.iterdir())
        return not inside or any(_is_of_a_course(origin, one) for one in inside)
    if path.name.startswith((".", "~")):
        return False
    suffix = path.suffix.lower()
    folder = path.parent.relative_to(origin).as_posix()
    return suffix == ".toml" or (suffix in _TABLES and folder in _OF_TABLES)


def _told(origin: Path, path: Path) -> str:
    return f"{path.relative_to(origin).as_posix()}{'/' * path.is_dir()}"


def _skeleton(course: Path, language: str) -> None:
    """Write the small course, with the comments of one language of those that it has."""
    skeleton = skeleton_root()
    for path in sorted(skeleton.rglob("*")):
        if path.is_file():
            text = "".join(_lines(path.read_text(encoding="utf-8"), language))
            write_text(course / path.relative_to(skeleton), text)
    slips = Path("grader") / "slips.toml"  # wrong methods that no subject has for itself
    write_text(course / slips, (course_root() / slips).read_text(encoding="utf-8"))


def _lines(text: str, language: str) -> Iterator[str]:
    for line in text.splitlines(keepends=True):
        comment = _COMMENT.match(line)
        if comment is None:
            yield _LANGUAGE.format(language) if line == _LANGUAGE.format("en") else line
        elif comment[1] == language:
            yield f"# {line[comment.end() :]}"


def _finish(course: Path, key: bytes, words: Words) -> None:
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
                "What the folder `templates` lacks is taken from the program: put there only "
                "what you change."
            )
        ),
        say(
            message(
                "A course can be made with all templates, to copy from: the guide for designers "
                "says how."
            )
        ),
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
