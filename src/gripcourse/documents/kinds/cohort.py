"""The report on a batch of works."""

from collections.abc import Mapping, Sequence

from gripcourse.documents.kind import DocumentKind, Maker, SampleDocument
from gripcourse.documents.pdf import Document
from gripcourse.documents.report.cohort import STYLES, TEMPLATE, cohort_values
from gripcourse.grading.model import Report
from gripcourse.text.words import message


def _samples(sample: SampleDocument) -> Mapping[str, Maker]:
    return {"cohort": lambda: summary(sample, [sample.judged, sample.refused])}


def summary(sample: SampleDocument, reports: Sequence[Report]) -> Document:
    """Make the report on works of a worked example."""
    values = cohort_values(reports, sample.policy, sample.course, sample.words)
    return Document(TEMPLATE, STYLES, values | {"graded_on": sample.day})


KIND = DocumentKind(
    id="cohort",
    title=message("Report on the cohort"),
    template=TEMPLATE,
    styles=STYLES,
    printed=True,
    samples=_samples,
)
