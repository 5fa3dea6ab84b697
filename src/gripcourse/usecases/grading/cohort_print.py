"""The report on a whole batch, laid out while those of the students are: it takes far longer.

Where a student's report fails, the batch has one more thing to look at, and its report is laid out
once more.
"""

import traceback
from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager, ExitStack, contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from gripcourse.grading.model import Report
from gripcourse.machine.files import write_bytes
from gripcourse.machine.jobs.beside import done_beside
from gripcourse.machine.jobs.limits import Limits
from gripcourse.machine.jobs.lost import Lost
from gripcourse.machine.jobs.work import Task, do
from gripcourse.usecases.grading.student_reports import Printing, cohort_pdf
from gripcourse.usecases.grading.unchanged import PrintedBefore, told_of

# Several times what a work adds to the report.
_SECONDS_PER_WORK: Final = 0.1


@dataclass(frozen=True, slots=True)
class CohortPrint:
    """A report on a batch that is to be written.

    Attributes:
        path: of the report.
        printing: what it is laid out with.
        workers: how many processes may be busy.
        printed: what earlier runs wrote; None to write it anyway.
        begun: what the reports that are known come to, which is being laid out; None where that
            has not begun.
    """

    path: Path
    printing: Printing
    workers: int
    printed: PrintedBefore | None
    begun: Callable[[], bytes | Lost] | None = None

    def written(self, reports: Sequence[Report], *, changed: bool) -> Lost | None:
        """Write the report, unless an earlier run wrote it from the very same.

        Args:
            reports: of the batch.
            changed: whether they are others than those that were known.

        Returns:
            Why it could not be laid out, None where it was.

        Raises:
            OSError: it cannot be written.
        """
        made_from = told_of(reports) if self.printed else ""
        if self.printed and self.printed.stands(self.path, made_from):
            return None
        if self.begun is None or changed:
            pdf = _laid_out(reports, self.printing, self.workers)
        else:
            pdf = self.begun()
        if isinstance(pdf, Lost):
            # An earlier one would say something else than the grades.
            self.path.unlink(missing_ok=True)
            return pdf
        write_bytes(self.path, pdf, private=True)
        if self.printed:
            self.printed.note(self.path, made_from)
        return None


@contextmanager
def printing_cohort(
    reports: Sequence[Report],
    printing: Printing,
    path: Path,
    workers: int,
    printed: PrintedBefore | None,
) -> Iterator[CohortPrint]:
    """Begin to lay out the report on a batch, where more than one process may be busy.

    Args:
        reports: of the batch as far as they are known.
        printing: what it is laid out with.
        path: of the report.
        workers: how many processes may be busy.
        printed: what earlier runs wrote; None to write it anyway.
    """
    plain = Printing(printing.course, printing.policy, printing.graded_on)
    stands = printed is not None and printed.stands(path, told_of(reports))
    with ExitStack() as stack:
        begun = None
        if workers > 1 and not stands:
            with suppress(OSError):  # no room for it: laid out at the end
                begun = stack.enter_context(_begun(reports, plain))
        yield CohortPrint(path, plain, workers, printed, begun)


def _begun(
    reports: Sequence[Report], printing: Printing
) -> AbstractContextManager[Callable[[], bytes | Lost]]:
    seconds = printing.seconds + len(reports) * _SECONDS_PER_WORK
    return done_beside(cohort_pdf, tuple(reports), printing, limits=Limits(), seconds=seconds)


def _laid_out(reports: Sequence[Report], printing: Printing, workers: int) -> bytes | Lost:
    """Lay it out now: in a process of its own, where there may be any."""
    if workers == 0:
        return do(Task(cohort_pdf, printing, printing.seconds, None), tuple(reports))
    try:
        with _begun(reports, printing) as answer:
            return answer()
    except OSError:
        return Lost(traceback.format_exc())
