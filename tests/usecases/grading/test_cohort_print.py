"""The report on a batch is laid out while those of the students are, from what is known."""

import importlib
from collections.abc import Iterator
from datetime import date
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from gripcourse.grading.unjudged import unknown_student_report
from gripcourse.usecases.grading import cohort_print
from gripcourse.usecases.grading.cohort_print import printing_cohort
from gripcourse.usecases.grading.student_reports import Printing
from gripcourse.usecases.grading.unchanged import PrintedBefore

if TYPE_CHECKING:
    from gripcourse.grading.model import Report
    from support.classroom import Classroom

GRADED_ON = date(2026, 12, 2)
REPORTS = tuple(unknown_student_report(f"{number}.xlsx", "", str(number)) for number in range(3))


@pytest.fixture(scope="module")
def printing(issued: "Classroom") -> Iterator[Printing]:
    """A cohort's page that tells how many reports it is about, at once."""
    small = issued.with_its_scheme()
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(str(Path(__file__).parent))
        fake = importlib.import_module("fake_documents")
        patch.setattr(cohort_print, "cohort_pdf", fake.cohort_page)
        yield Printing(small.course, small.policy, GRADED_ON)


def told(path: Path) -> str:
    """How many reports a page was laid out from."""
    return path.read_text(encoding="utf-8").split()[-1]


@pytest.mark.parametrize(("workers", "begins"), [(2, True), (1, False), (0, False)])
def test_it_is_begun_at_once_where_more_than_one_process_may_be_busy(
    printing: Printing, tmp_path: Path, workers: int, *, begins: bool
) -> None:
    path = tmp_path / "cohort.pdf"
    with printing_cohort(REPORTS, printing, path, workers, None) as cohort:
        assert (cohort.begun is not None) is begins
        assert cohort.written(REPORTS, changed=False) is None
    assert told(path) == "3"


def test_what_became_of_the_reports_since_is_laid_out_once_more(
    printing: Printing, tmp_path: Path
) -> None:
    path = tmp_path / "cohort.pdf"
    since: tuple[Report, ...] = REPORTS[:2]
    with printing_cohort(REPORTS, printing, path, 2, None) as cohort:
        assert cohort.written(since, changed=True) is None
    assert told(path) == "2"


def test_what_an_earlier_run_printed_is_not_begun_again(printing: Printing, tmp_path: Path) -> None:
    path, printed = tmp_path / "cohort.pdf", PrintedBefore(tmp_path / "notes", "the same course")
    with printing_cohort(REPORTS, printing, path, 2, printed) as first:
        first.written(REPORTS, changed=False)
    with printing_cohort(REPORTS, printing, path, 2, printed) as again:
        assert again.begun is None
        assert again.written(REPORTS, changed=False) is None
    with printing_cohort(REPORTS[:1], printing, path, 2, printed) as other:
        assert other.begun is not None
