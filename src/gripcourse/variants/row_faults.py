"""Faults of the rows of a table: the same fault in many rows is one problem."""

from collections.abc import Hashable, Iterator, Sequence
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


@dataclass(frozen=True, slots=True)
class RowRefusal:
    """Why the variant of a row cannot be handed out.

    Attributes:
        row: its number, as a spreadsheet shows it.
        variant: its id.
        reason: what it has in common with other rows that are refused for the same.
        what: why, with the row's own numbers.
    """

    row: int
    variant: str
    reason: Hashable
    what: Message


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
            place = message(
                "rows {rows} ({count} in all), column {column}",
                rows=_ranges([one.row for one in found]),
                count=len(found),
                column=column,
            )
        yield Problem(file, place, found[0].what, found[0].remedy)


def refusals_of(file: str, refused: Sequence[RowRefusal]) -> Iterator[Problem]:
    """Yield a problem for each reason, in the order in which it comes first.

    A wrong formula refuses most rows of a table: it is told once, with numbers of the first row.
    """
    alike: dict[object, list[RowRefusal]] = {}
    for one in sorted(refused, key=lambda one: one.row):
        alike.setdefault(one.reason, []).append(one)
    for found in alike.values():
        first = found[0]
        place = message("row {row}, variant {variant}", row=first.row, variant=first.variant)
        if len(found) > 1:
            place = message(
                "rows {rows} ({count} in all), the first of them variant {variant}",
                rows=_ranges([one.row for one in found]),
                count=len(found),
                variant=first.variant,
            )
        yield Problem(file, place, first.what, message("Change the numbers that it comes from."))


def _ranges(rows: Sequence[int]) -> str:
    """Write ascending numbers of rows: `2–9, 12`."""
    breaks = [at for at, (one, other) in enumerate(pairwise(rows), 1) if other != one + 1]
    runs = [
        rows[first:last] for first, last in zip([0, *breaks], [*breaks, len(rows)], strict=True)
    ]
    return ", ".join(str(run[0]) if len(run) == 1 else f"{run[0]}–{run[-1]}" for run in runs)
