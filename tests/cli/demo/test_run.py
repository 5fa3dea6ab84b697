"""The demo is the whole main job: everybody gets what the script says."""

import io
import json
import platform
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import pytest
from openpyxl import load_workbook
from openpyxl.comments import Comment
from openpyxl.workbook.defined_name import DefinedName
from pypdf import PdfWriter

from gripcourse.cli.demo.run import MARKED_STORY, Demo, run_demo
from gripcourse.cli.demo.students import COPIED, fill_workbooks
from gripcourse.cli.grading_text import demo_text
from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.documents.assignment_sheet import (
    STYLES,
    TEMPLATE,
    assignment_sheet,
    sheet_values,
)
from gripcourse.documents.pdf import Document, render_html
from gripcourse.documents.report.student import student_report
from gripcourse.grading.model import Outcome, Report
from gripcourse.issuing.signature import key_path, read_key
from gripcourse.issuing.store import read_register
from gripcourse.machine.resources import course_root
from gripcourse.policy.load import load_policy
from gripcourse.solver.plan import Plan, plan_of
from gripcourse.solver.solve import solve_variant
from gripcourse.text.number_text import format_number
from gripcourse.text.units import factor
from gripcourse.text.words import Words
from gripcourse.usecases.issuing.handout import sheet_path, workbook_path
from gripcourse.variants.model import Issued
from gripcourse.workbook.write import answer_workbook
from support.leaks import Piece, numbers_in, numbers_told, pieces, places_told, secrets_told

# One student of each language, with schemes of their own. The sheet of the first is laid out; of
# the others what it is laid out from is looked through, by the same code in every language.
LOOKED_AT = ("ivanova-ap", "shevchenko-ok", "carter-jl")
LAID_OUT = LOOKED_AT[0]
USER = "somebody-at-the-desk"
# Whose reports are read, by their stories: a sound one and an empty one.
REPORTS_READ = ("correct", "blank")
PAGE = b"%PDF-1.7 that nobody reads\n"


@pytest.fixture(scope="session")
def demo(tmp_path_factory: pytest.TempPathFactory) -> Demo:
    """The real thing, once; of sheets and reports only those are laid out that are read here.

    Each takes more than a second, and `make demo` lays out all of them.
    """
    out = tmp_path_factory.mktemp("demo")
    steps: list[object] = []
    stories: dict[str, str] = {}

    def step(name: object, _total: int) -> Callable[[], None]:
        steps.append(name)
        return lambda: None

    def filled(*told: object) -> Mapping[str, str]:
        stories.update(fill_workbooks(*told))  # type: ignore[arg-type]
        return stories

    def sheet(entry: Issued, *told: object) -> bytes:
        return assignment_sheet(entry, *told) if entry.student.id == LAID_OUT else PAGE

    def report(judged: Report, *told: object, **more: object) -> bytes:
        read = stories[judged.student] in REPORTS_READ
        return student_report(judged, *told, **more) if read else PAGE

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("gripcourse.cli.demo.run.fill_workbooks", filled)
        patch.setattr("gripcourse.usecases.issuing.handout.assignment_sheet", sheet)
        patch.setattr("gripcourse.documents.report.student.student_report", report)
        for name in ("USER", "LOGNAME", "USERNAME"):
            patch.setenv(name, USER)
        done = run_demo(course_root(), out, Words("en"), 0, step)
    assert len(steps) == 3
    return done


@pytest.fixture(scope="session")
def by_story(demo: Demo) -> dict[str, Report]:
    """The report of each scripted student, by what was scripted."""
    reports = {Path(one.file).stem: one for one in demo.outcome.reports}
    return {story: reports[student] for student, story in demo.students.items()}


def lost(report: Report) -> set[str]:
    """The quantities that do not earn all their points."""
    return {
        one.quantity
        for one in report.findings
        if one.outcome is not Outcome.MANUAL and one.points < one.max_points - 1e-9
    }


