"""Rates as tables, and what the second generator of virtual students measured."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, TypeAlias

from gripcourse.text.words import Message, Words, message

if TYPE_CHECKING:
    from gripcourse.simulation.foreign.measures import ForeignEvaluation
    from gripcourse.simulation.rates import Rate

Layout: TypeAlias = Callable[[Sequence[str], Sequence[Sequence[str]], set[int]], str]
"""Lays out a table: its heads, its rows, and the columns that stand at the right."""

_RATES = {
    "incidents": message("failures on our side"),
    "honest_refused": message("answers of honest students refused"),
    "coarse_refused": message("refused of those who round far or take g = 10"),
    "charged_once": message("one mistake charged once"),
    "charged_once_of_spoiling": message("the same, where a number spoils several answers"),
    "coarse_charged_once": message("the same of those who round far or take g = 10"),
    "uncharged_blank": message("mistakes in a step left blank, which cost that step alone"),
    "uncharged_sound": message("mistakes that come to a size or a way that is right too"),
    "uncharged_rough": message("mistakes that come to a rounded number, and cost as that does"),
    "uncharged_paid": message("wrong numbers accepted as right"),
    "misnamed": message("works with a mistake given another name"),
    "blamed": message("works in which another quantity is blamed"),
    "named": message("mistakes named, where there is a word for them"),
    "copies_flagged": message("copies flagged"),
    "moved_copies_flagged": message("copies with every number moved by up to 1 % flagged"),
    "mixtures_flagged": message("mixtures of two neighbours flagged"),
    "stolen_flagged": message("stolen workbooks flagged"),
    "own_flagged": message("works of one's own flagged"),
    "owners_named": message("owners of stolen workbooks named as owners"),
}

_MISTAKES = {
    "misread_digits": message("digits of a given number misread"),
    "misread_row": message("the given number of the next row"),
    "mistyped": message("digits of an answer mistyped"),
    "miscopied": message("an answer carried on with wrong digits"),
    "wrong_cell": message("the neighbouring answer in the cell"),
    "degrees": message("degrees taken for radians"),
    "efficiency": message("multiplied by the efficiency, or without it"),
    "factor": message("a number of the formula forgotten"),
    "power": message("a square or a root forgotten"),
    "sign": message("a wrong sign"),
    "radius": message("radius and diameter"),
    "range_end": message("the wrong end of a range"),
    "mean": message("the mean for the greatest"),
    "table_row": message("the neighbouring row of a table"),
    "function": message("another function of the angle"),
    "ratio": message("the ratio for its angle"),
    "brackets": message("brackets not keyed in"),
    "unit": message("an answer in another unit"),
    "input_unit": message("an input in another unit"),
}


def markdown_table(heads: Sequence[str], rows: Sequence[Sequence[str]], right: set[int]) -> str:
    """Lay out a table for a Markdown file; columns in `right` stand at the right."""
    rule = ["---:" if number in right else "---" for number in range(len(heads))]
    lines = ([one.replace("|", "\\|") for one in row] for row in (heads, rule, *rows))
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def rates_table(
    rates: Mapping[str, "Rate"], titles: Mapping[str, Message], words: Words, layout: Layout
) -> str:
    """Return rates with their intervals and what is required of them."""
    heads = (
        message("measured"), message("count"), message("of"), message("share, %"),
        message("95 % interval"), message("required"),
    )  # fmt: skip
    rows = [
        (
            words.say(titles[name]),
            *rate_cells(rate, words),
            ("✓" if rate.reached else "✗") if rate.required else "",
        )
        for name, rate in rates.items()
    ]
    return layout([*map(words.say, heads), ""], rows, {1, 2, 3, 4, 5})


def foreign_tables(
    found: "ForeignEvaluation | None", words: Words, layout: Layout
) -> Iterator[str]:
    """Yield what the second generator measured: rates, then each kind of mistake."""
    if found is None:
        return
    yield words.say(
        message(
            "{count} students of the second generator: their mistakes are not the grader's, their "
            "arithmetic is not the engine's",
            count=found.students,
        )
    )
    yield rates_table(found.rates, _RATES, words, layout)
    heads = (
        message("mistake"), message("works"), message("charged once, %"), message("named, %"),
        message("another name, %"), message("another quantity blamed, %"),
    )  # fmt: skip
    rows = [
        (
            words.say(_MISTAKES[kind.value]),
            str(one.once.total),
            percent(one.once.share, words),
            "" if one.named is None else percent(one.named.share, words),
            percent(one.misnamed.share, words),
            percent(one.blamed.share, words),
        )
        for kind, one in found.by_kind.items()
    ]
    yield layout([words.say(one) for one in heads], rows, {1, 2, 3, 4, 5})


def rate_cells(rate: "Rate", words: Words) -> tuple[str, ...]:
    """Return a rate as cells of a table: count, of, share, interval, what is required."""
    low, high = rate.interval
    return (
        str(rate.hits),
        str(rate.total),
        percent(rate.share, words) if rate.total else "",
        f"{percent(low, words)} … {percent(high, words)}",
        "".join(_limits(rate, words)),
    )


def percent(share: float, words: Words) -> str:
    """Return a share in per cent, three figures."""
    return words.number(100 * share, 3)


def _limits(rate: "Rate", words: Words) -> Iterator[str]:
    if rate.at_most is not None:
        yield f"≤ {percent(rate.at_most, words)}"
    if rate.at_least is not None:
        yield f"≥ {percent(rate.at_least, words)}"
