"""Where the names of a workbook point to, and where else its answers may stand."""

from collections.abc import Collection, Iterator
from itertools import islice
from typing import Final, NamedTuple

from gripcourse.machine.spreadsheet.addresses import Place

# Rows above the first answer and below the last one that an answer may have been moved to.
_FURTHER: Final = 30
_LONGEST: Final = 1_000  # rows from the first answer of a column to where others are looked for
_MOST_BESIDE: Final = 20_000  # places in columns of answers; a workbook has some hundreds
_MOST_OTHERS: Final = 12  # sheets that may be one of ours under another name


class NamedPlace(NamedTuple):
    """Where one of our names points to."""

    sheet: str
    place: Place


def places_beside(
    answers: Collection[NamedPlace], named: Collection[NamedPlace], sheets: Collection[str]
) -> set[NamedPlace]:
    """Return the places of answers' columns that no name points to, some rows further too.

    Some programs rename a sheet and leave the names where they were: of a sheet that is gone the
    columns are looked at on each sheet that no name points to.

    Args:
        answers: where the names of answers point to.
        named: where any of our names points to.
        sheets: that there are, in their order.

    Raises:
        OverflowError: names are scattered over far more places than answers take.
    """
    meant = {one.sheet for one in named}
    others = tuple(islice((one for one in sheets if one not in meant), _MOST_OTHERS))
    gone = [one for one in answers if one.sheet not in sheets]
    elsewhere = {one._replace(sheet=other) for one in gone for other in others}
    return {*_beside({*answers, *elsewhere}), *elsewhere}


def _beside(answers: Collection[NamedPlace]) -> Iterator[NamedPlace]:
    columns: dict[tuple[str, int], set[int]] = {}
    for sheet, (row, column) in answers:
        columns.setdefault((sheet, column), set()).add(row)
    spans = {
        one: (max(1, min(rows) - _FURTHER), min(max(rows), min(rows) + _LONGEST) + _FURTHER)
        for one, rows in columns.items()
    }
    if sum(last - first for first, last in spans.values()) > _MOST_BESIDE:
        raise OverflowError(len(columns))
    for (sheet, column), rows in columns.items():
        for row in set(range(*spans[sheet, column])) - rows:
            yield NamedPlace(sheet, (row, column))
