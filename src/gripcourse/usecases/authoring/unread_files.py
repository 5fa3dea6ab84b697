"""Files of a course that nobody reads: another case of letters, another folder, a name misspelt.

Nearly every file of a course may be missing: one that stands elsewhere would be so in silence.
"""

from collections.abc import Iterator
from difflib import get_close_matches
from pathlib import Path
from typing import Final

from gripcourse.errors import Problem
from gripcourse.machine.resources import REQUIRED_FOLDERS, VARIANTS
from gripcourse.text.words import Message, message
from gripcourse.usecases.authoring.schema import FILE_KINDS

_CATALOGUES: Final = f"{VARIANTS}/catalogues/*.csv"
_PATTERNS: Final = (*(one for kind in FILE_KINDS for one in kind.places), _CATALOGUES)
_NEAR: Final = 0.85


def unread_problems(root: Path) -> Iterator[Problem]:
    """Yield each file that is written like one of a course and stands where none is read.

    Args:
        root: of the course.
    """
    for name in sorted(_written_like_ours(root)):
        if not _is_read(name):
            yield Problem(name, "", message("The program does not read this file."), _remedy(name))


def _written_like_ours(root: Path) -> Iterator[str]:
    for folder in REQUIRED_FOLDERS:
        for path in (root / folder).rglob("*"):
            name = path.relative_to(root).as_posix()
            is_ours = path.suffix.lower() == ".toml" or _is_like(name, _CATALOGUES)
            if is_ours and not path.name.startswith(".") and path.is_file():
                yield name


def _is_read(name: str) -> bool:
    """Tell whether a file stands where one is read."""
    return any(name == _filled(pattern, name) for pattern in _PATTERNS)


def _is_like(name: str, pattern: str) -> bool:
    """Tell whether a file would be read if its name were in small letters."""
    return name.lower() == _filled(pattern, name.lower())


def _filled(pattern: str, name: str) -> str:
    """Return what a file would be called to be one of a kind; empty where its depth differs."""
    wanted = pattern.split("/")
    own = [*name.split("/")[:-1], Path(name).stem]
    if len(own) != len(wanted):
        return ""
    return "/".join(one.replace("*", mine) for one, mine in zip(wanted, own, strict=True))


def _remedy(name: str) -> Message:
    known = {one.lower(): one for pattern in _PATTERNS if (one := _filled(pattern, name))}
    near = get_close_matches(name.lower(), known, n=1, cutoff=_NEAR)
    if near:
        return message("Rename it to {name}.", name=known[near[0]])
    return message(
        "Put it where it is read, as `gripcourse schema` lists it, or give it another ending."
    )
