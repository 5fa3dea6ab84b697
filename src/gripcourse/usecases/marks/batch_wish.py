"""What a person says of a batch, as it was typed; see `opening.as_wished`."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class BatchWish:
    """What decides over what is found out of files, as it was typed.

    Attributes:
        whose: who handed files in; see `whose`.
        handed_in: when they were handed in; see `handed_in`.
        pattern: of paths, that tells whose a file is; None for none.
        either_version: of what was issued anew, whether the version counts that gives more; None as
            the gradebook says, else the workbook's own version.
        recalculate: whether LibreOffice computes all formulas once more.
    """

    whose: tuple[str, ...] = ()
    handed_in: tuple[str, ...] = ()
    pattern: str | None = None
    either_version: bool | None = None
    recalculate: bool = False
