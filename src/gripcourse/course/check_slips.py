"""Checking declared slips and alternatives: what differs in nothing from the formula is neither.

A slip that computes the right value would punish the right answer, one that computes that of an
accepted reading would never be named.
"""

from collections.abc import Iterable, Iterator, Mapping
from functools import lru_cache
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gripcourse.course.quantity import Quantity
from gripcourse.errors import Problem
from gripcourse.formula.evaluate import Column, evaluate
from gripcourse.formula.tree import Formula
from gripcourse.text.units import known
from gripcourse.text.words import message

_SAMPLES: Final = 16
_WIDE_SAMPLES: Final = 48
_DECADES: Final = (-1.0, 4.0)  # of SI units: what the columns of catalogues hold
_ENOUGH: Final = 4  # samples at which both have a value
_SAME: Final = 1e-9
_NO_OWN_ID: Final = {
    "slip": (
        message("The slip has no id of its own."),
        message("Give each slip of a quantity another id."),
    ),
    "alternative": (
        message("The alternative has no id of its own."),
        message("Give each alternative of a quantity another id."),
    ),
}


def slip_faults(one: Quantity, columns: Mapping[str, Column]) -> Iterator[Problem]:
    """Yield the problems of the declared slips of a quantity.

    Args:
        one: whose slips; its formulas have passed their own checks or are reported there.
        columns: catalogue columns, SI.
    """
    yield from _shared_ids(one, "slip", (slip.id for slip in one.slips))
    for slip in one.slips:
        key = f"quantity.{one.id}.slip.{slip.id}"
        if one.formula is not None and same_value(one, one.formula, slip.formula, columns):
            yield Problem(
                one.file,
                key,
                message("The slip equals the right formula."),
                message("Write the wrong method, or remove the slip."),
            )


def alternative_faults(one: Quantity, columns: Mapping[str, Column]) -> Iterator[Problem]:
    """Yield the problems of the other readings of a quantity; see `slip_faults`."""
    yield from _shared_ids(one, "alternative", (other.id for other in one.alternatives))
    for other in one.alternatives:
        key = f"quantity.{one.id}.alternative.{other.id}"
        if one.formula is not None and same_value(one, one.formula, other.formula, columns):
            yield Problem(
                one.file,
                key,
                message("The alternative equals the formula."),
                message("Write the other reading, or remove the alternative."),
            )
        for slip in one.slips:
            if same_value(one, slip.formula, other.formula, columns):
                yield Problem(
                    one.file,
                    key,
                    message("The alternative equals the slip '{slip}'.", slip=slip.id),
                    message("Remove one of them: an answer is a mistake or another reading."),
                )


def _shared_ids(one: Quantity, sort: str, ids: Iterable[str]) -> Iterator[Problem]:
    """Yield a problem for each id that an earlier slip, or an earlier alternative, has too."""
    seen: set[str] = set()
    what, remedy = _NO_OWN_ID[sort]
    for id_ in ids:
        if id_ and id_ in seen:
            yield Problem(one.file, f"quantity.{one.id}.{sort}.{id_}", what, remedy)
        seen.add(id_)


def same_value(
    one: Quantity, first: Formula, second: Formula, columns: Mapping[str, Column]
) -> bool:
    """Tell whether two formulas of a quantity compute one value, however they are written."""
    if first.tree == second.tree:
        return True
    units = (*first.units.values(), *second.units.values())
    if not known(one.unit) or any(not known(unit) for unit in units):
        return False
    try:
        names = {*first.names, *second.names}
        values = {name: _scattered(name) for name in sorted(names)}
        right = evaluate(first, one.unit, values, columns)
        wrong = evaluate(second, one.unit, values, columns)
    except KeyError:  # a name or a catalogue that does not exist is reported by itself
        return False
    both = np.isfinite(right) & np.isfinite(wrong)
    agree = np.isclose(right, wrong, rtol=_SAME, atol=0.0) | ~both
    return int(both.sum()) >= _ENOUGH and bool(agree.all())


@lru_cache(maxsize=4096)
def _scattered(name: str) -> NDArray[np.float64]:
    """Return numbers that belong to a name and to no other.

    The first lie between 0.1 and 0.9, where most formulas have a value; the others are spread over
    decades: of two columns of loads the first steps may be the same.
    """
    chance = np.random.default_rng(np.frombuffer(name.encode(), dtype=np.uint8).tolist())
    small = chance.uniform(0.1, 0.9, _SAMPLES)
    found = np.concatenate([small, 10 ** chance.uniform(*_DECADES, _WIDE_SAMPLES)])
    found.flags.writeable = False  # every formula with the name is given the same
    return found
