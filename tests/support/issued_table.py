"""The variants that a course hands out, read once."""

from functools import cache

from gripcourse.course.model import Course
from gripcourse.variants.model import Variant
from gripcourse.variants.table import read_table


@cache
def issued_table(course: Course) -> tuple[Variant, ...]:
    """Read the table of a course that nobody changes: each of its variants is judged then."""
    return read_table(course.root / "variants" / "tables" / "main.csv", course)
