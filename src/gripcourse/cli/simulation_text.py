"""What the commands that measure the grader print."""

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from gripcourse.cli.foreign_text import Layout, foreign_tables, percent, rate_cells, rates_table
from gripcourse.cli.table_layout import table_text
from gripcourse.text.words import Message, Words, counted, message

# `gripcourse --help` needs nothing of what is measured.
# ruff: noqa: PLC0415

if TYPE_CHECKING:
    from gripcourse.course.quantity import Tolerance
    from gripcourse.policy.model import Policy
    from gripcourse.simulation.confusion import GraderEvaluation
    from gripcourse.simulation.tolerance import AuditedBand, ToleranceAudit

_RATES = {
    "incidents": message("failures on our side"),
    "honest_refused": message("answers of honest students refused"),
    "slip_accepted": message("wrong methods accepted as right"),
    "slip_named": message("slips named as what they are"),
    "slip_misnamed": message("slips given another name"),
    "copy_flagged": message("copied works flagged"),
    "honest_flagged": message("other works flagged"),
    "source_flagged": message("works that were copied, flagged"),
    "slip_joined": message("wrong methods that cost together with another mistake"),
    "slip_tied": message("slips named together with a second one"),
    "other_refused": message("right answers of other students refused"),
    "follows_refused": message("right answers after something wrong refused"),
    "bare_unit_accepted": message("numbers in another unit accepted"),
    "wrong_unit_accepted": message("units that do not fit accepted"),
    "rounded_down_accepted": message("sizes rounded down accepted"),
    "copied_accepted": message("copied answers accepted"),
}

_WRONG = message(
    "“wrong” is the share of wrong methods that a band accepts, of students with the fewest "
    "figures, whose numbers leave the widest range; a wrong method that gives the right value is "
    "left out."
)

_SAID = {
    "correct": message("correct"),
    "carried": message("carried"),
    "named": message("named"),
    "tied": message("one of two"),
    "misnamed": message("another slip"),
    "rough": message("too rough"),
    "wrong": message("wrong"),
    "unsupported": message("not supported"),
    "blank": message("blank"),
    "unreadable": message("unreadable"),
    "not_judged": message("not judged"),
}
_STRATEGIES = {
    "least": message("the least that each cell lets through"),
    "zero": message("0 everywhere"),
    "hundredth": message("0.01 everywhere"),
    "one": message("1 everywhere"),
    "smallest": message("the smallest sizes, and yes"),
    "another": message("the numbers of another variant"),
    "blurred": message("right numbers, a third off"),
}
_DONE = {
    "right": message("the right method"),
    "follows": message("the right method after something wrong"),
    "slip": message("a wrong method"),
    "bare_unit": message("another unit, not named"),
    "wrong_unit": message("a unit that does not fit"),
    "rounded_down": message("a size rounded down"),
    "blank": message("blank"),
    "copied": message("copied"),
}


def simulated_text(count: int, out: Path, seconds: float, words: Words) -> str:
    """Return how many workbooks were written, where, and how fast."""
    return words.say(
        message(
            "Workbooks of virtual students in {folder}: {count}, {speed} per second.",
            count=count,
            folder=str(out),
            speed=float(f"{count / max(seconds, 1e-9):.3g}"),
        )
    )


def evaluation_text(
    found: "GraderEvaluation", policy: "Policy", words: Words, layout: Layout = table_text
) -> str:
    """Return the confusion table, the rates, and the share of each kind of slip that was named.

    Args:
        found: what was measured.
        policy: that was measured.
        words: language of the text.
        layout: of the tables.
    """
    lines = [
        words.say(message("Virtual students: {count}", count=found.students)),
        _confusion(found, words, layout),
        rates_table(found.rates, _RATES, words, layout),
        _kinds(found, policy, words, layout),
        *_strategies(found, words, layout),
        *foreign_tables(found.foreign, words, layout),
        words.say(
            counted(
                "Of {tried} places tried for slips {count} changes the answer too little for "
                "anybody to see.",
                "Of {tried} places tried for slips {count} change the answer too little for "
                "anybody to see.",
                found.hidden,
                tried=found.tried,
            )
        ),
    ]
    return "\n\n".join([*lines, *dict.fromkeys(found.incidents)])


