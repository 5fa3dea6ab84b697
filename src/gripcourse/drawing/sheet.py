"""A sheet by GOST: frame and title block of form 1 (2.104), list of parts, characteristics.

Millimetres; the origin is the lower left corner of the sheet.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from gripcourse.drawing.document import LineKind
from gripcourse.drawing.strokes import Box
from gripcourse.drawing.text import Point, add_text, wrapped
from gripcourse.words import Message, Words, message

if TYPE_CHECKING:
    from ezdxf.layouts.layout import Modelspace


@dataclass(frozen=True, slots=True)
class Format:
    """A sheet: its name and size."""

    name: str
    width: float
    height: float

    @property
    def frame(self) -> Box:
        """The frame: 20 mm free on the left for binding, 5 mm elsewhere."""
        return Box(20.0, 5.0, self.width - 5.0, self.height - 5.0)


A4 = Format("A4", 210.0, 297.0)
A3 = Format("A3", 420.0, 297.0)
FORMATS = (A4, A3)


@dataclass(frozen=True, slots=True)
class TitleBlock:
    """What the title block says; an empty text leaves its cell blank.

    Attributes:
        designation: of the document.
        title: of the gripper.
        document: what kind of drawing it is.
        student: who drew it.
        checked: who checks it.
        organisation: group and school.
        date: of the drawing, as it shall be written.
    """

    designation: str
    title: str
    document: str
    student: str
    checked: str = ""
    organisation: str = ""
    date: str = ""


@dataclass(frozen=True, slots=True)
class Row:
    """A row of the parts list."""

    number: str
    title: str
    count: str
    sizes: str


_WIDTH, _HEIGHT = 185.0, 55.0  # of the title block
_ROW = 8.0
_LINE = 6.0
_TITLE_LINES = 3
_SMALL, _NORMAL, _LARGE = 2.5, 3.5, 5.0  # mm, heights of letters
_PAD = 1.0
_COLUMNS = (10.0, 70.0, 10.0, 95.0)  # of the parts list: position, title, number, sizes
_CORNER = (70.0, 14.0)  # the designation again, upside down, in the upper left corner
_ABOVE_LIST = 4.0
_BESIDE = 4.0

_CHANGES: tuple[tuple[float, Message], ...] = (
    (0.0, message("Rev.")),
    (7.0, message("Sheet")),
    (17.0, message("Document no.")),
    (40.0, message("Signed")),
    (55.0, message("Date")),
    (65.0, message("")),
)
_ROLES = (
    message("Drawn"),
    message("Checked"),
    message("Technology"),
    None,
    message("Standards"),
    message("Approved"),
)
_ROLE_HEIGHT = 5.0


def block_box(sheet: Format, rows: int) -> Box:
    """Return what the title block takes with the parts list over it."""
    frame = sheet.frame
    above = _ROW * (rows + 1) if rows else 0.0
    return Box(frame.right - _WIDTH, frame.bottom, frame.right, frame.bottom + _HEIGHT + above)


def lines_boxes(sheet: Format, rows: int, lines: int) -> tuple[Box, ...]:
    """Return where characteristics may stand: over the parts list, or left of the title block."""
    block, size = block_box(sheet, rows), _LINE * (lines + 1)
    over = Box(block.left, block.top, block.right, block.top + _ABOVE_LIST + size)
    left = block.left - _WIDTH - _BESIDE
    beside = Box(left, block.bottom + _BESIDE, left + _WIDTH, block.bottom + _BESIDE + size)
    return (over, beside) if left >= sheet.frame.left + _BESIDE else (over,)


def corner_box(sheet: Format) -> Box:
    """Return what the designation in the upper left corner takes."""
    frame = sheet.frame
    long, short = _CORNER
    if sheet.width > sheet.height:
        return Box(frame.left, frame.top - long, frame.left + short, frame.top)
    return Box(frame.left, frame.top - short, frame.left + long, frame.top)


def draw_sheet(layout: "Modelspace", sheet: Format, block: TitleBlock, scale: str, words: Words) -> None:
    """Draw the frame and fill in the title block."""
    pen = _Pen(layout)
    outer, frame = Box(0.0, 0.0, sheet.width, sheet.height), sheet.frame
    pen.box(outer, LineKind.THIN)
    pen.box(frame, LineKind.OUTLINE)
    _draw_corner(pen, corner_box(sheet), block.designation, turned=sheet.width > sheet.height)
    cell = _Cells(pen, frame.right - _WIDTH, frame.bottom)
    _draw_grid(cell)
    _draw_people(cell, block, words)
    _draw_document(cell, sheet, block, scale, words)


def draw_list(layout: "Modelspace", sheet: Format, rows: Sequence[Row], words: Words) -> None:
    """Draw the parts list over the title block, its heading below, as it grows upwards."""
    if not rows:
        return
    cell = _Cells(_Pen(layout), sheet.frame.right - _WIDTH, sheet.frame.bottom + _HEIGHT)
    heading = Row(
        words.say(message("Pos.")),
        words.say(message("Name")),
        words.say(message("Qty")),
        words.say(message("Sizes, mm")),
    )
    edges = [sum(_COLUMNS[:number]) for number in range(len(_COLUMNS) + 1)]
    # Rows are read downwards: the first part stands highest, under the heading.
    for number, row in enumerate([*reversed(rows), heading]):
        bottom = _ROW * number
        kind = LineKind.OUTLINE if row is heading or number == len(rows) else LineKind.THIN
        cell.line((0.0, bottom), (_WIDTH, bottom), kind)
        for column, text in enumerate((row.number, row.title, row.count, row.sizes)):
            middle = row is heading or column in {0, 2}
            cell.words(text, (edges[column], bottom), (_COLUMNS[column], _ROW), _NORMAL, middle=middle)
    top = _ROW * (len(rows) + 1)
    cell.line((0.0, top), (_WIDTH, top))
    for edge in edges:
        cell.line((edge, 0.0), (edge, top))


def draw_characteristics(
    layout: "Modelspace", box: Box, lines: Sequence[str], words: Words
) -> None:
    """Write characteristics to the top of a box."""
    if not lines:
        return
    cell = _Cells(_Pen(layout), box.left, box.top)
    heading = words.say(message("Technical characteristics"))
    cell.words(heading, (0.0, -_LINE), (box.width, _LINE), _NORMAL, middle=True)
    for number, line in enumerate(lines, 1):
        place = (0.0, -_LINE * (number + 1))
        cell.words(f"{number}. {line}", place, (box.width, _LINE), _NORMAL)


@dataclass(frozen=True, slots=True)
class _Pen:
    layout: "Modelspace"

    def line(self, start: Point, end: Point, kind: LineKind = LineKind.OUTLINE) -> None:
        self.layout.add_line(start, end, dxfattribs={"layer": kind})

    def box(self, box: Box, kind: LineKind) -> None:
        corners = [
            (box.left, box.bottom),
            (box.right, box.bottom),
            (box.right, box.top),
            (box.left, box.top),
        ]
        self.layout.add_lwpolyline(corners, close=True, dxfattribs={"layer": kind})


@dataclass(frozen=True, slots=True)
class _Cells:
    """A table whose lower left corner lies at `left`, `bottom`."""

    pen: _Pen
    left: float
    bottom: float

    def line(self, start: Point, end: Point, kind: LineKind = LineKind.OUTLINE) -> None:
        self.pen.line(self._place(start), self._place(end), kind)

    def words(
        self, text: str, corner: Point, size: Point, height: float, *, middle: bool = False
    ) -> None:
        """Write into a cell, squeezed where it is narrow."""
        x = corner[0] + (size[0] / 2 if middle else _PAD)
        add_text(
            self.pen.layout,
            text,
            self._place((x, corner[1] + size[1] / 2)),
            height,
            align="MIDDLE_CENTER" if middle else "MIDDLE_LEFT",
            widest=size[0] - 2 * _PAD,
        )

    def _place(self, point: Point) -> Point:
        return self.left + point[0], self.bottom + point[1]


def _draw_corner(pen: _Pen, box: Box, designation: str, *, turned: bool) -> None:
    pen.line((box.left, box.bottom), (box.right, box.bottom))
    pen.line((box.right, box.bottom), (box.right, box.top))
    add_text(
        pen.layout,
        designation,
        ((box.left + box.right) / 2, (box.bottom + box.top) / 2),
        _LARGE,
        align="MIDDLE_CENTER",
        rotation=270.0 if turned else 180.0,
        widest=_CORNER[0] - 2 * _PAD,
    )


def _draw_grid(cell: _Cells) -> None:
    """Draw the lines of form 1, from GOST 2.104."""
    cell.line((0.0, _HEIGHT), (_WIDTH, _HEIGHT))
    cell.line((0.0, 0.0), (0.0, _HEIGHT))
    for x, low, high in (
        (7.0, 30.0, 55.0),
        (17.0, 0.0, 55.0),
        (40.0, 0.0, 55.0),
        (55.0, 0.0, 55.0),
        (65.0, 0.0, 55.0),
        (135.0, 0.0, 40.0),
        (150.0, 20.0, 40.0),
        (167.0, 20.0, 40.0),
        (155.0, 15.0, 20.0),
    ):
        cell.line((x, low), (x, high))
    for y, start, end in (
        (40.0, 65.0, 185.0),
        (15.0, 65.0, 185.0),
        (35.0, 135.0, 185.0),
        (20.0, 135.0, 185.0),
        (35.0, 0.0, 65.0),
        (30.0, 0.0, 65.0),
    ):
        cell.line((start, y), (end, y))
    for y in (5.0, 10.0, 15.0, 20.0, 25.0, 40.0, 45.0, 50.0):
        cell.line((0.0, y), (65.0, y), LineKind.THIN)
    for x in (140.0, 145.0):
        cell.line((x, 20.0), (x, 35.0), LineKind.THIN)


def _draw_people(cell: _Cells, block: TitleBlock, words: Words) -> None:
    for (left, heading), (right, _) in zip(_CHANGES, _CHANGES[1:], strict=False):
        size = (right - left, _ROLE_HEIGHT)
        cell.words(words.say(heading), (left, 30.0), size, _SMALL, middle=True)
    for number, role in enumerate(_ROLES):
        if role is not None:
            bottom = 25.0 - _ROLE_HEIGHT * number
            cell.words(words.say(role), (0.0, bottom), (17.0, _ROLE_HEIGHT), _SMALL)
    for number, (name, date) in enumerate(((block.student, block.date), (block.checked, ""))):
        bottom = 25.0 - _ROLE_HEIGHT * number
        cell.words(name, (17.0, bottom), (23.0, _ROLE_HEIGHT), _SMALL)
        cell.words(date, (55.0, bottom), (10.0, _ROLE_HEIGHT), _SMALL)


def _draw_document(
    cell: _Cells, sheet: Format, block: TitleBlock, scale: str, words: Words
) -> None:
    cell.words(block.designation, (65.0, 40.0), (120.0, 15.0), _LARGE, middle=True)
    lines = wrapped(block.title, _NORMAL, 70.0 - 2 * _PAD, _TITLE_LINES)
    top = 39.0 - (_TITLE_LINES - len(lines)) * _LINE / 2
    for number, line in enumerate(lines, 1):
        cell.words(line, (65.0, top - _LINE * number), (70.0, _LINE), _NORMAL, middle=True)
    cell.words(block.document, (65.0, 15.5), (70.0, _LINE), _NORMAL, middle=True)
    for text, left, width in (
        (message("Stage"), 135.0, 15.0),
        (message("Mass"), 150.0, 17.0),
        (message("Scale"), 167.0, 18.0),
    ):
        cell.words(words.say(text), (left, 35.0), (width, 5.0), _SMALL, middle=True)
    cell.words(words.say(message("E")), (135.0, 20.0), (5.0, 15.0), _NORMAL, middle=True)
    cell.words("—", (150.0, 20.0), (17.0, 15.0), _NORMAL, middle=True)
    cell.words(scale, (167.0, 20.0), (18.0, 15.0), _LARGE, middle=True)
    cell.words(words.say(message("Sheet")), (135.0, 15.0), (20.0, 5.0), _SMALL)
    cell.words(words.say(message("Sheets {count}", count=1)), (155.0, 15.0), (30.0, 5.0), _SMALL)
    cell.words(block.organisation, (135.0, 0.0), (50.0, 15.0), _NORMAL, middle=True)
    size = words.say(message("Format {name}", name=sheet.name))
    add_text(cell.pen.layout, size, (sheet.width - 25.0, 1.2), _SMALL)
