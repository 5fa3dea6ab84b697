"""What counts as the answer of a part of a Moodle question: numbers, shares and comments.

A part counts by its own number alone, for Moodle knows no consequences. So what earns something
whatever else was answered stands here: the reference, other sound sizes of a decision, other honest
readings, and what a source prints wrongly, where the policy accepts it.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from decimal import Decimal
from html import escape
from typing import Final

from gripcourse.course.quantity import Kind, Quantity
from gripcourse.formula.evaluate import evaluate_number
from gripcourse.formula.tree import Formula
from gripcourse.grading.choices import printed_choice, same_size, sizes_at, sizes_by
from gripcourse.grading.other_versions import as_printed, read_otherwise
from gripcourse.policy.bands import band
from gripcourse.policy.model import Policy
from gripcourse.solver.numbers import PlainNumbers
from gripcourse.solver.plan import Plan
from gripcourse.text.units import factor, unit_text
from gripcourse.text.words import Message, Words, message

_DIGITS: Final = 10  # significant
_LEAST: Final = 1e-9  # a tolerance of zero would refuse what floating point rounds
# Within a part these end an answer, and a brace in a text may begin one: as entities they are text.
_SIGNS: Final = str.maketrans({"{": "&#123;", "}": "&#125;", "~": "&#126;"})


@dataclass(frozen=True, slots=True)
class _AlsoRight:
    """What counts besides the reference: SI, the share that it earns, and what is said of it."""

    value: float
    share: float
    remark: Message | None = None


def as_text(text: str) -> str:
    """Return a text as HTML of which nothing is taken for a part of the question."""
    return escape(text).translate(_SIGNS)


def _comment(text: str) -> str:
    """Return a text for a comment: Moodle reads its entities once, and then it as HTML."""
    return as_text(escape(text, quote=False))


def answer_part(
    quantity: Quantity, plan: Plan, numbers: PlainNumbers, policy: Policy, words: Words
) -> str:
    """Return an answer as Moodle's text holds it: kind, what is right and how nearly.

    Args:
        quantity: that is asked.
        plan: of the variant.
        numbers: of the reference.
        policy: tolerances, and what an erratum earns.
        words: the language of the question.
    """
    reference = numbers.values[quantity.id]
    if quantity.kind is Kind.VERDICT:
        yes, no = words.say(message("yes")), words.say(message("no"))
        right, wrong = (yes, no) if reference else (no, yes)
        return f"MC:={right}~{wrong}"
    unit = factor(quantity.unit)
    goes_on = any(quantity.id in plan.inputs[one.id] for one in plan.answered)
    alternatives = []
    for other in _others(quantity, plan, numbers, policy):
        said = [] if other.remark is None else [words.say(other.remark)]
        if goes_on:
            said.append(_going_on(reference / unit, quantity, words, sound=other.remark is None))
        comment = f"#{'<br>'.join(map(_comment, said))}" if said else ""
        number = _number(quantity, other.value / unit, policy)
        alternatives.append(f"~%{_plain(100 * other.share)}%{number}{comment}")
    return f"NM:={_number(quantity, reference / unit, policy)}{''.join(alternatives)}"


def _going_on(reference: float, quantity: Quantity, words: Words, *, sound: bool) -> str:
    value = f"{_plain(reference)} {unit_text(quantity.unit, words.language)}".strip()
    told = (
        message("Sound as well; what follows goes on with {value}.", value=value)
        if sound
        else message("What follows goes on with {value}.", value=value)
    )
    return words.say(told)


def _others(
    quantity: Quantity, plan: Plan, numbers: PlainNumbers, policy: Policy
) -> Iterator[_AlsoRight]:
    """Yield what else counts, each number once; what earns most comes first."""
    told = [numbers.values[quantity.id]]
    for one in (
        *_sound_sizes(quantity, plan, numbers),
        *_other_readings(quantity, plan, numbers),
        *_as_printed(quantity, plan, numbers, policy),
    ):
        if math.isfinite(one.value) and not any(same_size(one.value, known) for known in told):
            told.append(one.value)
            yield one


def _sound_sizes(quantity: Quantity, plan: Plan, numbers: PlainNumbers) -> Iterator[_AlsoRight]:
    yield from (_AlsoRight(size, 1.0) for size in sizes_at(plan, quantity.id, numbers))


def _other_readings(quantity: Quantity, plan: Plan, numbers: PlainNumbers) -> Iterator[_AlsoRight]:
    for other in quantity.alternatives:
        values = (
            [_value(other.formula, quantity, plan, numbers)]
            if quantity.choice is None
            else sizes_by(plan, quantity.id, other.formula, numbers)
        )
        yield from (_AlsoRight(value, 1.0, read_otherwise(other)) for value in values)


def _as_printed(
    quantity: Quantity, plan: Plan, numbers: PlainNumbers, policy: Policy
) -> Iterator[_AlsoRight]:
    share, formula = policy.printed_credit, plan.reference_formula(quantity.id)
    if not share:
        return
    for printed in quantity.as_printed:
        if printed.formula is not None:
            value = _value(printed.formula, quantity, plan, numbers)
            yield _AlsoRight(value, share, as_printed(printed))
        elif formula is not None:
            required = _value(formula, quantity, plan, numbers)
            size = printed_choice(plan, quantity, required)
            if size is not None:
                yield _AlsoRight(size, share, as_printed(printed))


def _value(formula: Formula, quantity: Quantity, plan: Plan, numbers: PlainNumbers) -> float:
    return evaluate_number(formula, quantity.unit, numbers.values, plan.columns)


def _number(quantity: Quantity, value: float, policy: Policy) -> str:
    """Return a number and how far from it an answer may be."""
    tolerance = max(band(quantity, value, policy), _LEAST * abs(value))
    return f"{_plain(value)}:{_plain(tolerance)}"


def _plain(value: float) -> str:
    """Write a number with a point and without an exponent."""
    return f"{Decimal(f'{value:.{_DIGITS}g}'):f}"