def _confusion(found: "GraderEvaluation", words: Words, layout: Layout) -> str:
    from gripcourse.simulation.confusion import Said
    from gripcourse.simulation.model import ActionKind

    heads = (
        words.say(message("done \\ said")),
        *(words.say(_SAID[said.value]) for said in Said),
    )
    rows = [
        (
            words.say(_DONE[done.value]),
            *(str(found.table.get((done, said), 0) or "·") for said in Said),
        )
        for done in ActionKind
        if any(found.table.get((done, said)) for said in Said)
    ]
    return layout(heads, rows, set(range(1, len(heads))))


def _kinds(found: "GraderEvaluation", policy: "Policy", words: Words, layout: Layout) -> str:
    titles = {kind.value: slip.title for kind, slip in policy.slips.kinds.items()}
    own = words.say(message("declared beside the formula"))
    heads = (message("kind of slip"), message("named"), message("of"), message("share, %"))
    named = {
        kind: titles[kind].of(words.language) if kind in titles else own for kind in found.by_kind
    }
    rows = [(named[kind], *rate_cells(rate, words)[:3]) for kind, rate in found.by_kind.items()]
    return layout([words.say(one) for one in heads], rows, {1, 2, 3})


def _strategies(found: "GraderEvaluation", words: Words, layout: Layout) -> Iterator[str]:
    """Yield the table of what works earn that compute nothing, where some were judged."""
    if not found.strategies:
        return
    heads = (
        message("works that compute nothing"), message("works"), message("points, %"),
        message("at most, %"), message("required"), "",
    )  # fmt: skip
    allowed = found.earned_at_most
    rows = [
        (
            words.say(_STRATEGIES[one.strategy.value]),
            str(one.works),
            percent(one.mean, words),
            percent(one.most, words),
            f"≤ {percent(allowed, words)}",
            "✓" if one.mean <= allowed else "✗",
        )
        for one in found.strategies
    ]
    named = [one if isinstance(one, str) else words.say(one) for one in heads]
    yield layout(named, rows, {1, 2, 3, 4})


def audit_text(found: "ToleranceAudit", policy: "Policy", words: Words) -> str:
    """Return what a tolerance audit found: sums, what would change, and where steps are shaky."""
    heads = (
        message("quantity"), message("answers"), message("refused"), message("band now"),
        message("wrong, %"), message("proposed"), message("wrong, %"), message("spread, %"),
    )  # fmt: skip
    shown = [one for one in found.quantities if one.changes or one.tally.refused]
    shaky = [one for one in found.quantities if one.ill_conditioned]
    floors = ", ".join(
        f"{words.number(value)} {_unit(unit, words)}".strip()
        for unit, value in policy.floors.items()
    )
    answers = sum(one.tally.answers for one in found.quantities)
    lines = [
        _table(heads, [_audited(one, words) for one in shown], words)
        if shown
        else words.say(message("No band refuses anybody, and none needs to be changed.")),
        words.say(
            message(
                "{variants} variants answered in {ways} ways by honest students: {answers} answers "
                "to {quantities} computed quantities, {refused} refused with the bands that apply "
                "now.",
                variants=found.variants,
                ways=found.ways,
                answers=answers,
                quantities=len(found.quantities),
                refused=sum(one.tally.refused for one in found.quantities),
            )
        ),
        *([words.say(_WRONG)] if shown else []),
        words.say(message("Near zero an absolute floor counts instead: {floors}.", floors=floors)),
    ]
    if shaky:
        said = message(
            "Ill-conditioned: rounding earlier numbers moves these most: {names}.",
            names=", ".join(one.quantity.id for one in shaky),
        )
        lines.append(words.say(said))
    return "\n\n".join(lines)


def _table(heads: Sequence[Message], rows: Sequence[Sequence[str]], words: Words) -> str:
    named = [words.say(one) for one in heads]
    return table_text(named, rows, right=set(range(1, len(named))))


def _audited(one: "AuditedBand", words: Words) -> tuple[str, ...]:
    tally = one.tally
    return (
        one.quantity.id,
        str(tally.answers),
        str(tally.refused),
        _band(one.now, one, words),
        percent(tally.accepted / tally.slips, words) if tally.slips else "",
        _band(one.proposed, one, words) if one.changes else "",
        percent(one.price, words) if tally.slips else "",
        percent(tally.widest, words),
    )


def _band(tolerance: "Tolerance", one: "AuditedBand", words: Words) -> str:
    relative = f"{percent(tolerance.relative, words)} %"
    if not one.by_absolute:
        return relative
    unit = _unit(one.quantity.unit, words)
    return f"{relative}, {words.number(tolerance.absolute)} {unit}".strip()


def _unit(unit: str, words: Words) -> str:
    from gripcourse.text.units import unit_text

    return unit_text(unit, words.language)
