"""The sheets of a spreadsheet that a person made, as text, read in a process of their own.

What is no `.xlsx` is converted by LibreOffice first, as a student's work is.
"""

from collections.abc import Mapping, Sequence
from typing import Final

from gripcourse.machine.content import Readable
from gripcourse.machine.jobs.limits import Limits
from gripcourse.machine.jobs.lost import Lost
from gripcourse.machine.jobs.warm import do_apart
from gripcourse.machine.office import converted, office_command
from gripcourse.machine.spreadsheet.open_document import loses_texts
from gripcourse.machine.spreadsheet.refusals import WhyRefused
from gripcourse.machine.spreadsheet.table import TableSheet, visible_sheets
from gripcourse.machine.table_bounds import (
    LARGEST_TABLE,
    TooLargeTableError,
    content_of_table,
    said_of_too_large_workbook,
)
from gripcourse.text.shown import first_of
from gripcourse.text.words import Message, message

_NAMED: Final = 10  # rows that a note names
_SECONDS: Final = 60.0  # by the clock
_ENDINGS: Final = {WhyRefused.OLD_FORMAT: ".xls", WhyRefused.OPEN_DOCUMENT: ".ods"}
_SAVE_AGAIN: Final = message("Open it in a spreadsheet program and save it again as .xlsx.")
_CONVERT: Final = message(
    "Save it as .xlsx, or install LibreOffice, which opens it; if it is installed, the file is"
    " damaged."
)
_UNKNOWN: Final = (
    message("The file is damaged, protected by a password, or no spreadsheet."),
    _SAVE_AGAIN,
)
_REFUSED: Final[Mapping[WhyRefused, tuple[Message, Message]]] = {
    WhyRefused.OLD_FORMAT: (message("The table has the old format .xls."), _CONVERT),
    WhyRefused.OPEN_DOCUMENT: (message("The table is an OpenDocument file, .ods."), _CONVERT),
    WhyRefused.XLSB: (message("The table has the format .xlsb."), _SAVE_AGAIN),
    WhyRefused.NUMBERS: (message("The table is a document of Apple Numbers."), _SAVE_AGAIN),
    WhyRefused.WEB_PAGE: (
        message("The file is a web page, whatever its name says; some programs export tables so."),
        _SAVE_AGAIN,
    ),
    WhyRefused.EMPTY: (
        message("The file is empty: it has no bytes."),
        message("Save the table again, or copy it once more."),
    ),
    WhyRefused.PASSWORD: (
        message("The table is protected by a password."),
        message("Remove the password and save it."),
    ),
    WhyRefused.DELIMITED_TEXT: (
        message("The file is plain text, whatever its name says; some programs export tables so."),
        message("Give it a name that ends with .csv."),
    ),
}
"""What an instructor is told of a table: what it is, and what to do."""
_READERS: Final = Limits(memory=512 * 1024**2, grace=2.0, processor=10.0, writes=False)
"""Of who reads a spreadsheet: the largest that is read takes 2 s, and 130 MB of memory."""


class UnreadableSpreadsheetError(Exception):
    """A spreadsheet that cannot be read."""

    def __init__(self, what: Message, remedy: Message) -> None:
        super().__init__(str(what))
        self.what, self.remedy = what, remedy


def read_spreadsheet(source: Readable) -> Sequence[TableSheet]:
    """Read the visible sheets: stored results, and the formula where no result is stored.

    Raises:
        UnreadableSpreadsheetError: it is none, holds too much, or is of another format and there
            is no LibreOffice that opens it.
    """
    try:
        content = content_of_table(source)
    except TooLargeTableError as fault:
        raise UnreadableSpreadsheetError(*said_of_too_large_workbook()) from fault
    sheets = _read_apart(content)
    if isinstance(sheets, WhyRefused) and sheets in _ENDINGS and not _loses_texts_apart(content):
        sheets = _read_converted(content, sheets)
    if sheets is WhyRefused.TOO_LARGE or isinstance(sheets, Lost):
        raise UnreadableSpreadsheetError(*said_of_too_large_workbook())
    if isinstance(sheets, WhyRefused):
        raise UnreadableSpreadsheetError(*_REFUSED.get(sheets, _UNKNOWN))
    return sheets


def said_of_hidden(file: str, title: str, rows: Sequence[int]) -> Message:
    """Say which rows of a sheet were read though no program shows them."""
    return message(
        "{file}: rows that are hidden in the sheet '{sheet}' were read like all others: {rows}."
        " Delete those that are not meant.",
        file=file,
        sheet=title,
        rows=first_of(list(map(str, rows)), _NAMED),
    )


def said_of_hidden_columns(file: str, title: str, columns: Sequence[str]) -> Message:
    """Say which columns of a sheet were read though no program shows them."""
    return message(
        "{file}: columns that are hidden in the sheet '{sheet}' were read like all others: "
        "{columns}. Delete those that are not meant.",
        file=file,
        sheet=title,
        columns=first_of(columns, _NAMED),
    )


def _read_apart(content: bytes) -> tuple[TableSheet, ...] | WhyRefused | Lost:
    return do_apart(_sheets, content, None, limits=_READERS, seconds=_SECONDS)


def _loses_texts_apart(content: bytes) -> bool:
    lost = do_apart(_loses_texts, content, None, limits=_READERS, seconds=_SECONDS)
    return isinstance(lost, Lost) or lost  # what is too much to look through is not opened


def _loses_texts(content: bytes, _: None) -> bool:
    return loses_texts(content)


def _read_converted(
    content: bytes, refused: WhyRefused
) -> tuple[TableSheet, ...] | WhyRefused | Lost:
    """Read what LibreOffice makes of a table of another format; the refusal where there is none."""
    office, name = office_command(), f"table{_ENDINGS[refused]}"
    # Numbers are stored as such: the language would matter to formulas over texts alone.
    made = {} if office is None else converted({name: content}, office, "").made
    if name not in made:
        return refused
    return WhyRefused.TOO_LARGE if len(made[name]) > LARGEST_TABLE else _read_apart(made[name])


def _sheets(data: bytes, _: None) -> tuple[TableSheet, ...] | WhyRefused:
    return visible_sheets(data)
