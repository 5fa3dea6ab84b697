"""Which schemes of a course were found sound in the same files, whatever became of the others.

A scheme is judged from its own folder and from what all schemes share: the others' folders are
nothing to it. So its digest is that of every file of the course but theirs, and what is remembered
is digests alone: whatever changes, the digest is another one.
"""

import hashlib
from collections.abc import Collection, Iterable, Mapping
from pathlib import Path
from typing import Final

from gripcourse.machine.kept import digest_of, keep, read_kept
from gripcourse.machine.resources import REQUIRED_FOLDERS, VARIANTS

NOT_READ: Final = ("spaces", "tables", "atlas", "roster.csv")
"""What below `variants` neither declares anything nor is read to check what does."""
_REMEMBERED: Final = hashlib.sha256(b"digests of sound schemes").hexdigest()
_MOST: Final = 2048  # digests; the oldest are forgotten


def scheme_digests(root: Path, not_read: Collection[str] = NOT_READ) -> dict[str, str]:
    """Digest what each scheme is judged from, by its id; nothing where that cannot be told.

    Args:
        root: of the course.
        not_read: what below `variants` the judgement does not depend on.
    """
    home = root / VARIANTS / "schemes"
    left_out = [root / VARIANTS / one for one in not_read]
    below = [path for one in REQUIRED_FOLDERS for path in (root / one).rglob("*")]
    if any(path.is_symlink() and path.is_dir() for path in below):
        return {}
    own: dict[str, list[Path]] = {
        one.name: [] for one in below if one.parent == home and one.is_dir()
    }
    shared: list[Path] = []
    for path in below:
        if not path.is_file() or any(path.is_relative_to(one) for one in left_out):
            continue
        folder = path.relative_to(home).parts[0] if path.is_relative_to(home) else ""
        own.get(folder, shared).append(path)
    try:
        common = digest_of(root, shared)
        return {
            one: hashlib.sha256(f"{common}\0{digest_of(root, files)}".encode()).hexdigest()
            for one, files in own.items()
        }
    except OSError:
        return {}


def not_found_sound(digests: Mapping[str, str], subject: str, ids: Iterable[str]) -> frozenset[str]:
    """Return the schemes that were not found sound in the same files.

    Args:
        digests: see `scheme_digests`; taken before anything was read.
        subject: what is judged, and all that it depends on besides these files and the program.
        ids: of the schemes.
    """
    known = _remembered()
    return frozenset(
        one for one in ids if one not in digests or _named(subject, digests[one]) not in known
    )


def remember_sound(
    digests: Mapping[str, str],
    subject: str,
    root: Path,
    not_read: Collection[str] = NOT_READ,
) -> None:
    """Remember that all schemes were found sound, unless a file changed meanwhile; see above."""
    known = _remembered()
    new = {_named(subject, one): None for one in digests.values()}
    if not known.keys() >= new.keys() and scheme_digests(root, not_read) == digests:
        keep(_REMEMBERED, tuple(known | new)[-_MOST:])


def _named(subject: str, digest: str) -> str:
    return hashlib.sha256(f"{subject}\0{digest}".encode()).hexdigest()


def _remembered() -> dict[str, None]:
    """Return the digests that are remembered, the newest last."""
    found = read_kept(_REMEMBERED)
    return dict.fromkeys(found) if isinstance(found, tuple) else {}
