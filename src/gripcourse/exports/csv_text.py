"""Tables for spreadsheet programs and learning platforms: nothing in them runs."""

import csv
import io
from collections.abc import Iterable, Sequence

from gripcourse.text.shown import shown

_FORMULA_STARTS = ("=", "+", "-", "@", "\t", "\r")


def table_text(header: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Return a table with commas between cells in every language."""
    stream = io.StringIO(newline="")
    table = csv.writer(stream, lineterminator="\r\n")
    table.writerow(header)
    table.writerows(rows)
    return stream.getvalue()


def number_cell(value: float) -> str:
    """Write a number with a decimal point."""
    return f"{round(value, 4):.10g}"


def text_cell(text: str) -> str:
    """Keep a spreadsheet program from running a text as a formula."""
    seen = shown(text)
    return f"'{seen}" if seen.startswith(_FORMULA_STARTS) else seen
