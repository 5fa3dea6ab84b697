"""One answer in a student's report: its row, and below it the verdict, calculation and hints."""

import math
from collections.abc import Mapping
from dataclasses import dataclass

from gripcourse.course.quantity import Kind, Quantity
from gripcourse.documents.report.marked import MarkedItem, marked_item
from gripcourse.documents.report.root_causes import name_of
from gripcourse.documents.report.verdicts import AGAINST_WORDS
from gripcourse.documents.report.worked import entering_units, worked_line
from gripcourse.formula.boxes import Box
from gripcourse.grading.model import Against, Finding, Report
from gripcourse.policy.model import Policy, Reveal
from gripcourse.solver.plan import Plan
from gripcourse.text.amounts import NO_BREAK_SPACE, amount_text, points_text
from gripcourse.text.words import Words, message

_TYPED_LETTERS = 30  # of an unreadable cell; the list of what to mend shows more of it
_SAME = 1e-9  # two numbers that differ by rounding in the last bits only


@dataclass(frozen=True, slots=True)
class AnswerRow:
    """A row of a section's table, and what stands below it.

    Attributes:
        symbol, title: of the quantity.
        answer: the student's value with its unit, or what the cell shows.
        sign, verdict: the outcome.
        against: what it was judged against.
        roots: symbols of the wrong answers that it follows from.
        reference: the reference with its unit; empty where it is not revealed or there is none.
        points: `2 / 2`.
        style: class of the style sheet.
        message: the verdict in a sentence, empty for none.
        line: the calculation, None for none.
        units: symbol and unit of each of its numbers, empty where they carry their units.
        remarks: hints and notes.
        marked: what a person decided, None for nothing.
    """

    symbol: str
    title: str
    answer: str
    sign: str
    verdict: str
    against: str
    roots: tuple[str, ...]
    reference: str
    points: str
    style: str
    message: str
    line: Box | None
    units: tuple[tuple[str, str], ...]
    remarks: tuple[str, ...]
    marked: MarkedItem | None

    @property
    def detailed(self) -> bool:
        """Whether anything stands below the row."""
        return bool(self.message or self.line or self.remarks or self.marked)


def answer_row(
    finding: Finding, plan: Plan, own: Mapping[str, float], policy: Policy, words: Words
) -> AnswerRow:
    """Put one finding into words.

    Args:
        finding: the judgement of the answer.
        plan: declarations of the quantities.
        own: the student's own numbers and given values, from `own_numbers`.
        policy: whether the reference may be printed, and the rubrics.
        words: the reader's language.
    """
    quantity = plan.quantities[finding.quantity]
    reveal = policy.reveal is Reveal.REFERENCE
    line = _line(finding, plan, own, words, reveal=reveal)
    return AnswerRow(
        symbol=quantity.symbol.of(words.language),
        title=quantity.title.of(words.language),
        answer=answer_text(finding, quantity, words),
        sign=finding.outcome.traits.sign,
        verdict=words.say(finding.outcome.traits.word),
        against=_against(finding, words),
        roots=_roots(finding, plan, words),
        reference=value_text(finding.reference, quantity, words) if reveal else "",
        points=_points(finding, words),
        style=finding.outcome.traits.style,
        message=words.say(finding.message) if _spoken(finding) else "",
        line=line,
        units=entering_units(quantity, plan, words) if line is not None else (),
        remarks=_remarks(finding, words),
        marked=marked_item(finding, quantity, policy, words),
    )


def own_numbers(report: Report, plan: Plan) -> dict[str, float]:
    """Return what the student knows: given values and own answers, in declared units, by id.

    A finding's inputs can hold other numbers too, where an answer was missing or not carried on;
    those would tell the reference, so a worked line substitutes only what is in here.
    """
    answers = {one.quantity: one.given for one in report.findings if one.given is not None}
    inputs = {name: value for one in report.findings for name, value in one.inputs.items()}
    known = {
        name: value
        for name, value in inputs.items()
        if name in plan.quantities and plan.quantities[name].kind in {Kind.GIVEN, Kind.CONSTANT}
    }
    return known | answers


