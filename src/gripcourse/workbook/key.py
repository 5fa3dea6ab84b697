"""The instructor's key: every quantity as a live formula over the given data of one variant.

Formulas work in SI, as the engine does; the values that people read are converted beside them. The
stored results are the engine's, so that a viewer that does not compute shows them too.
"""

import io
import math
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, Final

from gripcourse.course.quantity import Convention, Kind
from gripcourse.machine.files import write_bytes
from gripcourse.solver.plan import Plan
from gripcourse.solver.sizes import reference_steps_up
from gripcourse.solver.solve import solve_variant
from gripcourse.text.units import factor, unit_text
from gripcourse.text.words import Words, message
from gripcourse.variants.model import Variant
from gripcourse.workbook import names
from gripcourse.workbook.catalogues import place_tables, write_tables
from gripcourse.workbook.key_formulas import direct_form, entry_form, required_value
from gripcourse.workbook.key_layout import (
    KEY_HEADER,
    KeyBlock,
    KeyColumn,
    KeyLayout,
    KeyLine,
    key_layout,
)
from gripcourse.workbook.key_sizes import TriedSizes, place_sizes, write_sizes
from gripcourse.workbook.key_text import cited_works, formula_text, source_text, tolerance_text
from gripcourse.workbook.style import (
    Styles,
    decimals_shown,
    make_styles,
    new_book,
    row_height,
    set_page,
    write_symbol,
    write_symbols,
)

if TYPE_CHECKING:
    from xlsxwriter import Workbook
    from xlsxwriter.worksheet import Worksheet

_WIDTHS: Final = {
    KeyColumn.NUMBER: 6,
    KeyColumn.SYMBOL: 12,
    KeyColumn.TITLE: 40,
    KeyColumn.VALUE: 12,
    KeyColumn.UNIT: 9,
    KeyColumn.FORMULA: 48,
    KeyColumn.SOURCE: 40,
    KeyColumn.TOLERANCE: 16,
    KeyColumn.SI: 15,
    KeyColumn.REQUIRED: 15,
}
_NO_DAY: Final = datetime(2000, 1, 1)  # noqa: DTZ001 - a key has no date: it is the same every day
_NO_VALUE: Final = "#N/A"


@dataclass(frozen=True, slots=True)
class _Key:
    """What the rows of a key are made of.

    Attributes:
        plan, words, styles: of the workbook.
        values: the engine's, in declared units.
        given: of the variant, in declared units.
        columns: ranges of the catalogues.
        tried: where the sizes of choices that step up are tried, by id.
    """

    plan: Plan
    words: Words
    styles: Styles
    values: Mapping[str, float]
    given: Mapping[str, float]
    columns: Mapping[str, tuple[str, str]]
    tried: Mapping[str, TriedSizes]


def write_key_workbook(path: Path, plan: Plan, variant: Variant, words: Words) -> None:
    """Write the key of a variant.

    Args:
        path: of the .xlsx file to make or to replace.
        plan: of the variant's scheme and options; its convention decides the formulas.
        variant: the given values.
        words: the instructor's language.

    Raises:
        OSError: the file cannot be written.
    """
    write_bytes(path, key_workbook(plan, variant, words), private=True)


def key_workbook(plan: Plan, variant: Variant, words: Words) -> bytes:
    """Return the content of the key of a variant; see `write_key_workbook`."""
    stream = io.BytesIO()
    book = new_book(stream)
    styles = make_styles(book)
    yes, no = words.say(message("yes")), words.say(message("no"))
    styles.verdict.set_num_format(f'[=1]"{yes}";[=0]"{no}";General')
    tables, layout = place_tables(plan, words), key_layout(plan, words)
    key = _Key(
        plan=plan,
        words=words,
        styles=styles,
        values=solve_variant(plan, variant.given),
        given=variant.given,
        columns=tables.ranges,
        tried=place_sizes(plan, layout, tables.ranges, words),
    )
    _write_sheet(book, layout, key, variant)
    write_sizes(book, key.tried, plan, key.values, words, styles)
    write_tables(book, tables, words, styles)
    title = words.say(message("Key of variant {variant}", variant=variant.id))
    book.set_properties({"title": title, "author": "gripcourse", "created": _NO_DAY})
    book.close()
    return stream.getvalue()


