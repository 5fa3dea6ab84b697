"""The sheet of the key that tries the sizes of a choice: the first that will do is taken.

A choice that steps up has a block with a row for each size of its series: what is computed from the
size on the way to the condition, whether the condition holds, and whether the size is large enough.
"""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np

from gripcourse.course.quantity import Quantity
from gripcourse.formula.excel import excel_form
from gripcourse.formula.functions import SLACK
from gripcourse.formula.parse import formula_of
from gripcourse.solver.condition_text import condition_text
from gripcourse.solver.plan import Plan
from gripcourse.solver.sizes import reference_steps_up, way_to_condition, will_do
from gripcourse.solver.solve import to_si
from gripcourse.text.words import Words, message
from gripcourse.workbook.key_formulas import Ranges, direct_form, entry_form, required_value
from gripcourse.workbook.key_layout import KeyColumn, KeyLayout
from gripcourse.workbook.layout import CellPlace
from gripcourse.workbook.names import SI, cell_name
from gripcourse.workbook.style import Styles, decimals_shown, set_page, write_symbols

if TYPE_CHECKING:
    from xlsxwriter import Workbook
    from xlsxwriter.worksheet import Worksheet

_FIRST: Final = 3  # row of the first block
_SIZE, _ENOUGH, _BETWEEN = 0, 1, 2  # columns
_WIDTH: Final = 16
_IS_ENOUGH: Final = formula_of("size >= required", {})


@dataclass(frozen=True, slots=True)
class TriedSizes:
    """The block of one choice.

    Attributes:
        quantity: the choice.
        sheet, row: where its heading stands; the headings of the columns and the sizes follow.
        count: how many sizes there are.
        forms: spreadsheet formulas of a row with places `{row}`, by column.
    """

    quantity: Quantity
    sheet: str
    row: int
    count: int
    forms: tuple[str, ...]

    @property
    def first(self) -> int:
        """Row of the smallest size."""
        return self.row + 2

    @property
    def chosen_form(self) -> str:
        """The spreadsheet formula of the first size that will do."""
        return f"INDEX({self._column(_SIZE)},MATCH(1,{self._column(len(self.forms) - 1)},0))"

    def _column(self, column: int) -> str:
        top = CellPlace(self.sheet, self.first, column)
        bottom = CellPlace(self.sheet, self.first + self.count - 1, column)
        return f"{top.reference}:{bottom.reference.rpartition('!')[2]}"


def place_sizes(
    plan: Plan, layout: KeyLayout, columns: Ranges, words: Words
) -> dict[str, TriedSizes]:
    """Place the blocks of all choices that step up, one below the other.

    Args:
        plan: of the key.
        layout: where the required values stand.
        columns: ranges of the catalogues.
        words: the reader's language.

    Returns:
        The blocks by id; without those whose condition no spreadsheet can compute.
    """
    sheet, row = words.say(message("Sizes tried")), _FIRST
    placed: dict[str, TriedSizes] = {}
    for line in (one for block in layout.blocks for one in block.lines):
        quantity = line.quantity
        if not reference_steps_up(quantity, plan.convention) or quantity.choice is None:
            continue
        required = line.place(KeyColumn.REQUIRED).reference
        forms = _forms(quantity, plan, required, columns)
        if forms is None:
            continue
        count = len(plan.columns[quantity.choice.column].sizes)
        placed[quantity.id] = TriedSizes(quantity, sheet, row, count, forms)
        row += count + 3
    return placed


def _forms(
    quantity: Quantity, plan: Plan, required: str, columns: Ranges
) -> tuple[str, ...] | None:
    """Return the spreadsheet formulas of a row; None where one of them has no such form."""
    choice, up = quantity.choice, plan.step_ups[quantity.id]
    if choice is None or choice.condition is None:
        return None
    cells = {name: cell_name(SI, name) for name in up.outside} | {quantity.id: _cell(_SIZE)}
    enough = excel_form(_IS_ENOUGH, "", {"size": _cell(_SIZE), "required": required}, columns)
    forms = [f"INDEX({columns[choice.column][1]},{{place}})", enough]
    for column, name in enumerate(up.between, start=_BETWEEN):
        forms.append(_between(plan.quantities[name], plan, cells, columns))
        cells[name] = _cell(column)
    forms.append(excel_form(choice.condition, "", cells, columns))
    last = _cell(len(forms) - 1)
    forms.append(f"IF({_cell(_ENOUGH)}=1,IFERROR({last},0),0)")
    found = tuple(one for one in forms if one is not None)
    return found if len(found) == len(forms) else None


