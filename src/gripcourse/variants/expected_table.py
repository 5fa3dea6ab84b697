"""Whether variants that are about to be drawn will fit into the table that is asked for."""

from collections.abc import Iterator, Sequence
from pathlib import Path

from gripcourse.course.compose import compose
from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind
from gripcourse.machine.table_bounds import MOST_CELLS, MOST_OF_WORKBOOK
from gripcourse.variants.draw import orders_of
from gripcourse.variants.headings import given_quantities
from gripcourse.variants.readable import WORKBOOK, Room, expect_kind, expect_readable
from gripcourse.variants.space import Space

_ALWAYS = 2  # columns: variant and scheme


def expect_room(path: Path, course: Course, spaces: Sequence[Space], count: int, seed: int) -> None:
    """Refuse a table larger than any that is read, before its variants are drawn.

    Args:
        path: of the table.
        course: whose variants.
        spaces: what is drawn from.
        count: how many variants.
        seed: of the drawing; see `draw`.

    Raises:
        TableError: it would be too large, or the name asks for no table.
    """
    is_workbook = expect_kind(path) == WORKBOOK
    most = MOST_OF_WORKBOOK if is_workbook else MOST_CELLS
    options = {one.id for scheme in course.schemes.values() for one in scheme.options}
    widest = _ALWAYS + len(options) + len(given_quantities(course))
    if (count + 1) * widest <= most:
        return  # whatever is drawn
    columns: set[str] = set()
    filled = 0
    for named, wanted in _cases(course, spaces, count, seed):
        columns |= named
        filled += wanted * (_ALWAYS + len(named))
    across = _ALWAYS + len(columns)
    # Of a workbook blank cells behind the last one of a row do not count.
    cells = across + filled if is_workbook else (count + 1) * across
    expect_readable(path, count + 1, across, Room(cells, most))


def _cases(
    course: Course, spaces: Sequence[Space], count: int, seed: int
) -> Iterator[tuple[set[str], int]]:
    """Yield the columns of each combination that will be drawn, and how many variants have it."""
    for space, order in zip(spaces, orders_of(spaces, count, seed), strict=True):
        for place, wanted in order.wanted.items():
            if wanted:
                options = space.cases.combinations[place]
                quantities = compose(course, course.schemes[space.scheme], options).values()
                given = {one.id for one in quantities if one.kind is Kind.GIVEN}
                yield given | {f"option:{one}" for one in options}, wanted