@pytest.mark.parametrize("story", ["correct", "three_figures", "as_printed"])
def test_who_computes_soundly_gets_everything(by_story: dict[str, Report], story: str) -> None:
    report = by_story[story]
    assert report.score == pytest.approx(report.max_score)
    # Also of the first student, whose file somebody else hands in too.
    assert report.flags == ()


def test_an_early_slip_costs_one_item(by_story: dict[str, Report]) -> None:
    (item,) = lost(by_story["early_slip"])
    assert item


def test_the_drawing_of_one_student_is_marked_by_a_person(
    demo: Demo, by_story: dict[str, Report]
) -> None:
    decided = {
        story: [one.quantity for one in report.findings if one.decision is not None]
        for story, report in by_story.items()
    }
    assert demo.marking is not None
    (item,) = demo.marking.items
    assert {story: names for story, names in decided.items() if names} == {
        MARKED_STORY: [item.mark.quantity]
    }
    assert len(item.mark.lines) > 1
    report = by_story[MARKED_STORY]
    drawing = next(one for one in report.findings if one.quantity == item.mark.quantity)
    assert drawing.points == item.points
    assert 0 < drawing.points < drawing.max_points


def test_a_blank_workbook_gets_nothing_and_no_flag(by_story: dict[str, Report]) -> None:
    assert by_story["blank"].score == 0
    assert by_story["blank"].judged
    assert by_story["blank"].flags == ()


def test_numbers_with_units_count_and_what_is_no_number_costs_itself(
    by_story: dict[str, Report],
) -> None:
    unread = {
        one.quantity
        for one in by_story["text_and_units"].findings
        if one.outcome is Outcome.UNREADABLE
    }
    assert len(unread) == 2
    assert lost(by_story["text_and_units"]) == unread


def test_sizes_rounded_down_cost_themselves(by_story: dict[str, Report]) -> None:
    assert 1 <= len(lost(by_story["rounded_down"])) <= 3


def test_a_copied_workbook_waits_for_a_person(by_story: dict[str, Report]) -> None:
    report = by_story[COPIED]
    assert [flag.code for flag in report.flags] == ["who_handed_in", "same_bytes"]
    assert not report.judged


def test_everything_that_is_promised_is_there(demo: Demo) -> None:
    students = set(demo.students)
    copied = {student for student, story in demo.students.items() if story == COPIED}
    assert {path.stem for path in (demo.graded / "reports").iterdir()} == students - copied
    assert {path.name for path in demo.graded.iterdir()} == {
        "reports",
        "cohort.pdf",
        "files.csv",
        "grades.csv",
        "grades.json",
    }
    folders = {path.name for path in demo.assignments.iterdir()}
    assert students < folders
    assert len(folders) == 12
    assert all(len(list((demo.assignments / one).iterdir())) == 2 for one in folders)
    assert (demo.course / "private" / "gradebook.sqlite").exists()
    made = [path.read_bytes() for path in demo.graded.rglob("*.pdf")]
    assert all(pdf.startswith(b"%PDF") for pdf in made)
    whole = [pdf for pdf in made if pdf != PAGE]
    assert len(whole) == len(REPORTS_READ) + 1  # and the report on the batch
    assert all(len(pdf) > 10_000 for pdf in whole)


def test_nothing_failed_on_our_side(demo: Demo) -> None:
    assert not (demo.graded / "incidents.log").exists()
    assert [one for one in demo.issuing.handouts if one.faults] == []


def test_the_grades_are_those_of_the_reports(demo: Demo) -> None:
    files = json.loads((demo.graded / "grades.json").read_text(encoding="utf-8"))
    written = {one["student"]: one["score"] for one in files["reports"]}
    judged = {one.student: round(one.score, 6) for one in demo.outcome.reports if one.judged}
    assert written == {**judged, "": None}


