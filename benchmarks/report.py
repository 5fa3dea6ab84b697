"""What documents cost: a report beside WeasyPrint alone; every kind in time, pages and bytes.

Times are those of the processor; a report's are the least of several, taken in turn.
"""

import gc
import re
from collections.abc import Callable
from functools import partial
from io import BytesIO
from itertools import islice
from statistics import median
from time import process_time
from typing import TypeVar

import pypdf
from weasyprint import CSS, HTML

from gripcourse.course.load import load_course
from gripcourse.documents.assignment_sheet import assignment_sheet
from gripcourse.documents.kind import SampleDocument
from gripcourse.documents.pdf import pdf_from_html, render_html
from gripcourse.documents.report.student import STYLES, student_report
from gripcourse.machine.process_wide import collect_rarely
from gripcourse.machine.resources import course_root
from gripcourse.policy.load import load_policy
from gripcourse.text.words import Words
from gripcourse.usecases.authoring.samples import DAY, printed_samples, samples
from gripcourse.variants.space import load_spaces

RUNS = 7
SCHEME = "rack_parallelogram"
SCHEMES = 5  # with a worked example each, for the sheets of a course
LANGUAGE = "ru"

Made = TypeVar("Made")


def main() -> None:
    """Print figures that were all taken in this run, in turn, in one process."""
    course = load_course(course_root())
    spaces, words = load_spaces(course), Words(LANGUAGE)
    tried = list(samples(course, load_policy(course), spaces, words))
    sample = next(one for one in tried if one.plan.scheme.id == SCHEME)
    _beside_weasyprint(sample)
    _sheets(list(islice(tried, SCHEMES)))
    _kinds(sample)


def _beside_weasyprint(sample: SampleDocument) -> None:
    """Compare a report from its values to its bytes with the bare rendering of its HTML.

    Ours collects garbage as a worker does, WeasyPrint as Python does where nobody says otherwise,
    and once more as a worker does: so it is seen what that alone comes to.
    """
    templates, report = sample.course.root / "templates", sample.judged
    finished = render_html(printed_samples(sample)["student"](), templates, sample.words)

    def ours() -> bytes:
        return student_report(report, sample.plan, sample.policy, sample.course, sample.words, DAY)

    def laid_out() -> bytes:
        return pdf_from_html(finished, STYLES, templates)

    def theirs() -> bytes:
        styles = [CSS(filename=templates / "style" / name) for name in STYLES]
        return bytes(HTML(string=finished).write_pdf(stylesheets=styles, pdf_variant="pdf/ua-1"))

    as_python = gc.get_threshold()
    collect_rarely()
    as_worker = gc.get_threshold()
    compared = (
        ("student report, all in all", ours, as_worker),
        ("student report, its HTML laid out", laid_out, as_worker),
        ("WeasyPrint, garbage collected rarely", theirs, as_worker),
        ("WeasyPrint with the same HTML", theirs, as_python),
    )
    ours(), theirs()
    rounds = [[_settled(call, often) for _, call, often in compared] for _ in range(RUNS)]
    gc.set_threshold(*as_worker)
    least = [min(column) for column in zip(*rounds, strict=True)]
    for (name, _, _), seconds in zip(compared, least, strict=True):
        print(f"{name:<38} {seconds * 1e3:7.0f} ms, ratio {seconds / least[-1]:.2f}")
    print(f"boxes of the report: {len(re.findall('<[a-z]', finished))} elements")


def _settled(call: Callable[[], object], often: tuple[int, int, int]) -> float:
    """Time a call that finds no garbage of the one before it."""
    gc.set_threshold(*often)
    gc.collect()
    return _timed(call)


def _sheets(tried: list[SampleDocument]) -> None:
    """Print what an assignment sheet costs per student, over several schemes."""
    times = [median(_timed(partial(_sheet, sample)) for _ in range(3)) for sample in tried]
    print(
        f"{'assignment sheet per student':<38} {median(times) * 1e3:7.0f} ms"
        f" (slowest of {len(times)} schemes {max(times) * 1e3:.0f})"
    )


def _sheet(sample: SampleDocument) -> bytes:
    one = sample
    return assignment_sheet(one.issued, one.plan, one.policy, one.course, one.words)


def _kinds(sample: SampleDocument) -> None:
    """Print time, pages and bytes of every kind of document that is printed."""
    templates = sample.course.root / "templates"
    for kind, make in printed_samples(sample).items():
        made, making = _result(make)
        html = render_html(made, templates, sample.words)
        pdf, laying = _result(lambda: pdf_from_html(html, made.styles, templates))  # noqa: B023 (as above)
        pages = len(pypdf.PdfReader(BytesIO(pdf)).pages)
        print(
            f"{kind:<20} {pages} pages, {len(pdf) / 1e3:6.1f} kB;"
            f" values {making * 1e3:6.0f} ms, layout {laying * 1e3:6.0f} ms"
        )


def _result(call: Callable[[], Made]) -> tuple[Made, float]:
    start = process_time()
    made = call()
    return made, process_time() - start


def _timed(call: Callable[[], object]) -> float:
    return _result(call)[1]


if __name__ == "__main__":
    main()
