"""What an instructor learns where LibreOffice computes a work's formulas once more.

The stored results count, whatever it comes to: a difference is a question, never a mark.
"""

from collections.abc import Iterator, Sequence
from typing import Final

from gripcourse.grading.model import Flag, FlagCode
from gripcourse.submission.raw import OtherResult
from gripcourse.submission.understand import cell_text
from gripcourse.text.words import counted, message

_SHOWN: Final = 10
_LONGEST_FORMULA: Final = 60  # characters


def results_flags(others: Sequence[OtherResult]) -> Iterator[Flag]:
    """Yield the flag of formulas that store other results than they have, with the evidence."""
    if others:
        cells = "; ".join(map(_evidence, others[:_SHOWN]))
        said = counted(
            "LibreOffice computes another result than {count} formula stores (stored → computed): "
            "{cells}. The stored one counts. Functions of time or chance, links to other files and "
            "functions that LibreOffice does not know make such differences too: look at the "
            "formula in the file before you ask.",
            "LibreOffice computes other results than {count} formulas store (stored → computed): "
            "{cells}. The stored ones count. Functions of time or chance, links to other files and "
            "functions that LibreOffice does not know make such differences too: look at the "
            "formulas in the file before you ask.",
            len(others),
            cells=cells if len(others) <= _SHOWN else f"{cells}; …",
        )
        yield Flag(FlagCode.RESULTS_DIFFER, said)


def not_recalculated_flag() -> Flag:
    """Return the flag of a work whose stored results nobody could compute once more."""
    said = message(
        "LibreOffice could not open the file: nobody knows whether its formulas give the results "
        "that it stores. Open it in a spreadsheet program."
    )
    return Flag(FlagCode.NOT_RECALCULATED, said)


def _evidence(one: OtherResult) -> str:
    stored, computed = cell_text(one.stored), cell_text(one.computed)
    formula = " ".join(one.stored.formula.split())
    shown = formula if len(formula) <= _LONGEST_FORMULA else f"{formula[:_LONGEST_FORMULA]}…"
    return f"{one.stored.cell}: {stored} → {computed} ({shown})"
