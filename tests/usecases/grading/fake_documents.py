"""Documents for tests that go wrong for one student; they must be found from another process."""

import os
import signal
import time
from collections.abc import Sequence

from gripcourse.grading.model import Report
from gripcourse.machine.files import write_bytes
from gripcourse.usecases.grading.student_reports import Printing
from gripcourse.usecases.issuing.handout import Handout, IssuingContext, sheet_path, workbook_path
from gripcourse.variants.model import Issued

PAGE = b"%PDF-1.7 a report"
REFUSED = "a page nobody foresaw"


def refuse_s02(report: Report, _printing: Printing) -> bytes:
    """Fail as a template does that cannot deal with the data of one student."""
    if report.student == "s02":
        raise ValueError(REFUSED)
    return PAGE


def meet_their_fates(report: Report, printing: Printing) -> bytes:
    """Refuse one, be killed as by a system without memory, ask for more than a worker may have."""
    match report.student:
        case "s05":
            os.kill(os.getpid(), signal.SIGKILL)
        case "s06":
            return bytes(1 << 45)
    return refuse_s02(report, printing)


def hang_at_s02(report: Report, _printing: Printing) -> bytes:
    """Never end."""
    while report.student == "s02":
        time.sleep(60)
    return PAGE


def hang_deaf_at_s02(report: Report, _printing: Printing) -> bytes:
    """Never end, deep inside a library where no alarm is heard."""
    if report.student == "s02":
        signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGALRM})
        time.sleep(600)
    return PAGE


def issue_and_die_at_s02(context: IssuingContext, entry: Issued) -> Handout:
    """Be killed in the middle of writing one student's workbook; write pages for the others."""
    if entry.student.id == "s02":
        workbook = workbook_path(context.out, "s02")
        workbook.parent.mkdir(parents=True, exist_ok=True)
        workbook.with_name(".s02.00ff00ff.xlsx").write_bytes(b"PK half of a workbook")
        os.kill(os.getpid(), signal.SIGKILL)
    student = entry.student.id
    made = (sheet_path(context.out, student), workbook_path(context.out, student))
    for path in made:
        write_bytes(path, PAGE)
    return Handout(student, made, ())


def page(report: Report, printing: Printing) -> bytes:
    """Print what a page is made from, at once."""
    return f"%PDF-1.7 {printing.graded_on} {report!r}".encode()


def cohort_page(reports: Sequence[Report], printing: Printing) -> bytes:
    """Print a cohort, at once."""
    return f"%PDF-1.7 {printing.graded_on} {len(reports)}".encode()
