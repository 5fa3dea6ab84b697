"""Faults of the cells of a table: the same fault in many rows of a column is one problem."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from gripcourse.errors import Problem
from gripcourse.text.words import Message, message
from gripcourse.variants.sheet import cell_place


@dataclass(frozen=True, slots=True)
class CellFault:
    """What is wrong with a cell.

    Attributes:
        row: its number, as a spreadsheet shows it.
        column: what a person calls it.
        what, remedy: as in `Problem`.
    """

    row: int
    column: str
    what: Message
    remedy: Message


def problems_of(file: str, faults: Sequence[CellFault]) -> Iterator[Problem]:
    """Yield a problem for each fault, in the order in which it comes first.

    A given that a scheme has lost or gained is the same fault in each of its rows: it is told once,
    with all rows.
    """
    alike: dict[tuple[str, str], list[CellFault]] = {}
    for one in faults:
        alike.setdefault((one.column, str(one.what)), []).append(one)
    for (column, _), found in alike.items():
        place = cell_place(found[0].row, column)
        if len(found) > 1:
            rows = _ranges([one.row for one in found])
            place = message(
                "{count} rows ({rows}), column {column}",
                count=len(found),
                rows=rows,
                column=column,
            )
        yield Problem(file, place, found[0].what, found[0].remedy)


def _ranges(rows: Sequence[int]) -> str:
    """Write ascending numbers of rows: `2–9, 12`."""
    breaks = [at for at, (one, other) in enumerate(pairwise(rows), 1) if other != one + 1]
    runs = [
        rows[first:last] for first, last in zip([0, *breaks], [*breaks, len(rows)], strict=True)
    ]
    return ", ".join(str(run[0]) if len(run) == 1 else f"{run[0]}–{run[-1]}" for run in runs)
