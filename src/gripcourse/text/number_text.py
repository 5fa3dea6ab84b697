"""Numbers as people read them: decimal comma or point, groups of three, a true minus.

How people's numbers are read back is in `number_reading`.
"""

import math
import re
from decimal import Decimal

from gripcourse.text.conventions import decimal_sign

_MINUS = "\u2212"
_NARROW_SPACE = "\u202f"
_GROUPED_FROM = 5  # digits before the decimal sign: 1234, but 12 345
_PLAIN = (Decimal("1e-4"), Decimal("1e9"))
_SIZE = re.compile("[^eE]*[1-9]")
_SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def format_number(value: float, language: str, figures: int = 5) -> str:
    """Write a number with so many significant figures, as a language writes it.

    Args:
        value: any float.
        language: `en` has a decimal point, `ru` and `uk` a comma; all group by narrow spaces.
        figures: significant figures, at least 1; zeros at the end are cut.

    Returns:
        For example `12 345,6`; outside 1e-4…1e9 a power of ten, for example `1,5·10⁻⁵`; `∞` for
        an infinite number and a dash where there is no number.
    """
    if math.isnan(value):
        return "—"
    if math.isinf(value):
        return f"{_MINUS if value < 0 else ''}∞"
    rounded = Decimal(f"{value:.{figures - 1}e}")
    sign = _MINUS if rounded < 0 else ""
    size = abs(rounded)
    if size == 0 or _PLAIN[0] <= size < _PLAIN[1]:
        return sign + _plain(size, language)
    power = size.adjusted()
    mantissa = _plain(size.scaleb(-power), language)
    return f"{sign}{mantissa}·10{str(power).translate(_SUPERSCRIPTS)}"


def is_lost(written: str, value: float) -> bool:
    """Tell whether a number became a zero though none was written: it is too small to be held.

    Args:
        written: with a decimal point or comma, and a power of ten behind the letter e.
        value: the nearest float.
    """
    return value == 0 and _SIZE.match(written) is not None


def _plain(size: Decimal, language: str) -> str:
    """Write a number that is not negative without a power of ten."""
    whole, _, decimals = f"{size:f}".partition(".")
    decimals = decimals.rstrip("0")
    if len(whole) >= _GROUPED_FROM:
        whole = f"{int(whole):,}".replace(",", _NARROW_SPACE)
    return f"{whole}{decimal_sign(language)}{decimals}" if decimals else whole
