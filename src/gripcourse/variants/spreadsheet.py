"""The sheets of a spreadsheet that a person made, as text, read in a process of their own."""

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import date, time
from typing import Final

from gripcourse.machine.content import Readable
from gripcourse.machine.jobs.limits import Limits
from gripcourse.machine.jobs.lost import Lost
from gripcourse.machine.jobs.warm import do_apart
from gripcourse.machine.spreadsheet.refusals import WhyRefused
from gripcourse.machine.spreadsheet.table import TableSheet, visible_sheets
from gripcourse.machine.table_bounds import (
    TooLargeTableError,
    content_of_table,
    said_of_too_large,
)
from gripcourse.text.words import Message, message

_SECONDS: Final = 60.0  # by the clock
_READERS: Final = Limits(memory=2 * 1024**3, grace=2.0, processor=30.0, writes=False)
"""Of who reads a spreadsheet: a hundred thousand rows take 5 s."""


class UnreadableSpreadsheetError(Exception):
    """A spreadsheet that cannot be read."""

    def __init__(self, what: Message, remedy: Message) -> None:
        super().__init__(str(what))
        self.what, self.remedy = what, remedy


@dataclass(frozen=True, slots=True)
class SheetAsText:
    """A sheet.

    Attributes:
        title: of the sheet.
        rows: by number, as a spreadsheet shows it, without blank ones.
    """

    title: str
    rows: Sequence[tuple[int, tuple[str, ...]]]


def read_spreadsheet(source: Readable) -> Sequence[SheetAsText]:
    """Read the visible sheets: stored results, and the formula where no result is stored.

    Raises:
        UnreadableSpreadsheetError: it is none, or holds too much.
    """
    try:
        content = content_of_table(source)
    except TooLargeTableError as fault:
        raise UnreadableSpreadsheetError(*said_of_too_large()) from fault
    sheets = do_apart(_sheets, content, None, limits=_READERS, seconds=_SECONDS)
    if sheets is WhyRefused.TOO_LARGE or isinstance(sheets, Lost):
        raise UnreadableSpreadsheetError(*said_of_too_large())
    if isinstance(sheets, WhyRefused):
        raise UnreadableSpreadsheetError(
            message("The file is damaged, protected by a password, or no spreadsheet."),
            message("Open it in a spreadsheet program and save it again as .xlsx."),
        )
    return [
        SheetAsText(
            one.title, [(row.number, tuple(map(_cell_text, row.cells))) for row in one.rows]
        )
        for one in sheets
    ]


def _sheets(data: bytes, _: None) -> tuple[TableSheet, ...] | WhyRefused:
    return visible_sheets(data)


def _cell_text(cell: object) -> str:
    if cell is None:
        return ""
    if isinstance(cell, float) and cell.is_integer():
        return str(int(cell))
    if isinstance(cell, date | time):
        return cell.isoformat()
    return str(cell)
