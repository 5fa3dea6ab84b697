"""Judging a computed value, a value picked from a table, or a verdict."""

import math
from collections.abc import Iterator

from gripcourse.course.model import Kind
from gripcourse.formula.tree import Formula
from gripcourse.grading.comparison import Judgement, Range, View
from gripcourse.grading.model import Against, Outcome
from gripcourse.policy.bands import band
from gripcourse.text.words import Message, message


def judge_value(view: View) -> Judgement:
    """Judge an answer: reference, own inputs, printed errata; what earns most counts.

    Among those that earn the same, the first counts.
    """
    if not view.answer.unit_fits:
        return _judge_wrong_unit(view)
    best: Judgement | None = None
    for found in _matches(view):
        best = found if best is None or found.credit > best.credit else best
        if best.credit >= 1:
            break
    return best or _conclude(view, Outcome.WRONG, Against.NOTHING, 0.0, _wrong(view))


def _matches(view: View) -> Iterator[Judgement]:
    if view.fits(view.reference):
        yield _conclude(view, Outcome.CORRECT, Against.REFERENCE, 1.0, message("Correct."))
    if _follows(view, view.follows):
        yield _conclude(
            view,
            Outcome.CARRIED,
            Against.OWN_INPUTS,
            view.policy.carried_credit,
            message("Follows from your own earlier numbers."),
        )
    yield from _printed(view)


def _follows(view: View, expected: Range) -> bool:
    return view.fits(expected.nearest(view.value))


def _fits_printed(view: View, formula: Formula) -> bool:
    return view.fits(view.at_reference(formula)) or _follows(view, view.at_own(formula))


def _printed(view: View) -> Iterator[Judgement]:
    for printed in view.quantity.as_printed:
        if printed.formula is None or not _fits_printed(view, printed.formula):
            continue
        remark = message(
            "As the source prints it (erratum {erratum}): {note}",
            erratum=printed.erratum,
            note=printed.note,
        )
        credit = view.policy.printed_credit
        if credit is None:
            said = message("As the source prints it; this course does not accept the erratum.")
            yield _conclude(
                view, Outcome.SLIP, Against.PRINTED, 0.0, said, slip=printed.erratum, remark=remark
            )
        else:
            said = message("Accepted as the source prints it.")
            yield _conclude(view, Outcome.CORRECT, Against.PRINTED, credit, said, remark=remark)


def _judge_wrong_unit(view: View) -> Judgement:
    """The right number with a unit that measures something else earns what the policy says."""
    if view.fits(view.reference) or _follows(view, view.follows):
        said = message("The number is right, the unit is not.")
        return _conclude(view, Outcome.WRONG, Against.NOTHING, view.policy.wrong_unit_credit, said)
    return _conclude(view, Outcome.WRONG, Against.NOTHING, 0.0, _wrong(view))


def _wrong(view: View) -> Message:
    if view.quantity.kind is Kind.VERDICT:
        return message("The numbers say the opposite.")
    if view.quantity.kind is Kind.PICK:
        return message("The table gives another value for your size.")
    return message("Does not follow from the formula with your numbers.")


def _conclude(  # noqa: PLR0913 (the parts of a conclusion)
    view: View,
    outcome: Outcome,
    against: Against,
    credit: float,
    said: Message,
    *,
    slip: str = "",
    remark: Message | None = None,
) -> Judgement:
    target = view.expected
    known = math.isfinite(target)
    return Judgement(
        outcome=outcome,
        against=against,
        expected=target if known else None,
        band=band(view.quantity, target, view.policy) if known else 0.0,
        credit=credit,
        slip=slip,
        tied=(),
        roots=(),
        message=said,
        remarks=() if remark is None else (remark,),
    )
