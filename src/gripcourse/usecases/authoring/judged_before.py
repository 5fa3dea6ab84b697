"""What of a course was found out, and sound: not again as long as no file has changed."""

import hashlib
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

from gripcourse.errors import Problem
from gripcourse.machine.kept import digest_of, keep, read_kept

_Found = TypeVar("_Found")


@dataclass(frozen=True, slots=True)
class FilesSeen:
    """Files as they were before anything was read of them; equal as long as none has changed.

    Attributes:
        root: of the course.
        paths: files, and folders with all that is below.
        digest: of all of them; None: some cannot be read, or a folder is a link.
        changed: when anything of each file changed last: one may be again what it was.
    """

    root: Path
    paths: tuple[Path, ...]
    digest: str | None
    changed: tuple[int, ...]


def files_seen(root: Path, paths: Iterable[Path]) -> FilesSeen:
    """Look at files before they are read.

    Args:
        root: of the course.
        paths: files, and folders with all that is below.
    """
    listed = tuple(paths)
    found = hashlib.sha256()
    changed: list[int] = []
    try:
        for folder in listed:
            below = sorted([folder, *folder.rglob("*")])
            if any(path.is_symlink() and path.is_dir() for path in below):
                return FilesSeen(root, listed, None, ())
            base = root if folder.is_relative_to(root) else folder
            files = [path for path in below if path.is_file()]
            changed += (path.stat().st_ctime_ns for path in files)
            found.update(f"\0{digest_of(base, files)}".encode())
    except OSError:
        return FilesSeen(root, listed, None, ())
    return FilesSeen(root, listed, found.hexdigest(), tuple(changed))


def unless_sound(
    subject: str, seen: Sequence[FilesSeen], judge: Callable[[], list[Problem]]
) -> list[Problem]:
    """Return the problems that a judgement finds; none where it found none in the same files.

    What was found wrong is judged again each time: whoever mends a course wants to read of it.

    Args:
        subject: a name of the judgement; another one of the same files has another.
        seen: all that the judgement depends on, besides this program and what it is built on; seen
            before it was read.
        judge: finds the problems.
    """
    return found_before(subject, seen, judge, lambda problems: not problems)


def found_before(
    subject: str,
    seen: Sequence[FilesSeen],
    find: Callable[[], _Found],
    is_kept: Callable[[_Found], bool],
) -> _Found:
    """Return what is found in files, or was found in the same ones.

    Args:
        subject: a name of what is found; another one of the same files has another.
        seen: all that it depends on, besides this program and what it is built on; seen before it
            was read.
        find: finds it; it can be pickled.
        is_kept: whether it is kept for the next time.
    """
    digest = _digest(subject, seen)
    kept: _Found | None = None if digest is None else read_kept(digest)
    if kept is not None:
        return kept
    found = find()
    # What changed meanwhile is not kept under the digest of what was there before.
    if digest is not None and is_kept(found) and _are_unchanged(seen):
        keep(digest, found)
    return found


def is_known(subject: str, seen: Sequence[FilesSeen]) -> bool:
    """Tell whether `found_before` would find nothing anew."""
    digest = _digest(subject, seen)
    return digest is not None and read_kept(digest) is not None


def _digest(subject: str, seen: Iterable[FilesSeen]) -> str | None:
    digests = [one.digest for one in seen]
    told = [one for one in digests if one is not None]
    if len(told) < len(digests):
        return None
    program = digest_of(Path(), ())
    return hashlib.sha256("\0".join([program, subject, *told]).encode()).hexdigest()


def _are_unchanged(seen: Iterable[FilesSeen]) -> bool:
    return all(files_seen(one.root, one.paths) == one for one in seen)
