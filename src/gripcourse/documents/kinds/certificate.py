"""The certificate of a table of variants."""

from collections.abc import Mapping
from dataclasses import replace

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


def _samples(sample: SampleDocument) -> Mapping[str, Maker]:
    return {"certificate": lambda: _certified(sample)} if sample.spaces else {}


def _certified(sample: SampleDocument) -> Document:
    """Make the certificate of the numbers of the worked example."""
    course, policy, spaces = sample.course, sample.policy, sample.spaces
    own = [one for one in spaces if one.scheme == sample.plan.scheme.id] or spaces[:1]
    # Twice: nothing may be alike, and the certificate says where something is. Nothing is drawn,
    # for which a second of imports would be paid.
    variant = sample.issued.variant
    found = audit(course, policy, (variant, replace(variant, id="twin")), own)
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
