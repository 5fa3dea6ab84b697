"""A sheet by GOST: frame and title block of form 1 (2.104), list of parts, characteristics.

Millimetres; the origin is the lower left corner of the sheet.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from gripcourse.drawing.paper.cells import LARGE, NORMAL, PAD, SMALL, Cells, Pen
from gripcourse.drawing.paper.document import LineKind
from gripcourse.drawing.paper.margin import draw_margin
from gripcourse.drawing.paper.strokes import Box
from gripcourse.drawing.paper.text import add_text, wrapped
from gripcourse.drawing.paper.title_block import (
    BLOCK_HEIGHT,
    BLOCK_WIDTH,
    TitleBlock,
    draw_title_block,
)
from gripcourse.text.words import Message, Words, message

if TYPE_CHECKING:
    from ezdxf.layouts.layout import Modelspace


@dataclass(frozen=True, slots=True)
class Format:
    """A sheet: its name, in letters of the reader's language, and its size."""

    name: Message
    width: float
    height: float

    @property
    def frame(self) -> Box:
        """The frame: 20 mm free on the left for binding, 5 mm elsewhere."""
        return Box(20.0, 5.0, self.width - 5.0, self.height - 5.0)


A4 = Format(message("A4"), 210.0, 297.0)
A3 = Format(message("A3"), 420.0, 297.0)
A2 = Format(message("A2"), 594.0, 420.0)
A3_UPRIGHT = Format(A3.name, A3.height, A3.width)
A2_UPRIGHT = Format(A2.name, A2.height, A2.width)
A4_BY_3 = Format(message("A4×3"), 630.0, 297.0)  # an additional format: what is long fills it
# From the smallest to the largest, each in the directions that the title block allows (GOST 2.301).
FORMATS = ((A4,), (A3, A3_UPRIGHT), (A4_BY_3,), (A2, A2_UPRIGHT))


@dataclass(frozen=True, slots=True)
class PartsRow:
    """A row of the parts list."""

    number: str
    title: str
    count: str
    material: str
    sizes: str


@dataclass(frozen=True, slots=True)
class Notes:
    """Numbered lines under a heading; a line that begins with an asterisk explains that."""

    heading: Message
    lines: tuple[str, ...]


_ROW = 8.0
_LINE = 6.0
_INDENT = 3.0  # of characteristics, from the frame
# Of the parts list: position, title, number, material, sizes.
_COLUMNS = (10.0, 61.0, 10.0, 26.0, 78.0)
_SIZES = len(_COLUMNS) - 1
_CORNER = (70.0, 14.0)  # field 26: the designation again, upside down, in the upper left corner
_ABOVE_LIST = 4.0
_BESIDE = 4.0
_FORMAT_LEFT, _FORMAT_LOW = 20.0, 1.2  # of the name of the format, under the frame


def block_box(sheet: Format, rows: int) -> Box:
    """Return what the title block takes with the parts list over it."""
    frame = sheet.frame
    above = _ROW * (rows + 1) if rows else 0.0
    return Box(
        frame.right - BLOCK_WIDTH, frame.bottom, frame.right, frame.bottom + BLOCK_HEIGHT + above
    )


def lines_boxes(sheet: Format, rows: int, lines: int) -> tuple[Box, ...]:
    """Return where lines may stand: over the parts list, or left of the title block."""
    block, size = block_box(sheet, rows), _LINE * lines
    over = Box(block.left, block.top, block.right, block.top + _ABOVE_LIST + size)
    left = block.left - BLOCK_WIDTH - _BESIDE
    beside = Box(left, block.bottom + _BESIDE, left + BLOCK_WIDTH, block.bottom + _BESIDE + size)
    return (over, beside) if left >= sheet.frame.left + _BESIDE else (over,)


def corner_box(sheet: Format) -> Box:
    """Return what the designation in the upper left corner takes."""
    frame = sheet.frame
    long, short = _CORNER
    if _is_turned(sheet):
        return Box(frame.left, frame.top - long, frame.left + short, frame.top)
    return Box(frame.left, frame.top - short, frame.left + long, frame.top)


def _is_turned(sheet: Format) -> bool:
    """Tell whether field 26 runs down the sheet: where the title block stands at a short side."""
    return sheet.height > sheet.width and sheet is not A4


