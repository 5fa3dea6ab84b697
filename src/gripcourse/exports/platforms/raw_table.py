"""A platform's table as it came: encoding, separator, line ends, and every row as it stood.

What nobody fills in goes back byte for byte.
"""

import csv
import io
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Final

from charset_normalizer import from_bytes

from gripcourse.errors import Problem, UsageError
from gripcourse.machine.content import Readable, shown_name
from gripcourse.machine.table_bounds import (
    TooLargeTableError,
    around,
    content_of_table,
    said_of_too_large,
    within_bounds,
)
from gripcourse.text.words import message

_SEPARATORS: Final = (",", ";", "\t", ":")
_BOM: Final = b"\xef\xbb\xbf"
_CYRILLIC: Final = "cp1251"
# Windows, DOS, Unix, and spreadsheet programs on macOS.
_PAGES: Final = (_CYRILLIC, "cp866", "koi8_u", "mac_cyrillic")
# A row ends at a line end outside of quotes.
_RECORD: Final = re.compile(r'(?:[^"\r\n]++|"(?:[^"]++|"")*+(?:"|$))*+(?:\r\n|\n|\r|$)')
_LINE_ENDS: Final = "\r\n"

RateHeader = Callable[[Sequence[str]], int]
"""Tells how many headings of a row are known."""


@dataclass(frozen=True, slots=True)
class RawTable:
    """A table as it came.

    Attributes:
        file: what it is called.
        encoding: of its text.
        separator: between cells.
        records: every row as it stood, with its line end.
        rows: the cells of each record.
    """

    file: str
    encoding: str
    separator: str
    records: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]

    @property
    def header(self) -> tuple[str, ...]:
        """The headings."""
        return self.rows[0]

    def with_rows(self, changed: Mapping[int, Sequence[str]]) -> bytes:
        """Return the file with some rows changed, by their place among the records.

        A cell that is the same stays as it stood, quoted or not.
        """
        written = [
            self._written(changed[place], place) if place in changed else record
            for place, record in enumerate(self.records)
        ]
        return "".join(written).encode(self.encoding, errors="xmlcharrefreplace")

    def _written(self, cells: Sequence[str], place: int) -> str:
        record, before = self.records[place], self.rows[place]
        line = record.rstrip(_LINE_ENDS)
        stood = _as_they_stand(line, self.separator)
        if len(stood) != len(before):  # a quotation mark amid a cell
            stood = [self._quoted(cell) for cell in before]
        pairs = zip(cells, before, stood, strict=True)
        text = (raw if cell == old else self._quoted(cell) for cell, old, raw in pairs)
        return self.separator.join(text) + record[len(line) :]

    def _quoted(self, cell: str) -> str:
        stream = io.StringIO(newline="")
        # Alone in a row, an empty cell would be quoted.
        csv.writer(stream, delimiter=self.separator, lineterminator="").writerow((cell, ""))
        return stream.getvalue().removesuffix(self.separator)


def read_raw_table(source: Readable, known: RateHeader) -> RawTable:
    """Read a table in whatever way a platform or a spreadsheet program wrote it.

    Args:
        source: the file, or its bytes.
        known: tells how many headings of a row are known: the separator with the most is right,
            of those with as many the one with the most headings.

    Raises:
        UsageError: it is no table of text, or a row has other cells than the headings.
        OSError: it cannot be read.
    """
    file = shown_name(source)
    try:
        # Neither the bytes nor the whole text are kept beside the cells: all of them are too much.
        return _table(file, *_records(content_of_table(source), file, known), known)
    except TooLargeTableError as fault:
        raise UsageError([Problem(file, "", *said_of_too_large())]) from fault


def _records(data: bytes, file: str, known: RateHeader) -> tuple[str, tuple[str, ...]]:
    """Return the encoding of a table and its rows as they stand."""
    encoding = _encoding(data, known)
    try:
        if encoding is None:
            raise _no_text(file)
        text = data.decode(encoding)
    except UnicodeError as fault:
        raise _no_text(file) from fault
    found = (one[0] for one in _RECORD.finditer(text) if one[0])
    return encoding, tuple(record for (record,) in within_bounds((one,) for one in found))


