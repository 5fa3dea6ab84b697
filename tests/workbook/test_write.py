import html
import io
import zipfile
from dataclasses import replace
from datetime import date, datetime
from pathlib import Path

import pytest
from openpyxl import Workbook, load_workbook

from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind
from gripcourse.solver.needed_tables import needed_tables
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import solve_variant
from gripcourse.text.words import LANGUAGES, Words
from gripcourse.variants.model import Issued, Variant
from gripcourse.workbook.layout import SheetColumn, layout
from gripcourse.workbook.names import HIDDEN_SHEET
from gripcourse.workbook.write import answer_workbook, write_answer_workbook

LONGEST_PROMPT = 255
RUSSIAN = Words("ru")


@pytest.fixture(scope="module")
def content(plan: Plan, issued: Issued, course: Course) -> bytes:
    return answer_workbook(plan, issued, course, RUSSIAN)


@pytest.fixture(scope="module")
def book(content: bytes) -> Workbook:
    return load_workbook(io.BytesIO(content))


def test_the_same_inputs_give_the_same_bytes(
    plan: Plan, issued: Issued, course: Course, content: bytes
) -> None:
    assert answer_workbook(plan, issued, course, RUSSIAN) == content


def test_the_document_is_dated_by_the_day_of_issue(book: Workbook, issued: Issued) -> None:
    assert issued.issued_on == date(2026, 2, 3)
    assert book.properties.created == datetime(2026, 2, 3)  # noqa: DTZ001 - files have no zone


def test_the_file_is_written(plan: Plan, issued: Issued, course: Course, tmp_path: Path) -> None:
    path = tmp_path / "answers.xlsx"
    write_answer_workbook(path, plan, issued, course, RUSSIAN)
    assert path.read_bytes()[:2] == b"PK"


def test_every_answer_and_given_value_has_its_name(book: Workbook, plan: Plan) -> None:
    placed = layout(plan, RUSSIAN)
    expected = {f"answer.{name}": place for name, place in placed.answers.items()}
    expected |= {f"given.{name}": place for name, place in placed.givens.items()}
    for name, place in expected.items():
        [(sheet, address)] = book.defined_names[name].destinations
        assert (sheet, address.replace("$", "")) == (place.sheet, place.address)


def test_given_values_stand_in_declared_units(book: Workbook, plan: Plan, issued: Issued) -> None:
    for name, place in layout(plan, RUSSIAN).givens.items():
        assert book[place.sheet][place.address].value == issued.variant.given[name]


def test_answer_cells_are_empty_unlocked_general_and_coloured(book: Workbook, plan: Plan) -> None:
    plain = book[layout(plan, RUSSIAN).cover.name]["A1"].fill.fgColor.rgb
    for place in layout(plan, RUSSIAN).answers.values():
        cell = book[place.sheet][place.address]
        assert cell.value is None
        assert cell.number_format == "General"
        assert not cell.protection.locked
        assert cell.fill.fgColor.rgb != plain


def test_everything_but_the_answers_is_locked(book: Workbook, plan: Plan) -> None:
    answers = {(place.sheet, place.address) for place in layout(plan, RUSSIAN).answers.values()}
    for sheet in book:
        assert sheet.protection.sheet
        unlocked = {
            (sheet.title, cell.coordinate)
            for row in sheet.iter_rows()
            for cell in row
            if not cell.protection.locked
        }
        assert unlocked <= answers


def test_a_student_may_select_locked_cells_and_resize_columns(book: Workbook) -> None:
    for sheet in book.worksheets[:-1]:
        assert not sheet.protection.selectLockedCells
        assert not sheet.protection.formatColumns
        assert sheet.protection.password is None


def test_number_cells_accept_numbers_between_the_bounds_only(book: Workbook, plan: Plan) -> None:
    placed = layout(plan, RUSSIAN).answers
    for quantity in plan.answered:
        place = placed[quantity.id]
        rules = [
            rule
            for rule in book[place.sheet].data_validations.dataValidation
            if place.address in rule.sqref
        ]
        assert len(rules) == 1
        rule = rules[0]
        assert rule.errorStyle in {None, "stop"}
        assert rule.showErrorMessage
        assert 0 < len(rule.prompt) <= LONGEST_PROMPT
        if quantity.kind is Kind.VERDICT:
            assert rule.type == "list"
        else:
            assert (rule.type, rule.operator) == ("decimal", None)
            assert (float(rule.formula1), float(rule.formula2)) == quantity.bounds


def test_nothing_of_the_reference_is_in_the_workbook(
    book: Workbook, plan: Plan, issued: Issued
) -> None:
    given = {place.address for place in layout(plan, RUSSIAN).givens.values()}
    given |= {line.place.address for line in layout(plan, RUSSIAN).cover.constants}
    cover = layout(plan, RUSSIAN).cover.name
    series = layout(plan, RUSSIAN).series
    numbers = {
        (sheet.title, cell.coordinate)
        for sheet in book
        if sheet.title != series
        for row in sheet.iter_rows()
        for cell in row
        if isinstance(cell.value, int | float)
    }
    assert numbers == {(cover, address) for address in given}
    reference = solve_variant(plan, issued.variant.given)
    formulas = [
        cell.value
        for sheet in book
        for row in sheet.iter_rows()
        for cell in row
        if cell.data_type == "f"
    ]
    telling = [f"{reference[q.id]:.4g}" for q in plan.answered if reference[q.id] % 1]
    assert formulas
    assert not [text for text in formulas for value in telling if value in text]


