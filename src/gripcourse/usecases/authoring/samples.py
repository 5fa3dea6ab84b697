"""A worked example as what documents of every kind are made from.

What a course prints is tried with these before anybody gets it: answers of every sort, so that
every part of a template is used.
"""

from collections.abc import Iterator, Sequence
from datetime import date
from itertools import cycle

from gripcourse.course.composition import Composition
from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind
from gripcourse.documents.kind import Maker, SampleDocument
from gripcourse.documents.registry import document_kinds
from gripcourse.grading.judge import judge
from gripcourse.grading.model import Report
from gripcourse.grading.unjudged import rejected_report
from gripcourse.policy.model import Policy
from gripcourse.solver.plan import Plan, plan_of, usual_values
from gripcourse.solver.solve import solve_variant
from gripcourse.submission.model import Answer, Identity, Reading, Rejected, Submission
from gripcourse.text.words import Words, message
from gripcourse.variants.model import Issued, Student, Variant
from gripcourse.variants.space import Space

DAY = date(2026, 12, 1)
NAME = "Ada Lovelace"
_SLIPPED = 1.37  # times the right value: no rounding, and no slip of any course


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
        plan = plan_of(course, Composition.of(scheme.id, example.options))
        variant = Variant("001", scheme.id, dict(plan.options), usual_values(plan))
        student = Student("s1", name, "", "", words.language, "")
        issued = Issued(student, variant, DAY, DAY, "0" * 64)
        yield SampleDocument(
            course=course,
            policy=policy,
            spaces=tuple(spaces),
            plan=plan,
            issued=issued,
            words=words,
            day=DAY,
            judged=judged_sample(issued, plan, policy),
            refused=refused_sample(issued),
        )


def printed_samples(sample: SampleDocument) -> dict[str, Maker]:
    """Return how each document that is printed is made of a sample, by its name."""
    printed = (kind for kind in document_kinds() if kind.printed)
    return {name: make for kind in printed for name, make in kind.samples(sample).items()}


def judged_sample(issued: Issued, plan: Plan, policy: Policy) -> Report:
    """Judge answers of every sort in turn: right, wrong, blank, unreadable."""
    values = solve_variant(plan, issued.variant.given)
    sorts = cycle((1.0, _SLIPPED, None, "~"))
    answers = {
        one.id: _answer(one.id, values[one.id], 1.0 if one.kind is Kind.VERDICT else sort)
        for one, sort in zip(plan.answered, sorts, strict=False)
    }
    identity = Identity("s1", issued.variant.id, plan.scheme.id, plan.options, issued.signature)
    remarks = (message("The workbook says nothing about its student."),)
    submission = Submission("s1.xlsx", "", identity, "", issued.variant.given, answers, remarks)
    return judge(submission, issued, plan, policy)


def refused_sample(issued: Issued) -> Report:
    """Report a file that is no workbook."""
    reason = message("Hand in the answer workbook that you were given.")
    return rejected_report(Rejected("s1.txt", "", reason), issued)


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
