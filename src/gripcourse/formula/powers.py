"""Powers of arrays and of single numbers: the same bits from both, on any processor.

Where a processor has the instructions for it, numpy raises arrays by them, and its single numbers
and the system's `pow` by others: one power in twenty differs in its last place, on some machines.
So a small whole exponent is a product here, and any other goes through the same ufunc.
"""

from collections.abc import Callable
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

_Array = NDArray[np.float64]
_Some = TypeVar("_Some", _Array, float)


def power_of_arrays(exponent: float) -> Callable[[_Array], _Array]:
    """Make a function that raises arrays; overflow is infinite, a root of a negative number NaN."""
    return _product(exponent) or (lambda base: np.asarray(np.power(base, exponent)))


def power_of_numbers(exponent: float) -> Callable[[float], float]:
    """Make a function that raises single numbers as `power_of_arrays` does, without a warning."""
    return _product(exponent) or (lambda base: raised(base, exponent))


def raised(base: float, exponent: float) -> float:
    """Raise a number to any power as numpy raises a column, without a warning."""
    with np.errstate(all="ignore"):
        return float(np.power(base, exponent))


def _product(exponent: float) -> Callable[[_Some], _Some] | None:
    match exponent:
        case 2:
            return lambda base: base * base
        case 3:
            return lambda base: base * base * base
        case 4:
            return lambda base: base * base * (base * base)
        case _:
            return None
