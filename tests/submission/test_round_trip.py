"""What is typed into an answer workbook is what is read from it."""

import subprocess
from datetime import date, datetime, time, timedelta
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from openpyxl import load_workbook
from openpyxl.utils.datetime import CALENDAR_MAC_1904
from openpyxl.workbook.defined_name import DefinedName

from gripcourse.course.quantity import Kind
from gripcourse.solver.plan import Plan
from gripcourse.submission.model import Answer, Reading
from gripcourse.text.words import Words, message

if TYPE_CHECKING:
    from .conftest import Returned

FORCE = "drive_force"  # in N
BORE = "bore_required"  # in mm
ANGLE = "arm_angle_open"  # in °
RATIO = "velocity_ratio"  # a plain number
VERDICT = "bearing_ok"


def remarks(answer: Answer) -> str:
    return " ".join(map(str, answer.remarks))


def test_an_untouched_workbook_is_blank_everywhere(returned: "Returned", plan: Plan) -> None:
    submission = returned.filled({})
    assert set(submission.answers) == {quantity.id for quantity in plan.answered}
    assert {answer.reading for answer in submission.answers.values()} == {Reading.BLANK}
    assert {answer.remarks for answer in submission.answers.values()} == {()}


def test_the_workbook_says_whose_it_is(returned: "Returned", plan: Plan) -> None:
    identity = returned.filled({}).identity
    assert (identity.student, identity.variant) == ("s001", "07")
    assert (identity.scheme, identity.signature) == ("rack_parallelogram", "ab" * 32)
    assert identity.options == plan.options


def test_given_values_are_read_as_they_stand_now(returned: "Returned", plan: Plan) -> None:
    book = returned.book()
    [(sheet, address)] = book.defined_names["given.mass"].destinations
    book[sheet][address] = 61.5
    submission = returned.read(returned.saved(book))
    assert submission.givens["mass"] == 61.5
    assert set(submission.givens) == {quantity.id for quantity in plan.givens}


@pytest.mark.parametrize("value", [0, 0.0, -0.0, 12, 12.5, -5.5, 1e-12, 1e300, 22941.176470588])
def test_a_number_is_read_as_it_is_and_zero_is_a_value(returned: "Returned", value: float) -> None:
    answer = returned.filled({FORCE: value}).answers[FORCE]
    assert answer.reading is Reading.READ
    assert answer.value == value
    assert answer.remarks == ()


@pytest.mark.parametrize(("value", "half"), [(12.5, 0.05), (1500, 0.5), (0.0625, 0.00005), (0, 0)])
def test_the_half_unit_of_a_number_comes_from_its_digits(
    returned: "Returned", value: float, half: float
) -> None:
    assert returned.filled({FORCE: value}).answers[FORCE].half_unit == pytest.approx(half)


def test_a_computed_number_has_practically_no_half_unit(returned: "Returned") -> None:
    assert returned.filled({FORCE: 100 / 3}).answers[FORCE].half_unit < 1e-12


@pytest.mark.parametrize("stored", ["1" + "0" * 400, "1E400", "-1e999", "1e-999"])
def test_a_number_beyond_any_float_is_unreadable(returned: "Returned", stored: str) -> None:
    quantity, path = returned.stored(stored)
    answer = returned.read(path).answers[quantity]
    assert answer.reading is Reading.UNREADABLE
    assert "too large or too small" in remarks(answer)


@pytest.mark.parametrize("text", ["", " ", "\u00a0\t\n"])
def test_white_space_is_blank(returned: "Returned", text: str) -> None:
    assert returned.filled({FORCE: text}).answers[FORCE].reading is Reading.BLANK


@pytest.mark.parametrize(
    ("text", "value"),
    [("12,5", 12.5), ("12.5", 12.5), ("\u22125,5", -5.5), ("-5,5", -5.5), ("0", 0.0), ("5,0", 5.0)],
)
def test_a_number_typed_as_text_is_read_and_remarked_on(
    returned: "Returned", text: str, value: float
) -> None:
    answer = returned.filled({FORCE: text}).answers[FORCE]
    assert (answer.reading, answer.value, answer.typed) == (Reading.READ, value, text)
    assert "The cell holds text" in remarks(answer)


