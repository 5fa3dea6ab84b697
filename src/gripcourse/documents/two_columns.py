"""Two columns of about one height, of rows that take one line or several."""

import math
from collections.abc import Sequence
from typing import Final, TypeVar

Row = TypeVar("Row")

_LETTERS: Final = 60


def two_columns(rows: Sequence[Row], attribute: str) -> tuple[Sequence[Row], Sequence[Row]]:
    """Part rows where the higher column is lowest; they are read down the first, then the second.

    Args:
        rows: in order.
        attribute: of a row, its text.
    """
    heights = [math.ceil(len(str(getattr(row, attribute))) / _LETTERS) or 1 for row in rows]
    whole = sum(heights)

    def higher(parted: int) -> int:
        left = sum(heights[:parted])
        return max(left, whole - left)

    # Of places that are equally good, the one with the longer first column.
    parted = min(range(len(rows), -1, -1), key=higher)
    return rows[:parted], rows[parted:]
