"""What mistakes cost over a table, and which rules let guesses pay, as a terminal shows it."""

from typing import TYPE_CHECKING

from gripcourse.cli.problems import spoken
from gripcourse.cli.text import table_text
from gripcourse.text.words import Words, message

if TYPE_CHECKING:
    from gripcourse.usecases.tolerance import Paying


def paying_text(found: "Paying", words: Words) -> str:
    """Return the table of main results with what a mistake costs, and the rules to be mended."""
    heads = (
        message("a mistake in"), message("section"), message("variants"), message("costs at least"),
        message("at most"), message("times"),
    )  # fmt: skip
    rows = [
        (
            one.quantity,
            one.section,
            str(one.variants),
            words.number(one.least),
            words.number(one.most),
            words.number(one.apart, 3),
        )
        for one in found.costs
    ]
    lines = [
        words.say(message("Points that a mistake in a main result costs over the issued table:")),
        table_text([words.say(one) for one in heads], rows, right={2, 3, 4, 5}),
        *(spoken(one, words) for one in found.problems),
    ]
    return "\n\n".join(lines)
