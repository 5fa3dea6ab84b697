"""What one student report costs, as a ratio to WeasyPrint rendering the same finished HTML."""

from collections.abc import Callable
from datetime import date
from io import BytesIO
from statistics import median
from time import perf_counter

import pypdf
from weasyprint import CSS, HTML

from gripcourse.commands.students import early_slip
from gripcourse.course.load import load_course
from gripcourse.course.model import Course, Kind
from gripcourse.course.policy_load import load_policy
from gripcourse.grading.judge import judge
from gripcourse.pdf import Document, render_html
from gripcourse.report.student import STYLES, TEMPLATE, student_report, student_values
from gripcourse.resources import course_root
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.submission.model import Answer, Identity, Reading, Submission
from gripcourse.variants.model import Issued, Student
from gripcourse.variants.table import read_table
from gripcourse.words import Words

RUNS = 7
DAY = date(2026, 12, 1)


def main() -> None:
    """Render one report both ways, in turn, in one process."""
    course = load_course(course_root())
    policy = load_policy(course)
    variant = read_table(course.root / "variants" / "tables" / "main.csv", course)[0]
    issued = Issued(Student("s1", "Student", "", "", "ru", ""), variant, DAY, None, "0" * 64)
    plan = make_plan(course, variant.scheme, variant.options)
    report = judge(_submission(plan, issued), issued, plan, policy)
    words = Words("ru")
    values = student_values(report, plan, policy, course, words) | {"graded_on": DAY}
    finished = render_html(Document(TEMPLATE, STYLES, values), course.root / "templates", words)

    def ours() -> bytes:
        return student_report(report, plan, policy, course, words, DAY)

    def theirs() -> bytes:
        return _bare(finished, course)

    ours(), theirs()
    pairs = [(_timed(ours), _timed(theirs)) for _ in range(RUNS)]
    mine, bare = median(a for a, _ in pairs), median(b for _, b in pairs)
    pages = len(pypdf.PdfReader(BytesIO(ours())).pages)
    print(f"student report, all in all             {mine * 1e3:7.0f} ms")
    print(f"WeasyPrint with the same HTML          {bare * 1e3:7.0f} ms")
    print(f"ratio                                  {median(a / b for a, b in pairs):7.2f}")
    print(f"pages {pages}, bytes {len(ours())}")


def _submission(plan: Plan, issued: Issued) -> Submission:
    typed = early_slip(plan, issued)
    answers = {
        name: Answer(
            quantity=name,
            reading=Reading.READ,
            value=float(value == "да")
            if plan.quantities[name].kind is Kind.VERDICT
            else float(value),
            typed=str(value),
            cell="A1",
            half_unit=0.0,
            unit="",
            unit_fits=True,
            remarks=(),
        )
        for name, value in typed.items()
    }
    identity = Identity("s1", issued.variant.id, plan.scheme.id, plan.options, issued.signature)
    return Submission("s1.xlsx", "", identity, "", issued.variant.given, answers, ())


def _bare(html: str, course: Course) -> bytes:
    folder = course.root / "templates" / "style"
    styles = [CSS(filename=folder / name) for name in STYLES]
    return HTML(string=html).write_pdf(stylesheets=styles, pdf_variant="pdf/ua-1")


def _timed(call: Callable[[], object]) -> float:
    start = perf_counter()
    call()
    return perf_counter() - start


if __name__ == "__main__":
    main()
