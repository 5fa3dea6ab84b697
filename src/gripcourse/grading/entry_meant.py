"""Sizes and numbers of tables that were written in another unit than the table's.

185 l/min are 3.0833… l/s: whoever writes that down has to round, and nobody means a number that
the table does not have. So the entry is taken that the typed figures stand for.
"""

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gripcourse.course.quantity import Kind, Quantity
from gripcourse.formula.tree import Call, Node
from gripcourse.grading.choices import same_size
from gripcourse.solver.plan import Plan
from gripcourse.submission.model import Answer, Submission
from gripcourse.text.units import factor, unit_text
from gripcourse.text.words import LANGUAGES, Texts, message

_ALIKE: Final = 1e-9
# Both ends of what was typed are other numbers when written down.
_WITHIN: Final = 1 - 1e-6


def with_entries_meant(submission: Submission, plan: Plan) -> Submission:
    """Take the entries that numbers in other units stand for.

    Args:
        submission: as it was read.
        plan: of the variant, for the tables.

    Returns:
        The submission with these entries as answers, each with a remark.
    """
    found = {
        one.id: meant
        for one in plan.answered
        if (answer := submission.answers.get(one.id)) is not None
        and (meant := _entry_meant(plan, one, answer)) is not None
    }
    return replace(submission, answers={**submission.answers, **found}) if found else submission


def _entry_meant(plan: Plan, quantity: Quantity, answer: Answer) -> Answer | None:
    """Return the answer with the only entry that rounds to it; None where it stays as it is."""
    if answer.value is None or not answer.unit_fits or not _loses_digits(quantity, answer):
        return None
    entries = _entries(plan, quantity) / factor(quantity.unit)
    if any(same_size(answer.value, one) for one in entries.tolist()):
        return None
    near = entries[np.abs(entries - answer.value) < answer.half_unit * _WITHIN]
    if len(near) != 1:
        return None
    value = float(f"{near[0]:.14g}")
    remark = message(
        "It was taken for {value} {unit}, the only entry of the table that rounds to what was "
        "typed.",
        value=value,
        unit=Texts({language: unit_text(quantity.unit, language) for language in LANGUAGES}),
    )
    return replace(answer, value=value, remarks=(*answer.remarks, remark))


def _loses_digits(quantity: Quantity, answer: Answer) -> bool:
    """Tell whether a table's number is another one in the typed unit, with other digits.

    Millimetres in metres have the same digits: 6 cm are 60 mm and no rounded 63.
    """
    if answer.unit in {"", quantity.unit}:
        return False
    decades = math.log10(factor(answer.unit) / factor(quantity.unit))
    return not math.isclose(decades, round(decades), abs_tol=_ALIKE)


def _entries(plan: Plan, quantity: Quantity) -> NDArray[np.float64]:
    """Return the numbers, SI, of which a quantity is one, each once; none where it may be any."""
    if quantity.choice is not None:
        names = (quantity.choice.column, *quantity.choice.also)
        return np.unique(np.concatenate([plan.columns[one].sizes for one in names]))
    if quantity.kind is Kind.PICK and quantity.exact and quantity.formula is not None:
        columns = (plan.columns[one].values for one in _read_from(quantity.formula.tree))
        return np.unique(np.concatenate([*columns, np.empty(0)]))
    return np.empty(0)


def _read_from(node: Node) -> Iterator[str]:
    """Yield the columns that an entry may stand in."""
    match node:
        case Call(_, _, str(column)):
            yield column
        case Call(_, arguments):
            for one in arguments:
                yield from _read_from(one)