def _between(
    quantity: Quantity, plan: Plan, cells: Mapping[str, str], columns: Ranges
) -> str | None:
    """Return the formula of what is computed from a size, in its row."""
    direct = direct_form(quantity, plan, columns, cells)
    if quantity.choice is None or direct is None:
        return direct
    return entry_form(quantity, plan, f"({direct})", columns)


def _cell(column: int) -> str:
    """Name a cell of the same row; the row is filled in when it is written."""
    return CellPlace("", 0, column).address.removesuffix("1") + "{row}"


def write_sizes(
    book: "Workbook",
    placed: Mapping[str, TriedSizes],
    plan: Plan,
    values: Mapping[str, float],
    words: Words,
    styles: Styles,
) -> None:
    """Write the sheet, with the engine's results; nothing where no choice steps up.

    Args:
        book: that the sheet is added to.
        placed: where everything stands.
        plan: of the key.
        values: the engine's, in declared units.
        words: the reader's language.
        styles: of `book`.
    """
    if not placed:
        return
    title = words.say(message("Sizes tried"))
    sheet = book.add_worksheet(title)
    sheet.set_row(0, 26)
    sheet.write_string(0, 0, words.say(message("Sizes tried, in SI units")), styles.title)
    hint = message("The first size that is large enough and satisfies the condition is taken.")
    sheet.write_string(1, 0, words.say(hint), styles.hint_line)
    widest = max(len(one.forms) for one in placed.values())
    sheet.set_column(0, widest - 1, _WIDTH)
    for one in placed.values():
        _write_block(sheet, one, plan, values, words, styles)
    set_page(sheet, title, "", landscape=True)


def _write_block(
    sheet: "Worksheet",
    one: TriedSizes,
    plan: Plan,
    values: Mapping[str, float],
    words: Words,
    styles: Styles,
) -> None:
    quantity = one.quantity
    heading = f"{quantity.symbol.of(words.language)}: {quantity.title.of(words.language)}"
    write_symbols(sheet, one.row, 0, heading, styles.heading, styles)
    sheet.set_row(one.row + 1, 34)
    for column, said in enumerate(_headings(quantity, plan, words)):
        write_symbols(sheet, one.row + 1, column, said, styles.head, styles)
    for place, numbers in enumerate(_numbers(quantity, plan, values)):
        row = one.first + place
        for column, (form, value) in enumerate(zip(one.forms, numbers, strict=True)):
            formula = form.replace("{row}", str(row + 1)).replace("{place}", str(place + 1))
            stored = "#N/A" if math.isnan(value) else value
            style = styles.computed[decimals_shown(value)]
            sheet.write_formula(row, column, f"={formula}", style, value=stored)


def _headings(quantity: Quantity, plan: Plan, words: Words) -> Iterator[str]:
    yield words.say(message("Size"))
    yield words.say(message("Large enough"))
    for name in plan.step_ups[quantity.id].between:
        yield plan.quantities[name].symbol.of(words.language)
    yield condition_text(quantity, plan, words.language)
    yield words.say(message("Will do"))


def _numbers(
    quantity: Quantity, plan: Plan, values: Mapping[str, float]
) -> Iterator[tuple[float, ...]]:
    """Yield the engine's numbers of each row, SI."""
    sizes = np.asarray(
        () if quantity.choice is None else plan.columns[quantity.choice.column].sizes
    )
    up = plan.step_ups[quantity.id]
    known = {
        name: np.asarray(value)
        for name, value in to_si(plan, {name: values[name] for name in up.outside}).items()
    }
    way = way_to_condition(plan, quantity, sizes, known)
    met = will_do(plan, quantity, sizes, known)
    needed = required_value(quantity, plan, values)
    for place, size in enumerate(sizes.tolist()):
        between = (float(np.broadcast_to(way[name], sizes.shape)[place]) for name in up.between)
        enough = needed - size <= SLACK * max(abs(needed), abs(size))
        holds = bool(met[place])
        yield (size, float(enough), *between, float(holds), float(enough and holds))
