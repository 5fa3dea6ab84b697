"""The formula reference: an index, the errata, and a page for each scheme."""

from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from pathlib import PurePath

from gripcourse.documents.kind import DocumentKind, Maker, SampleDocument
from gripcourse.documents.pdf import Document
from gripcourse.documents.reference.pages import INDEX, STYLE, page_documents
from gripcourse.text.words import message


def _samples(sample: SampleDocument) -> Mapping[str, Maker]:
    """Make the pages of the sample's scheme only."""
    scheme = sample.plan.scheme
    course = replace(sample.course, schemes={scheme.id: scheme})
    made = page_documents(course, sample.words)
    return {f"reference_{PurePath(name).stem}": partial(_made, page) for name, page in made.items()}


def _made(page: Document) -> Document:
    return page


KIND = DocumentKind(
    id="reference",
    title=message("Formula reference"),
    template=INDEX,
    styles=(STYLE,),
    printed=False,
    samples=_samples,
)
