"""The cells of a returned workbook as they stand in the file, before anything is made of them."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from gripcourse.machine.spreadsheet.cell_value import CellValue
from gripcourse.submission.model import Identity
from gripcourse.text.words import Message

__all__ = ["CellValue", "OtherResult", "RawCell", "RawWorkbook"]


@dataclass(frozen=True, slots=True)
class RawCell:
    """One named cell.

    Attributes:
        value: what the file stores for it.
        number_format: as the file spells it, for example `General` or `0.00%`.
        error: whether `value` is an error of a formula, for example `#DIV/0!`; without a value,
            whether the text that the cell had is not in the file.
        formula: of the cell, beginning with `=`; empty for none. Without a value, its result is
            not stored.
        cell: where it stands, `sheet!address`.
        label: the text that names a quantity in its row; empty for none.
        aside: of an answer that is blank, the cells behind it in its row, the nearest first.
    """

    value: CellValue
    number_format: str
    error: bool
    formula: str
    cell: str
    label: str = ""
    aside: tuple["RawCell", ...] = ()

    @property
    def is_filled(self) -> bool:
        """Whether anything stands there, readable or not."""
        return self.value is not None or self.formula != "" or self.error


@dataclass(frozen=True, slots=True)
class OtherResult:
    """A formula whose stored result is not what another program computes.

    Attributes:
        stored: the cell as the file has it.
        computed: the same cell as the other program saved it.
    """

    stored: RawCell
    computed: RawCell


@dataclass(frozen=True, slots=True)
class RawWorkbook:
    """The named cells of a workbook.

    Attributes:
        file: path as the user gave it.
        digest: SHA-256 of the file's bytes, hexadecimal.
        identity: what the workbook says it belongs to.
        creator: who saved it last, or who made it; empty where it does not say.
        givens: cells of given values, by quantity id; ids whose cell is gone are absent.
        answers: answer cells, likewise.
        remarks: about the workbook as a whole.
        beside: cells of the columns of answers that no name points to, in rows with a label.
        nowhere: titles of sheets that are not there, by the id of an answer that belongs there.
        other_results: formulas that another program computes otherwise; none where nobody asked.
    """

    file: str
    digest: str
    identity: Identity
    creator: str
    givens: Mapping[str, RawCell]
    answers: Mapping[str, RawCell]
    remarks: tuple[Message, ...]
    beside: tuple[RawCell, ...] = ()
    nowhere: Mapping[str, str] = field(default_factory=dict)
    other_results: tuple[OtherResult, ...] = ()
