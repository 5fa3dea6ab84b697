"""The report on one student's work, before and after the reference is published."""

from collections.abc import Mapping
from dataclasses import replace

from gripcourse.documents.kind import DocumentKind, Maker, SampleDocument
from gripcourse.documents.pdf import Document
from gripcourse.documents.report.student import STYLES, TEMPLATE, student_values
from gripcourse.grading.model import Report
from gripcourse.policy.model import Reveal
from gripcourse.text.words import message


def _samples(sample: SampleDocument) -> Mapping[str, Maker]:
    return {
        "student": lambda: report_page(sample, sample.judged, Reveal.NOTHING),
        "student_revealed": lambda: report_page(sample, sample.judged, Reveal.REFERENCE),
        "student_refused": lambda: report_page(sample, sample.refused, Reveal.NOTHING),
    }


def report_page(sample: SampleDocument, report: Report, reveal: Reveal) -> Document:
    """Make a report on a worked example."""
    policy = replace(sample.policy, reveal=reveal)
    values = student_values(report, sample.plan, policy, sample.course, sample.words)
    return Document(TEMPLATE, STYLES, values | {"graded_on": sample.day})


KIND = DocumentKind(
    id="student",
    title=message("Report on the assignment"),
    template=TEMPLATE,
    styles=STYLES,
    printed=True,
    samples=_samples,
)
