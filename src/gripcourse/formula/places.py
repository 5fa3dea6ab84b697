"""Where numbers would stand in a series."""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Places = NDArray[np.intp]

_MANY = 1000  # numbers; of fewer, looking at all of them first takes longer
_FEW = 40  # entries, each of which all numbers are compared with


def places(series: Array, numbers: Array) -> Places:
    """Return how many entries of a series are below each number; NaN has some place, or none.

    It is what `np.searchsorted` returns of numbers. Searching a series for each number by itself,
    the processor cannot foresee where the search goes; comparing all numbers with one entry after
    another is many times as quick, and only entries between the least and the greatest count.

    Args:
        series: ascending.
        numbers: of any shape.
    """
    if numbers.size < _MANY:
        return np.asarray(series.searchsorted(numbers))
    ends = (np.fmin.reduce(numbers, axis=None), np.fmax.reduce(numbers, axis=None))
    first, last = series.searchsorted(ends)
    if last - first > _FEW:
        return np.asarray(series.searchsorted(numbers))
    below = np.zeros(numbers.shape, np.uint8)
    for entry in series[first:last]:
        np.add(below, np.less(entry, numbers).view(np.uint8), below)
    return np.asarray(first + below.astype(np.intp))