@pytest.mark.parametrize("language", ["en", "ru", "uk"])
def test_the_summary_names_everybody_and_every_place(demo: Demo, language: str) -> None:
    shown = demo_text(replace(demo), Words(language))
    assert all(student in shown for student in demo.students)
    places = (demo.course, demo.assignments, demo.submissions, demo.graded)
    assert all(str(place) in shown for place in places)


def test_the_reference_course_itself_is_untouched(demo: Demo) -> None:
    assert demo.course != course_root()
    assert not (Path(__file__).parents[3] / "private").exists()


@dataclass(frozen=True, slots=True)
class Secret:
    """What a student must not find in what they are handed.

    Attributes:
        plan, issued: what the values are those of.
        values: of computed quantities, in the declared unit and in SI.
        known: numbers that everybody may read, whatever their variant.
        key: that signs.
    """

    plan: Plan
    issued: Issued
    values: dict[str, tuple[float, ...]]
    known: frozenset[float]
    key: bytes


@pytest.fixture(scope="session")
def demo_course(demo: Demo) -> Course:
    return load_course(demo.course)


@pytest.fixture(scope="session")
def secret_of(demo: Demo, demo_course: Course) -> Callable[[str], Secret]:
    register = read_register(demo.course, demo_course.id).by_student()
    key = read_key(key_path(demo.course))

    def find(student: str) -> Secret:
        issued = register[student]
        plan = plan_of(demo_course, issued.variant.composition)
        solved = solve_variant(plan, issued.variant.given)
        open_to_all = {one.id for one in (*plan.givens, *plan.constants)}
        values = {
            name: (solved[name], solved[name] * factor(one.unit))
            for name, one in plan.quantities.items()
            if name in solved and name not in open_to_all
        }
        assert len(values) > 30
        known = {*issued.variant.given.values(), *catalogued(demo_course)}
        known |= set(whatever_the_variant(issued, plan, demo_course))
        return Secret(plan, issued, values, frozenset(known), key)

    return find


def catalogued(course: Course) -> Iterator[float]:
    """Yield the sizes of all catalogues, in declared units and in SI."""
    for catalogue in course.catalogues.values():
        for name, column in catalogue.columns.items():
            yield from map(float, column)
            yield from map(float, column / factor(catalogue.units[name]))


def whatever_the_variant(issued: Issued, plan: Plan, course: Course) -> Iterator[float]:
    """Yield the numbers that stand in the documents of other given numbers, too."""
    given = {name: value * 1.0371 for name, value in issued.variant.given.items()}
    other = replace(issued, variant=replace(issued.variant, given=given))
    words = Words(issued.student.language or course.language)
    made = answer_workbook(plan, other, course, words)
    for piece in (page_of(other, plan, course), *pieces("workbook.xlsx", made)):
        for number in numbers_in(piece.data.decode("utf-8", "replace")):
            yield float(number.replace(",", "."))


def page_of(issued: Issued, plan: Plan, course: Course) -> Piece:
    """Fill in the page that a sheet is laid out from, its pictures with it."""
    words = Words(issued.student.language or course.language)
    values = sheet_values(issued, plan, load_policy(course), course, words)
    page = render_html(Document(TEMPLATE, STYLES, values), course.root / "templates", words)
    return Piece("page", page.encode())


def handed_out(demo: Demo, student: str) -> list[Piece]:
    """Take apart everything that lies in a student's folder."""
    found = []
    for path in sorted((demo.assignments / student).rglob("*")):
        if path.is_file():
            named = Piece("name", path.name.encode())
            content = path.read_bytes()
            found += [named, *(pieces(path.name, content) if content != PAGE else ())]
    assert len(found) > (30 if student == LAID_OUT else 15)
    return found


