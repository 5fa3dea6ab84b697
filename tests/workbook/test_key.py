import io
import subprocess
from dataclasses import replace
from pathlib import Path

import pytest
from openpyxl import Workbook, load_workbook

from gripcourse.course.model import Course
from gripcourse.course.quantity import Convention, Kind
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import solve_variant
from gripcourse.text.units import factor
from gripcourse.text.words import LANGUAGES, Words
from gripcourse.variants.model import Variant
from gripcourse.workbook.key import key_workbook, write_key_workbook

ENGLISH = Words("en")


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


@pytest.mark.office
@pytest.mark.parametrize("drive", ["hydraulic", "pneumatic"])
def test_a_spreadsheet_program_computes_what_the_engine_computes(
    course: Course, variant: Variant, drive: str, tmp_path: Path
) -> None:
    plan = make_plan(course, variant.scheme, variant.options | {"drive": drive})
    given = variant.given | {"mass": 20.0, "arm_length": 120.0}
    if drive == "pneumatic":
        given |= {"supply_pressure": 0.6}
    path = tmp_path / "key.xlsx"
    write_key_workbook(path, plan, variant, ENGLISH)
    changed = load_workbook(path)  # formulas only: stored results are lost, all is computed anew
    for name, value in given.items():
        [(sheet, address)] = changed.defined_names[f"given.{name}"].destinations
        changed[sheet][address] = value
    changed.save(path)
    computed = load_workbook(recalculated(path, tmp_path), data_only=True)
    values = solve_variant(plan, replace(variant, given=given).given)
    for quantity in plan.answered:
        if quantity.kind is not Kind.MANUAL:
            found = value_of(computed, f"answer.{quantity.id}")
            assert found == pytest.approx(values[quantity.id], rel=1e-9), quantity.id


def recalculated(path: Path, folder: Path) -> Path:
    """Let LibreOffice, with a profile of its own, open a workbook and save it elsewhere."""
    out = folder / "out"
    command = [
        *("soffice", f"-env:UserInstallation={(folder / 'profile').as_uri()}", "--headless"),
        *("--convert-to", "xlsx", "--outdir", str(out), str(path)),
    ]
    subprocess.run(command, check=True, capture_output=True, timeout=120)  # noqa: S603
    return out / path.name
