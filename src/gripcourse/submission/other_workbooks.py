"""Answers that a formula takes from another workbook, which nobody handed in."""

import re
from collections.abc import Iterable
from typing import Final

from gripcourse.submission.raw import RawCell
from gripcourse.text.shown import first_of
from gripcourse.text.words import Message, message

# As files store them: `[1]Sheet!A1`, `'[1]Own sheet'!A1`, `[1]!name`. A column of a table has its
# brackets behind a name.
_OUTSIDE: Final = re.compile(r"(?<![\w\]])\[\d{1,4}\][^\[\]!]{0,100}!")
_LONGEST: Final = 10_000  # characters of a formula that are looked at; programs allow 8192
_NAMED: Final = 5


def about_other_workbooks(answers: Iterable[RawCell]) -> tuple[Message, ...]:
    """Say which answers rest on another workbook: nobody can see how they were computed."""
    outside = [one.cell for one in answers if _OUTSIDE.search(one.formula[:_LONGEST])]
    if not outside:
        return ()
    return (
        message(
            "Answers are taken by formulas from another workbook, which was not handed in: {cells}."
            " What they last showed counts; write the numbers themselves.",
            cells=first_of(outside, _NAMED),
        ),
    )
