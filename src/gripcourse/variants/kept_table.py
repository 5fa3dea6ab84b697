"""A table of a course, judged once: a sound one is kept on disk for the next process."""

import hashlib
from pathlib import Path

from gripcourse.course.digest import course_digest
from gripcourse.course.load import load_with_digest
from gripcourse.course.model import Course
from gripcourse.machine.kept import keep, read_kept
from gripcourse.variants.model import Variant


def load_with_table(root: Path, table: Path) -> tuple[Course, tuple[Variant, ...]]:
    """Load a course and read a table of its variants.

    Args:
        root: of the course.
        table: a `.csv` or `.xlsx` file; what is kept of it counts only as long as neither the table
            nor the course has changed.

    Returns:
        The course, and the variants in the order of the rows.

    Raises:
        CourseError: with every problem of the course.
        TableError: with every problem of the table.
    """
    course, of_course = load_with_digest(root)
    digest = _digest(of_course, table)
    kept = None if digest is None else read_kept(digest)
    if isinstance(kept, tuple):
        return course, kept
    from gripcourse.variants.table import read_table  # noqa: PLC0415 (nothing else needs its 20 modules)

    variants = read_table(table, course)
    # What changed while it was read is not kept under the digest of what was there before.
    if digest is not None and digest == _digest(course_digest(root), table):
        keep(digest, variants)
    return course, variants


def _digest(of_course: str | None, table: Path) -> str | None:
    """Digest a table and the course that it is judged with; None: some cannot be read."""
    try:
        content = table.read_bytes()
    except OSError:
        return None
    if of_course is None:
        return None
    return hashlib.sha256(f"table{table.suffix}\0{of_course}\0".encode() + content).hexdigest()
