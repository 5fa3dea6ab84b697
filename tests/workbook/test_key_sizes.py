"""The sheet of the key on which the sizes of a choice that steps up are tried."""

import io
from collections.abc import Mapping
from pathlib import Path

import openpyxl
import pytest
from openpyxl import load_workbook
from openpyxl.worksheet.worksheet import Worksheet

from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.machine.office import office_command
from gripcourse.proofs.workbooks import recalculate
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.text.words import Words
from gripcourse.variants.model import Variant
from gripcourse.workbook.key import key_workbook
from gripcourse.workbook.key_text import formula_text

SPRINGS = Path(__file__).parents[1] / "support" / "spring_course"
BELTS = Path(__file__).parents[2] / "examples" / "belt_drive"
ENGLISH = Words("en")
WIDTHS = {0.36: 71.0, 0.30: 80.0, 0.50: 63.0}  # mm, by the friction
# At 100 N, by hand: stress of each wire, what is allowed, and whether it holds; 1.55 mm are needed.
WIRES = [
    (1.0, 0, 1913.7, 800, 0, 0),
    (1.2, 0, 1328.9, 780, 0, 0),
    (1.4, 0, 976.4, 760, 0, 0),
    (1.6, 1, 747.5, 740, 0, 0),
    (1.8, 1, 590.6, 720, 1, 1),
    (2.0, 1, 478.4, 700, 1, 1),
    (2.5, 1, 306.2, 660, 1, 1),
]


def sizes_of(content: bytes, *, results: bool) -> Worksheet:
    sheet = load_workbook(io.BytesIO(content), data_only=results)["Sizes tried"]
    assert isinstance(sheet, Worksheet)
    return sheet


@pytest.fixture(scope="module")
def springs() -> Course:
    return load_course(SPRINGS)


def key_of(plan: Plan, given: Mapping[str, float]) -> bytes:
    return key_workbook(plan, Variant("1", plan.scheme.id, dict(plan.options), given), ENGLISH)


@pytest.fixture(scope="module")
def spring_key(springs: Course) -> bytes:
    plan = make_plan(springs, "spring", {"wire": "bright"})
    return key_of(plan, {"force": 100.0, "stress_assumed": 800.0, "index": 6.0})


def test_each_size_has_a_row_with_what_decides_about_it(spring_key: bytes) -> None:
    sheet = sizes_of(spring_key, results=True)
    headings = [cell.value for cell in sheet[5]]
    assert headings == ["Size", "Large enough", "τ", "σu", "[τ]", "τ ≤ [τ]", "Will do"]
    rows = [[cell.value for cell in row] for row in sheet.iter_rows(min_row=6, max_row=12)]
    for (size, enough, stress, allowed, holds, will_do), row in zip(WIRES, rows, strict=True):
        in_si = [size * 1e-3, enough, stress * 1e6, allowed * 1e6, holds, will_do]
        assert [*row[:3], *row[4:]] == pytest.approx(in_si, rel=1e-4)


def test_all_of_it_is_computed_there(spring_key: bytes) -> None:
    sheet = sizes_of(spring_key, results=False)
    cells = [cell.value for row in sheet.iter_rows(min_row=6, max_row=12) for cell in row]
    assert all(str(one).startswith("=") for one in cells)


def test_the_key_says_that_the_smallest_is_taken(springs: Course) -> None:
    plan = make_plan(springs, "spring", {"wire": "bright"})
    said = formula_text(plan.quantities["wire"], plan, ENGLISH)
    assert said == "d ≥ d_req, from “wires”: the smallest for which τ ≤ [τ]"


def test_a_key_without_such_a_choice_has_no_such_sheet(plan: Plan, variant: Variant) -> None:
    book = load_workbook(io.BytesIO(key_workbook(plan, variant, ENGLISH)))
    assert "Sizes tried" not in book.sheetnames


@pytest.fixture(scope="module")
def stepped_up(tmp_path_factory: pytest.TempPathFactory) -> Mapping[float, float]:
    """The width that a spreadsheet steps up to, by the friction that is written into its key."""
    office, folder = office_command(), tmp_path_factory.mktemp("sizes")
    assert office is not None
    scheme = (belts := load_course(BELTS)).schemes["flat_belt"]
    assert scheme.example is not None
    plan = make_plan(belts, scheme.id, scheme.example.options)
    key = key_of(plan, {one.id: scheme.example.given[one.id] for one in plan.givens})
    for friction in WIDTHS:
        book = openpyxl.load_workbook(io.BytesIO(key))
        cell(book, "given.friction").value = friction
        book.save(folder / f"{friction}.xlsx")
    recalculate(folder, list(map(str, WIDTHS)), office)
    computed = {
        friction: openpyxl.load_workbook(folder / "out" / f"{friction}.xlsx", data_only=True)
        for friction in WIDTHS
    }
    return {one: cell(book, "answer.belt_width").value for one, book in computed.items()}


@pytest.mark.office
@pytest.mark.parametrize(("friction", "width"), WIDTHS.items())
def test_a_spreadsheet_steps_up_by_itself(
    stepped_up: Mapping[float, float], friction: float, width: float
) -> None:
    """The belt slips at 2·6997·tanh(f·α/2) N for each metre of width, α = 2.9171; 444.07 N pull.

    With 0.30 that is 5760 N/m, and 77.1 mm hold; with 0.50 it is 8717 N/m, and 50.9 mm.
    """
    assert stepped_up[friction] == pytest.approx(width, rel=1e-9)


def cell(book: openpyxl.Workbook, name: str) -> openpyxl.cell.Cell:
    [(sheet, address)] = book.defined_names[name].destinations
    found = book[sheet][address]
    assert isinstance(found, openpyxl.cell.Cell)
    return found
