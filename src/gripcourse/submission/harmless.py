"""Damage that spreadsheet programs open a workbook with: what was read all the same is said."""

from collections.abc import Collection, Iterable
from typing import Final

from gripcourse.machine.spreadsheet.sheet_cells import StoredCell
from gripcourse.submission.looks import Looks
from gripcourse.text.shown import first_of, shown
from gripcourse.text.words import Message, message

_NAMED: Final = 5
_LONGEST: Final = 60  # characters of a part's name


def about_damage(parts: Collection[str]) -> tuple[Message, ...]:
    """Say which parts of a workbook are damaged that no answer, name or identity stands in."""
    if not parts:
        return ()
    return (
        message(
            "Parts of the workbook are damaged; the answers do not stand in them and were read:"
            " {parts}. Open the workbook in a spreadsheet program, look at it and save it again.",
            parts=first_of([shown(one)[:_LONGEST] for one in sorted(parts)], _NAMED),
        ),
    )


def about_lost_formats(looks: Looks, cells: Iterable[StoredCell]) -> tuple[Message, ...]:
    """Say that numbers count as they are stored, where nobody can know what they showed."""
    if not any(_is_number(one) and looks.formats.is_lost(one) for one in cells):
        return ()
    return (
        message(
            "The styles of the workbook are damaged or missing. Its numbers were read as they are"
            " stored: a percentage as a part of one, a date as a count of days. Open the workbook"
            " in a spreadsheet program, look at the numbers and save it again."
        ),
    )


def _is_number(cell: StoredCell) -> bool:
    return cell.kind == "n" and cell.text is not None
