"""Answers that are looked for on a sheet that is not in the workbook."""

from collections.abc import Container, Iterable
from typing import Final

from gripcourse.text.shown import one_line
from gripcourse.text.words import Message, message

_NAMED: Final = 3
_LONGEST: Final = 60


def about_missing_sheets(pointed_at: Iterable[str], there: Container[str]) -> tuple[Message, ...]:
    """Say that answers stand nowhere: who reads a report sees blanks that nobody left blank.

    Args:
        pointed_at: title of the sheet that each answer is looked for on.
        there: the sheets of the workbook.
    """
    gone = [one for one in pointed_at if one not in there]
    titles = set(gone)
    if not titles:
        return ()
    shown = [one_line(one)[:_LONGEST] for one in sorted(titles)[:_NAMED]]
    return (
        message(
            "Answers are looked for on a sheet that the workbook does not have: '{sheets}'. They"
            " count as blank (in all: {count}). Fill in the workbook that you were handed, or give"
            " the sheet its title back.",
            sheets=", ".join(shown) + (", …" if len(titles) > _NAMED else ""),
            count=len(gone),
        ),
    )
