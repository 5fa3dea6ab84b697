"""One file, read apart, with LibreOffice's help where it could make more of it."""

from dataclasses import dataclass

from gripcourse.machine.content import Readable, content_of
from gripcourse.machine.office import converted
from gripcourse.submission.apart import read_apart
from gripcourse.submission.model import Rejected
from gripcourse.submission.raw import RawWorkbook
from gripcourse.submission.second import OTHER_FORMATS, lacks_results, read_again, stores_zeros

_NAME = "work"


@dataclass(frozen=True, slots=True)
class SecondReading:
    """Reads a file together with what LibreOffice made of it, in another process too.

    Attributes:
        made: the workbook that LibreOffice saved.
    """

    made: bytes

    def __call__(self, source: Readable) -> RawWorkbook | Rejected:
        """Read it; see `read_again`."""
        return read_again(source, self.made)


def read_with_office(source: Readable, office: str | None, language: str) -> RawWorkbook | Rejected:
    """Read a workbook as `grade` does: of another format, or without results of its formulas, too.

    LibreOffice takes seconds: this is for who waits for one file.

    Args:
        source: a file of any content, or its bytes.
        office: the command that starts LibreOffice; None where there is none.
        language: of the course; formulas read texts as numbers as it writes them.

    Raises:
        OSError: there is no such file, or it may not be read.
    """
    first = read_apart(source)
    ending = _ending_for_office(first)
    if office is None or not ending:
        return first
    made = converted({f"{_NAME}{ending}": content_of(source)}, office, language).made
    return read_apart(source, read=SecondReading(*made.values())) if made else first


def _ending_for_office(read: RawWorkbook | Rejected) -> str:
    """Return how a file ends that LibreOffice could make more of; nothing for any other."""
    if isinstance(read, Rejected):
        return OTHER_FORMATS.get(read.code, "")
    return ".xlsx" if lacks_results(read) or stores_zeros(read) else ""
