"""Reading a formula that must be there."""

from gripcourse.course.declare_formulas import read_formula
from gripcourse.course.toml_table import Table
from gripcourse.formula.parse import parse
from gripcourse.formula.tree import Formula


def written_formula(table: Table, name: str) -> Formula:
    """Read the formula of a key; 0 where it cannot be read, which the table remembers."""
    return read_formula(table, name, {}) or Formula("0", parse("0"), {})
