"""The long parts of a table: its cells and texts, read while they are parsed.

No tree is made of them: one of half a million cells takes ten times as long and as much memory as
all that they hold.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Final, TypeAlias

from gripcourse.machine.spreadsheet.addresses import place_of
from gripcourse.machine.spreadsheet.cell_value import UnreadableContentError
from gripcourse.machine.spreadsheet.long_scan import Handlers, PartNames, go_through
from gripcourse.machine.spreadsheet.sheet_cells import Merged, merged_range, whole_number
from gripcourse.machine.spreadsheet.text_item import TextItem
from gripcourse.machine.spreadsheet.xml_scan import XmlScan
from gripcourse.machine.table_bounds import MOST_OF_WORKBOOK, RoomForCells, TooLargeTableError

ShownText: TypeAlias = Callable[[str, str | None, int, str], str]
"""Tells what a cell shows by its kind, what is stored, its style and its formula."""

_DATA, _ROW, _CELL, _IN_CELL = 2, 3, 4, 5  # how deep they stand in a sheet
_TRUE: Final = frozenset({"1", "true"})
_ITEM: Final = 2  # how deep in the table of shared texts
_DIGITS: Final = "0123456789"
_FOR_SOME: Final = "AlternateContent"
_ELSEWHERE: Final = frozenset({"row", "sheetData"})  # where programs look for none


@dataclass(frozen=True, slots=True)
class LongSheet:
    """The cells of a sheet.

    Attributes:
        rows: by number, in the order of the file; of each what its cells show, as far as the last
            one that shows anything, or None where none does.
        merged: its merged ranges.
        hidden: numbers of rows that are hidden and hold anything.
        hidden_columns: first and last number of each run of columns that are hidden.
    """

    rows: Mapping[int, list[str] | None]
    merged: tuple[Merged, ...]
    hidden: tuple[int, ...] = ()
    hidden_columns: tuple[tuple[int, int], ...] = ()


def read_long_sheet(
    content: bytes, scan: XmlScan, shown: ShownText, room: RoomForCells
) -> LongSheet:
    """Read all cells of a sheet.

    Args:
        content: of its part.
        scan: of the archive.
        shown: tells what a cell shows.
        room: for cells, of all sheets together.

    Raises:
        TooLargeTableError: it holds more than is ever read.
        UnreadableContentError: programs disagree what it holds, or `shown` cannot tell it.
        Exception: see `long_scan.go_through`.
    """
    reader = _SheetReader(scan, shown, room)
    handlers = Handlers(reader.enter, reader.leave, reader.written.append)
    go_through(content, scan, reader.names, handlers)
    hidden = tuple(number for number in sorted(reader.hidden) if reader.rows[number])
    return LongSheet(reader.rows, tuple(reader.merged), hidden, tuple(reader.hidden_columns))


def read_long_texts(content: bytes, scan: XmlScan) -> list[str]:
    """Read the table of shared texts; errors as above."""
    reader = _TextsReader(scan)
    handlers = Handlers(reader.enter, reader.leave, reader.written.append)
    go_through(content, scan, reader.names, handlers)
    return reader.texts


class _SheetReader:
    """What was seen of a sheet so far; half a million cells go through each line of it."""

    __slots__ = (
        *("_column", "_columns", "_depth", "_formula", "_is_cell", "_is_data", "_is_row"),
        *("_item", "_kind", "_known", "_number", "_part", "_room", "_row", "_scan", "_shown"),
        *("_style", "_styles", "_value", "hidden", "hidden_columns", "merged", "names", "rows"),
        "written",
    )

    def __init__(self, scan: XmlScan, shown: ShownText, room: RoomForCells) -> None:
        self._scan, self._shown, self._room = scan, shown, room
        self.names = PartNames()
        self._known = self.names.known
        self.rows: dict[int, list[str] | None] = {}
        self.merged: list[Merged] = []
        self.hidden: set[int] = set()
        self.hidden_columns: list[tuple[int, int]] = []
        self.written: list[str] = []
        self._columns: dict[str, int] = {}  # by their letters
        self._styles: dict[str, int] = {}
        self._item = TextItem()
        self._depth = self._number = self._column = self._style = 0
        self._is_data = self._is_row = self._is_cell = False
        self._row: list[str] | None = None
        self._kind = self._part = self._formula = ""
        self._value: str | None = None

    def enter(self, element: str, attributes: dict[str, str]) -> None:
        self._depth = depth = self._depth + 1
        name = self._known.get(element)
        if name is None:
            name = self.names.learn(element)
        if not self._is_cell:
            if depth == _CELL and self._is_row and name == "c":
                self._enter_cell(attributes)
            else:
                self._enter_other(name, attributes)
        elif depth == _IN_CELL:
            self._part = name
            self.written.clear()
            if name == "is":
                self._item.begin()
            elif name == _FOR_SOME:  # some of it is for older programs, some for newer ones
                raise UnreadableContentError
        elif self._part == "is":
            self._item.enter(depth - _IN_CELL, name, attributes)
            self.written.clear()
        else:
            raise UnreadableContentError

    def leave(self, element: str) -> None:
        depth = self._depth
        self._depth = depth - 1
        if not self._is_cell:
            if depth == _ROW:
                self._is_row = False
            elif depth == _DATA:
                self._is_data = False
        elif depth == _IN_CELL:
            self._leave_part()
        elif depth == _CELL:
            self._is_cell = False
            if self._value or self._formula:
                self._keep(self._shown(self._kind, self._value or None, self._style, self._formula))
        else:
            self._item.leave(depth - _IN_CELL, self._known[element], "".join(self.written))

    def _enter_cell(self, attributes: dict[str, str]) -> None:
        get = attributes.get
        reference = get("r", "")
        self._column = self._columns.get(reference.rstrip(_DIGITS)) or self._column_of(reference)
        self._kind = get("t", "n")
        style = get("s")
        self._style = 0 if style is None else self._style_of(style)
        self._is_cell, self._value, self._formula = True, None, ""

    def _column_of(self, reference: str) -> int:
        """Read which column a cell is in; one that does not say so stands beside the last one."""
        place = place_of(reference)
        if place is None:
            return self._column + 1
        self._columns[reference.rstrip(_DIGITS)] = place[1]
        return place[1]

    def _style_of(self, text: str) -> int:
        style = self._styles.get(text)
        if style is None:
            style = self._styles[text] = whole_number(text) or 0
        return style

    def _enter_other(self, name: str, attributes: dict[str, str]) -> None:
        self.names.check()
        self._scan.look_at(self._depth, name, attributes)
        if self._depth == _ROW and self._is_data and name == "row":
            self._number = whole_number(attributes.get("r")) or self._number + 1
            self._column, self._is_row = 0, True
            self._row = self.rows.setdefault(self._number, None)
            if attributes.get("hidden") in _TRUE:
                self.hidden.add(self._number)
        elif self._depth == _DATA and name == "sheetData":
            self._is_data = True
        elif name == "col" and attributes.get("hidden") in _TRUE:
            first, last = (whole_number(attributes.get(end)) for end in ("min", "max"))
            if first is not None and last is not None:
                self.hidden_columns.append((first, last))
        elif name == "mergeCell" and (found := merged_range(attributes.get("ref", ""))):
            self.merged.append(found)
        elif name in _ELSEWHERE or (name == _FOR_SOME and self._is_data):  # some would be lost
            raise UnreadableContentError

    def _leave_part(self) -> None:
        if self._part == "v":
            if self._kind == "inlineStr":
                return
            if self._value is not None:  # programs disagree which of two counts
                raise UnreadableContentError
            self._value = "".join(self.written)
        elif self._part == "f":
            self._formula = f"={''.join(self.written) or '…'}"
        elif self._part == "is" and self._kind == "inlineStr":
            self._value = self._item.whole()

    def _keep(self, text: str) -> None:
        if not text:
            return
        if self._row is None:
            self._row = self.rows[self._number] = []
            self._room.take_row()
        self._room.put(text, self._column, self._row)


class _TextsReader:
    """What was seen of the table of shared texts so far."""

    __slots__ = ("_depth", "_item", "_known", "_scan", "names", "texts", "written")

    def __init__(self, scan: XmlScan) -> None:
        self._scan = scan
        self.names = PartNames()
        self._known = self.names.known
        self._item = TextItem()
        self._depth = 0
        self.texts: list[str] = []
        self.written: list[str] = []

    def enter(self, element: str, attributes: dict[str, str]) -> None:
        self._depth = depth = self._depth + 1
        name = self._known.get(element)
        if name is None:
            name = self.names.learn(element)
        if depth > _ITEM:
            self._item.enter(depth - _ITEM, name, attributes)
            self.written.clear()
        if depth != _ITEM + 1:
            self.names.check()
            self._scan.look_at(depth, name, attributes)
            if name == _FOR_SOME:
                raise UnreadableContentError

    def leave(self, element: str) -> None:
        depth = self._depth
        self._depth = depth - 1
        if depth > _ITEM:
            self._item.leave(depth - _ITEM, self._known[element], "".join(self.written))
        elif depth == _ITEM and self._known[element] == "si":
            if len(self.texts) >= MOST_OF_WORKBOOK:
                raise TooLargeTableError
            self.texts.append(self._item.whole())
            self._item.begin()
