"""Raw cells → answers in declared units. Nothing is guessed and nothing silently becomes a zero."""

from collections.abc import Iterable, Mapping
from dataclasses import replace

from gripcourse.course.quantity import Kind, Quantity
from gripcourse.submission.by_label import by_label
from gripcourse.submission.measure import Understood
from gripcourse.submission.missing_sheets import about_missing_sheets
from gripcourse.submission.model import Answer, Reading, Submission
from gripcourse.submission.raw import RawCell, RawWorkbook
from gripcourse.submission.understand import cell_text, understand
from gripcourse.text.number_reading import NumberRead, read_number
from gripcourse.text.words import Message, message


def interpret(raw: RawWorkbook, quantities: Iterable[Quantity]) -> Submission:
    """Make answers of the cells of a workbook.

    Args:
        raw: what stands in the file.
        quantities: of the plan; those that are neither answered nor given are passed over.

    Returns:
        One answer for each answered quantity, also where its cell is gone.
    """
    asked = tuple(quantities)
    answered = tuple(quantity for quantity in asked if quantity.kind.answered)
    found = by_label(raw, answered)
    absent = tuple(one.id for one in answered if one.id not in found.answers)
    nowhere = [raw.nowhere.get(name) for name in absent]
    return Submission(
        file=raw.file,
        digest=raw.digest,
        identity=raw.identity,
        creator=raw.creator,
        givens=_givens(raw.givens, asked),
        answers={
            one.id: _answer(one, found.answers.get(one.id), moved=one.id in found.moved)
            for one in answered
        },
        remarks=(*raw.remarks, *about_missing_sheets([one for one in nowhere if one])),
        moved=found.moved,
        absent=absent,
    )


def _givens(cells: Mapping[str, RawCell], quantities: Iterable[Quantity]) -> dict[str, float]:
    """Read the given values that are still numbers."""
    given = (one for one in quantities if one.kind is Kind.GIVEN and one.id in cells)
    values = ((one.id, _number(cells[one.id])) for one in given)
    return {identifier: value for identifier, value in values if value is not None}


def _number(cell: RawCell) -> float | None:
    value = cell.value
    if isinstance(value, str):
        read = read_number(value)
        return read.value if isinstance(read, NumberRead) else None
    if isinstance(value, bool) or not isinstance(value, int | float):
        return None
    try:
        return float(value)
    except OverflowError:
        return None


def _answer(quantity: Quantity, cell: RawCell | None, *, moved: bool) -> Answer:
    answer = _in_cell(quantity, cell)
    if not moved:
        return answer
    said = message("Rows were moved; the answer was taken from the row with this title.")
    return replace(answer, remarks=(*answer.remarks, said))


def _in_cell(quantity: Quantity, cell: RawCell | None) -> Answer:
    if cell is None:
        gone = message("The answer cell is missing from the workbook.")
        return _without_value(quantity, Reading.BLANK, "", "", (gone,))
    understood = understand(quantity, cell)
    if isinstance(understood, Understood):
        figures = understood.figures
        return Answer(
            quantity=quantity.id,
            reading=Reading.READ,
            value=understood.value,
            typed=cell_text(cell),
            cell=cell.cell,
            half_unit=understood.half_unit,
            unit=understood.unit,
            unit_fits=understood.unit_fits,
            remarks=understood.remarks,
            figures=None if figures is None else figures.least,
            figures_at_most=None if figures is None else figures.most,
        )
    if understood is None:
        return _blank(quantity, cell)
    return _without_value(quantity, Reading.UNREADABLE, cell_text(cell), cell.cell, (understood,))


def _blank(quantity: Quantity, cell: RawCell) -> Answer:
    """A value behind the cell is no answer, but no blank: whoever wrote it has to be told."""
    for one in cell.aside:
        if isinstance(understand(quantity, one), Understood):
            said = message(
                "The value stands beside the answer cell, which is empty: write it into the cell."
            )
            typed = cell_text(one)
            return _without_value(quantity, Reading.UNREADABLE, typed, cell.cell, (said,))
    return _without_value(quantity, Reading.BLANK, "", cell.cell, ())


def _without_value(
    quantity: Quantity, reading: Reading, typed: str, cell: str, remarks: tuple[Message, ...]
) -> Answer:
    return Answer(
        quantity=quantity.id,
        reading=reading,
        value=None,
        typed=typed,
        cell=cell,
        half_unit=0.0,
        unit="",
        unit_fits=True,
        remarks=remarks,
    )
