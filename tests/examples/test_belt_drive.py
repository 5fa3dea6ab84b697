"""A course of another subject, as data only: it proves, issues, grades and prints as any other."""

import re
import shutil
from io import BytesIO
from pathlib import Path

import pytest
from openpyxl import load_workbook

from gripcourse.cli.demo.run import Demo, run_demo
from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.documents.assignment_sheet import asked_items
from gripcourse.documents.pdf import pdf_from_html, render_html
from gripcourse.documents.registry import document_kinds
from gripcourse.policy.load import load_policy
from gripcourse.policy.model import Policy
from gripcourse.proofs.model import ProofKind, Verdict
from gripcourse.proofs.prove import prove
from gripcourse.solver.plan import make_plan
from gripcourse.solver.solve import solve_variant
from gripcourse.text.words import LANGUAGES, Words
from gripcourse.usecases.authoring.samples import samples
from gripcourse.usecases.authoring.validate import validated
from gripcourse.variants.audit import audit
from gripcourse.variants.draw import draw
from gripcourse.variants.screening import sifter
from gripcourse.variants.space import load_spaces
from gripcourse.variants.table import read_table
from gripcourse.workbook.write import answer_workbook
from support.pages import LAYOUT, SIGNATURE
from support.sheet_symbols import beside_answers, idle_givens, undefined_symbols

ROOT = Path(__file__).parents[2] / "examples" / "belt_drive"
# Kinds that take a second or two; operators, slips and workbooks are proved by hand.
QUICK = (
    *(ProofKind.EXAMPLE, ProofKind.PUBLISHED_CASE, ProofKind.IDENTITY, ProofKind.INEQUALITY),
    ProofKind.PRINTED_LINES,
)
STUDENTS = 3
# Stems of the reference course's subject, in the languages of the course.
OTHER_SUBJECT = re.compile(
    r"\b(grip(?!course)|jaw|finger|robot|vacuum|suction|захват|захоп|схват|губк|губок|присос)",
    re.IGNORECASE,
)


@pytest.fixture(scope="module")
def belts() -> Course:
    return load_course(ROOT)


@pytest.fixture(scope="module")
def belts_policy(belts: Course) -> Policy:
    return load_policy(belts)


@pytest.fixture(scope="module")
def demo(tmp_path_factory: pytest.TempPathFactory) -> Demo:
    """The first students of its roster, issued to and graded in this process.

    Sheets are laid out for the reference course, and filled for this one; of its reports one of
    each kind is laid out.
    """
    laid_out: set[tuple[str, ...]] = set()

    def lay_out(html: str, styles: tuple[str, ...], templates: Path) -> bytes:
        if styles in laid_out:
            return SIGNATURE
        laid_out.add(styles)
        return pdf_from_html(html, styles, templates)

    folder = tmp_path_factory.mktemp("belts")
    source = folder / "source"
    shutil.copytree(ROOT, source)
    roster = source / "variants" / "roster.csv"
    lines = roster.read_text(encoding="utf-8-sig").splitlines()[: STUDENTS + 1]
    roster.write_text("\n".join(lines) + "\n", encoding="utf-8")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("gripcourse.usecases.issuing.handout.assignment_sheet", lambda *_: SIGNATURE)
        patch.setattr(LAYOUT, lay_out)
        return run_demo(source, folder / "out", Words("en"), 0, lambda _name, _total: lambda: None)


def test_it_has_no_problems() -> None:
    assert validated(ROOT).problems == []


def test_what_it_prints_and_declares_holds(belts: Course, belts_policy: Policy) -> None:
    results = tuple(prove(belts, belts_policy, kinds=QUICK, count=2))
    assert {one.proof.kind for one in results} == set(QUICK)
    assert [problem for one in results for problem in one.problems] == []
    assert {one.verdict for one in results} == {Verdict.HOLDS}


