"""A document of every kind, filled with the data of a worked example.

What a course prints is tried with these before anybody gets it: answers of every sort, so that
every part of a template is used.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from datetime import date
from itertools import cycle

from gripcourse.course.atlas import load_atlas
from gripcourse.course.model import Course, Kind
from gripcourse.documents.assignment_sheet import STYLES as SHEET_STYLES
from gripcourse.documents.assignment_sheet import TEMPLATE as SHEET
from gripcourse.documents.assignment_sheet import sheet_values
from gripcourse.documents.pdf import Document
from gripcourse.documents.reference.pages import page_documents
from gripcourse.grading.judge import judge
from gripcourse.grading.model import Report
from gripcourse.grading.unjudged import rejected_report
from gripcourse.policy.model import Policy, Reveal
from gripcourse.solver.plan import Plan, make_plan, usual_values
from gripcourse.solver.solve import solve_variant
from gripcourse.submission.model import Answer, Identity, Reading, Rejected, Submission
from gripcourse.text.words import Words, message
from gripcourse.variants.audit import audit
from gripcourse.variants.draw import draw
from gripcourse.variants.model import Issued, Student, Variant
from gripcourse.variants.space import Space

# matplotlib, which draws the plots of three kinds, costs 400 ms to import.
# ruff: noqa: PLC0415

DAY = date(2026, 12, 1)
NAME = "Ada Lovelace"
_DRAWN, _SEED = 3, 1
_SLIPPED = 1.37  # times the right value: no rounding, and no slip of any course


@dataclass(frozen=True, slots=True)
class SampleDocument:
    """What the documents of a worked example are made from; spaces are those of all schemes."""

    course: Course
    policy: Policy
    spaces: tuple[Space, ...]
    plan: Plan
    issued: Issued
    words: Words


def samples(
    course: Course, policy: Policy, spaces: Sequence[Space], words: Words, name: str = NAME
) -> Iterator[SampleDocument]:
    """Yield what can be printed of each scheme that has a worked example.

    Args:
        course: titles, declarations and worked examples.
        policy: points and bands.
        spaces: to draw variants for a certificate from; none for no certificate.
        words: the language of the documents.
        name: of the student.
    """
    for scheme in course.schemes.values():
        example = scheme.example
        if example is None:
            continue
        plan = make_plan(course, scheme.id, example.options)
        variant = Variant("001", scheme.id, dict(plan.options), usual_values(plan))
        student = Student("s1", name, "", "", words.language, "")
        issued = Issued(student, variant, DAY, DAY, "0" * 64)
        yield SampleDocument(course, policy, tuple(spaces), plan, issued, words)


def printed_documents(sample: SampleDocument) -> dict[str, Callable[[], Document]]:
    """Return how each kind of PDF document is made, by a name for the kind."""
    made = {
        "assignment": lambda: assignment(sample),
        "student": lambda: student(sample, sample_report(sample), Reveal.NOTHING),
        "student_revealed": lambda: student(sample, sample_report(sample), Reveal.REFERENCE),
        "student_refused": lambda: student(sample, refused_report(sample), Reveal.NOTHING),
        "cohort": lambda: cohort(sample, [sample_report(sample), refused_report(sample)]),
        "solution": lambda: solution(sample),
    }
    if sample.spaces:
        made["certificate"] = lambda: certificate(sample)
    for path in sorted((sample.course.root / "variants" / "atlas").glob("*.toml")):
        made[f"atlas_{path.stem}"] = lambda name=path.stem: atlas(sample, name)  # type: ignore[misc]
    return made


def reference_documents(sample: SampleDocument) -> dict[str, Document]:
    """Return the pages of the formula reference of the sample's scheme."""
    one = {sample.plan.scheme.id: sample.plan.scheme}
    return page_documents(replace(sample.course, schemes=one), sample.words)


