"""One cell of a table: a number that is exactly what was written, or none; or a formula alone."""

import re

from gripcourse.text.number_text import is_lost
from gripcourse.text.units import factor
from gripcourse.text.words import Message, message

_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")
_INVISIBLE = str.maketrans({" ": None, "\u00a0": None, "\u202f": None, "\u2009": None, "−": "-"})


def exact_number(text: str, *, decimal_comma: bool) -> float | None:
    """Read a number; None where the text is none, or could be read in two ways.

    Args:
        text: as it stands in the cell; blanks between groups of digits are allowed.
        decimal_comma: whether a comma can only be a decimal one.

    Returns:
        The nearest float; None also for a number too large for one, or so small that it would be
        taken as 0.
    """
    plain = text.translate(_INVISIBLE)
    if decimal_comma and "." not in plain:
        plain = plain.replace(",", ".", 1)
    if not _NUMBER.fullmatch(plain):
        return None
    value = float(plain)
    return value if abs(value) < float("inf") and not is_lost(plain, value) else None


def is_formula(text: str) -> bool:
    """Tell whether a cell has a formula whose result the file does not hold."""
    return text.startswith("=") and text != "="


def said_of_formula() -> tuple[Message, Message]:
    """Say that the result of a formula is not in the file, and the remedy."""
    return (
        message("The cell has a formula whose result is not stored in the file."),
        message("Open the file in a spreadsheet program and save it again, or write the result."),
    )


def number_text(value: float) -> str:
    """Write a number in the fewest digits that are read back as the same: `60`, `0.15`."""
    if value.is_integer() and abs(value) < 1e15:  # noqa: PLR2004 - all digits of a float are known
        return str(int(value)) if value else "0"
    return repr(value)


def converted(value: float, unit: str, wanted: str) -> float:
    """Convert a number from one unit to another of its kind, without digits that nobody wrote.

    Args:
        value: in `unit`.
        unit: as written over the column.
        wanted: as declared.
    """
    if unit == wanted:
        return value
    # Fourteen figures: 0.15 m is 150 mm, not 149.99999999999997.
    return float(f"{value * (factor(unit) / factor(wanted)):.14g}")
