"""Pictures of every kind of page and drawing, for docs/gallery/.

    scripts/gallery.py OUT PICTURES

OUT is the folder that the demo was made in. What the demo has no example of is made here by the
same functions: the longest assignment under the longest name, a report after publication, a cohort
of sixty, the diagram and the general view of every scheme, the certificate, the atlas; of every
kind of document that has no picture yet, the first page of each of its samples.
"""

import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from gripcourse.batch.context import GradingContext
from gripcourse.cli.demo.run import DEADLINE, GRADED_ON, ISSUED_ON
from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.documents.assignment_sheet import assignment_sheet
from gripcourse.documents.kind import DocumentKind
from gripcourse.documents.pdf import pdf_from_html, render_pdf
from gripcourse.documents.registry import document_kinds
from gripcourse.documents.report.cohort import cohort_report
from gripcourse.documents.report.student import student_report
from gripcourse.drawing.diagram.kinematic_diagram import kinematic_diagram
from gripcourse.drawing.paper.title_block import variant_block
from gripcourse.drawing.view.general_view import general_view, sheet_svg
from gripcourse.issuing.store import read_register
from gripcourse.policy.load import load_policy
from gripcourse.policy.model import Policy, Reveal
from gripcourse.simulation.cohort import make_classroom
from gripcourse.simulation.in_memory import judge_in_memory
from gripcourse.simulation.mix import load_mix
from gripcourse.solver.plan import Plan, plan_of
from gripcourse.solver.solve import solve_variant
from gripcourse.text.words import Words
from gripcourse.usecases.authoring.atlas import draw_atlas
from gripcourse.usecases.authoring.samples import samples
from gripcourse.usecases.grading.grade import grade
from gripcourse.usecases.issuing.handout import workbook_path
from gripcourse.usecases.solving.audit import audit_table
from gripcourse.usecases.solving.solve import solve_from_table, write_solution
from gripcourse.variants.model import Issued, Student, Variant
from gripcourse.variants.space import load_spaces
from gripcourse.variants.table import read_table

DOTS_PER_INCH = 80
SHADES = 16  # of grey, of drawings
WIDE = 1200  # dots of a general view, whatever its sheet
STUDENT, UKRAINIAN = "smirnova-ev", "shevchenko-ok"
LONG_NAME = "Константинопольський-Верхньодніпровський Всеволод-Олександр"
LONG_GROUP = "РТК-41мн, друга вища освіта, вечірня форма навчання"
COHORT, SEED, WORKERS = 60, 1, 2
# Kinds of documents that have pictures with better data than a sample's; a browser shows one kind.
PICTURED = frozenset({"assignment", "student", "cohort", "solution", "certificate", "atlas"})

Shown = tuple[str, Path, int]
"""A picture: its name, the document, and the page, counted from the end where negative."""


def main(out: Path, pictures: Path) -> None:
    """Make all pictures."""
    pictures.mkdir(parents=True, exist_ok=True)
    for old in pictures.glob("*.png"):
        old.unlink()
    course = load_course(out / "course")
    with tempfile.TemporaryDirectory() as folder:
        for name, document, page in _documents(course, out, Path(folder)):
            _show(document, page, pictures / name)
            print(pictures / f"{name}.png")
        for name, document in _drawings(course, Path(folder)):
            _show_drawing(document, pictures / name)
            print(pictures / f"{name}.png")


def _documents(course: Course, out: Path, made: Path) -> Iterator[Shown]:
    policy = load_policy(course)
    words = Words(course.language)
    table = course.root / "variants" / "tables" / "main.csv"
    variants = read_table(table, course)
    register = read_register(course.root, course.id).by_student()
    assigned = out / "assignments" / STUDENT / f"assignment_{STUDENT}.pdf"
    yield "assignment_1", assigned, 1
    yield "assignment_2", assigned, 2
    yield "assignment_appendix", assigned, -1
    longest = _written(made / "longest.pdf", _longest_sheet(variants, policy, course))
    yield "assignment_longest_1", longest, 1
    yield "assignment_longest_2", longest, 2
    yield "workbook", _as_pdf(workbook_path(out / "assignments", STUDENT), made), 2
    yield "student_report", out / "graded" / "reports" / f"{STUDENT}.pdf", 1
    yield "student_report_uk", out / "graded" / "reports" / f"{UKRAINIAN}.pdf", 1
    published = _written(
        made / "published.pdf", _published(out, GradingContext(course, policy, register))
    )
    yield "student_report_published_1", published, 1
    yield "student_report_published_2", published, 2
    cohort = _written(made / "cohort.pdf", _cohort(course, policy))
    yield "cohort_summary", cohort, 1
    yield "cohort_mistakes", cohort, 4
    yield "cohort_quantities", cohort, 6
    solved = solve_from_table(course, variants, register[STUDENT].variant.id, None)
    solution = write_solution(solved, made / "solution.pdf", words)
    yield "solution", solution, 2
    yield "general_view", solution, -1
    audit_table(course, table, made / "audit", words, ISSUED_ON)
    yield "certificate", made / "audit" / "certificate.pdf", 1
    for path in draw_atlas(course, "lever-arms", made / "atlas", words):
        if path.suffix == ".pdf":
            yield "atlas", path, 1
    sample = next(samples(course, policy, load_spaces(course), words))
    for kind in unpictured():
        for name, make in kind.samples(sample).items():
            document = render_pdf(make(), course.root / "templates", words)
            yield name, _written(made / f"{name}.pdf", document), 1