@pytest.mark.parametrize(
    ("quantity", "text", "value", "unit"),
    [
        (FORCE, "12,5 кН", 12500.0, "kN"),
        (FORCE, "12.5 kN", 12500.0, "kN"),
        (BORE, "6 см", 60.0, "cm"),
        (BORE, "0,06 м", 60.0, "m"),
        (ANGLE, "0,5 рад", 28.64788975654, "rad"),
        (RATIO, "85 %", 0.85, "%"),
    ],
)
def test_a_unit_of_the_same_dimension_is_converted_and_remarked_on(
    returned: "Returned", quantity: str, text: str, value: float, unit: str
) -> None:
    answer = returned.filled({quantity: text}).answers[quantity]
    assert answer.value == pytest.approx(value, rel=1e-12)
    assert (answer.unit, answer.unit_fits) == (unit, True)
    assert "Read as" in remarks(answer)


def test_the_half_unit_is_converted_with_the_number(returned: "Returned") -> None:
    assert returned.filled({FORCE: "12,5 кН"}).answers[FORCE].half_unit == pytest.approx(50)


def test_the_declared_unit_beside_the_number_changes_nothing(returned: "Returned") -> None:
    answer = returned.filled({BORE: "60,08 мм"}).answers[BORE]
    assert (answer.value, answer.unit, answer.unit_fits) == (60.08, "mm", True)


@pytest.mark.parametrize(
    ("quantity", "text", "unit"),
    [
        (FORCE, "12,5 мм", "mm"),
        (BORE, "60 МПа", "MPa"),
        (RATIO, "3 мм", "mm"),
        (ANGLE, "30 %", "%"),
        (RATIO, "2,9°", "deg"),
    ],
)
def test_a_unit_of_another_dimension_keeps_the_number_as_typed(
    returned: "Returned", quantity: str, text: str, unit: str
) -> None:
    answer = returned.filled({quantity: text}).answers[quantity]
    assert answer.reading is Reading.READ
    assert answer.value == float(text.split(maxsplit=1)[0].rstrip("°").replace(",", "."))
    assert (answer.unit, answer.unit_fits) == (unit, False)
    assert "does not fit" in remarks(answer)


@pytest.mark.parametrize("text", ["12,5 попугаев", "12,5 мм9999", "12,5 ед."])
def test_unknown_text_behind_a_number_is_remarked_on(returned: "Returned", text: str) -> None:
    answer = returned.filled({FORCE: text}).answers[FORCE]
    assert (answer.value, answer.unit, answer.unit_fits) == (12.5, "", True)
    assert "no known unit" in remarks(answer)


@pytest.mark.parametrize(
    ("value", "said"),
    [
        ("12-13", "One number is needed"),
        ("=1,5*2", "formula was typed"),
        ("примерно двенадцать", "does not begin with a number"),
        ("x" * 32_000, "too long"),
        ("#ДЕЛ/0!", "error #ДЕЛ/0!"),
        ("#Н/Д", "error #Н/Д"),
        (True, "not a logical value"),
        (time(1, 30), "into a time"),
        (timedelta(hours=30), "into a time"),
        (46143, "into the date 01.05.2026"),
        ("1.5.26", "looks like a date"),
    ],
)
def test_what_is_no_number_is_unreadable_and_says_why(
    returned: "Returned", value: object, said: str
) -> None:
    answer = returned.filled({BORE: value}).answers[BORE]
    assert (answer.reading, answer.value) == (Reading.UNREADABLE, None)
    assert said in remarks(answer)
    assert 0 < len(answer.typed) <= 80


@pytest.mark.parametrize(
    ("value", "readings"),
    [
        (datetime(2026, 5, 1), ["1.5", "1.05", "5.2026"]),  # noqa: DTZ001 - cells have no zone
        (date(1987, 5, 1), ["1.5", "1.05", "5.1987"]),
        (date(2026, 12, 31), ["31.12"]),
    ],
)
def test_a_date_shows_every_number_that_it_may_have_been(
    returned: "Returned", value: object, readings: list[str]
) -> None:
    answer = returned.filled({BORE: value}).answers[BORE]
    assert answer.reading is Reading.UNREADABLE
    assert all(reading in remarks(answer) for reading in readings)


def test_dates_of_the_1904_system_are_read_as_the_dates_they_show(returned: "Returned") -> None:
    book = returned.book()
    book.epoch = CALENDAR_MAC_1904
    returned.cell(book, BORE).value = datetime(2026, 5, 1)  # noqa: DTZ001 - cells have no zone
    answer = returned.read(returned.saved(book)).answers[BORE]
    assert "01.05.2026" in remarks(answer)


def test_a_large_whole_number_inside_its_bounds_is_no_date(returned: "Returned") -> None:
    assert returned.filled({FORCE: 46143}).answers[FORCE].value == 46143


