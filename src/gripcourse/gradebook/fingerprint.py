"""What graded: fingerprints over the files of course, policy and engine."""

import hashlib
from collections.abc import Iterable
from functools import cache
from pathlib import Path

from gripcourse.gradebook.model import Fingerprints

# What decides over results. Rosters, tables and spaces do not: everybody's numbers are in the
# register.
_COURSE = ("variants/*.toml", "variants/*/*.toml", "variants/schemes/*/*.toml", "variants/*/*.csv")
_POLICY = ("grader/*.toml", "grader/*/*.toml")
_NO_COURSE = {"spaces", "tables"}
_ENGINE = Path(__file__).parents[1]
# The parts that decide over results: what draws, prints and speaks does not.
_DECIDING = (
    *("text", "formula", "course", "solver", "policy", "slips"),
    *("variants", "submission", "grading", "batch"),
)


def fingerprints(root: Path) -> Fingerprints:
    """Return the fingerprints of a course's declarations, of its policy and of this program.

    Args:
        root: folder of the course.

    Raises:
        OSError: a file cannot be read.
    """
    course, policy = (_digest(root, files(root)) for files in (declaring_files, policy_files))
    return Fingerprints(course, policy, engine_fingerprint())


def declaring_files(root: Path) -> list[Path]:
    """Return the files of a course that declare what is judged: neither people nor tables."""
    return [path for path in _found(root, _COURSE) if path.parent.name not in _NO_COURSE]


def policy_files(root: Path) -> list[Path]:
    """Return the files of a course that say how answers become points, with the rubrics."""
    return _found(root, _POLICY)


@cache
def engine_fingerprint() -> str:
    """Return the fingerprint of the parts of this program that decide over results.

    Raises:
        OSError: a file of the program cannot be read.
    """
    return _digest(_ENGINE, _found(_ENGINE, [f"{part}/**/*.py" for part in _DECIDING]))


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
