"""Formulas of declarations as boxes, with the symbols of a scheme."""

from collections.abc import Mapping
from typing import Final

from gripcourse.course.columns_read import columns_of_formula
from gripcourse.course.compose import used_names
from gripcourse.course.quantity import Kind, Quantity, Rounding
from gripcourse.documents.reference.occurrence import Content, Occurrence
from gripcourse.formula.boxes import Box, Row, Text
from gripcourse.formula.tree import Formula
from gripcourse.formula.typeset import declared_symbol, equation, typeset

Symbols = Mapping[str, Box]

_ROUNDED: Final = {Rounding.UP: "≥", Rounding.NEAREST: "≈"}


def symbols_for(one: Occurrence, content: Content, language: str) -> Symbols:
    """Return what stands for every name and every column in the formulas of a declaration."""
    found: dict[str, Box] = {
        name: symbol_of(content.meant(name, one)[0].quantity, language)
        for name in used_names([one.quantity])
    }
    for formula in one.quantity.formulas():
        found |= {column: column_box(column) for column in columns_of_formula(formula)}
    return found


def symbol_of(quantity: Quantity, language: str) -> Box:
    """Return the symbol of a quantity; of one without, its id."""
    symbol = quantity.symbol.of(language)
    return declared_symbol(symbol) if symbol else name_box(quantity.id)


def name_box(name: str) -> Box:
    """Print a name of the declarations that has no symbol, for example that of a coordinate."""
    return Text("upright", name)


def column_box(column: str) -> Box:
    """Print the name of a catalogue's column."""
    return name_box(column)


def statement(quantity: Quantity, formula: Formula, symbols: Symbols, language: str) -> Box:
    """Lay out what a formula says about a quantity.

    Args:
        quantity: a computed one, a choice or a verdict.
        formula: its own, or another version of it.
        symbols: of every name in the formula.
        language: of the signs.

    Returns:
        `D = √(…)`; for a choice the bound, `D ≥ D_req`; for a verdict the condition.
    """
    said = typeset(formula.tree, symbols, language)
    own = symbol_of(quantity, language)
    if quantity.kind is Kind.VERDICT:
        return said
    if quantity.choice is not None:
        return Row((own, Text("relation", _ROUNDED[quantity.choice.rounding]), said))
    return equation((own, said))
