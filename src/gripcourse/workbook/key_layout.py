"""Where everything stands in the instructor's key workbook."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from enum import IntEnum
from typing import Final

from gripcourse.course.quantity import Quantity
from gripcourse.solver.plan import Plan
from gripcourse.text.words import Words, message
from gripcourse.workbook.layout import CellPlace


class KeyColumn(IntEnum):
    """Columns of the key, counted from zero."""

    NUMBER = 0
    SYMBOL = 1
    TITLE = 2
    VALUE = 3
    UNIT = 4
    FORMULA = 5
    SOURCE = 6
    TOLERANCE = 7
    SI = 8
    REQUIRED = 9
    """What a chosen size must not be below, in SI."""


KEY_HEADER: Final = 4
"""Row of the headings; the blocks follow."""


@dataclass(frozen=True, slots=True)
class KeyLine:
    """The row of one quantity."""

    quantity: Quantity
    number: str
    sheet: str
    row: int

    def place(self, column: KeyColumn) -> CellPlace:
        """Return the cell of this row in a column."""
        return CellPlace(self.sheet, self.row, column)


@dataclass(frozen=True, slots=True)
class KeyBlock:
    """Rows under one heading: the given data, the constants, or a section."""

    title: str
    row: int
    lines: tuple[KeyLine, ...]


@dataclass(frozen=True, slots=True)
class KeyLayout:
    """The sheet with all quantities: first what is given, then the sections of the course."""

    sheet: str
    blocks: tuple[KeyBlock, ...]
    works: int
    """Row of the heading of the cited works."""


def key_layout(plan: Plan, words: Words) -> KeyLayout:
    """Lay out the key of a plan, one block below the other."""
    sheet = words.say(message("Key"))
    given = [
        (words.say(message("Given data")), "", plan.givens),
        (words.say(message("Constants")), "c", plan.constants),
    ]
    asked = [
        (f"{number}. {title}", f"{number}.", quantities)
        for number, (title, quantities) in enumerate(_sections(plan, words), start=1)
    ]
    blocks = tuple(_blocks([*given, *asked], sheet))
    return KeyLayout(sheet, blocks, blocks[-1].row + len(blocks[-1].lines) + 2)


def _sections(plan: Plan, words: Words) -> Iterator[tuple[str, tuple[Quantity, ...]]]:
    for section in plan.course.sections:
        asked = tuple(q for q in plan.asked if q.section == section.id)
        if asked:
            yield section.title.of(words.language), asked


def _blocks(
    contents: Iterable[tuple[str, str, tuple[Quantity, ...]]], sheet: str
) -> Iterator[KeyBlock]:
    """Put blocks below the headings, each under a row with its title."""
    row = KEY_HEADER + 1
    for title, prefix, quantities in contents:
        lines = tuple(
            KeyLine(quantity, f"{prefix}{index}", sheet, row + index)
            for index, quantity in enumerate(quantities, start=1)
        )
        yield KeyBlock(title, row, lines)
        row += len(lines) + 1
