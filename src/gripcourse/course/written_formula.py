"""Reading the formula of a key."""

from collections.abc import Mapping

from gripcourse.course.toml_table import Table
from gripcourse.formula.parse import FormulaFault, caret, formula_of
from gripcourse.formula.tree import Formula
from gripcourse.text.words import message


def read_formula(table: Table, name: str, units: Mapping[str, str]) -> Formula | None:
    """Read a formula; None (and a problem) where it is none."""
    text = table.text(name)
    if not text.strip():
        if table.values.get(name) == text:  # else it is missing, or no text, which is said
            table.add(name, message("The formula is empty."), message("Write the formula."))
        return None
    try:
        return formula_of(text, dict(units))
    except FormulaFault as fault:
        table.add(name, fault.what, message("Correct the formula."), caret(text, fault.span))
        return None


def written_formula(table: Table, name: str) -> Formula:
    """Read the formula of a key; 0 where it cannot be read, which the table remembers."""
    return read_formula(table, name, {}) or formula_of("0", {})