def test_each_answer_has_a_check_that_is_silent_while_it_is_empty(
    content: bytes, plan: Plan
) -> None:
    computed = load_workbook(io.BytesIO(content), data_only=True)
    live = load_workbook(io.BytesIO(content))
    for place in layout(plan, RUSSIAN).answers.values():
        assert live[place.sheet].cell(place.row + 1, SheetColumn.CHECK + 1).value.startswith("=IF(")
        assert computed[place.sheet].cell(place.row + 1, SheetColumn.CHECK + 1).value in {None, ""}


def test_a_name_from_the_roster_is_never_a_formula(book: Workbook, issued: Issued) -> None:
    cells = [
        cell
        for sheet in book
        for row in sheet.iter_rows()
        for cell in row
        if cell.value == issued.student.name
    ]
    assert [cell.data_type for cell in cells] == ["s"]


def test_manual_items_are_told_and_have_no_answer_cell(book: Workbook, plan: Plan) -> None:
    for sheet in layout(plan, RUSSIAN).sheets:
        for line in sheet.manual:
            cell = book[sheet.name][line.place.address]
            assert isinstance(cell.value, str)
            assert cell.protection.locked
            assert f"answer.{line.quantity.id}" not in book.defined_names


def test_the_hidden_sheet_and_the_properties_say_whose_workbook_it_is(
    book: Workbook, issued: Issued
) -> None:
    hidden = book[HIDDEN_SHEET]
    assert hidden.sheet_state == "veryHidden"
    stored = {prop.name: prop.value for prop in book.custom_doc_props.props}
    shown = {row[0].value: row[1].value for row in hidden.iter_rows()}
    assert shown == {name.removeprefix("gripcourse."): value for name, value in stored.items()}
    assert shown["student"] == issued.student.id
    assert shown["variant"] == issued.variant.id
    assert shown["signature"] == issued.signature
    options = sorted(issued.variant.options.items())
    assert shown["options"] == "; ".join(f"{option}={choice}" for option, choice in options)


@pytest.mark.parametrize("language", LANGUAGES)
def test_sheets_are_ready_for_a4_paper(
    plan: Plan, issued: Issued, course: Course, language: str
) -> None:
    book = load_workbook(io.BytesIO(answer_workbook(plan, issued, course, Words(language))))
    for sheet in book.worksheets[:-1]:
        assert str(sheet.page_setup.paperSize) == sheet.PAPERSIZE_A4
        assert (sheet.page_setup.fitToHeight or 1) >= 1
        assert sheet.oddHeader.right.text
    for sheet in book.worksheets[1:-2]:
        assert sheet.freeze_panes == "A6"


@pytest.mark.parametrize("name", ["&" * 300, "x" + "&" * 300, "И" * 300, "&P&D&[Tab]"])
def test_a_strange_name_fits_the_header_of_the_page(
    plan: Plan, issued: Issued, course: Course, name: str
) -> None:
    student = replace(issued.student, name=name)
    content = answer_workbook(plan, replace(issued, student=student), course, RUSSIAN)
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        sheet = archive.read("xl/worksheets/sheet1.xml").decode()
    header = html.unescape(sheet.partition("<oddHeader>")[2].partition("</oddHeader>")[0])
    shown = header.rpartition("&R")[2] if "&R" in header else ""
    assert len(header) <= LONGEST_PROMPT
    assert shown.replace("&&", "") == shown.replace("&", "")


def test_a_long_name_stands_below_the_course_over_a_printed_page(
    plan: Plan, issued: Issued, course: Course
) -> None:
    name = "Константинопольский-Черноризский Юлиан Афанасьевич"
    student = replace(issued.student, name=name)
    content = answer_workbook(plan, replace(issued, student=student), course, RUSSIAN)
    header = load_workbook(io.BytesIO(content)).worksheets[0].oddHeader
    assert (header.left.text or "").split("\n") == [course.title.of("ru"), name]
    assert not header.right.text


def test_the_series_stand_in_the_workbook_exactly_as_they_are_declared(
    book: Workbook, plan: Plan
) -> None:
    sheet = book[layout(plan, RUSSIAN).series]
    shown = {cell.value for row in sheet.iter_rows() for cell in row if cell.data_type == "n"}
    tables = needed_tables(plan)
    assert tables
    assert shown - {None} == {size for table in tables for row in table.rows for size in row}


def test_no_raw_symbol_is_shown_in_a_cell_or_beside_it(course: Course, issued: Issued) -> None:
    """`prism_lever` has titles and conditions with symbols in them."""
    example = course.schemes["prism_lever"].example
    assert example is not None
    long = make_plan(course, "prism_lever", example.options)
    given = {one.id: sum(one.bounds) / 2 for one in long.givens}
    entry = replace(issued, variant=Variant("7", "prism_lever", dict(long.options), given))
    shown = load_workbook(io.BytesIO(answer_workbook(long, entry, course, RUSSIAN)))
    for sheet in shown:
        if sheet.title == HIDDEN_SHEET:
            continue
        texts = [cell.value for row in sheet for cell in row if cell.data_type == "s"]
        for rule in sheet.data_validations.dataValidation:
            texts += [rule.promptTitle, rule.prompt]
        assert not [text for text in texts if "_" in text]
