"""The list that goes round when assignments are handed out."""

from collections.abc import Mapping

from gripcourse.documents.handout_list import STYLES, TEMPLATE, handout_document
from gripcourse.documents.kind import DocumentKind, Maker, SampleDocument
from gripcourse.text.words import message


def _samples(sample: SampleDocument) -> Mapping[str, Maker]:
    entries = (sample.issued,)
    return {"handout": lambda: handout_document(entries, sample.course, sample.words, sample.day)}


KIND = DocumentKind(
    id="handout",
    title=message("Hand-out list"),
    template=TEMPLATE,
    styles=STYLES,
    printed=True,
    samples=_samples,
)