def sample_report(sample: SampleDocument) -> Report:
    """Judge answers of every sort in turn: right, wrong, blank, unreadable."""
    plan, issued = sample.plan, sample.issued
    values = solve_variant(plan, issued.variant.given)
    sorts = cycle((1.0, _SLIPPED, None, "~"))
    answers = {
        one.id: _answer(one.id, values[one.id], 1.0 if one.kind is Kind.VERDICT else sort)
        for one, sort in zip(plan.answered, sorts, strict=False)
    }
    identity = Identity("s1", issued.variant.id, plan.scheme.id, plan.options, issued.signature)
    remarks = (message("The workbook says nothing about its student."),)
    submission = Submission("s1.xlsx", "", identity, "", issued.variant.given, answers, remarks)
    return judge(submission, issued, plan, sample.policy)


def refused_report(sample: SampleDocument) -> Report:
    """Report a file that is no workbook."""
    reason = message("Hand in the answer workbook that you were given.")
    return rejected_report(Rejected("s1.txt", "", reason), sample.issued)


def assignment(sample: SampleDocument) -> Document:
    """Make the assignment sheet."""
    one = sample
    return Document(
        SHEET, SHEET_STYLES, sheet_values(one.issued, one.plan, one.policy, one.course, one.words)
    )


def student(sample: SampleDocument, report: Report, reveal: Reveal) -> Document:
    """Make a student's report, before or after the reference is published."""
    from gripcourse.documents.report.student import STYLES, TEMPLATE, student_values

    policy = replace(sample.policy, reveal=reveal)
    values = student_values(report, sample.plan, policy, sample.course, sample.words)
    return Document(TEMPLATE, STYLES, values | {"graded_on": DAY})


def cohort(sample: SampleDocument, reports: Sequence[Report]) -> Document:
    """Make the report on a batch."""
    from gripcourse.documents.report.cohort import STYLES, TEMPLATE, cohort_values

    values = cohort_values(reports, sample.policy, sample.course, sample.words)
    return Document(TEMPLATE, STYLES, values | {"graded_on": DAY})


def solution(sample: SampleDocument) -> Document:
    """Make the worked solution."""
    from gripcourse.documents.report.solution import STYLES, TEMPLATE, solution_values

    values = solve_variant(sample.plan, sample.issued.variant.given)
    variant, course = sample.issued.variant, sample.course
    return Document(
        TEMPLATE, STYLES, solution_values(sample.plan, variant, values, course, sample.words)
    )


def certificate(sample: SampleDocument) -> Document:
    """Make the certificate of a few variants that are drawn for it."""
    from gripcourse.documents.report.certificate import (
        STYLES,
        TEMPLATE,
        CertificateSource,
        certificate_values,
    )

    course, policy = sample.course, sample.policy
    spaces = sample.spaces
    own = [one for one in spaces if one.scheme == sample.plan.scheme.id] or spaces[:1]
    drawn = draw(course, own, _DRAWN, _SEED).variants
    # The same numbers twice: nothing may be alike, and the certificate says where something is.
    found = audit(course, policy, (*drawn, replace(drawn[0], id="twin")), own)
    source = CertificateSource("table.csv", "0" * 64)
    values = certificate_values(found, source, course, policy, sample.words)
    return Document(TEMPLATE, STYLES, values | {"day": DAY})


def atlas(sample: SampleDocument, name: str) -> Document:
    """Make an atlas of the course."""
    from gripcourse.documents.report.atlas import STYLES, TEMPLATE, atlas_values, plates

    loaded = load_atlas(sample.course.root, name)
    drawn = plates(loaded, sample.course, sample.words)
    return Document(TEMPLATE, STYLES, atlas_values(loaded, drawn, sample.course, sample.words))


def _answer(quantity: str, right: float, sort: float | str | None) -> Answer:
    value = right * sort if isinstance(sort, float) else None
    reading = Reading.READ
    if value is None:
        reading = Reading.BLANK if sort is None else Reading.UNREADABLE
    return Answer(
        quantity=quantity,
        reading=reading,
        value=value,
        typed="" if sort is None else str(sort if value is None else value),
        cell="A1",
        half_unit=0.0,
        unit="",
        unit_fits=True,
        remarks=(),
    )
