"""What was read from a returned workbook."""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum

from gripcourse.machine.spreadsheet.refusals import REASONS, WhyRefused
from gripcourse.text.words import Message

__all__ = ["Answer", "Identity", "Reading", "Rejected", "Submission", "WhyRefused"]


class Reading(StrEnum):
    """How an answer cell was read: three different things, none of which is a zero."""

    READ = "read"
    BLANK = "blank"
    UNREADABLE = "unreadable"


@dataclass(frozen=True, slots=True)
class Answer:
    """One answer cell.

    Attributes:
        quantity: id of the quantity.
        reading: read, blank or unreadable.
        value: in the quantity's declared unit; None unless read. A verdict reads as 1.0 or 0.0.
        typed: what the cell shows, at most 80 characters, for the report.
        cell: where it stands now, `sheet!address`; empty where the cell is gone.
        half_unit: half a unit of the last typed digit, in the declared unit; 0.0 where the cell
            holds a computed number.
        unit: the unit that was typed beside the number, in our spelling; empty for none.
        unit_fits: False where that unit measures something else; the value is then as typed.
        remarks: what the student should learn about how the cell was read, or why it was not.
        figures: significant figures that were typed for certain; None where that cannot be told, as
            of a formula's result.
        figures_at_most: that it can have been; None for no bound: a cell that holds a number loses
            the zeros at its end.
    """

    quantity: str
    reading: Reading
    value: float | None
    typed: str
    cell: str
    half_unit: float
    unit: str
    unit_fits: bool
    remarks: tuple[Message, ...]
    figures: int | None = None
    figures_at_most: int | None = None


@dataclass(frozen=True, slots=True)
class Identity:
    """Who and what a workbook says it belongs to; empty where it does not say.

    Attributes:
        student, variant, scheme: ids.
        options: what the variant chooses.
        signature: hexadecimal, over all of it and the given values.
        other: the student whom the document's properties name, where the hidden sheet names
            another; no program writes that.
    """

    student: str
    variant: str
    scheme: str
    options: Mapping[str, str]
    signature: str
    other: str = ""


@dataclass(frozen=True, slots=True)
class Submission:
    """A workbook that could be read.

    Attributes:
        file: path as the user gave it.
        digest: SHA-256 of the file's bytes, hexadecimal.
        identity: as written in the hidden sheet, or in the custom property where the sheet is gone.
        creator: the author that the workbook's properties name.
        givens: given values as they stand in the workbook now, in declared units.
        answers: by quantity id; one for each answered quantity, also for missing cells.
        remarks: about the workbook as a whole.
        moved: ids of the answers that were found by their titles, in other cells than were issued.
        absent: ids of the answers that the workbook has no cell for.
    """

    file: str
    digest: str
    identity: Identity
    creator: str
    givens: Mapping[str, float]
    answers: Mapping[str, Answer]
    remarks: tuple[Message, ...]
    moved: tuple[str, ...] = ()
    absent: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Rejected:
    """A file that is no workbook that we can read, and why, for the person who sent it.

    Attributes:
        file: path as the user gave it.
        digest: SHA-256 of the file's bytes, hexadecimal; empty where there are none.
        reason: a sentence that also says what to do.
        code: the reason for other programs; empty where there is none.
    """

    file: str
    digest: str
    reason: Message
    code: str = ""

    @classmethod
    def because(cls, file: str, digest: str, refused: WhyRefused) -> "Rejected":
        """Refuse a file for one of the reasons that there are."""
        return cls(file, digest, REASONS[refused], refused.value)