def test_a_percent_format_is_remarked_on_where_no_share_is_asked(returned: "Returned") -> None:
    book = returned.book()
    for quantity in (BORE, RATIO):
        cell = returned.cell(book, quantity)
        cell.value, cell.number_format = 0.05, "0.00%"
    answers = returned.read(returned.saved(book)).answers
    assert answers[BORE].value == answers[RATIO].value == 0.05
    assert "percent format" in remarks(answers[BORE])
    assert remarks(answers[RATIO]) == ""


def test_an_error_of_a_formula_is_named_with_its_cell(returned: "Returned") -> None:
    book = returned.book()
    cell = returned.cell(book, BORE)
    cell.value, cell.data_type = "#DIV/0!", "e"
    answer = returned.read(returned.saved(book)).answers[BORE]
    assert answer.reading is Reading.UNREADABLE
    assert "#DIV/0!" in remarks(answer)
    assert cell.coordinate in remarks(answer)


def test_a_formula_without_a_stored_result_is_told_from_an_empty_cell(
    returned: "Returned",
) -> None:
    book = returned.book()
    returned.cell(book, BORE).value = "=2*3"
    answers = returned.read(returned.saved(book)).answers
    assert answers[BORE].reading is Reading.UNREADABLE
    assert answers[BORE].typed == "=2*3"
    assert "not stored" in remarks(answers[BORE])
    assert answers[FORCE].reading is Reading.BLANK


@pytest.mark.parametrize(
    ("value", "meant"),
    [
        *((word, 1.0) for word in ("да", "Да.", "ТАК", "yes", "+", "1", "True", "истина", 1, True)),
        *(
            (word, 0.0)
            for word in ("нет", "НЕТ!", "ні", "no", "-", "\u2212", "0", "ложь", 0, False)
        ),
    ],
)
def test_a_verdict_is_yes_or_no_in_any_language(
    returned: "Returned", value: object, meant: float
) -> None:
    answer = returned.filled({VERDICT: value}).answers[VERDICT]
    assert (answer.reading, answer.value) == (Reading.READ, meant)


@pytest.mark.parametrize("value", ["наверное", "да нет", 2, 0.5, 46143])
def test_anything_else_is_no_verdict(returned: "Returned", value: object) -> None:
    answer = returned.filled({VERDICT: value}).answers[VERDICT]
    assert answer.reading is Reading.UNREADABLE
    assert "Yes or no" in remarks(answer)


def test_a_deleted_answer_cell_is_blank_and_remarked_on(returned: "Returned") -> None:
    book = returned.book()
    book.defined_names["answer.bore_required"].value = "#REF!"
    del book.defined_names["answer.drive_force"]
    answers = returned.read(returned.saved(book)).answers
    for quantity in (BORE, FORCE):
        assert answers[quantity].reading is Reading.BLANK
        assert "missing" in remarks(answers[quantity])
        assert answers[quantity].cell == ""


@pytest.mark.parametrize("address", ["$ZZZ$9999999", "nonsense", "$A$0"])
def test_a_name_that_points_nowhere_counts_as_a_missing_cell(
    returned: "Returned", address: str
) -> None:
    book = returned.book()
    sheet = book.sheetnames[1]
    book.defined_names["answer.bore_required"].value = f"'{sheet}'!{address}"
    assert "missing" in remarks(returned.read(returned.saved(book)).answers[BORE])


def test_answers_are_found_after_sheets_were_renamed_and_cells_moved(returned: "Returned") -> None:
    book = returned.book()
    [(title, _)] = book.defined_names["answer.bore_required"].destinations
    book[title].title = "Мой 'привод'"
    book["Мой 'привод'"]["K40"] = 60.08
    book.defined_names["answer.bore_required"].value = "'Мой ''привод'''!$K$40"
    answer = returned.read(returned.saved(book)).answers[BORE]
    assert (answer.value, answer.cell) == (60.08, "Мой 'привод'!K40")


def test_names_that_a_sheet_keeps_for_itself_are_used_when_the_workbook_lost_them(
    returned: "Returned",
) -> None:
    book = returned.book()
    cell = returned.cell(book, BORE)
    cell.value = 60.08
    reference = book.defined_names.pop("answer.bore_required").value
    cell.parent.defined_names["answer_bore_required"] = DefinedName(
        "answer_bore_required", attr_text=reference
    )
    assert returned.read(returned.saved(book)).answers[BORE].value == 60.08


def test_the_value_of_a_merged_answer_cell_stands_in_its_first_cell(returned: "Returned") -> None:
    book = returned.book()
    first, second = returned.cell(book, BORE), returned.cell(book, FORCE)
    first.value, second.value = 60.08, 22941.0
    sheet = first.parent
    sheet.merge_cells(f"{first.coordinate}:F{first.row}")
    moved = f"'{second.parent.title}'!$F${second.row}"
    second.parent.merge_cells(f"{second.coordinate}:F{second.row}")
    book.defined_names["answer.drive_force"].value = moved
    answers = returned.read(returned.saved(book)).answers
    assert (answers[BORE].value, answers[FORCE].value) == (60.08, 22941.0)