def _write_sheet(book: "Workbook", placed: KeyLayout, key: _Key, variant: Variant) -> None:
    words, styles = key.words, key.styles
    sheet = book.add_worksheet(placed.sheet)
    for column, width in _WIDTHS.items():
        sheet.set_column(column, column, width)
    title = words.say(message("Key of variant {variant}", variant=variant.id))
    sheet.set_row(0, 26)
    sheet.write_string(0, 0, title, styles.title)
    sheet.write_string(1, 0, _about(key.plan, words), styles.label)
    hint = message("Change a given value: everything below is computed again from it.")
    sheet.write_string(2, 0, words.say(hint), styles.hint_line)
    for index, heading in enumerate(_headings(words)):
        sheet.write_string(KEY_HEADER, index, heading, styles.head)
    for block in placed.blocks:
        _write_block(book, sheet, block, key)
    _write_works(sheet, placed.works, key)
    sheet.freeze_panes(KEY_HEADER + 1, KeyColumn.VALUE)
    sheet.repeat_rows(KEY_HEADER)
    set_page(sheet, key.plan.course.title.of(words.language), title, landscape=True)


def _write_works(sheet: "Worksheet", row: int, key: _Key) -> None:
    heading = key.words.say(message("Cited works"))
    sheet.write_string(row, 0, heading, key.styles.heading)
    for offset, work in enumerate(cited_works(key.plan), start=1):
        title = key.plan.course.works[work].title.of(key.words.language)
        sheet.write_string(row + offset, 0, f"[{offset}]", key.styles.label)
        sheet.write_string(row + offset, KeyColumn.TITLE, title, key.styles.label)


def _about(plan: Plan, words: Words) -> str:
    """Name the scheme, what the variant chooses, and whose formulas are used."""
    language = words.language
    chosen = [
        choice.title.of(language)
        for option in plan.scheme.options
        for choice in option.choices
        if choice.id == plan.options.get(option.id)
    ]
    as_printed = plan.convention is Convention.AS_PRINTED
    formulas = message("formulas as printed") if as_printed else message("corrected formulas")
    whose = (words.say(formulas),) if plan.course.errata else ()
    return "; ".join((plan.scheme.title.of(language), *chosen, *whose))


def _headings(words: Words) -> tuple[str, ...]:
    return (
        words.say(message("No.")),
        words.say(message("Symbol")),
        words.say(message("Quantity")),
        words.say(message("Value")),
        words.say(message("Unit")),
        words.say(message("Formula")),
        words.say(message("Source")),
        words.say(message("Tolerance")),
        words.say(message("Value in SI")),
        words.say(message("Required, in SI")),
    )


def _write_block(book: "Workbook", sheet: "Worksheet", block: KeyBlock, key: _Key) -> None:
    if not block.lines:
        return
    sheet.write_string(block.row, 0, block.title, key.styles.heading)
    sheet.set_row(block.row, 22)
    for line in block.lines:
        _write_texts(sheet, line, key)
        match line.quantity.kind:
            case Kind.MANUAL:
                sheet.write_blank(line.row, KeyColumn.VALUE, None, key.styles.unit)
                continue
            case Kind.GIVEN | Kind.CONSTANT:
                _write_given(sheet, line, key)
                role = names.GIVEN
            case _:
                _write_computed(sheet, line, key)
                role = names.ANSWER
        identifier = line.quantity.id
        for name, column in ((role, KeyColumn.VALUE), (names.SI, KeyColumn.SI)):
            reference = line.place(column).reference
            book.define_name(names.cell_name(name, identifier), f"={reference}")


