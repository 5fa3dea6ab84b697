"""What workers need is imported before they are there: once, while the course is read."""

import sys
from collections.abc import Iterator
from datetime import date
from functools import partial
from multiprocessing.forkserver import _forkserver
from pathlib import Path

import pytest

from gripcourse.batch.one_file import grade_file
from gripcourse.cli.foreseen import GRADING, HANDOUTS, REPORTS, foresee
from gripcourse.machine.jobs.workers import in_order, run_each
from gripcourse.policy.model import Policy
from gripcourse.solver.plan import plan_of
from gripcourse.usecases.grading.student_reports import Printing, student_pdf
from gripcourse.usecases.issuing.handout import Handout, IssuingContext, issue_one
from gripcourse.variants.model import Issued
from support.classroom import forget_one_jaw, open_classroom
from support.imports import first_imports

ONE = "student,name,group,email,language,variant\ns01,Іваненко Ганна,РТК-41,,uk,007\n"

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="workers are forks on Linux only")


@pytest.fixture
def no_workers_yet() -> Iterator[None]:
    """What workers are forks of is not the one of other tests, nor is theirs this one."""
    _forkserver._stop()  # type: ignore[attr-defined]  # noqa: SLF001 (made for tests)
    yield
    _forkserver._stop()  # type: ignore[attr-defined]  # noqa: SLF001


@pytest.mark.usefixtures("no_workers_yet")
def test_a_worker_that_was_foreseen_imports_nothing_for_its_first_job(
    policy: Policy, tmp_path: Path
) -> None:
    foresee((*GRADING, *REPORTS, *HANDOUTS), workers=1)
    classroom = open_classroom(tmp_path / "class", policy, ONE).with_its_scheme()
    classroom.issue()
    work = classroom.hand_in("s01", forget_one_jaw, tmp_path / "s01.xlsx")
    report, entry = grade_file(work, classroom.context), classroom.register["s01"]
    plan = partial(plan_of, classroom.course)
    issuing = IssuingContext(classroom.course, policy, plan, tmp_path / "again")
    jobs = (
        (grade_file, work, classroom.context),
        (student_pdf, report, Printing(classroom.course, policy, date(2026, 10, 1))),
        (_issue, entry, issuing),
    )
    for do, item, shared in jobs:
        done = run_each(first_imports, [item], (do, shared), workers=1, seconds=60)
        (imported,) = in_order(done)
        assert imported == set(), do


def _issue(entry: Issued, context: IssuingContext) -> Handout:
    return issue_one(context, entry)