@pytest.mark.parametrize("student", LOOKED_AT)
def test_what_a_student_is_handed_tells_no_result_no_key_and_no_place(
    demo: Demo, demo_course: Course, secret_of: Callable[[str], Secret], student: str
) -> None:
    secret = secret_of(student)
    parts = handed_out(demo, student)
    if student != LAID_OUT:
        parts.append(page_of(secret.issued, secret.plan, demo_course))
    assert numbers_told(parts, secret.values, secret.known) == []
    assert secrets_told(parts, secret.key) == []
    names = (USER, str(demo.course.parent), str(Path.home()) + "/", platform.node() + ".")
    assert places_told(parts, names) == []


def test_the_report_on_a_blank_workbook_tells_none_either(
    demo: Demo, secret_of: Callable[[str], Secret]
) -> None:
    (student,) = (one for one, story in demo.students.items() if story == "blank")
    secret = secret_of(student)
    parts = pieces("report.pdf", (demo.graded / "reports" / f"{student}.pdf").read_bytes())
    assert numbers_told(parts, secret.values, secret.known) == []
    assert secrets_told(parts, secret.key) == []
    assert places_told(parts, (USER, str(demo.course.parent))) == []


def test_a_result_is_found_wherever_it_is_hidden_in_a_workbook(
    demo: Demo, secret_of: Callable[[str], Secret]
) -> None:
    student = LOOKED_AT[0]
    secret = secret_of(student)
    name, (value, in_si) = next(
        (one, two) for one, two in secret.values.items() if len(f"{two[0]:.7g}") > 7
    )
    spelled = format_number(value, "ru", 4)
    for place in ("hidden sheet", "comment", "property", "defined name", "format", "key"):
        book = load_workbook(workbook_path(demo.assignments, student))
        sheet = book.create_sheet("z")
        sheet.sheet_state = "veryHidden"
        match place:
            case "hidden sheet":
                sheet["A1"] = in_si
            case "comment":
                book.worksheets[0]["A1"].comment = Comment(f"= {spelled} мм", "x")
            case "property":
                book.properties.keywords = spelled
            case "defined name":
                book.defined_names["z"] = DefinedName("z", attr_text=f"{value:.7g}")
            case "format":
                sheet["A1"].number_format = f'"{value:.6g}"'
            case "key":
                sheet["A1"] = secret.key.hex().upper()
        stream = io.BytesIO()
        book.save(stream)
        parts = pieces("a.xlsx", stream.getvalue())
        told = numbers_told(parts, secret.values, secret.known)
        if place == "key":
            assert secrets_told(parts, secret.key), place
        else:
            assert any(one.endswith(f"is {name}") for one in told), place


def test_a_result_is_found_on_a_page_in_a_bookmark_and_in_an_attachment(
    demo: Demo, secret_of: Callable[[str], Secret]
) -> None:
    student = LOOKED_AT[0]
    secret = secret_of(student)
    spelled = [f"{value:.6g}" for value, _ in secret.values.values() if len(f"{value:.6g}") > 6]
    writer = PdfWriter(clone_from=sheet_path(demo.assignments, student))
    writer.add_metadata({"/Keywords": spelled[0], "/Author": USER})
    writer.add_outline_item(title=spelled[1], page_number=0)
    writer.add_attachment("notes.txt", spelled[2].encode() + b" of it\n" + secret.key)
    stream = io.BytesIO()
    writer.write(stream)
    parts = pieces("a.pdf", stream.getvalue())
    told = " ".join(numbers_told(parts, secret.values, secret.known))
    assert all(f": {one} is " in told for one in spelled[:3])
    assert secrets_told(parts, secret.key)
    assert places_told(parts, (USER,))
    # The report of somebody who computed soundly shows what they typed: that page is read, too.
    (sound,) = (one for one, story in demo.students.items() if story == "correct")
    page = pieces("report.pdf", (demo.graded / "reports" / f"{sound}.pdf").read_bytes())
    mine = secret_of(sound)
    assert len(numbers_told(page, mine.values, mine.known)) > 20
