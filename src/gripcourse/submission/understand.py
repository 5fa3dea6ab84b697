"""What one answer cell means: a value, nothing, or the reason why it cannot be read."""

import re
from dataclasses import replace
from datetime import date, datetime, time, timedelta
from typing import Final

from gripcourse.course.quantity import Kind, Quantity
from gripcourse.machine.spreadsheet.sheet_cells import CROSSED_OUT, without_crossed_out
from gripcourse.submission.dates import about_date, about_time, is_serial_date, serial_date
from gripcourse.submission.measure import Understood, from_number, from_text
from gripcourse.submission.raw import CellValue, RawCell
from gripcourse.text.number_reading import TOO_LONG
from gripcourse.text.words import Message, message

LONGEST_SHOWN: Final = 80
"""Characters of a cell that a report repeats."""
_LONGEST_LOOKED_AT: Final = 10_000
"""Characters; one text of megabytes may stand in every cell."""

_YES: Final = frozenset({"да", "так", "yes", "+", "1", "true", "истина", "істина", "✓", "✔"})
_NO: Final = frozenset(
    {"нет", "ні", "нi", "no", "-", "−", "–", "—", "0", "false", "ложь", "хибність", "✗", "✘"}
)
# What people add to a yes or no: `нет (не проходит)`, `да, выполняется`.
_EXPLAINED: Final = re.compile(
    r"(?P<word>[^\W\d_]{2,5})\s*[,(]\s*(?P<more>[^\W\d_][\w\s]{0,40})\)?"
)
_DENIES: Final = re.compile(r"\b(?:не|нет|ні|not|no|fails?)\b")
_DOUBTS: Final = re.compile(r"\b(?:но|але|but|или|або|чи|or|если|якщо|if)\b")
# Files store errors in English; other languages come as text that was pasted.
# Examples: division by zero is #DIV/0! or #ДЕЛ/0!; another program writes Err:502.
_ERROR: Final = re.compile(
    r"#(?:N/A|Н/Д|GETTING_DATA|[^\W\d_][\w/'’]{1,14}[!?])|(?:ERR|ОШИБКА|ПОМИЛКА):\d{3}"
)
_VERDICT_NEEDED: Final = message("Yes or no is needed here.")
_NUMBER_NEEDED: Final = message("A number is needed here, not a logical value.")
_TEXT_LOST: Final = message(
    "The text of this cell is not in the file, which is damaged. Type it again and save the "
    "workbook."
)
_NO_NUMBER: Final = message("A number is needed here.")
_CROSSED_OUT: Final = message("What is crossed out in the cell was left out.")
_ALL_CROSSED_OUT: Final = message(
    "All that stands in the cell is crossed out. Write there what counts."
)


def understand(quantity: Quantity, cell: RawCell) -> Understood | Message | None:
    """Tell what a cell means.

    Args:
        quantity: that the cell answers.
        cell: as it stands in the file.

    Returns:
        The value in the declared unit; None for a blank cell; else why it cannot be read.
    """
    if cell.value is None and not cell.formula:
        return _TEXT_LOST if cell.error else None
    if isinstance(cell.value, str):
        if len(cell.value.strip()) > _LONGEST_LOOKED_AT:
            return _VERDICT_NEEDED if quantity.kind is Kind.VERDICT else TOO_LONG
        if CROSSED_OUT in cell.value:
            return _not_crossed_out(quantity, cell, cell.value)
        if not cell.value.strip():
            return None
    return _damaged(cell) or _value(quantity, cell)


def _not_crossed_out(quantity: Quantity, cell: RawCell, text: str) -> Understood | Message | None:
    """Tell what a cell means in which a part of the text is crossed out."""
    found = understand(quantity, replace(cell, value=without_crossed_out(text)))
    if found is None:
        return _ALL_CROSSED_OUT
    if isinstance(found, Message):
        return found
    return replace(found, remarks=(_CROSSED_OUT, *found.remarks))


def _damaged(cell: RawCell) -> Message | None:
    """Tell what the spreadsheet program made of a cell that is no number any more."""
    value = cell.value
    if cell.formula and value is None:
        return message(
            "The cell holds a formula whose result is empty or not stored in the file. Open the "
            "workbook in a spreadsheet program, save it there and send it again."
        )
    if cell.error or (isinstance(value, str) and _ERROR.fullmatch(value.strip().upper())):
        return message(
            "The formula in the cell {cell} gives the error {error}.",
            cell=cell.cell,
            error=cell_text(cell),
        )
    if isinstance(value, date):  # a `datetime` is one too
        return about_date(value)
    return about_time() if isinstance(value, time | timedelta) else None


def _value(quantity: Quantity, cell: RawCell) -> Understood | Message:
    value = cell.value
    if quantity.kind is Kind.VERDICT:
        return _verdict(value)
    match value:
        case bool():
            return _NUMBER_NEEDED
        case str():
            return from_text(quantity, value)
        case int() | float() if is_serial_date(value, quantity.bounds):
            return about_date(serial_date(value))
        case int() | float():
            return from_number(quantity, value, cell.number_format, typed=not cell.formula)
        case _:
            return _NO_NUMBER


def cell_text(cell: RawCell) -> str:
    """Return what the cell shows, as one short line; a computed number with all its digits."""
    value = cell.value
    if cell.formula and value is None:
        text = cell.formula
    elif isinstance(value, bool):
        text = str(value).upper()
    elif isinstance(value, float):
        text = f"{value:.15g}"
    elif isinstance(value, int):
        text = f"{value:d}" if abs(value) < 10**LONGEST_SHOWN else "1E+80…"
    elif isinstance(value, datetime) and value.time() == time():
        text = f"{value:%d.%m.%Y}"
    else:
        text = "" if value is None else str(value)
    line = " ".join(text[: LONGEST_SHOWN * 4].split())
    if not line.isprintable():
        line = "".join(sign for sign in line if sign.isprintable())
    return line[:LONGEST_SHOWN]


def _verdict(value: CellValue) -> Understood | Message:
    """Read yes or no in any of the three languages, or as a spreadsheet's logical value."""
    word = _verdict_word(str(value))
    if word in _YES or value == 1:
        return Understood(1.0, 0.0, "", unit_fits=True, remarks=(), figures=None)
    if word in _NO or value == 0:
        return Understood(0.0, 0.0, "", unit_fits=True, remarks=(), figures=None)
    return _VERDICT_NEEDED


def _verdict_word(text: str) -> str:
    """Return the word of a verdict, without what only says it again."""
    word = text.strip().strip("\"«»“”'").rstrip(".!").strip().casefold()
    explained = _EXPLAINED.fullmatch(word)
    if explained is None:
        return word
    more = explained["more"]
    denies = bool(_DENIES.search(more))
    is_same = denies if explained["word"] in _NO else not denies
    says_both = _DOUBTS.search(more) or not _YES.isdisjoint(more.split())
    return explained["word"] if is_same and not says_both else word
