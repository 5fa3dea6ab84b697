"""The look of a course for workers that share no disk with it: its files travel as bytes."""

from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from tempfile import TemporaryDirectory

from gripcourse.course.model import Course
from gripcourse.machine.resources import TEMPLATES


@dataclass(frozen=True, slots=True)
class Look:
    """A course's own templates and style sheets.

    Attributes:
        files: by name below the folder of templates, sorted.
    """

    files: tuple[tuple[str, bytes], ...]


def look_of(course: Course) -> Look:
    """Read the look of a course; what it lacks is taken from the program wherever it is used.

    Raises:
        OSError: a file cannot be read.
    """
    folder = course.root / TEMPLATES
    inside = folder.resolve()
    found = (
        (path.relative_to(folder).as_posix(), path.read_bytes())
        for path in folder.rglob("*")
        if path.is_file() and path.resolve().is_relative_to(inside)
    )
    return Look(tuple(sorted(found)))


def with_look(course: Course, look: Look) -> Course:
    """Return a course whose folder is here and has nothing but its look; this process keeps it."""
    return replace(course, root=Path(_unpacked(look).name))


@lru_cache(maxsize=4)
def _unpacked(look: Look) -> "TemporaryDirectory[str]":
    folder = TemporaryDirectory(prefix="gripcourse-look-")
    for name, content in look.files:
        path = Path(folder.name) / TEMPLATES / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    return folder