def _table(file: str, encoding: str, records: tuple[str, ...], known: RateHeader) -> RawTable:
    if not records:
        what, remedy = message("The table is empty."), message("Export it again.")
        raise UsageError([Problem(file, "", what, remedy)])
    try:
        separator = max(_SEPARATORS, key=lambda one: _rated(_cells(records[0], one), known))
        rows = tuple(within_bounds(_cells(record, separator) for record in records))
    except csv.Error as fault:
        what = message("The rows cannot be told apart: {fault}.", fault=fault)
        remedy = message("Look for a quotation mark that is opened and never closed.")
        raise UsageError([Problem(file, "", what, remedy)]) from fault
    problems = [
        Problem(
            file,
            message("row {row}", row=number),
            message(
                "It has {count} cells, the headings are {wanted}.",
                count=len(row),
                wanted=len(rows[0]),
            ),
            message("Export the table from the platform again and leave its rows as they are."),
        )
        for number, row in enumerate(rows, start=1)
        if row and len(row) != len(rows[0])
    ]
    if problems:
        raise UsageError(problems)
    return RawTable(file, encoding, separator, records, rows)


def _rated(header: Sequence[str], known: RateHeader) -> tuple[int, int]:
    """Rate headings: where none is known, as of another table, the most are the likeliest."""
    return known(header), len(header)


def _as_they_stand(line: str, separator: str) -> list[str]:
    """Split a row into its cells with the quotation marks that they stand in."""
    sign = re.escape(separator)
    cell = re.compile(rf'(?:"(?:[^"]|"")*")?[^{sign}]*')
    found, place = [], 0
    while place <= len(line):
        one = cell.match(line, place)
        end = place if one is None else one.end()
        found.append(line[place:end])
        place = end + 1
    return found


def _no_text(file: str) -> UsageError:
    what = message("This is no table of text.")
    remedy = message("Download the table again, as CSV; a workbook is something else.")
    return UsageError([Problem(file, "", what, remedy)])


def _cells(record: str, separator: str) -> tuple[str, ...]:
    rows = csv.reader([record.rstrip(_LINE_ENDS)], delimiter=separator)
    if "\n" in record.rstrip(_LINE_ENDS) or "\r" in record.rstrip(_LINE_ENDS):
        rows = csv.reader(io.StringIO(record.rstrip(_LINE_ENDS), newline=""), delimiter=separator)
    return tuple(next(rows, ()))


def _encoding(data: bytes, known: RateHeader) -> str | None:
    if data.startswith(_BOM):
        return "utf-8-sig"
    if b"\0" in data:
        return "utf-16" if data.startswith((b"\xff\xfe", b"\xfe\xff")) else None
    try:
        data.decode()
    except UnicodeDecodeError as fault:
        return _page_of_headings(data, known) or _likely_page(around(data, fault.start))
    return "utf-8"


def _page_of_headings(data: bytes, known: RateHeader) -> str:
    """Return the code page in which most headings are known; empty where several are as good.

    A short table has too few letters to be told by how often they occur.
    """
    first = data.splitlines()[0]
    rates = {page: _most_known(first.decode(page, errors="replace"), known) for page in _PAGES}
    best = max(rates.values())
    pages = [page for page, rate in rates.items() if rate == best]
    return pages[0] if len(pages) == 1 else ""


def _most_known(line: str, known: RateHeader) -> int:
    """Return how many headings are known; none of them holds a separator or a quotation mark."""
    line = line.replace('"', "")
    return max(known(line.split(separator)) for separator in _SEPARATORS)


def _likely_page(data: bytes) -> str:
    best = from_bytes(data, cp_isolation=[_CYRILLIC, "koi8_r", "cp866"]).best()
    return _CYRILLIC if best is None else best.encoding
