"""What of a course was found out, and sound: not again as long as no file has changed."""

import hashlib
import sys
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Final, TypeVar

from gripcourse.errors import Problem
from gripcourse.machine.kept import digest_of, keep, read_kept

_Found = TypeVar("_Found")
_TRANSLATIONS: Final = Path(__file__).parents[1] / "locale"  # the program, too


def unless_sound(
    subject: str, root: Path, folders: Iterable[Path], judge: Callable[[], list[Problem]]
) -> list[Problem]:
    """Return the problems that a judgement finds; none where it found none in the same files.

    What was found wrong is judged again each time: whoever mends a course wants to read of it.

    Args:
        subject: a name of the judgement; another one of the same files has another.
        root: of the course.
        folders: all that the judgement depends on, besides this program and what it is built on.
        judge: finds the problems.
    """
    return found_before(subject, root, folders, judge, lambda problems: not problems)


def found_before(
    subject: str,
    root: Path,
    paths: Iterable[Path],
    find: Callable[[], _Found],
    is_kept: Callable[[_Found], bool],
) -> _Found:
    """Return what is found in files, or was found in the same ones.

    Args:
        subject: a name of what is found; another one of the same files has another.
        root: of the course.
        paths: all that it depends on, besides this program and what it is built on; of a folder all
            that is below.
        find: finds it; it can be pickled.
        is_kept: whether it is kept for the next time.
    """
    listed = (*paths, _TRANSLATIONS)
    digest = _digest(subject, root, listed)
    kept: _Found | None = None if digest is None else read_kept(digest)
    if kept is not None:
        return kept
    found = find()
    # What changed meanwhile is not kept under the digest of what was there before.
    if digest is not None and is_kept(found) and digest == _digest(subject, root, listed):
        keep(digest, found)
    return found


def installed() -> list[str]:
    """Name the packages that are installed, with their versions: others may judge otherwise."""
    return sorted(one.name for place in sys.path for one in Path(place).glob("*.dist-info"))


def _digest(subject: str, root: Path, folders: Iterable[Path]) -> str | None:
    """Digest every file of some folders; None: some cannot be read, or a folder is a link."""
    found = hashlib.sha256("\0".join([subject, *installed()]).encode())
    try:
        for folder in folders:
            below = [folder, *folder.rglob("*")]
            if any(path.is_symlink() and path.is_dir() for path in below):
                return None
            base = root if folder.is_relative_to(root) else folder
            of_folder = digest_of(base, (path for path in below if path.is_file()))
            found.update(f"\0{of_folder}".encode())
    except OSError:
        return None
    return found.hexdigest()
