"""A second reading: what another program made of a file that says too little by itself.

What the file stores is always preferred: another program may compute otherwise than the student's.
"""

import math
from collections.abc import Iterator
from dataclasses import replace
from pathlib import PurePath
from typing import Final

from gripcourse.machine.content import NamedBytes, Readable, content_of, shown_name
from gripcourse.machine.spreadsheet.open_document import loses_texts
from gripcourse.submission.model import Rejected, WhyRefused
from gripcourse.submission.raw import CellValue, OtherResult, RawCell, RawWorkbook
from gripcourse.submission.read import read_workbook
from gripcourse.text.words import message

OTHER_FORMATS: Final = {
    WhyRefused.OLD_FORMAT.value: ".xls",
    WhyRefused.OPEN_DOCUMENT.value: ".ods",
}
"""Refused by us, and read by LibreOffice: the code of the refusal and how such files end."""

_ROUNDING: Final = 1e-6
"""By which share of itself a result may differ between two programs that compute the same."""

_CONVERTED: Final = message(
    "The file is no .xlsx workbook; LibreOffice converted it. Hand in an .xlsx workbook next time."
)
_COMPUTED: Final = message(
    "The file stores no results of its formulas; LibreOffice computed them. Open it in a "
    "spreadsheet program and save it there next time."
)


def lacks_results(raw: RawWorkbook) -> bool:
    """Tell whether answers are formulas whose results are not stored."""
    return any(_lacks_result(one) for one in (*raw.answers.values(), *raw.beside))


def stores_zeros(raw: RawWorkbook) -> bool:
    """Tell whether all results that answers' formulas store are zeros: some writers compute none.

    XlsxWriter and what is like it store a zero for each formula until a spreadsheet computes it.
    """
    cells = (*raw.answers.values(), *raw.beside)
    results = [one.value for one in cells if one.formula and one.value is not None]
    return bool(results) and all(_is_zero(one) for one in results)


def stores_results(raw: RawWorkbook) -> bool:
    """Tell whether cells that count are formulas whose results are stored: any text can be one."""
    return any(one.formula and one.value is not None for one in _counting(raw).values())


def read_again(source: Readable, made: bytes) -> RawWorkbook | Rejected:
    """Read a file together with what LibreOffice made of it; see `read_workbook`.

    Args:
        source: the file.
        made: the workbook that LibreOffice saved of it.

    Raises:
        OSError: there is no such file, or it may not be read.
    """
    first = read_workbook(source)
    again = read_workbook(NamedBytes(f"{PurePath(shown_name(source)).stem}.xlsx", made))
    if isinstance(again, Rejected):
        is_opened = isinstance(first, Rejected) and first.code in OTHER_FORMATS
        if (
            is_opened and again.code == WhyRefused.FOREIGN.value
        ):  # saved again, it would be no other
            return replace(again, file=first.file, digest=first.digest)
        return first
    if isinstance(first, RawWorkbook):
        computed = _with_results(first, again)
        return replace(computed, other_results=tuple(_other_results(computed, again)))
    if first.code not in OTHER_FORMATS or loses_texts(content_of(source)):
        return first
    remarks = (*again.remarks, _CONVERTED)
    return replace(again, file=first.file, digest=first.digest, remarks=remarks)


def _with_results(first: RawWorkbook, again: RawWorkbook) -> RawWorkbook:
    """Add the results that are not stored; cells keep their names and their places."""
    cells = {**again.answers, **{one.cell: one for one in again.beside}}
    only_zeros = stores_zeros(first)

    def added(name: str, cell: RawCell) -> RawCell:
        other = cells.get(name)
        lacking = _lacks_result(cell) or (only_zeros and cell.formula != "")
        if other is None or other.cell != cell.cell or not lacking:
            return cell
        return replace(cell, value=other.value, error=other.error)

    answers = {name: added(name, cell) for name, cell in first.answers.items()}
    beside = tuple(added(one.cell, one) for one in first.beside)
    if (answers, beside) == (first.answers, first.beside):
        return first
    return replace(first, answers=answers, beside=beside, remarks=(*first.remarks, _COMPUTED))


def _counting(raw: RawWorkbook) -> dict[str, RawCell]:
    """Return by their places the cells that a work is judged by."""
    cells = (*raw.answers.values(), *raw.givens.values(), *raw.beside)
    return {one.cell: one for one in cells}


def _other_results(first: RawWorkbook, again: RawWorkbook) -> Iterator[OtherResult]:
    """Yield the formulas whose stored results another program does not come to.

    An error that is stored gains nobody anything: programs know different functions.
    """
    computed = _counting(again)
    for place, stored in _counting(first).items():
        other = computed.get(place)
        if other is None or not stored.formula or stored.value is None or stored.error:
            continue
        if other.error or not _same(stored.value, other.value):
            yield OtherResult(stored, other)


def _same(stored: CellValue, computed: CellValue) -> bool:
    if isinstance(stored, int | float) and isinstance(computed, int | float):
        try:
            return math.isclose(stored, computed, rel_tol=_ROUNDING, abs_tol=_ROUNDING**2)
        except OverflowError:
            return stored == computed
    if isinstance(stored, str) and isinstance(computed, str):
        return stored.strip() == computed.strip()
    return stored == computed


def _is_zero(value: CellValue) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and value == 0


def _lacks_result(cell: RawCell) -> bool:
    return cell.formula != "" and cell.value is None
