"""What the first sheet of an answer workbook tells the student."""

from typing import Final

from gripcourse.text.words import Message, message

_EXAMPLE: Final = 12.5

DECIMAL_SIGN: Final = message(
    "Type numbers as {example}: with the decimal sign of your spreadsheet program and without a "
    "unit; the unit stands beside the cell.",
    example=_EXAMPLE,
)

HOW_TO: Final[tuple[Message, ...]] = (
    message("Fill in the yellow cells on the sheets of the sections. Everything else is locked."),
    DECIMAL_SIGN,
    message("A formula in a cell is as good as a number: its result is what counts."),
    message("Keep at least four significant figures. An empty cell is no answer, not a zero."),
    message("The column beside the answers says when a cell does not hold what is needed."),
    message("Do not change the given data: answers are judged against what was issued."),
    message("Save as an .xlsx workbook, without a password, and hand in this file."),
)
