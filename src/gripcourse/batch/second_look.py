"""Files that our reader alone cannot judge, through LibreOffice in one call for the whole batch."""

from collections.abc import Mapping, Sequence
from typing import TypeAlias

from gripcourse.grading.model import Report
from gripcourse.jobs.lost import Lost
from gripcourse.machine.content import Readable, content_of
from gripcourse.machine.office import converted
from gripcourse.submission.second import OTHER_FORMATS

Made: TypeAlias = Mapping[int, bytes]
"""What LibreOffice made of files, by their places in a batch."""


def made_by_office(
    files: Sequence[Readable], reports: Sequence[Report | Lost], office: str | None, language: str
) -> Made:
    """Let LibreOffice compute or convert the files that need it.

    Args:
        files: of a batch.
        reports: of each file, as our reader alone sees it.
        office: the command that starts LibreOffice; None for none.
        language: of the course.

    Returns:
        A workbook for each file that needs it and that LibreOffice could open.
    """
    needed = {
        number: OTHER_FORMATS.get(report.refusal, ".xlsx")
        for number, report in enumerate(reports)
        if isinstance(report, Report) and needs_second_look(report)
    }
    if office is None or not needed:
        return {}
    named = {
        f"{number}{suffix}": data
        for number, suffix in needed.items()
        if (data := _content(files[number])) is not None
    }
    made = converted(named, office, language)
    return {int(name.partition(".")[0]): data for name, data in made.items()}


def needs_second_look(report: Report) -> bool:
    """Tell whether LibreOffice could make more of a file than our reader alone did."""
    return report.lacks_results or report.refusal in OTHER_FORMATS


def _content(source: Readable) -> bytes | None:
    try:
        return content_of(source)
    except OSError:  # it was there when the batch began
        return None
