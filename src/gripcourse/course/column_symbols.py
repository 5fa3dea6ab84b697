"""What stands for the column of a catalogue where a printed formula reads a value of it.

A value that is all there is to a quantity has the quantity's symbol: `b(D)`. Inside a formula it
has the symbol of the quantity that is read from that column, where there is one, else the heading
that students see above the column, so that nobody takes it for the result.
"""

from collections.abc import Iterator, Mapping
from typing import TypeGuard

from gripcourse.course.model import Catalogue
from gripcourse.course.quantity import Quantity
from gripcourse.formula.boxes import Box, Row, Script, Text, reading
from gripcourse.formula.functions import FUNCTIONS
from gripcourse.formula.prose import subscript_runs
from gripcourse.formula.tree import Call, Node, walk
from gripcourse.formula.typeset import symbol_box
from gripcourse.text.words import Words, message


def reads_value(node: Node) -> TypeGuard[Call]:
    """Tell whether a node does nothing but read a value of a table, at a row or between two."""
    return isinstance(node, Call) and FUNCTIONS[node.function].form is reading


def column_symbols(
    node: Node,
    own: Quantity | None,
    quantities: Mapping[str, Quantity],
    catalogues: Mapping[str, Catalogue],
    language: str,
) -> dict[str, Box]:
    """Return what stands for each column that an expression reads values of.

    Args:
        node: the expression.
        own: the quantity that it computes; None for a part of a formula.
        quantities: declarations of the composition, by id.
        catalogues: of the course, by id.
        language: of the symbols.
    """
    found: dict[str, Box] = {}
    for call in _readings(node):
        reader = own if call is node else _reader(call.column, quantities)
        found[call.column or ""] = (
            _heading_box(call.column or "", catalogues, language)
            if reader is None
            else symbol_box(reader.symbol.of(language))
        )
    return found


def _readings(node: Node) -> Iterator[Call]:
    return (one for one in walk(node) if reads_value(one))


def readers_of(node: Node, quantities: Mapping[str, Quantity]) -> dict[str, Quantity]:
    """Return by id the quantities that read a column that an expression reads too."""
    columns = {call.column for call in _readings(node)}
    return {
        name: one for name, one in quantities.items() if columns and _column_read(one) in columns
    }


def _reader(column: str | None, quantities: Mapping[str, Quantity]) -> Quantity | None:
    """Return the only quantity whose formula is a reading of a column."""
    readers = [one for one in quantities.values() if _column_read(one) == column]
    return readers[0] if len(readers) == 1 else None


def _column_read(quantity: Quantity) -> str | None:
    """Return the column that a quantity is a reading of; empty where it is none."""
    formula = quantity.formula
    if formula is None or quantity.choice is not None or not reads_value(formula.tree):
        return ""
    return formula.tree.column


def _heading_box(column: str, catalogues: Mapping[str, Catalogue], language: str) -> Box:
    """Print what students read above a column, in quotation marks; of one they do not see its id.

    What follows the first underscore of an id is a subscript.
    """
    catalogue, _, name = column.partition(".")
    heading = catalogues[catalogue].headings.get(name) if catalogue in catalogues else None
    if heading is None:
        return _name_box(column)
    quoted = Words(language).say(message("“{title}”", title=heading.of(language)))
    found: list[Box] = []
    for run, below in subscript_runs(quoted):
        box = Text("upright", run)
        found.append(Script(found.pop(), box, None) if below else box)
    return found[0] if len(found) == 1 else Row(tuple(found))


def _name_box(column: str) -> Box:
    base, _, sub = column.rpartition(".")[2].partition("_")
    body = Text("upright", base)
    return Script(body, Text("upright", sub.replace("_", " ")), None) if sub else body
