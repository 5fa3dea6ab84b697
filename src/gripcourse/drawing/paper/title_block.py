"""The title block by form 1 of GOST 2.104, 185 by 55 mm."""

from dataclasses import dataclass
from itertools import chain

from gripcourse.drawing.paper.cells import LARGE, NORMAL, PAD, SMALL, Cells
from gripcourse.drawing.paper.document import LineKind
from gripcourse.drawing.paper.text import (
    READ_WELL,
    WIDE_ENOUGH,
    Setting,
    capital,
    set_in,
    squeeze_of,
)
from gripcourse.solver.plan import Plan
from gripcourse.text.signed_names import signed_name, surname_of
from gripcourse.text.words import Message, Words, message

BLOCK_WIDTH, BLOCK_HEIGHT = 185.0, 55.0
_LINE = 6.0
_TITLE_LINES = 3

_CHANGES: tuple[tuple[float, Message], ...] = (
    (0.0, message("Rev.")),
    (7.0, message("Sheet")),
    (17.0, message("Document no.")),
    (40.0, message("Signed")),
    (55.0, message("Date")),
)
_CHANGES_END = 65.0
_ROLES = (
    message("Drawn"),
    message("Checked"),
    message("Technology"),
    None,
    message("Standards"),
    message("Approved"),
)
_ROLE_HEIGHT = 5.0
_NAME = (23.0, _ROLE_HEIGHT)
_TWO_LINES = 8.0  # mm, of the least height


@dataclass(frozen=True, slots=True)
class TitleBlock:
    """What the title block says; an empty text leaves its cell blank.

    Attributes:
        designation: of the document.
        title: of what is drawn.
        document: what kind of drawing it is.
        student: who drew it.
        checked: who checks it.
        organisation: group and school.
        date: of the drawing, as it shall be written.
        mass: of what is drawn, kg.
    """

    designation: str
    title: str
    document: str
    student: str
    checked: str = ""
    organisation: str = ""
    date: str = ""
    mass: str = ""


def variant_block(plan: Plan, variant: str, student: str, words: Words) -> TitleBlock:
    """Return what the title block says on the general view of a variant.

    Args:
        plan: of the variant.
        variant: its id.
        student: name; may be empty.
        words: of the reader.
    """
    return TitleBlock(
        designation=words.say(message("Variant {variant} GA", variant=variant)),
        title=capital(plan.scheme.title.of(words.language)),
        document=words.say(message("General arrangement")),
        student=student,
        organisation=plan.course.title.of(words.language),
    )


def draw_title_block(cell: Cells, block: TitleBlock, scale: str, words: Words) -> None:
    """Draw the block with what it says into cells whose corner is its lower left one."""
    _draw_grid(cell)
    _draw_people(cell, block, words)
    _draw_document(cell, block, scale, words)


def _draw_grid(cell: Cells) -> None:
    """Draw the lines of form 1, from GOST 2.104."""
    cell.line((0.0, BLOCK_HEIGHT), (BLOCK_WIDTH, BLOCK_HEIGHT))
    cell.line((0.0, 0.0), (0.0, BLOCK_HEIGHT))
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


def _draw_people(cell: Cells, block: TitleBlock, words: Words) -> None:
    ends = [*(left for left, _ in _CHANGES[1:]), _CHANGES_END]
    for (left, heading), right in zip(_CHANGES, ends, strict=True):
        size = (right - left, _ROLE_HEIGHT)
        cell.words(words.say(heading), (left, 30.0), size, SMALL, middle=True)
    for number, role in enumerate(_ROLES):
        if role is not None:
            bottom = 25.0 - _ROLE_HEIGHT * number
            cell.words(words.say(role), (0.0, bottom), (17.0, _ROLE_HEIGHT), SMALL)
    # What a name loses here stands above the organisation: there is room for one of them.
    for number, (name, date, least) in enumerate(
        ((block.student, block.date, SMALL), (block.checked, "", 0.0))
    ):
        bottom = 25.0 - _ROLE_HEIGHT * number
        most = 1 if least else 2
        cell.words(_written(name), (17.0, bottom), _NAME, SMALL, most=most, least=least)
        cell.words(date, (55.0, bottom), (10.0, _ROLE_HEIGHT), SMALL)


def _written(name: str) -> str:
    """Return a name as its cell can be read: whole, with initials, or the surname alone.

    The standard asks for the surname only.
    """
    if _narrowed(name) >= READ_WELL:
        return name
    signed = signed_name(name)
    return signed if _narrowed(signed) >= WIDE_ENOUGH else surname_of(name)


def _is_shortened(name: str) -> bool:
    """Tell whether the cell of a name has less of it than surname and initials."""
    written = _written(name)
    return written not in {name, signed_name(name)} or _narrowed(written) < WIDE_ENOUGH


def _narrowed(name: str) -> float:
    """Return the factor that letters of the least height are narrowed by in the cell of a name."""
    return squeeze_of(name, SMALL, _NAME[0] - 2 * PAD)


def _draw_organisation(cell: Cells, block: TitleBlock) -> None:
    """Write group and school; above them the name that its own cell has no room for."""
    place, size = (135.0, 0.0), (50.0, 15.0)
    if not _is_shortened(block.student):
        words = block.organisation
        cell.words(words, place, size, NORMAL, middle=True, most=4, least=SMALL)
        return
    room = (size[0] - 2 * PAD, _TWO_LINES)
    texts = (block.student, block.organisation)
    lines = [set_in(text, SMALL, room, 2, least=SMALL).lines for text in texts if text]
    cell.lines(Setting(tuple(chain(*lines)), SMALL, 1.0), place, size, middle=True)


def _draw_document(cell: Cells, block: TitleBlock, scale: str, words: Words) -> None:
    cell.words(block.designation, (65.0, 40.0), (120.0, 15.0), LARGE, middle=True)
    place, size = (65.0, 15.5 + _LINE), (70.0, 24.0 - _LINE)
    cell.words(block.title, place, size, NORMAL, middle=True, most=_TITLE_LINES)
    cell.words(block.document, (65.0, 15.5), (70.0, _LINE), NORMAL, middle=True)
    for text, left, width in (
        (message("Stage"), 135.0, 15.0),
        (message("Mass"), 150.0, 17.0),
        (message("Scale"), 167.0, 18.0),
    ):
        cell.words(words.say(text), (left, 35.0), (width, 5.0), SMALL, middle=True)
    cell.words(words.say(message("E")), (135.0, 20.0), (5.0, 15.0), NORMAL, middle=True)
    cell.words(block.mass or "—", (150.0, 20.0), (17.0, 15.0), NORMAL, middle=True)
    cell.words(scale, (167.0, 20.0), (18.0, 15.0), LARGE, middle=True)
    cell.words(words.say(message("Sheet")), (135.0, 15.0), (20.0, 5.0), SMALL)
    cell.words(words.say(message("Sheets {count}", count=1)), (155.0, 15.0), (30.0, 5.0), SMALL)
    _draw_organisation(cell, block)
