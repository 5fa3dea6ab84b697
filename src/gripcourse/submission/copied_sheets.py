"""Answers that stand on a copy of their sheet: the sheet that was issued was left blank."""

from collections.abc import Iterable, Sequence
from typing import Final

from gripcourse.submission.raw import RawCell
from gripcourse.text.shown import first_of, one_line
from gripcourse.text.words import Message, message

_NAMED: Final = 3
_LONGEST: Final = 60


def about_copies(found: Iterable[Sequence[RawCell]]) -> tuple[Message, ...]:
    """Say that answers were taken from a copy of their sheet, or from none of several.

    Args:
        found: of each answer that is blank on its sheet, the cells of copies that are not.
    """
    known = [one for one in found if one]
    taken, left = ([one for one in known if (len(one) == 1) is single] for single in (True, False))
    said = []
    if taken:
        said.append(
            message(
                "Answers stand on a copy of their sheet, '{sheets}'; on the sheet itself they are"
                " blank. They were taken from the copy (in all: {count}).",
                sheets=_titles(taken),
                count=len(taken),
            )
        )
    if left:
        said.append(
            message(
                "Answers stand on several copies of their sheet, '{sheets}'; on the sheet itself"
                " they are blank. They count as blank (in all: {count}).",
                sheets=_titles(left),
                count=len(left),
            )
        )
    return tuple(said)


def _titles(found: Iterable[Sequence[RawCell]]) -> str:
    titles = sorted({one.cell.rpartition("!")[0] for cells in found for one in cells})
    return first_of([one_line(one)[:_LONGEST] for one in titles], _NAMED)