def draw_sheet(
    layout: "Modelspace", sheet: Format, block: TitleBlock, scale: str, words: Words
) -> None:
    """Draw the frame and fill in the title block."""
    _set_extents(layout, sheet)
    pen = Pen(layout)
    outer, frame = Box(0.0, 0.0, sheet.width, sheet.height), sheet.frame
    pen.box(outer, LineKind.THIN)
    pen.box(frame, LineKind.OUTLINE)
    _draw_corner(pen, corner_box(sheet), block.designation, turned=_is_turned(sheet))
    draw_margin(pen, frame, words)
    cell = Cells(pen, frame.right - BLOCK_WIDTH, frame.bottom)
    draw_title_block(cell, block, scale, words)
    size = words.say(message("Format {name}", name=sheet.name))
    add_text(layout, size, (frame.right - _FORMAT_LEFT, _FORMAT_LOW), SMALL)


def draw_list(layout: "Modelspace", sheet: Format, rows: Sequence[PartsRow], words: Words) -> None:
    """Draw the parts list over the title block, its heading below, as it grows upwards."""
    if not rows:
        return
    cell = Cells(Pen(layout), sheet.frame.right - BLOCK_WIDTH, sheet.frame.bottom + BLOCK_HEIGHT)
    heading = PartsRow(
        words.say(message("Pos.")),
        words.say(message("Name")),
        words.say(message("Qty")),
        words.say(message("Material")),
        words.say(message("Sizes, mm")),
    )
    edges = [sum(_COLUMNS[:number]) for number in range(len(_COLUMNS) + 1)]
    # Rows are read downwards: the first part stands highest, under the heading.
    for number, row in enumerate([*reversed(rows), heading]):
        bottom = _ROW * number
        kind = LineKind.OUTLINE if row is heading or number == len(rows) else LineKind.THIN
        cell.line((0.0, bottom), (BLOCK_WIDTH, bottom), kind)
        for column, text in enumerate(_cells(row)):
            middle = row is heading or column in {0, 2}
            place, size = (edges[column], bottom), (_COLUMNS[column], _ROW)
            if column == _SIZES and row is not heading:
                cell.symbols(text, place, size, NORMAL, most=2)
            else:
                cell.words(text, place, size, NORMAL, middle=middle, most=2)
    top = _ROW * (len(rows) + 1)
    cell.line((0.0, top), (BLOCK_WIDTH, top))
    for edge in edges:
        cell.line((edge, 0.0), (edge, top))


def _cells(row: PartsRow) -> tuple[str, ...]:
    return row.number, row.title, row.count, row.material, row.sizes


def note_lines(notes: Sequence[Notes]) -> int:
    """Return how many lines notes take with their headings."""
    return sum(1 + len(_written(one)) for one in notes)


def _written(notes: Notes) -> list[str]:
    """Return the lines of notes, numbered; one that is too long goes on in the next."""
    numbered = [
        line if is_explanation(line) else f"{number}. {line}"
        for number, line in enumerate(notes.lines, 1)
    ]
    room = BLOCK_WIDTH - _INDENT - 2 * PAD
    return [one for line in numbered for one in wrapped(line, NORMAL, room, len(line))]


def draw_notes(layout: "Modelspace", box: Box, notes: Sequence[Notes], words: Words) -> None:
    """Write notes to the top of a box, one below the other."""
    cell, level = Cells(Pen(layout), box.left, box.top), 0.0
    for one in notes:
        level -= _LINE
        heading = words.say(one.heading)
        cell.words(heading, (0.0, level), (box.width, _LINE), NORMAL, middle=True)
        for line in _written(one):
            level -= _LINE
            cell.words(line, (_INDENT, level), (box.width - _INDENT, _LINE), NORMAL)


def _set_extents(layout: "Modelspace", sheet: Format) -> None:
    """Tell how large the drawing is: some programs place all of it by that."""
    low, high = (0.0, 0.0, 0.0), (sheet.width, sheet.height, 0.0)
    layout.reset_extents(low, high)
    for one in (layout, layout.doc.active_layout()):  # what paper shows is printed by the second
        one.reset_limits(low[:2], high[:2])
    # The library takes a corner at the origin for none, and leaves these as they are.
    layout.doc.header["$EXTMIN"], layout.doc.header["$EXTMAX"] = low, high


def is_explanation(line: str) -> bool:
    """Tell whether a line says what an asterisk means: it stands last and has no number."""
    return line.startswith("*")


def _draw_corner(pen: Pen, box: Box, designation: str, *, turned: bool) -> None:
    pen.line((box.left, box.bottom), (box.right, box.bottom))
    pen.line((box.right, box.bottom), (box.right, box.top))
    add_text(
        pen.layout,
        designation,
        ((box.left + box.right) / 2, (box.bottom + box.top) / 2),
        LARGE,
        align="MIDDLE_CENTER",
        rotation=270.0 if turned else 180.0,
        widest=_CORNER[0] - 2 * PAD,
    )
