"""How numbers are written down, digit by digit."""

from collections.abc import Mapping
from decimal import ROUND_DOWN, ROUND_HALF_UP, Decimal
from typing import Final

import numpy as np

from gripcourse.course.quantity import Kind, Quantity
from gripcourse.simulation.foreign.kinds import Writing
from gripcourse.simulation.foreign.model import Habits
from gripcourse.text.units import unit_text

_DISPLAY: Final = 10
_ENOUGH: Final = 1.0  # from here on two decimals are three figures
_LARGE: Final = 10.0  # from here on whole numbers are written
_YES_AND_NO: Final = {"en": ("yes", "no"), "ru": ("да", "нет"), "uk": ("так", "ні")}
_FIGURES: Final[Mapping[Writing, int]] = {
    Writing.FIGURES_2: 2,
    Writing.FIGURES_3: 3,
    Writing.FIGURES_4: 4,
    Writing.FIGURES_5: 5,
    Writing.CUT_4: 4,
}
_DECIMALS: Final[Mapping[Writing, int]] = {Writing.ONE_DECIMAL: 1, Writing.TWO_DECIMALS: 2}


def written(value: float, writing: Writing, rng: np.random.Generator) -> str:
    """Write a number down, with the zeros at its end that belong to it."""
    shown = Decimal(f"{value:.{_DISPLAY - 1}e}")
    if not shown or writing is Writing.DISPLAY:
        return f"{shown.normalize():f}"
    if writing is Writing.MIXED:
        return _to_figures(shown, int(rng.integers(3, 7)))
    if writing in _FIGURES:
        return _to_figures(shown, _FIGURES[writing], cut=writing is Writing.CUT_4)
    if writing is Writing.DECIMALS:
        return _to_decimals(shown, 2) if abs(shown) >= _ENOUGH else _to_figures(shown, 3)
    decimals = _DECIMALS.get(writing, 0 if abs(shown) >= _LARGE else 1)
    rounded = _to_decimals(shown, decimals)
    # Nobody writes 0 for what is not: it gets two figures.
    return rounded if float(rounded) else _to_figures(shown, 2)


def exactly(value: float) -> str:
    """Write a size or an entry of a table as it stands there."""
    return f"{Decimal(f'{value:.10g}').normalize():f}"


def cell(quantity: Quantity, text: str, habits: Habits, language: str, place: int) -> float | str:
    """Return what stands in the cell of an answer.

    Args:
        quantity: that is answered.
        text: the number as it was written.
        habits: of the student.
        language: the student's.
        place: of the answer among the others.
    """
    if quantity.kind is Kind.VERDICT:
        return _YES_AND_NO[language][0 if float(text) else 1]
    if not habits.as_text:
        return float(text)
    typed = text if language == "en" else text.replace(".", ",")
    named = quantity.unit and (habits.seed + place) % 2
    return f"{typed} {unit_text(quantity.unit, language)}" if named else typed


def _to_figures(shown: Decimal, figures: int, *, cut: bool = False) -> str:
    step = Decimal(1).scaleb(shown.adjusted() - figures + 1)
    how = ROUND_DOWN if cut else ROUND_HALF_UP
    rounded = (shown / step).quantize(Decimal(1), how) * step
    return f"{rounded:f}"


def _to_decimals(shown: Decimal, decimals: int) -> str:
    if shown.adjusted() >= _DISPLAY:  # after a mistake: a calculator shows no decimals of it
        return f"{shown:f}"
    return f"{shown.quantize(Decimal(1).scaleb(-decimals), ROUND_HALF_UP):f}"
