"""How far an answer may differ, as sheets and keys print it."""

from gripcourse.course.quantity import Tolerance
from gripcourse.text.amounts import NO_BREAK_SPACE, amount_text, percent_text
from gripcourse.text.words import Words


def band_text(band: Tolerance, unit: str, words: Words) -> str:
    """Write the share of the expected value, or the amount where there is no share.

    Beside a share the amount counts near zero only.

    Args:
        band: of the answer.
        unit: that the answer is asked in.
        words: the reader's language.
    """
    if band.absolute and not band.relative:
        return f"±{NO_BREAK_SPACE}{amount_text(band.absolute, unit, words)}"
    return f"±{NO_BREAK_SPACE}{percent_text(band.relative, words)}"