def unpictured() -> tuple[DocumentKind, ...]:
    """Return the kinds of printed documents that only their samples show."""
    return tuple(one for one in document_kinds() if one.printed and one.id not in PICTURED)


def _longest_sheet(variants: Sequence[Variant], policy: Policy, course: Course) -> bytes:
    """Make the sheet of the longest assignment of the table for the longest of names."""
    longest = max(variants, key=lambda variant: len(_plan(variant, course).quantities))
    student = Student("longest", LONG_NAME, LONG_GROUP, "", "uk", longest.id)
    entry = Issued(student, longest, ISSUED_ON, DEADLINE, "0" * 64)
    return assignment_sheet(entry, _plan(longest, course), policy, course, Words("uk"))


def _published(out: Path, desk: GradingContext) -> bytes:
    """Make the report that the student gets when the reference may be shown."""
    (graded,) = grade([out / "submissions" / f"{STUDENT}.xlsx"], desk, 1, lambda _: None)
    variant = desk.register[STUDENT].variant
    shown = replace(desk.policy, reveal=Reveal.REFERENCE)
    words = Words(desk.register[STUDENT].student.language or desk.course.language)
    plan = _plan(variant, desk.course)
    return student_report(graded.report, plan, shown, desk.course, words, GRADED_ON)


def _cohort(course: Course, policy: Policy) -> bytes:
    """Make the report on virtual students of all schemes, in English."""
    room = make_classroom(course, policy, load_mix(course), COHORT, SEED)
    reports = [judged.report for judged in judge_in_memory(room, WORKERS)]
    return cohort_report(reports, policy, course, Words("en"), GRADED_ON)


def _drawings(course: Course, made: Path) -> Iterator[tuple[str, Path]]:
    """Draw the diagram and the general view of the first variant of every scheme, as PDF files."""
    words, templates = Words(course.language), course.root / "templates"
    variants = read_table(course.root / "variants" / "tables" / "main.csv", course)
    for scheme, variant in sorted({one.scheme: one for one in reversed(variants)}.items()):
        plan = _plan(variant, course)
        diagram = kinematic_diagram(plan, variant.given, words.language)
        if diagram is not None:
            page = _page(diagram.svg(), diagram.width, diagram.height, words)
            document = pdf_from_html(page, (), templates)
            yield f"diagram_{scheme}", _written(made / f"diagram_{scheme}.pdf", document)
        if plan.scheme.view is not None:
            block = variant_block(plan, variant.id, "", words)
            values = solve_variant(plan, variant.given)
            drawn = general_view(plan, plan.scheme.view, values, block, words)
            sheet = drawn.arranged.sheet
            page = _page(sheet_svg(drawn, block)[0], sheet.width, sheet.height, words)
            document = pdf_from_html(page, (), templates)
            yield f"view_{scheme}", _written(made / f"view_{scheme}.pdf", document)


def _page(svg: str, width: float, height: float, words: Words) -> str:
    """Return a page that is as large as a drawing."""
    style = f"@page {{ size: {width}mm {height}mm; margin: 0 }} body {{ margin: 0 }}"
    head = f"<title>–</title><style>{style}</style>"
    return f'<html lang="{words.language}">{head}<body>{svg}</body></html>'


def _plan(variant: Variant, course: Course) -> Plan:
    return plan_of(course, variant.composition)


def _as_pdf(workbook: Path, folder: Path) -> Path:
    """Let LibreOffice print a workbook."""
    profile = f"-env:UserInstallation={(folder / 'profile').as_uri()}"
    _run("soffice", profile, "--headless", "--convert-to", "pdf", "--outdir", folder, workbook)
    return folder / f"{workbook.stem}.pdf"


def _written(path: Path, content: bytes) -> Path:
    path.write_bytes(content)
    return path


def _show(document: Path, page: int, picture: Path) -> None:
    """Draw a page of a document as a PNG file of few colours."""
    if page < 0:
        described = _run("pdfinfo", document)
        count = next(line for line in described.splitlines() if line.startswith("Pages:"))
        page += int(count.split()[1]) + 1
    places = ("-f", page, "-l", page, "-singlefile")
    _run("pdftoppm", "-png", "-r", DOTS_PER_INCH, *places, document, picture)


def _show_drawing(document: Path, picture: Path) -> None:
    """Draw a drawing as a PNG file of few greys, so that all of them take little room."""
    from PIL import Image  # noqa: PLC0415 (as all other libraries of pictures, only here)

    _run("pdftoppm", "-gray", "-r", 110, "-scale-to", WIDE, "-singlefile", document, picture)
    plain = picture.with_suffix(".pgm")
    with Image.open(plain) as image:
        image.quantize(SHADES).save(picture.with_suffix(".png"), optimize=True)
    plain.unlink()


def _run(*command: object) -> str:
    done = subprocess.run(list(map(str, command)), check=True, capture_output=True)  # noqa: S603 (own words)
    return done.stdout.decode()


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:3]))
