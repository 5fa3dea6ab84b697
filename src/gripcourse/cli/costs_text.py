"""What mistakes cost over a table, and which rules let guesses pay, as a terminal shows it."""

from typing import TYPE_CHECKING

from gripcourse.cli.problems import spoken
from gripcourse.cli.table_layout import table_text
from gripcourse.text.words import Words, message

if TYPE_CHECKING:
    from collections.abc import Sequence

    from gripcourse.usecases.measuring.tolerance import Paying
    from gripcourse.variants.pays import MistakeCost


def paying_text(found: "Paying", words: Words) -> str:
    """Return tables of what mistakes cost, main results first, and the rules to be corrected."""
    lines: list[str] = []
    if found.costs:
        said = message("Points that a mistake in a main result costs over the issued table:")
        lines += [words.say(said), _costs_text(found.costs, words)]
    if found.uneven:
        said = message("Of other answers, what costs more than 1.5 times as much in some variants:")
        lines += [words.say(said), _costs_text(found.uneven, words)]
    return "\n\n".join((*lines, *(spoken(one, words) for one in found.problems)))


def _costs_text(costs: "Sequence[MistakeCost]", words: Words) -> str:
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
        for one in costs
    ]
    return table_text([words.say(one) for one in heads], rows, right={2, 3, 4, 5})
