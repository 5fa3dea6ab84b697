"""What `solve` prints."""

import math
from typing import TYPE_CHECKING

from gripcourse.cli.table_layout import table_text
from gripcourse.course.quantity import Kind, Quantity
from gripcourse.text.units import unit_text
from gripcourse.text.words import Words, message

if TYPE_CHECKING:
    from gripcourse.usecases.solving.solve import SolvedVariant


def solution_table(solved: "SolvedVariant", words: Words) -> str:
    """Return the values of a solution as a table, by section."""
    plan = solved.plan
    rows = [
        (
            quantity.id,
            quantity.symbol.of(words.language),
            quantity.title.of(words.language),
            _value(quantity, solved.values[quantity.id], words),
            unit_text(quantity.unit, words.language),
        )
        for quantity in (*plan.constants, *plan.givens, *plan.answered)
    ]
    heads = ("id", "", plan.scheme.title.of(words.language), "", "")
    # A condition is a symbol too: long ones must leave the titles their room.
    table = table_text(heads, rows, right={3}, widest={1: 16})
    refused = (
        words.say(message("Not to be handed out as a variant: {reason}", reason=one))
        for one in solved.refused
    )
    return "\n".join((table, *refused))


def _value(quantity: Quantity, value: float, words: Words) -> str:
    if not math.isfinite(value):
        return "—"
    if quantity.kind is not Kind.VERDICT:
        return words.number(value)
    return words.say(message("yes") if value else message("no"))