def is_unreadable(finding: Finding) -> bool:
    """Whether the cell holds something, but nothing that could be judged."""
    return finding.outcome.traits.missing and finding.outcome.traits.typed


def answer_text(finding: Finding, quantity: Quantity, words: Words) -> str:
    """Write what the student answered."""
    if finding.given is None:
        return shortened(finding.typed, _TYPED_LETTERS) or "—"
    return value_text(finding.given, quantity, words)


def shortened(typed: str, letters: int) -> str:
    """Cut a text of unknown length, with an ellipsis where something is missing."""
    return typed if len(typed) <= letters else f"{typed[: letters - 1]}…"


def value_text(value: float | None, quantity: Quantity, words: Words) -> str:
    """Write a value of a quantity in its declared unit; yes or no for a verdict."""
    if value is None or math.isnan(value):
        return "—"
    if quantity.kind is Kind.VERDICT:
        return words.say(message("yes") if value else message("no"))
    return amount_text(value, quantity.unit, words)


def _against(finding: Finding, words: Words) -> str:
    said = AGAINST_WORDS.get(finding.against)
    return "—" if said is None else words.say(said)


def _roots(finding: Finding, plan: Plan, words: Words) -> tuple[str, ...]:
    if not finding.outcome.traits.follows:
        return ()
    return tuple(name_of(root, plan, words) for root in finding.roots)


def _line(
    finding: Finding, plan: Plan, own: Mapping[str, float], words: Words, *, reveal: bool
) -> Box | None:
    if finding.outcome.traits.equals_reference or finding.is_open:
        return None
    if finding.outcome.traits.missing and not reveal:
        return None  # until the solution is published, the formulas are the student's to find
    quantity = plan.quantities[finding.quantity]
    shown = finding.inputs if reveal else _only_own(finding.inputs, own)
    return worked_line(quantity, shown, _result(finding, quantity, reveal=reveal), plan, words)


def _result(finding: Finding, quantity: Quantity, *, reveal: bool) -> float | None:
    """Return what may stand at the end of the calculation."""
    if finding.outcome.traits.right:
        # What followed from the student's numbers is no secret: the student has it already.
        if quantity.kind is Kind.CHOICE:
            # Of several sound decisions the student's own is shown, not the smallest.
            return finding.given
        return finding.expected if reveal or _follows(finding) else None
    return finding.expected if reveal else None


def _follows(finding: Finding) -> bool:
    """Whether the answer meets what its formula gives at the student's own numbers.

    What follows from a slip in a blank step, or from a number used wrongly, does not: there the
    formula's value is another one than the student's, and may be the reference.
    """
    if finding.given is None or finding.expected is None:
        return False
    low = finding.expected if finding.low is None else finding.low
    high = finding.expected if finding.high is None else finding.high
    nearest = min(max(finding.given, low), high)
    # A relative band grows with the point that it is laid round.
    grown = max(1.0, abs(nearest / finding.expected)) if finding.expected else 1.0
    return abs(finding.given - nearest) <= finding.band * grown + _SAME * abs(nearest)


def _only_own(inputs: Mapping[str, float], own: Mapping[str, float]) -> dict[str, float]:
    return {
        name: value
        for name, value in inputs.items()
        if name in own and math.isclose(value, own[name], rel_tol=_SAME)
    }


def _spoken(finding: Finding) -> bool:
    """Whether the verdict's sentence says more than its word and its points."""
    traits = finding.outcome.traits
    if traits.right:
        explained = traits.follows and not _follows(finding)
        costs = finding.points < finding.max_points
        return costs or explained or finding.against in {Against.PRINTED, Against.ALTERNATIVE}
    return not traits.said_elsewhere


def _remarks(finding: Finding, words: Words) -> tuple[str, ...]:
    if is_unreadable(finding):
        return ()  # the list of what to do next has them
    return tuple(words.say(remark) for remark in finding.remarks)


def _points(finding: Finding, words: Words) -> str:
    possible = points_text(finding.max_points, words)
    earned = "…" if finding.is_open else points_text(finding.points, words)
    return f"{earned}{NO_BREAK_SPACE}/{NO_BREAK_SPACE}{possible}"
