"""What the commands that measure the grader print."""

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from gripcourse.cli_text import table
from gripcourse.words import Words, message

# `gripcourse --help` needs nothing of what is measured.
# ruff: noqa: PLC0415

if TYPE_CHECKING:
    from gripcourse.virtual.confusion import Evaluation
    from gripcourse.virtual.rates import Rate

_RATES = {
    "incidents": message("failures on our side"),
    "honest_refused": message("answers of honest students refused"),
    "slip_accepted": message("wrong methods accepted as right"),
    "slip_named": message("slips named as what they are"),
    "slip_misnamed": message("slips given another name"),
    "copy_flagged": message("copied works flagged"),
    "honest_flagged": message("other works flagged"),
    "source_flagged": message("works that were copied, flagged"),
    "slip_tied": message("slips named together with a second one"),
    "other_refused": message("right answers of other students refused"),
    "follows_refused": message("right answers after something wrong refused"),
    "bare_unit_accepted": message("numbers in another unit accepted"),
    "wrong_unit_accepted": message("units that do not fit accepted"),
    "rounded_down_accepted": message("sizes rounded down accepted"),
    "copied_accepted": message("copied answers accepted"),
}


def simulated_text(count: int, out: Path, seconds: float, words: Words) -> str:
    """Return how many workbooks were written, where, and how fast."""
    return words.say(
        message(
            "{count} workbooks of virtual students are in {folder}: {speed} per second.",
            count=count,
            folder=str(out),
            speed=float(f"{count / max(seconds, 1e-9):.3g}"),
        )
    )


def evaluation_text(found: "Evaluation", words: Words) -> str:
    """Return the confusion table, the rates, and the share of each kind of slip that was named."""
    lines = [
        words.say(message("{count} virtual students", count=found.students)),
        _confusion(found, words),
        _rates(found, words),
        _kinds(found, words),
        words.say(
            message(
                "Of {tried} places tried for slips {hidden} change the answer too little for "
                "anybody to see.",
                tried=found.tried,
                hidden=found.hidden,
            )
        ),
    ]
    return "\n\n".join([*lines, *dict.fromkeys(found.incidents)])


def _confusion(found: "Evaluation", words: Words) -> str:
    from gripcourse.virtual.confusion import Said
    from gripcourse.virtual.model import Done

    heads = (words.say(message("done \\ said")), *(str(said) for said in Said))
    rows = [
        (str(done), *(str(found.table.get((done, said), 0) or "·") for said in Said))
        for done in Done
        if any(found.table.get((done, said)) for said in Said)
    ]
    return table(heads, rows, right=set(range(1, len(heads))))


def _rates(found: "Evaluation", words: Words) -> str:
    heads = (
        message("measured"), message("count"), message("of"), message("share, %"),
        message("95 % interval"), message("required"), "",
    )  # fmt: skip
    rows = [
        (words.say(_RATES[name]), *_numbers(rate, words), "✓" if rate.reached else "✗")
        if rate.required
        else (words.say(_RATES[name]), *_numbers(rate, words), "")
        for name, rate in found.rates.items()
    ]
    named = [one if isinstance(one, str) else words.say(one) for one in heads]
    return table(named, rows, right={1, 2, 3, 4, 5})


def _kinds(found: "Evaluation", words: Words) -> str:
    heads = (message("kind of slip"), message("named"), message("of"), message("share, %"))
    rows = [(kind, *list(_numbers(rate, words))[:3]) for kind, rate in found.by_kind.items()]
    return table([words.say(one) for one in heads], rows, right={1, 2, 3})


def _numbers(rate: "Rate", words: Words) -> Iterator[str]:
    low, high = rate.interval
    yield str(rate.hits)
    yield str(rate.total)
    yield _percent(rate.share, words)
    yield f"{_percent(low, words)} … {_percent(high, words)}"
    yield "".join(_limits(rate, words))


def _limits(rate: "Rate", words: Words) -> Iterable[str]:
    if rate.at_most is not None:
        yield f"≤ {_percent(rate.at_most, words)}"
    if rate.at_least is not None:
        yield f"≥ {_percent(rate.at_least, words)}"


def _percent(share: float, words: Words) -> str:
    return words.number(100 * share, 3)
