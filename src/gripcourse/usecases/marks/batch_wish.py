"""What a person says of a batch, as it was typed; see `opening.as_wished`."""

from dataclasses import dataclass
from pathlib import Path

from gripcourse.machine.content import digest_of_content


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

    def tables_said(self) -> tuple[str, ...]:
        """Return the digests of the tables that say when files were handed in.

        Another table of the same name says other times.
        """
        return tuple(digest_of_content(Path(one)) for one in self.handed_in if is_table(one))


def is_table(written: str) -> bool:
    """Tell whether a table says when files were handed in, and not a person by a time."""
    return "=" not in written and Path(written).is_file()
