"""Addresses of cells, such as `C5`."""

import re
from functools import lru_cache
from typing import Final, TypeAlias

Place: TypeAlias = tuple[int, int]
"""Row and column of a cell, from 1."""

LAST_ROW: Final = 1_048_576
LAST_COLUMN: Final = 16_384
_CORNER: Final = re.compile(r"\$?([A-Za-z]{1,3})\$?([0-9]{1,7})")
_KEPT: Final = 1 << 14  # addresses: all workbooks of a course have the same


@lru_cache(maxsize=_KEPT)
def place_of(reference: str) -> Place | None:
    """Read an address such as `$C$5`; None where it is none of a sheet."""
    found = _CORNER.fullmatch(reference)
    if found is None:
        return None
    row, column = int(found[2]), column_number(found[1])
    return (row, column) if 1 <= row <= LAST_ROW and column <= LAST_COLUMN else None


def column_number(letters: str) -> int:
    """Return the number of a column, from 1."""
    number = 0
    for letter in letters.upper():
        number = number * 26 + ord(letter) - ord("A") + 1
    return number


@lru_cache(maxsize=_KEPT)
def address(place: Place) -> str:
    """Write a place as `C5`."""
    row, column = place
    letters = ""
    while column:
        column, rest = divmod(column - 1, 26)
        letters = chr(ord("A") + rest) + letters
    return f"{letters}{row}"
