"""Tables for spreadsheet programs and learning platforms: nothing in them runs."""

import csv
import io
import re
from collections.abc import Iterable, Iterator, Sequence
from itertools import chain

from gripcourse.text.shown import shown

# A cell that begins so is run; East Asian programs take the wide signs for the same. Where cells
# end at semicolons, as in Russian and Ukrainian, a program begins one inside of ours, and a row.
_RUN = re.compile(
    r"(?:\A|(?<=[;\t\r\n]))(?=[ \t\r\n]*[=+\-@\uff1d\uff0b\uff0d\uff20])|\A(?=[\t\r\n])"
)

_NUMBER = re.compile(r"-?[0-9]+(?:[.,][0-9]+)?")  # a negative number runs nothing


def table_text(header: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Return a table with commas between cells in every language."""
    return "".join(table_lines(header, rows))


def table_lines(header: Sequence[str], rows: Iterable[Sequence[str]]) -> Iterator[str]:
    """Yield the lines of a table that may be of any length; see `table_text`."""
    stream = io.StringIO(newline="")
    table = csv.writer(stream, lineterminator="\r\n")
    for row in chain([header], rows):
        table.writerow(row)
        yield stream.getvalue()
        stream.seek(0)
        stream.truncate()


def rounded_points(value: float) -> float:
    """Return points, or a percentage, as precisely as every table has them."""
    return round(value, 4)


def number_cell(value: float) -> str:
    """Write a number with a decimal point."""
    return f"{rounded_points(value):.10g}"


def text_cell(text: str) -> str:
    """Keep a spreadsheet program from running a text, or a part of it, as a formula."""
    return text if _NUMBER.fullmatch(text) else _RUN.sub("'", shown(text))
