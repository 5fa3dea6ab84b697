"""The words of `validate --prove`: a line for each proof, what stays open, what they come to."""

from collections import Counter
from collections.abc import Sequence

from gripcourse.proofs.model import ProofKind, ProofResult, Verdict
from gripcourse.text.words import Message, Words, message

_KINDS = {
    ProofKind.EXAMPLE: message("worked example"),
    ProofKind.PUBLISHED_CASE: message("published case"),
    ProofKind.VIRTUAL_WORK: message("virtual work"),
    ProofKind.MOTION: message("motion"),
    ProofKind.TRAVEL: message("travel"),
    ProofKind.INTERFERENCE: message("interference"),
    ProofKind.IDENTITY: message("identity"),
    ProofKind.INEQUALITY: message("inequality"),
    ProofKind.EQUILIBRIUM: message("equilibrium"),
    ProofKind.OPERATORS: message("flipped operators"),
    ProofKind.WRONG_METHODS: message("slips and errata"),
    ProofKind.PRINTED_LINES: message("printed lines"),
    ProofKind.WORKBOOKS: message("key workbooks"),
}
_VERDICTS = {
    Verdict.HOLDS: message("holds"),
    Verdict.FAILS: message("fails"),
    Verdict.OPEN: message("open"),
}


def result_line(result: ProofResult, words: Words) -> str:
    """Say how one proof ended, on one line."""
    kind, verdict = _KINDS[result.proof.kind], _VERDICTS[result.verdict]
    if result.verdict is Verdict.OPEN and result.note is not None:
        return words.say(
            message(
                "{verdict}: {kind}, {name}: {note}",
                verdict=verdict,
                kind=kind,
                name=result.proof.name,
                note=result.note,
            )
        )
    return words.say(
        message(
            "{verdict}: {kind}, {name} ({compared} compared)",
            verdict=verdict,
            kind=kind,
            name=result.proof.name,
            compared=result.compared,
        )
    )


def open_text(results: Sequence[ProofResult], words: Words) -> str:
    """List what a person has to look at, though nothing failed; empty where there is nothing."""
    lines = [
        problem.say(words)
        for result in results
        if result.verdict is Verdict.OPEN
        for problem in result.problems
    ]
    return "\n".join(lines)


def summary_text(results: Sequence[ProofResult], words: Words) -> str:
    """Say what all proofs come to."""
    counted = Counter(one.verdict for one in results)
    return words.say(_summary(counted))


def _summary(counted: Counter[Verdict]) -> Message:
    return message(
        "Proofs: {holds} hold, {fails} fail, {left} are open.",
        holds=counted[Verdict.HOLDS],
        fails=counted[Verdict.FAILS],
        left=counted[Verdict.OPEN],
    )
