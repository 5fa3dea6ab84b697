"""Which course and which policy graded: a fingerprint over their files."""

import hashlib
from collections.abc import Iterable
from pathlib import Path

from gripcourse.gradebook.model import Fingerprints

# What decides over results. Rosters, tables and spaces do not: everybody's numbers are in the
# register.
_COURSE = ("variants/*.toml", "variants/*/*.toml", "variants/schemes/*/*.toml", "variants/*/*.csv")
_POLICY = ("grader/*.toml", "grader/*/*.toml")
_NO_COURSE = {"spaces", "tables"}


def fingerprints(root: Path) -> Fingerprints:
    """Return the fingerprints of a course's declarations and of its policy.

    Args:
        root: folder of the course.

    Raises:
        OSError: a file cannot be read.
    """
    course = [path for path in _found(root, _COURSE) if path.parent.name not in _NO_COURSE]
    return Fingerprints(_digest(root, course), _digest(root, _found(root, _POLICY)))


def _found(root: Path, patterns: Iterable[str]) -> list[Path]:
    return sorted({path for pattern in patterns for path in root.glob(pattern)})


def _digest(root: Path, paths: Iterable[Path]) -> str:
    whole = hashlib.sha256()
    for path in paths:
        name, content = path.relative_to(root).as_posix(), path.read_bytes()
        # Lengths keep the end of one file apart from the beginning of the next.
        whole.update(f"{name}\n{len(content)}\n".encode())
        whole.update(content)
    return whole.hexdigest()
