"""The certificate of a table of variants."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Final

from gripcourse.documents.kind import DocumentKind, Maker, SampleDocument
from gripcourse.documents.pdf import Document
from gripcourse.documents.report.certificate import (
    STYLES,
    TEMPLATE,
    CertificateSource,
    certificate_values,
)
from gripcourse.text.words import message
from gripcourse.variants.audit import audit
from gripcourse.variants.draw import draw

_DRAWN: Final = 1  # variant, which is looked at twice
_SEED: Final = 1


def _samples(sample: SampleDocument) -> Mapping[str, Maker]:
    return {"certificate": lambda: _certified(sample)} if sample.spaces else {}


def _certified(sample: SampleDocument) -> Document:
    """Make the certificate of a variant that is drawn for it, and of its twin."""
    course, policy, spaces = sample.course, sample.policy, sample.spaces
    own = [one for one in spaces if one.scheme == sample.plan.scheme.id] or spaces[:1]
    drawn = draw(course, own, _DRAWN, _SEED).variants
    # The same numbers twice: nothing may be alike, and the certificate says where something is.
    found = audit(course, policy, (*drawn, replace(drawn[0], id="twin")), own)
    source = CertificateSource("table.csv", "0" * 64)
    values = certificate_values(found, source, course, policy, sample.words)
    return Document(TEMPLATE, STYLES, values | {"day": sample.day})


KIND = DocumentKind(
    id="certificate",
    title=message("Certificate of a table of variants"),
    template=TEMPLATE,
    styles=STYLES,
    printed=True,
    samples=_samples,
)
