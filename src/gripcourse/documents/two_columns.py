"""Two columns of about one height, of rows that take one line or several."""

from collections.abc import Sequence
from typing import Final, TypeVar

Row = TypeVar("Row")

# A column of a long print in widths of a letter; a sheet is laid out once, so that the lines of a
# row are counted beforehand: of twenty rows, one comes out a line higher or lower.
_COLUMN: Final = 34.0
_LETTER, _NARROW, _WIDE = 0.53, 0.33, 0.75
_NARROW_LETTERS: Final = frozenset(" \u00a0.,;:·()[]|!'-/1Ііijlfrt")
_WIDE_LETTERS: Final = frozenset("дмшщюжфыДМШЩЮЖФЫОQOmwMW—≤≥@")
# Heights are in tenths of a line: of a line, and of what stands round the lines of a row.
_LINE, _ROUND = 10, 1
# Of a group, both of its columns. It stays on one page where a section goes on overleaf: the higher
# it is, the more of a page may stay empty; the lower, the oftener its columns are uneven.
_MOST: Final = 120
_BETWEEN: Final = 3


def two_columns(rows: Sequence[Row], attribute: str) -> tuple[Sequence[Row], Sequence[Row]]:
    """Part rows where the higher column is lowest; they are read down the first, then the second.

    Args:
        rows: in order.
        attribute: of a row, its text.
    """
    # Of places that are equally good, the one with the longer first column.
    parted = _parted(_heights(rows, attribute))[1]
    return rows[:parted], rows[parted:]


def groups(rows: Sequence[Row], attribute: str) -> Sequence[Sequence[Row]]:
    """Part rows into groups that each stay on a page, in two columns of their own.

    Two columns that went on overleaf as a whole would be read in another order than they stand:
    all of the first, on both pages, before the second. The groups are those that are lowest, one
    under the other.

    Args:
        rows: in order.
        attribute: of a row, its text.
    """
    heights = _heights(rows, attribute)
    # By the number of rows: how high they are at least, and where their last group begins.
    lowest: list[tuple[int, int]] = [(0, 0)]
    for end in range(1, len(rows) + 1):
        begins = [end - 1]
        while begins[-1] and sum(heights[begins[-1] - 1 : end]) <= _MOST:
            begins.append(begins[-1] - 1)
        lowest.append(
            min((lowest[one][0] + _parted(heights[one:end])[0] + _BETWEEN, one) for one in begins)
        )
    found: list[Sequence[Row]] = []
    end = len(rows)
    while end:
        begin = lowest[end][1]
        found.append(rows[begin:end])
        end = begin
    return found[::-1]


def _parted(heights: Sequence[int]) -> tuple[int, int]:
    """Return the height of the higher column, and how many rows stand in the first."""
    whole, left = sum(heights), 0
    best = (whole, 0)
    for number, height in enumerate(heights, start=1):
        left += height
        best = min(best, (max(left, whole - left), number), key=lambda one: (one[0], -one[1]))
    return best


def _heights(rows: Sequence[Row], attribute: str) -> list[int]:
    return [_LINE * _lines(str(getattr(row, attribute))) + _ROUND for row in rows]


def _lines(text: str) -> int:
    """Count the lines of a text in a column; a word that is longer than one goes on in the next."""
    lines, taken = 1, 0.0
    for word in text.split(" "):
        wide = sum(map(_width, word))
        if taken and taken + _NARROW + wide > _COLUMN:
            lines, taken = lines + 1, wide
        else:
            taken += _NARROW + wide if taken else wide
        lines += int(taken / _COLUMN)
        taken %= _COLUMN
    return lines


def _width(letter: str) -> float:
    if letter in _NARROW_LETTERS:
        return _NARROW
    return _WIDE if letter in _WIDE_LETTERS else _LETTER
