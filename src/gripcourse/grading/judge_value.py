"""Judging a computed value, a value picked from a table, or a verdict."""

import math
from collections.abc import Iterator
from typing import Final

from gripcourse.course.quantity import Kind
from gripcourse.formula.tree import Formula
from gripcourse.grading.comparison import Comparison, ExpectedRange, Judgement, conclude
from gripcourse.grading.judge_blank import judge_through_blank
from gripcourse.grading.judge_rough import judge_rough
from gripcourse.grading.model import Against, Outcome
from gripcourse.grading.other_versions import as_printed, read_otherwise
from gripcourse.grading.past_table import follows_from_the_last_row
from gripcourse.grading.shortened import judge_shortened
from gripcourse.slips.model import SlipId
from gripcourse.text.words import Message, message

_CORRECT: Final = message("Correct.")
_FOLLOWS: Final = message("Follows from your own earlier numbers.")
ANOTHER_READING: Final = message("Accepted: another reading of what is asked.")


def judge_value(comparison: Comparison) -> Judgement:
    """Judge an answer: reference, own inputs, other readings, errata; what earns most counts.

    Among those that earn the same, the first counts.
    """
    if not comparison.answer.unit_fits:
        return _judge_wrong_unit(comparison)
    best: Judgement | None = None
    for found in _matches(comparison):
        best = found if best is None or found.credit > best.credit else best
        if best.credit >= 1:
            break
    return (
        best
        or _judge_coarse(comparison)
        or _conclude(comparison, Outcome.WRONG, Against.NOTHING, 0.0, _wrong(comparison))
    )


def _judge_coarse(comparison: Comparison) -> Judgement | None:
    """Judge an answer by what rounding and shortened constants lead to; what earns most counts."""
    through_blank = judge_through_blank(comparison)
    if through_blank is not None and not through_blank.outcome.traits.coarse:
        return through_blank
    return judge_rough(comparison) or judge_shortened(comparison) or through_blank


def _matches(comparison: Comparison) -> Iterator[Judgement]:
    if comparison.fits(comparison.reference) and not _contradicts_itself(comparison):
        yield _conclude(comparison, Outcome.CORRECT, Against.REFERENCE, 1.0, _CORRECT)
    if (
        _follows(comparison, comparison.follows)
        or _follows_by_route(comparison)
        or _follows_in_size(comparison)
        or follows_from_the_last_row(comparison)
    ):
        yield _conclude(
            comparison,
            Outcome.CARRIED,
            Against.OWN_INPUTS,
            comparison.policy.carried_credit,
            _FOLLOWS,
        )
    yield from _alternatives(comparison)
    yield from _printed(comparison)


def _contradicts_itself(comparison: Comparison) -> bool:
    """Tell whether a verdict is not that of the numbers which the student compared.

    Right numbers may say the opposite near the edge, by digits that were kept and not typed.
    """
    if comparison.quantity.kind is not Kind.VERDICT or math.isnan(comparison.expected):
        return False
    return not _follows(comparison, comparison.follows) and not comparison.has_right_inputs


def _follows(comparison: Comparison, expected: ExpectedRange) -> bool:
    return comparison.fits(expected.nearest(comparison.value))


def _follows_by_route(comparison: Comparison) -> bool:
    """Tell whether an answer follows from the student's numbers by the other way to it."""
    route = comparison.quantity.route
    return route is not None and _follows(comparison, comparison.at_own(route))


def _follows_in_size(comparison: Comparison) -> bool:
    """Tell whether a length or a speed is written as positive where own numbers make it negative.

    After a mistake a difference may come out the wrong way round; a stroke has no sign.
    """
    lowest, follows = comparison.quantity.bounds[0], comparison.follows
    if lowest < 0 or not follows.value < 0:
        return False
    return _follows(comparison, ExpectedRange(-follows.value, -follows.high, -follows.low))


def _alternatives(comparison: Comparison) -> Iterator[Judgement]:
    for other in comparison.quantity.alternatives:
        if _fits_formula(comparison, other.formula):
            yield _conclude(
                comparison,
                Outcome.CORRECT,
                Against.ALTERNATIVE,
                1.0,
                ANOTHER_READING,
                remarks=(read_otherwise(other),),
            )


def _fits_formula(comparison: Comparison, formula: Formula) -> bool:
    return comparison.fits(comparison.at_reference(formula)) or _follows(
        comparison, comparison.at_own(formula)
    )


def _printed(comparison: Comparison) -> Iterator[Judgement]:
    for printed in comparison.quantity.as_printed:
        if printed.formula is None or not _fits_formula(comparison, printed.formula):
            continue
        remark = as_printed(printed)
        credit = comparison.policy.printed_credit
        if credit is None:
            said = message("As the source prints it; this course does not accept the erratum.")
            yield _conclude(
                comparison,
                Outcome.SLIP,
                Against.PRINTED,
                0.0,
                said,
                slip=SlipId.declared(printed.erratum),
                remarks=(remark,),
            )
        else:
            said = message("Accepted as the source prints it.")
            yield _conclude(
                comparison,
                Outcome.CORRECT,
                Against.PRINTED,
                credit,
                said,
                remarks=(remark,),
            )


def _judge_wrong_unit(comparison: Comparison) -> Judgement:
    """The right number with a unit that measures something else earns what the policy says."""
    if comparison.fits(comparison.reference) or _follows(comparison, comparison.follows):
        said = message("The number is right, the unit is not.")
        return _conclude(
            comparison, Outcome.WRONG, Against.NOTHING, comparison.policy.wrong_unit_credit, said
        )
    return _conclude(comparison, Outcome.WRONG, Against.NOTHING, 0.0, _wrong(comparison))


def _wrong(comparison: Comparison) -> Message:
    if comparison.quantity.kind is Kind.VERDICT:
        return message("Your numbers say the opposite.")
    if comparison.quantity.kind is Kind.PICK:
        return message("The table gives another value for your size.")
    return message("Does not follow from the formula with your numbers.")


def _conclude(  # noqa: PLR0913 (the parts of a conclusion)
    comparison: Comparison,
    outcome: Outcome,
    against: Against,
    credit: float,
    said: Message,
    *,
    slip: SlipId | None = None,
    remarks: tuple[Message, ...] = (),
) -> Judgement:
    target = comparison.expected
    reach = comparison.band_round(target) if math.isfinite(target) else 0.0
    return conclude(
        comparison, outcome, against, credit, said, reach=reach, slip=slip, remarks=remarks
    )
