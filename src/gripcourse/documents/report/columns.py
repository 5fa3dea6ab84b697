"""Columns of numbers whose decimal marks stand one below the other.

No style sheet can align at a decimal mark on paper, so the numbers of a column are written with
equally many decimals. A text may hold several numbers, as `12,5 / 20` does: the first ones of a
column are alike, and so are the second ones; both ends of a range, `66,7 … 100`, are.
"""

import re
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Final, TypeVar

if TYPE_CHECKING:
    from _typeshed import DataclassInstance

Line = TypeVar("Line", bound="DataclassInstance")

_RANGE: Final = "…"
_NUMBER: Final = re.compile(r"\d+(?:([.,])(\d+))?")


def aligned(texts: Sequence[str]) -> list[str]:
    """Write the numbers of a column with equally many decimals.

    Args:
        texts: of the column, numbers below one thousand; what has no number stays as it is.
    """
    found = [list(_NUMBER.finditer(text)) for text in texts]
    marks = [number[1] for numbers in found for number in numbers if number[1]]
    if not marks:
        return list(texts)
    most = [
        max(len(numbers[place][2] or "") for numbers in found if len(numbers) > place)
        for place in range(max(map(len, found)))
    ]
    if any(_RANGE in text for text in texts):
        most = [max(most)] * len(most)
    return [_written(text, most, marks[0]) for text in texts]


def aligned_rows(rows: Sequence[Line], *columns: str) -> list[Line]:
    """Align the named fields of rows, each a text or as many texts in every row."""
    for column in columns:
        cells = [getattr(row, column) for row in rows]
        if all(isinstance(cell, str) for cell in cells):
            written: Sequence[object] = aligned(cells)
        else:
            sides = [aligned(side) for side in zip(*cells, strict=True)]
            written = list(zip(*sides, strict=True)) if sides else cells
        rows = [replace(row, **{column: cell}) for row, cell in zip(rows, written, strict=True)]
    return list(rows)


def aligned_cells(rows: Sequence[tuple[str, ...]]) -> list[tuple[str, ...]]:
    """Align every column of a table of texts but the first, which names the row."""
    if not rows:
        return []
    names, *columns = zip(*rows, strict=True)
    return list(zip(names, *map(aligned, columns), strict=True))


def _written(text: str, most: Sequence[int], mark: str) -> str:
    places = iter(most)

    def padded(number: re.Match[str]) -> str:
        wanted = next(places)
        whole, dot, decimals = number[0], number[1] or mark, number[2] or ""
        if not wanted:
            return whole
        return f"{whole.partition(dot)[0]}{dot}{decimals:0<{wanted}}"

    return _NUMBER.sub(padded, text)
