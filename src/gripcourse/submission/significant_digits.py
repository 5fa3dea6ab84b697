"""How many significant figures a cell that holds a number shows for certain.

A spreadsheet stores 5,00 as 5: zeros at the end are lost unless the cell's format shows them.
"""

import re
from decimal import Decimal
from functools import lru_cache
from typing import Final

from gripcourse.text.number_reading import Figures

_KEPT: Final = 1024  # number formats: a workbook has few
_DIGITS_STORED: Final = 15  # what a spreadsheet program keeps of a typed number
_NOT_DIGITS: Final = re.compile(r'"[^"]*"|\[[^\]]*\]|\\.|_.')
_DECIMALS: Final = re.compile(r"[0#?]\.(0+)(?![0#?,])")


def figures_of_number(value: float, number_format: str) -> Figures | None:
    """Count the figures of a number as it is stored and shown.

    Args:
        value: as the file stores it.
        number_format: of the cell, for example `General`, `0.00` or `0.00E+00`.

    Returns:
        The figures that are certain, without a bound above; None for a zero, and for a number with
        all the digits that can be stored, which nobody typed.
    """
    digits = repr(abs(value)).partition("e")[0].replace(".", "").lstrip("0")
    if value == 0 or len(digits) > _DIGITS_STORED:
        return None
    return Figures(max(len(digits.rstrip("0")), _shown(value, number_format)), None)


def _shown(value: float, number_format: str) -> int:
    """Count what a format with decimals shows, where it hides nothing."""
    first, places = _decimals(number_format)
    if places is None:
        return 0
    if "E" in first.upper():
        return 1 + places
    stored = Decimal(repr(abs(value)))
    shown = stored.scaleb(2) if "%" in first else stored
    hides = -int(shown.normalize().as_tuple().exponent) > places
    return 0 if hides else len(f"{shown:.{places}f}".replace(".", "").lstrip("0"))


@lru_cache(maxsize=_KEPT)
def _decimals(number_format: str) -> tuple[str, int | None]:
    """Return what a format says of positive numbers, and its decimals; None for no fixed ones."""
    first = _NOT_DIGITS.sub("", number_format).partition(";")[0]
    found = _DECIMALS.search(first)
    return first, None if found is None else len(found[1])
