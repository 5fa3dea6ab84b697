"""The assignment sheet of one student."""

from collections.abc import Mapping

from gripcourse.documents.assignment_sheet import STYLES, TEMPLATE, sheet_values
from gripcourse.documents.kind import DocumentKind, Maker, SampleDocument
from gripcourse.documents.pdf import Document
from gripcourse.text.words import message


def _samples(sample: SampleDocument) -> Mapping[str, Maker]:
    return {"assignment": lambda: sheet(sample)}


def sheet(one: SampleDocument) -> Document:
    """Make the sheet of a worked example."""
    values = sheet_values(one.issued, one.plan, one.policy, one.course, one.words)
    return Document(TEMPLATE, STYLES, values)


KIND = DocumentKind(
    id="assignment",
    title=message("Individual assignment"),
    template=TEMPLATE,
    styles=STYLES,
    printed=True,
    samples=_samples,
)
