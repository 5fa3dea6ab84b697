"""Whom an office's list marks as somebody who has left: named, and taken over all the same.

A list that is not of today, or a mark that means something else, must not take an assignment from
anybody; who is to have none is taken off the list, or withdrawn.
"""

from collections.abc import Iterator, Mapping
from typing import Final

from gripcourse.issuing.office_list import names_in, row_shown
from gripcourse.text.shown import first_of
from gripcourse.text.spelling import plain
from gripcourse.text.words import Message, message
from gripcourse.variants.headings import TableColumn, declared_names
from gripcourse.variants.sheet import Sheet

_NAMED: Final = 10  # rows that a note names


def said_of_left(
    whole: Sheet, sheet: Sheet, columns: Mapping[str, TableColumn]
) -> tuple[Message, ...]:
    """Name the rows that say that somebody has left.

    Args:
        whole: the table with all its columns.
        sheet: the list that is made of it.
        columns: of the list, by id.
    """
    marks = dict(_marks(whole))
    found = [row for row in sheet.rows if row.number in marks]
    if not found:
        return ()
    rows = [row_shown(sheet, row, [*names_in(row, columns), marks[row.number]]) for row in found]
    said = message(
        "{file}: rows are marked as people who have left, and were taken over all the same: "
        "{rows}. Delete the rows of those who are to get none; who has an assignment is taken out "
        "by gripcourse withdraw.",
        file=sheet.file,
        rows=first_of(rows, _NAMED),
    )
    return (said,)


def _marks(whole: Sheet) -> Iterator[tuple[int, str]]:
    """Yield the numbers of the rows that say it, with how they do."""
    called = declared_names("left")
    for place, heading in enumerate(whole.header):
        sorts = called.get(plain(heading), frozenset())
        for row in whole.rows:
            cell = row.cells[place]
            said = called.get(plain(cell), frozenset())
            is_marked = "marks" in sorts and cell and "no" not in said
            if is_marked or ("status" in sorts and "gone" in said):
                yield row.number, f"{heading}: {cell}"
