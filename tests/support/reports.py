"""One variant of the reference course solved, and reports put together by hand."""

import html
import io
import re
from collections.abc import Callable
from dataclasses import replace
from datetime import date

import pytest
from pypdf import PdfReader

from gripcourse.course.model import WorkedExample
from gripcourse.course.quantity import Kind
from gripcourse.grading.model import Against, Finding, Outcome, Report
from gripcourse.solver.plan import Plan
from gripcourse.solver.solve import solve_variant
from gripcourse.text.words import message
from gripcourse.variants.model import Variant
from support import printed

GRADED_ON = date(2025, 5, 21)
LONG_NAME = "Константинопольский-Верхнеднепровский Александр Всеволодович"

Change = Callable[..., Report]


@pytest.fixture(scope="session")
def variant(plan: Plan, example: WorkedExample) -> Variant:
    given = {quantity.id: example.given[quantity.id] for quantity in plan.givens}
    return Variant("17", plan.scheme.id, dict(plan.options), given)


@pytest.fixture(scope="session")
def values(plan: Plan, variant: Variant) -> dict[str, float]:
    return solve_variant(plan, variant.given)


@pytest.fixture(scope="session")
def perfect(plan: Plan, values: dict[str, float]) -> Report:
    """The report of somebody whose every answer is the reference; manual items are open."""
    ranks = {section.id: rank for rank, section in enumerate(plan.course.sections)}
    asked = sorted((*plan.answered, *plan.manual), key=lambda one: ranks[one.section])
    findings = tuple(
        Finding(
            quantity=one.id,
            section=one.section,
            outcome=Outcome.MANUAL if one.kind is Kind.MANUAL else Outcome.CORRECT,
            against=Against.NOTHING if one.kind is Kind.MANUAL else Against.REFERENCE,
            given=values.get(one.id),
            typed="",
            cell=f"Ответы!D{row}",
            reference=values.get(one.id),
            expected=values.get(one.id),
            band=0.0,
            inputs={name: values[name] for name in plan.inputs[one.id]},
            points=0.0 if one.kind is Kind.MANUAL else 2.0,
            max_points=2.0,
            slip=None,
            message=message("Correct."),
            remarks=(),
        )
        for row, one in enumerate(asked, start=10)
    )
    return _summed(
        Report(
            file="inbox/s017.xlsx",
            student="s017",
            name="Иванова Ольга",
            variant="17",
            scheme=plan.scheme.id,
            options=plan.options,
            language="ru",
            score=0.0,
            max_score=0.0,
            open_points=0.0,
            flags=(),
            findings=findings,
            remarks=(),
            judged=True,
        )
    )


def _summed(report: Report) -> Report:
    """Bring the sums of a report in line with its findings."""
    scored = [one for one in report.findings if one.outcome is not Outcome.MANUAL]
    manual = [one for one in report.findings if one.outcome is Outcome.MANUAL]
    return replace(
        report,
        score=sum(one.points for one in scored),
        max_score=sum(one.max_points for one in scored),
        open_points=sum(one.max_points for one in manual),
    )


def _with_finding(report: Report, quantity: str, **changes: object) -> Report:
    """Change the finding of one quantity, as `dataclasses.replace` does, and the sums."""
    findings = tuple(
        replace(one, **changes) if one.quantity == quantity else one  # type: ignore[arg-type]
        for one in report.findings
    )
    return _summed(replace(report, findings=findings))


def _wrong(report: Report, quantity: str, given: float, **changes: object) -> Report:
    """Let one answer be wrong."""
    return _with_finding(
        report,
        quantity,
        outcome=Outcome.WRONG,
        against=Against.NOTHING,
        given=given,
        points=0.0,
        message=message("Does not follow from the formula with your numbers."),
        **changes,
    )


def _blank(report: Report, quantity: str) -> Report:
    """Let one cell be empty."""
    return _with_finding(
        report,
        quantity,
        outcome=Outcome.BLANK,
        against=Against.NOTHING,
        given=None,
        points=0.0,
        message=message("No answer."),
    )


def _rejected(report: Report) -> Report:
    """Make the report of a file of the same student that could not be judged."""
    return replace(
        report, score=0.0, max_score=0.0, open_points=0.0, findings=(), judged=False, remarks=()
    )


def _read(page: str) -> str:
    """Return the text of HTML, every run of spaces as one space."""
    text = html.unescape(re.sub(r"<[^>]*>", " ", page[page.index("<body") :])).replace("\u2060", "")
    return " ".join(text.split())


def _text_of(pdf: bytes) -> str:
    return " ".join(printed.pages_of(pdf))


def _embedded_fonts(pdf: bytes) -> dict[str, bool]:
    """Tell for each font of a document whether its letters are in the file."""
    found: dict[str, bool] = {}
    for page in PdfReader(io.BytesIO(pdf)).pages:
        for font in page["/Resources"]["/Font"].values():
            for descendant in font.get_object()["/DescendantFonts"]:
                one = descendant.get_object()
                descriptor = one["/FontDescriptor"].get_object()
                held = {"/FontFile", "/FontFile2", "/FontFile3"} & set(descriptor)
                found[str(one["/BaseFont"])] = bool(held)
    return found


@pytest.fixture(scope="session")
def long_name() -> str:
    return LONG_NAME


@pytest.fixture(scope="session")
def graded_on() -> date:
    return GRADED_ON


@pytest.fixture(scope="session")
def with_finding() -> Change:
    return _with_finding


@pytest.fixture(scope="session")
def wrong() -> Change:
    return _wrong


@pytest.fixture(scope="session")
def blank() -> Change:
    return _blank


@pytest.fixture(scope="session")
def rejected() -> Change:
    return _rejected


@pytest.fixture(scope="session")
def pages_of() -> Callable[[bytes], list[str]]:
    return printed.pages_of


@pytest.fixture(scope="session")
def text_of() -> Callable[[bytes], str]:
    return _text_of


@pytest.fixture(scope="session")
def embedded_fonts() -> Callable[[bytes], dict[str, bool]]:
    return _embedded_fonts


@pytest.fixture(scope="session")
def read() -> Callable[[str], str]:
    return _read
