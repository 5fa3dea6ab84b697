"""The keys of a file in `variants/spaces`."""

from typing import Final

from gripcourse.course.quantity_keys import RANGE
from gripcourse.course.shape import Shape, by_name, number, strings, table, tables, text, texts

SPACE: Final = Shape(
    {
        "scheme": text("The scheme that it is about.", required=True),
        "weight": number("Share of its variants among the schemes; 1 where nothing is written."),
        "options": by_name(
            "Choices that are mixed, by option; all where nothing is written.",
            strings("Ids of choices."),
        ),
        "given": by_name(
            "Ranges that replace those beside the givens, by id.", table("A range.", RANGE)
        ),
        "constraint": tables(
            "Conditions that each variant satisfies.",
            {
                "formula": text("A comparison of quantities.", required=True),
                "title": texts("What it asks for, as a sentence that whoever draws reads."),
                "evaluated_in": by_name(
                    "The unit in which a name enters.", text("A unit.", required=True)
                ),
            },
        ),
    }
)
