"""Reading a formula that must be there."""

from gripcourse.course.toml_table import Table
from gripcourse.formula.parse import FormulaFault, caret, parse
from gripcourse.formula.tree import Formula
from gripcourse.text.words import message


def written_formula(table: Table, name: str) -> Formula:
    """Read the formula of a key; 0 where it cannot be read, which the table remembers."""
    text = table.text(name)
    try:
        return Formula(text, parse(text), {})
    except FormulaFault as fault:
        table.add(name, fault.what, message("Correct the formula."), caret(text, fault.span))
        return Formula("0", parse("0"), {})
