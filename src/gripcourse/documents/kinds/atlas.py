"""Figures and cases of a source, reproduced from the course's formulas."""

from collections.abc import Mapping
from functools import partial

from gripcourse.course.check_atlas import load_atlas
from gripcourse.documents.kind import DocumentKind, Maker, SampleDocument
from gripcourse.documents.pdf import Document
from gripcourse.documents.report.atlas import STYLES, TEMPLATE, atlas_values, plates
from gripcourse.text.words import message


def _samples(sample: SampleDocument) -> Mapping[str, Maker]:
    written = sorted((sample.course.root / "variants" / "atlas").glob("*.toml"))
    return {f"atlas_{path.stem}": partial(_drawn, sample, path.stem) for path in written}


def _drawn(sample: SampleDocument, name: str) -> Document:
    loaded = load_atlas(sample.course, name)
    drawn = plates(loaded, sample.course, sample.words)
    values = atlas_values(loaded, drawn, sample.course, sample.words)
    return Document(TEMPLATE, STYLES, values)


KIND = DocumentKind(
    id="atlas",
    title=message("Atlas"),
    template=TEMPLATE,
    styles=STYLES,
    printed=True,
    samples=_samples,
)