def _write_texts(sheet: "Worksheet", line: KeyLine, key: _Key) -> None:
    quantity, row, styles, words = line.quantity, line.row, key.styles, key.words
    sheet.write_string(row, KeyColumn.NUMBER, line.number, styles.number)
    write_symbol(sheet, row, KeyColumn.SYMBOL, quantity.symbol.of(words.language), styles)
    texts = {
        KeyColumn.TITLE: quantity.title.of(words.language),
        KeyColumn.FORMULA: formula_text(quantity, key.plan, words),
        KeyColumn.SOURCE: source_text(quantity, key.plan, words),
        KeyColumn.TOLERANCE: tolerance_text(quantity, words),
    }
    sheet.set_row(row, row_height((said, _WIDTHS[column]) for column, said in texts.items()))
    for column, said in texts.items():
        write_symbols(sheet, row, column, said, styles.text, styles)
    unit = unit_text(quantity.unit, words.language)
    sheet.write_string(row, KeyColumn.UNIT, unit, styles.unit)


def _write_given(sheet: "Worksheet", line: KeyLine, key: _Key) -> None:
    """Write a number that may be changed, and its value in SI."""
    quantity, row = line.quantity, line.row
    value = key.given.get(quantity.id, quantity.value)
    if value is None:
        return
    sheet.write_number(row, KeyColumn.VALUE, value, key.styles.answer)
    formula = _times(line.place(KeyColumn.VALUE).address, factor(quantity.unit))
    _write_formula(sheet, row, KeyColumn.SI, formula, value * factor(quantity.unit), key)


def _write_computed(sheet: "Worksheet", line: KeyLine, key: _Key) -> None:
    """Write a live formula in SI and its value in the declared unit."""
    quantity, row = line.quantity, line.row
    value = key.values[quantity.id]
    size = factor(quantity.unit)
    if quantity.choice is None:
        formula = direct_form(quantity, key.plan, key.columns)
    else:
        formula = _write_required(sheet, line, key)
    if formula is None:
        _write_fixed(sheet, line, value * size, key)
    else:
        _write_formula(sheet, row, KeyColumn.SI, f"={formula}", value * size, key)
    shown = _times(line.place(KeyColumn.SI).address, size, divided=True)
    if quantity.kind is Kind.VERDICT:
        stored = _stored(value)
        sheet.write_formula(row, KeyColumn.VALUE, shown, key.styles.verdict, value=stored)
    else:
        _write_formula(sheet, row, KeyColumn.VALUE, shown, value, key)


def _write_required(sheet: "Worksheet", line: KeyLine, key: _Key) -> str | None:
    """Write what the size of a choice must not be below; return the formula of the choice."""
    quantity, place = line.quantity, line.place(KeyColumn.REQUIRED)
    required = direct_form(quantity, key.plan, key.columns)
    if required is not None:
        value = required_value(quantity, key.plan, key.values)
        _write_formula(sheet, place.row, place.column, f"={required}", value, key)
    if quantity.id in key.tried:
        return key.tried[quantity.id].chosen_form
    if required is None or reference_steps_up(quantity, key.plan.convention):
        return None
    return entry_form(quantity, key.plan, place.address, key.columns)


def _write_fixed(sheet: "Worksheet", line: KeyLine, value: float, key: _Key) -> None:
    """Write a value that no spreadsheet formula computes, and say so."""
    if math.isnan(value):
        sheet.write_string(line.row, KeyColumn.SI, _NO_VALUE, key.styles.unit)
    else:
        sheet.write_number(line.row, KeyColumn.SI, value, key.styles.given)
    note = message(
        "{formula} (no spreadsheet form: this value does not follow changes)",
        formula=formula_text(line.quantity, key.plan, key.words),
    )
    said = key.words.say(note)
    write_symbols(sheet, line.row, KeyColumn.FORMULA, said, key.styles.text, key.styles)


def _write_formula(
    sheet: "Worksheet", row: int, column: int, formula: str, value: float, key: _Key
) -> None:
    """Write a live formula with the engine's result, shown with as many decimals as that needs."""
    style = key.styles.computed[decimals_shown(value)]
    sheet.write_formula(row, column, formula, style, value=_stored(value))


def _times(cell: str, size: float, *, divided: bool = False) -> str:
    if size == 1:
        return f"={cell}"
    return f"={cell}{'/' if divided else '*'}{size!r}"


def _stored(value: float) -> float | str:
    """Return the result that is stored beside a formula; a missing one is an error."""
    return _NO_VALUE if math.isnan(value) else value
