"""Tables for a terminal, laid out by rich; what fits without breaking a line, at once.

Rich looks at each cell a dozen times, which is half a second for a thousand rows.
"""

import io
import shutil
import sys
from collections.abc import Collection, Iterable, Mapping, Sequence
from itertools import chain
from typing import TYPE_CHECKING, Final

from gripcourse.machine.shelf import Viewed
from gripcourse.text.shown import shown

# rich costs 60 ms to import: only who prints what does not fit pays.
# ruff: noqa: PLC0415

if TYPE_CHECKING:
    from rich.console import JustifyMethod

WIDTH: Final = 110

_NARROWEST: Final = 60  # places: in fewer the words of a table would be broken
_BETWEEN: Final = 3  # blanks between columns


def table_text(
    heads: Iterable[str],
    rows: Iterable[Sequence[str]],
    right: Collection[int],
    widest: Mapping[int, int] | None = None,
) -> str:
    """Lay out a table; columns in `right` stand at the right, those in `widest` break earlier.

    A sequence of rows is gone through several times, and of a long one no row is held.
    """
    listed = rows if isinstance(rows, Sequence) else tuple(rows)
    heads, lines = list(heads), Viewed(listed, _shown_row)
    plain = None if widest else plain_table(heads, lines, right)
    return broken_table(heads, lines, right, widest or {}) if plain is None else plain


def broken_table(
    heads: Sequence[str],
    rows: Sequence[Sequence[str]],
    right: Collection[int],
    widest: Mapping[int, int],
) -> str:
    """Lay out a table of which some cells may have to break."""
    from rich.box import SIMPLE_HEAD
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    table = Table(box=SIMPLE_HEAD, pad_edge=False)
    for number, head in enumerate(heads):
        side: JustifyMethod = "right" if number in right else "left"
        table.add_column(Text(head), justify=side, max_width=widest.get(number), overflow="fold")
    for row in rows:
        # Text, not markup: what a student typed must not be read as a colour.
        table.add_row(*map(Text, row))
    # A file, not the terminal: the caller decides where it goes.
    console = Console(width=_room(), file=io.StringIO())
    with console.capture() as capture:
        console.print(table)
    return capture.get().rstrip()


def plain_table(
    heads: Sequence[str], rows: Sequence[Sequence[str]], right: Collection[int]
) -> str | None:
    """Lay out a table of which no cell has to break, as `broken_table` does it.

    Returns:
        The table; None where a cell has to break or may be shown otherwise than it is written,
        or a column is empty.
    """
    widths = [0] * len(heads)
    for line in chain([heads], rows):
        if not all(map(_is_plain, line)):
            return None
        widths = [max(*pair) for pair in zip(widths, map(_width, line), strict=True)]
    inner = sum(widths) + _BETWEEN * (len(widths) - 1)
    if not all(widths) or inner + 2 > _room():
        return None
    sides = [number in right for number in range(len(widths))]
    head, under = _line(heads, widths, sides), f" {'─' * inner} "
    body = (_line(line, widths, sides) for line in rows)
    return "\n".join(chain((" " * (inner + 2), head, under), body)).rstrip()


def _room() -> int:
    """Return how wide a table may be: as the terminal is, where one shows it."""
    if not sys.stdout.isatty():
        return WIDTH
    return max(_NARROWEST, min(WIDTH, shutil.get_terminal_size((WIDTH, 0)).columns))


def _shown_row(row: Sequence[str]) -> list[str]:
    return [shown(cell) for cell in row]


def _line(cells: Sequence[str], widths: Sequence[int], sides: Sequence[bool]) -> str:
    padded = (
        " " * (width - _width(cell)) + cell if at_right else cell + " " * (width - _width(cell))
        for cell, width, at_right in zip(cells, widths, sides, strict=True)
    )
    return f" {(' ' * _BETWEEN).join(padded)} "


def _is_plain(cell: str) -> bool:
    return cell.isprintable() and cell == cell.strip()


def _width(cell: str) -> int:
    """Return how many places of a terminal a text takes."""
    if cell.isascii():
        return len(cell)
    from rich.cells import cell_len

    return cell_len(cell)