def test_verdicts_of_its_table_come_out_either_way(belts: Course) -> None:
    answers: dict[str, set[bool]] = {}
    for variant in read_table(ROOT / "variants" / "tables" / "main.csv", belts):
        plan = make_plan(belts, variant.scheme, variant.options)
        values = solve_variant(plan, variant.given)
        for one in plan.answered:
            if one.kind == "verdict" and not one.must_hold:
                answers.setdefault(one.id, set()).add(values[one.id] > 0)
    assert answers
    assert all(found == {True, False} for found in answers.values()), answers


def test_its_table_keeps_all_rules(belts: Course, belts_policy: Policy) -> None:
    table = read_table(ROOT / "variants" / "tables" / "main.csv", belts)
    found = audit(belts, belts_policy, table, load_spaces(belts))
    assert [
        (one.variant.id, one.slips, one.edges) for one in found.variants if not one.passed
    ] == []


def test_another_table_can_be_drawn(belts: Course, belts_policy: Policy) -> None:
    """Every declared slip shows in enough variants of either scheme."""
    rules = sifter(belts_policy, len(belts.sections))
    drawn = draw(belts, load_spaces(belts), 4, 1, rules).variants
    assert {one.scheme for one in drawn} == {"flat_belt", "v_belt"}


def test_students_are_issued_to_and_graded(demo: Demo) -> None:
    assert len(demo.students) == STUDENTS
    reports = {demo.students[one.student]: one for one in demo.outcome.reports}
    right = reports["correct"]
    assert right.score == pytest.approx(right.max_score)  # but for drawings that a person marks
    assert right.max_score > 80
    assert 0 < reports["early_slip"].score < reports["early_slip"].max_score
    assert not (demo.graded / "incidents.log").exists()


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_document_is_filled_and_speaks_of_belts(
    belts: Course, belts_policy: Policy, language: str
) -> None:
    words, templates = Words(language), ROOT / "templates"
    filled: set[str] = set()
    for sample in samples(belts, belts_policy, (), words):
        for kind in document_kinds():
            for make in kind.samples(sample).values():
                html = render_html(make(), templates, words, with_charts=False)
                assert not OTHER_SUBJECT.findall(html), (kind.id, language)
                filled.add(kind.id)
    # The course has no atlas; a certificate is filled with drawn variants when it is validated.
    assert filled == {kind.id for kind in document_kinds()} - {"atlas", "certificate"}


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_workbook_speaks_of_belts(belts: Course, belts_policy: Policy, language: str) -> None:
    words = Words(language)
    for sample in samples(belts, belts_policy, (), words):
        book = load_workbook(BytesIO(answer_workbook(sample.plan, sample.issued, belts, words)))
        said = "\n".join(
            str(cell.value) for sheet in book for row in sheet.iter_rows() for cell in row
        )
        assert len(said) > 1000
        assert not OTHER_SUBJECT.findall(said)


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_sheet_says_once_how_a_size_is_taken(
    belts: Course, belts_policy: Policy, language: str
) -> None:
    plan = make_plan(belts, "v_belt", {"tensioning": "screw"})
    driven = [one for one in plan.answered if one.id == "large_diameter"]
    (item,) = asked_items(driven, plan, belts_policy, Words(language))
    assert item.text.count("(1 − ") == 1


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("scheme", ["flat_belt", "v_belt"])
@pytest.mark.parametrize("tensioning", ["base", "screw"])
def test_a_sheet_gives_nothing_idle_and_leaves_no_symbol_open(
    belts: Course, scheme: str, tensioning: str, language: str
) -> None:
    plan, words = make_plan(belts, scheme, {"tensioning": tensioning}), Words(language)
    read = beside_answers(plan, words)
    assert undefined_symbols(plan, words, read) == set()
    assert idle_givens(plan, words, read) == set()


def test_a_given_that_a_written_formula_does_not_name_would_be_noticed(belts: Course) -> None:
    plan, words = make_plan(belts, "v_belt", {"tensioning": "base"}), Words("en")
    read = beside_answers(plan, words)
    read["belt_power"] = read["belt_power"].replace("/v_1", "") + " X_1"
    assert idle_givens(plan, words, read) == {"unit_speed"}
    assert ("belt_power", "X_1") in undefined_symbols(plan, words, read)
