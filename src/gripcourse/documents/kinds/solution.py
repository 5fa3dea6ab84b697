"""One variant fully worked, for the instructor."""

from collections.abc import Mapping

from gripcourse.documents.kind import DocumentKind, Maker, SampleDocument
from gripcourse.documents.pdf import Document
from gripcourse.documents.report.solution import STYLES, TEMPLATE, solution_values
from gripcourse.solver.solve import solve_variant
from gripcourse.text.words import message


def _samples(sample: SampleDocument) -> Mapping[str, Maker]:
    return {"solution": lambda: _worked(sample)}


def _worked(one: SampleDocument) -> Document:
    variant = one.issued.variant
    solved = solve_variant(one.plan, variant.given)
    values = solution_values(one.plan, variant, solved, one.course, one.words)
    return Document(TEMPLATE, STYLES, values)


KIND = DocumentKind(
    id="solution",
    title=message("Worked solution"),
    template=TEMPLATE,
    styles=STYLES,
    printed=True,
    samples=_samples,
)
