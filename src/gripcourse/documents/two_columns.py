"""Two columns of about one height, of rows that take one line or several."""

import math
from collections.abc import Sequence
from typing import Final, TypeVar

Row = TypeVar("Row")

_LETTERS: Final = 60
# Lines that stay on one page where a section may go on overleaf.
_GROUP: Final = 6


def two_columns(rows: Sequence[Row], attribute: str) -> tuple[Sequence[Row], Sequence[Row]]:
    """Part rows where the higher column is lowest; they are read down the first, then the second.

    Args:
        rows: in order.
        attribute: of a row, its text.
    """
    heights = _heights(rows, attribute)
    whole = sum(heights)

    def higher(parted: int) -> int:
        left = sum(heights[:parted])
        return max(left, whole - left)

    # Of places that are equally good, the one with the longer first column.
    parted = min(range(len(rows), -1, -1), key=higher)
    return rows[:parted], rows[parted:]


def groups(rows: Sequence[Row], attribute: str) -> Sequence[Sequence[Row]]:
    """Part rows into groups that each stay on a page, in two columns of their own.

    Two columns that went on overleaf as a whole would be read in another order than they stand:
    all of the first, on both pages, before the second.

    Args:
        rows: in order.
        attribute: of a row, its text.
    """
    found: list[list[Row]] = [[]]
    taken = 0
    for row, height in zip(rows, _heights(rows, attribute), strict=True):
        if taken >= _GROUP:
            found.append([])
            taken = 0
        found[-1].append(row)
        taken += height
    if len(found) > 1 and taken < _GROUP // 2:
        found[-2:] = [[*found[-2], *found[-1]]]
    return found


def _heights(rows: Sequence[Row], attribute: str) -> list[int]:
    return [math.ceil(len(str(getattr(row, attribute))) / _LETTERS) or 1 for row in rows]
