"""What students hand in and what they are called may be long: nothing leaves the page."""

from collections.abc import Callable
from dataclasses import replace
from datetime import date

import pytest

from gripcourse.course.model import Course
from gripcourse.documents.report.cohort import cohort_report
from gripcourse.documents.report.student import student_report
from gripcourse.grading.model import Against, Flag, FlagCode, Outcome, Report
from gripcourse.policy.model import Policy, Reveal
from gripcourse.solver.plan import Plan
from gripcourse.text.words import Words, message

UNBROKEN_NAME = "Константинопольсковерхнеднепровскоалександровсковсеволодович"
HOSTILE = '=HYPERLINK("http://x")<script>' + "Щ" * 300
Beyond = Callable[[bytes], list[str]]


@pytest.fixture
def hostile(perfect: Report, with_finding: Callable[..., Report]) -> Report:
    """The report of a long name on a workbook of which many cells hold long unbroken texts."""
    report = replace(perfect, name=UNBROKEN_NAME)
    for finding in perfect.findings[::4]:
        report = with_finding(
            report,
            finding.quantity,
            outcome=Outcome.UNREADABLE,
            against=Against.NOTHING,
            given=None,
            typed=HOSTILE,
            points=0.0,
            remarks=(message("The cell holds text."),),
        )
    return report


@pytest.fixture
def written(hostile: Report, plan: Plan, policy: Policy, course: Course, graded_on: date) -> bytes:
    """The student's report of it, with the reference."""
    shown = replace(policy, reveal=Reveal.REFERENCE)
    return student_report(hostile, plan, shown, course, Words("uk"), graded_on)


def test_no_text_of_a_student_leaves_the_page_of_the_report(
    written: bytes, beyond_the_edge: Beyond, pages_of: Callable[[bytes], list[str]]
) -> None:
    assert not beyond_the_edge(written)
    assert "http" in pages_of(written)[0]  # the list begins below the result, not on its own page


def test_no_text_of_a_student_leaves_the_page_of_the_cohort(
    hostile: Report, policy: Policy, course: Course, graded_on: date, beyond_the_edge: Beyond
) -> None:
    flag = Flag(
        FlagCode.SIGNATURE, message("The workbook names the author {name}.", name="Щ" * 200)
    )
    flagged = replace(hostile, flags=(flag,), file=f"{'ф' * 200}.xlsx")
    pdf = cohort_report([flagged] * 3, policy, course, Words("uk"), graded_on)
    assert not beyond_the_edge(pdf)
