"""Checking declared slips: one that computes the right value would punish the right answer."""

from collections.abc import Iterator, Mapping
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gripcourse.course.quantity import Quantity, Slip
from gripcourse.errors import Problem
from gripcourse.formula.evaluate import Column, evaluate
from gripcourse.text.units import known
from gripcourse.text.words import message

_SAMPLES: Final = 16
_WIDE_SAMPLES: Final = 48
_DECADES: Final = (-1.0, 4.0)  # of SI units: what the columns of catalogues hold
_ENOUGH: Final = 4  # samples at which both have a value
_SAME: Final = 1e-9


def slip_faults(one: Quantity, columns: Mapping[str, Column]) -> Iterator[Problem]:
    """Yield the problems of the declared slips of a quantity.

    Args:
        one: whose slips; its formulas have passed their own checks or are reported there.
        columns: catalogue columns, SI.
    """
    seen: set[str] = set()
    for slip in one.slips:
        key = f"quantity.{one.id}.slip.{slip.id}"
        if _equals_formula(one, slip, columns):
            yield Problem(
                one.file,
                key,
                message("The slip equals the right formula."),
                message("Write the wrong method, or remove the slip."),
            )
        if slip.id and slip.id in seen:
            yield Problem(
                one.file,
                key,
                message("The slip has no id of its own."),
                message("Give each slip of a quantity another id."),
            )
        seen.add(slip.id)


def _equals_formula(one: Quantity, slip: Slip, columns: Mapping[str, Column]) -> bool:
    """Tell whether a slip computes the right value, however it is written."""
    if one.formula is None:
        return False
    if slip.formula.tree == one.formula.tree:
        return True
    if not known(one.unit) or any(not known(unit) for unit in one.formula.units.values()):
        return False
    try:
        names = {*one.formula.names, *slip.formula.names}
        values = {name: _scattered(name) for name in sorted(names)}
        right = evaluate(one.formula, one.unit, values, columns)
        wrong = evaluate(slip.formula, one.unit, values, columns)
    except KeyError:  # a name or a catalogue that does not exist is reported by itself
        return False
    both = np.isfinite(right) & np.isfinite(wrong)
    agree = np.isclose(right, wrong, rtol=_SAME, atol=0.0) | ~both
    return int(both.sum()) >= _ENOUGH and bool(agree.all())


def _scattered(name: str) -> NDArray[np.float64]:
    """Return numbers that belong to a name and to no other.

    The first lie between 0.1 and 0.9, where most formulas have a value; the others are spread over
    decades: of two columns of loads the first steps may be the same.
    """
    chance = np.random.default_rng(np.frombuffer(name.encode(), dtype=np.uint8).tolist())
    small = chance.uniform(0.1, 0.9, _SAMPLES)
    return np.concatenate([small, 10 ** chance.uniform(*_DECADES, _WIDE_SAMPLES)])