def test_without_the_hidden_sheet_the_properties_tell_whose_it_is(
    returned: "Returned", plan: Plan
) -> None:
    book = returned.book()
    del book["_gripcourse"]
    submission = returned.read(returned.saved(book))
    assert submission.identity.student == "s001"
    assert submission.identity.options == plan.options
    assert "has been removed" in str(submission.remarks[0])


def test_whoever_saved_the_workbook_last_is_named(returned: "Returned") -> None:
    book = returned.book()
    book.properties.lastModifiedBy = "Petrov"
    assert returned.read(returned.saved(book)).creator == "Petrov"


NUMBERS = st.floats(allow_nan=False, allow_infinity=False, min_value=-1e12, max_value=1e12)


@settings(
    deadline=None,
    max_examples=12,
    suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow],
)
@given(data=st.data())
def test_every_number_comes_back_however_it_was_typed(
    returned: "Returned", plan: Plan, data: st.DataObject
) -> None:
    numbers = {q.id: data.draw(NUMBERS) for q in plan.answered if q.kind is not Kind.VERDICT}
    typed = {name: data.draw(st.sampled_from(WAYS))(value) for name, value in numbers.items()}
    answers = returned.filled(typed).answers
    for name, value in numbers.items():
        assert answers[name].reading is Reading.READ, (typed[name], answers[name])
        assert answers[name].value == pytest.approx(value, rel=1e-14, abs=1e-300)


WAYS = (
    lambda value: value,
    lambda value: f"{value:.17g}",
    lambda value: f"{value:.17g}".replace(".", ","),
    lambda value: f"{value:.16e}".replace("-", "\u2212").replace("e", "е"),
    lambda value: f" {value:.16e}".replace("e", "·10^"),
    lambda value: f"≈{value:.17g}",
)


@settings(
    deadline=None,
    max_examples=8,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)
@given(text=st.text(st.characters(codec="utf-8", exclude_categories=["Cc", "Cs"]), max_size=90))
def test_no_text_makes_reading_fail(returned: "Returned", text: str) -> None:
    answer = returned.filled({FORCE: text.replace("\ufffe", "").replace("\uffff", "")}).answers[
        FORCE
    ]
    assert answer.reading in set(Reading)
    assert (answer.value is None) == (answer.reading is not Reading.READ)


@pytest.mark.office
def test_a_spreadsheet_program_keeps_names_rules_and_answers(
    returned: "Returned", plan: Plan, tmp_path: Path
) -> None:
    book = returned.book()
    yes = Words("ru").say(message("yes"))
    for quantity, value in {FORCE: 22941.2, BORE: "60,08", VERDICT: yes}.items():
        returned.cell(book, quantity).value = value
    returned.cell(book, RATIO).value = "=2.5+0.5"
    returned.cell(book, ANGLE).value = "много"
    returned.cell(book, "gear_torque").value = 1e9
    path = returned.saved(book)
    command = [
        *("soffice", f"-env:UserInstallation={(tmp_path / 'profile').as_uri()}", "--headless"),
        *("--convert-to", "xlsx", "--outdir", str(tmp_path / "out"), str(path)),
    ]
    subprocess.run(command, check=True, capture_output=True, timeout=120)  # noqa: S603
    kept = tmp_path / "out" / path.name
    submission = returned.read(kept)
    values = {name: submission.answers[name].value for name in (FORCE, BORE, VERDICT, RATIO)}
    assert values == {FORCE: 22941.2, BORE: 60.08, VERDICT: 1.0, RATIO: 3.0}
    assert not [a for a in submission.answers.values() if "missing" in remarks(a)]
    assert submission.identity.signature == "ab" * 32
    again = load_workbook(kept)
    for quantity in plan.answered:
        cell = returned.cell(again, quantity.id)
        rules = cell.parent.data_validations.dataValidation
        assert [rule for rule in rules if cell.coordinate in rule.sqref], quantity.id
        assert not cell.protection.locked
    assert [prop.name for prop in again.custom_doc_props.props if prop.value == "s001"]
    computed = load_workbook(kept, data_only=True)
    checks = {
        name: returned.cell(computed, name).offset(column=1).value
        for name in (FORCE, VERDICT, RATIO, "stroke", ANGLE, "gear_torque")
    }
    wrong = {name for name, said in checks.items() if said}
    assert wrong == {ANGLE, "gear_torque"}
