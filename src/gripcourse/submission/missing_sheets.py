"""Answers that are looked for on a sheet that is not in the workbook."""

from collections.abc import Sequence
from typing import Final

from gripcourse.text.shown import first_of, one_line
from gripcourse.text.words import Message, message

_NAMED: Final = 3
_LONGEST: Final = 60


def about_missing_sheets(looked_for_on: Sequence[str]) -> tuple[Message, ...]:
    """Say that answers stand nowhere: who reads a report sees blanks that nobody left blank.

    Args:
        looked_for_on: title of the sheet that each of them is looked for on.
    """
    titles = set(looked_for_on)
    if not titles:
        return ()
    return (
        message(
            "Answers are looked for on a sheet that the workbook does not have: '{sheets}'. They"
            " count as blank (in all: {count}). Fill in the workbook that you were handed, or give"
            " the sheet its title back.",
            sheets=first_of([one_line(one)[:_LONGEST] for one in sorted(titles)], _NAMED),
            count=len(looked_for_on),
        ),
    )
