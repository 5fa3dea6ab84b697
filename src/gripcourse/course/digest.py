"""What a course is loaded from and checked with, as one digest: what has another one is another."""

from pathlib import Path
from typing import Final

from gripcourse.machine.kept import digest_of
from gripcourse.machine.resources import VARIANTS

RUBRICS: Final = "grader/rubric"
"""Items that persons mark name a file there."""
# Not the roster and the tables: a course has no people.
_READ: Final = ("**/*.toml", "catalogues/*.csv")


def course_digest(root: Path) -> str | None:
    """Digest all that a course is loaded from and checked with; None: some cannot be read."""
    try:
        folders = (root / VARIANTS, root / RUBRICS)
        below = (path for folder in folders for pattern in _READ for path in folder.glob(pattern))
        return digest_of(root, [path for path in below if path.is_file()])
    except OSError:
        return None
