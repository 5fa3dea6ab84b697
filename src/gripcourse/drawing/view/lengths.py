"""How the lengths of a view are written."""

import math

from gripcourse.text.words import Words

FOR_REFERENCE = "*"
_FIGURES = 7  # tenths of a millimetre of any machine, thousandths of a small size
_SERIES_DECIMALS = 3  # no series is finer
_SAME = 1e-9


def length_text(value: float, words: Words) -> str:
    """Write a length to tenths of a millimetre, as dimensions do.

    A size as a series or a table of variants has it, such as a module of 1.25 mm or a wire of
    0.355 mm, is written as it is: rounded, it would be another size.
    """
    tidy = round(value, _SERIES_DECIMALS)
    is_tidy = math.isclose(value, tidy, rel_tol=_SAME)
    return words.number(tidy if is_tidy else round(value, 1), _FIGURES)
