import io
from collections.abc import Mapping

import pytest
from openpyxl import Workbook, load_workbook

from gripcourse.course.model import Course
from gripcourse.course.quantity import Convention, Kind
from gripcourse.machine.office import office_command
from gripcourse.proofs.workbooks import recalculate
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import solve_variant
from gripcourse.text.units import factor
from gripcourse.text.words import LANGUAGES, Words
from gripcourse.variants.model import Variant
from gripcourse.workbook.key import key_workbook, write_key_workbook

ENGLISH = Words("en")
# Givens that a drive has besides, by the drive.
DRIVES: Mapping[str, Mapping[str, float]] = {"hydraulic": {}, "pneumatic": {"supply_pressure": 0.6}}


def value_of(book: Workbook, name: str) -> object:
    [(sheet, address)] = book.defined_names[name].destinations
    return book[sheet][address].value


@pytest.fixture(scope="module")
def content(plan: Plan, variant: Variant) -> bytes:
    return key_workbook(plan, variant, ENGLISH)


def test_the_same_inputs_give_the_same_bytes(plan: Plan, variant: Variant, content: bytes) -> None:
    assert key_workbook(plan, variant, ENGLISH) == content


def test_stored_results_are_the_engine_s_in_both_columns(
    plan: Plan, variant: Variant, content: bytes
) -> None:
    book = load_workbook(io.BytesIO(content), data_only=True)
    values = solve_variant(plan, variant.given)
    for quantity in plan.answered:
        value = values[quantity.id]
        assert value_of(book, f"answer.{quantity.id}") == pytest.approx(value, rel=1e-12)
        in_si = value * factor(quantity.unit)
        assert value_of(book, f"si.{quantity.id}") == pytest.approx(in_si, rel=1e-12)


def test_every_answer_is_a_live_formula(plan: Plan, content: bytes) -> None:
    book = load_workbook(io.BytesIO(content))
    for quantity in plan.answered:
        assert str(value_of(book, f"si.{quantity.id}")).startswith("=")
        assert str(value_of(book, f"answer.{quantity.id}")).startswith("=")


def test_given_values_and_constants_are_numbers_that_can_be_changed(
    plan: Plan, variant: Variant, content: bytes
) -> None:
    book = load_workbook(io.BytesIO(content))
    for quantity in plan.givens:
        assert value_of(book, f"given.{quantity.id}") == variant.given[quantity.id]
    assert value_of(book, "given.gravity") == 9.81


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_quantity_has_its_formula_source_and_tolerance_in_words(
    plan: Plan, variant: Variant, language: str
) -> None:
    book = load_workbook(io.BytesIO(key_workbook(plan, variant, Words(language))))
    for quantity in plan.answered:
        [(sheet, address)] = book.defined_names[f"answer.{quantity.id}"].destinations
        sheet = sheet.replace("''", "'")
        row = book[sheet][address.replace("$", "")].row
        texts = [book[sheet].cell(row, column).value for column in (3, 6, 7, 8)]
        assert all(texts), quantity.id


def test_the_convention_of_the_plan_decides_the_formulas(course: Course, variant: Variant) -> None:
    plan = make_plan(course, variant.scheme, variant.options, Convention.AS_PRINTED)
    book = load_workbook(io.BytesIO(key_workbook(plan, variant, ENGLISH)), data_only=True)
    values = solve_variant(plan, variant.given)
    for quantity in plan.answered:
        assert value_of(book, f"answer.{quantity.id}") == pytest.approx(values[quantity.id])


@pytest.fixture(scope="module")
def computed_anew(
    course: Course, variant: Variant, tmp_path_factory: pytest.TempPathFactory
) -> Mapping[str, tuple[Plan, Mapping[str, float], Workbook]]:
    """The key for each drive with other numbers, as a spreadsheet program computes it."""
    office, folder = office_command(), tmp_path_factory.mktemp("keys")
    assert office is not None
    written = {}
    for drive, more in DRIVES.items():
        plan = make_plan(course, variant.scheme, variant.options | {"drive": drive})
        given = variant.given | {"mass": 20.0, "arm_length": 120.0} | more
        path = folder / f"{drive}.xlsx"
        write_key_workbook(path, plan, variant, ENGLISH)
        changed = load_workbook(path)  # formulas only: stored results are lost, all is computed
        for name, value in given.items():
            [(sheet, address)] = changed.defined_names[f"given.{name}"].destinations
            changed[sheet][address] = value
        changed.save(path)
        written[drive] = plan, given
    recalculate(folder, list(written), office)
    return {
        drive: (*made, load_workbook(folder / "out" / f"{drive}.xlsx", data_only=True))
        for drive, made in written.items()
    }


@pytest.mark.office
@pytest.mark.parametrize("drive", DRIVES)
def test_a_spreadsheet_program_computes_what_the_engine_computes(
    computed_anew: Mapping[str, tuple[Plan, Mapping[str, float], Workbook]], drive: str
) -> None:
    plan, given, computed = computed_anew[drive]
    values = solve_variant(plan, given)
    for quantity in plan.answered:
        if quantity.kind is not Kind.MANUAL:
            found = value_of(computed, f"answer.{quantity.id}")
            assert found == pytest.approx(values[quantity.id], rel=1e-9), quantity.id
