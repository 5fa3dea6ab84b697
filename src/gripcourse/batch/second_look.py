"""Files that our reader alone cannot judge, through LibreOffice in one call for many of them."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

from gripcourse.grading.model import Report
from gripcourse.machine.content import Readable, content_of
from gripcourse.machine.office import converted
from gripcourse.submission.second import OTHER_FORMATS


@dataclass(frozen=True, slots=True)
class MadeByOffice:
    """What LibreOffice made of files.

    Attributes:
        workbooks: by the places of the files in a batch.
        unopened: places of those that it gave up, and would again.
    """

    workbooks: Mapping[int, bytes]
    unopened: frozenset[int]


_WORKBOOK: Final = ".xlsx"


def needs_second_look(report: Report, *, recalculate: bool) -> bool:
    """Tell whether LibreOffice could make more of a file than our reader alone did.

    Args:
        report: as our reader sees the file.
        recalculate: whether stored results are to be compared with computed ones.
    """
    without = report.lacks_results or report.refusal in OTHER_FORMATS
    return not report.unopened and (without or (recalculate and report.unverified))


def made_by_office(
    files: Mapping[int, Readable],
    reports: Mapping[int, Report],
    office: str,
    language: str,
) -> MadeByOffice:
    """Let LibreOffice compute or convert files.

    Args:
        files: that need it, by their places in the batch.
        reports: of these files, as our reader alone sees them.
        office: the command that starts LibreOffice.
        language: of the course.
    """
    named = {
        f"{number}{_suffix(reports[number])}": data
        for number, file in files.items()
        if (data := _content(file)) is not None
    }
    if not named:
        return MadeByOffice({}, frozenset())
    done = converted(named, office, language)
    return MadeByOffice(
        {_place(name): data for name, data in done.made.items()},
        frozenset(map(_place, done.unopened)),
    )


def _place(name: str) -> int:
    return int(name.partition(".")[0])


def _suffix(report: Report) -> str:
    return OTHER_FORMATS.get(report.refusal, _WORKBOOK)


def _content(source: Readable) -> bytes | None:
    try:
        return content_of(source)
    except OSError:  # it was there when the batch began
        return None
