import math
import random
import subprocess
from collections.abc import Callable
from pathlib import Path

import numpy as np
import openpyxl
import pytest

from gripcourse.formula.evaluate import Column, evaluate
from gripcourse.formula.excel import excel_form
from gripcourse.formula.functions import FUNCTIONS
from gripcourse.formula.parse import parse
from gripcourse.formula.tree import Formula

MakeFormula = Callable[..., Formula]
CELLS = {"a": "si.a", "b": "si.b", "c": "si.c", "force": "F1", "length": "L1"}
COLUMNS = {"s.x": ("SIZES", "VALUES")}


@pytest.mark.parametrize(
    ("text", "excel"),
    [
        ("a + b*c", "si.a+si.b*si.c"),
        ("(a + b)*c", "(si.a+si.b)*si.c"),
        ("a - (b - c)", "si.a-(si.b-si.c)"),
        ("a - b - c", "si.a-si.b-si.c"),
        ("a/b/c", "si.a/si.b/si.c"),
        ("a/(b*c)", "si.a/(si.b*si.c)"),
        ("-a**2", "(-(si.a^2))"),  # a spreadsheet takes -a^2 for a square
        ("(-a)**2", "(-si.a)^2"),
        ("a**b**c", "si.a^(si.b^si.c)"),  # and a^b^c from the left
        ("(a**b)**c", "(si.a^si.b)^si.c"),
        ("a**-2", "si.a^(-2)"),
        ("a**(1/3)", "si.a^(1/3)"),
        ("2*pi*a", "2*PI()*si.a"),
        ("1e-7*a", "1E-07*si.a"),
        ("sqrt(a + b)", "SQRT(si.a+si.b)"),
        ("cbrt(a)", "(SIGN(si.a)*ABS(si.a)^(1/3))"),
        ("atan2(a, b)", "ATAN2(si.b,si.a)"),
        ("hypot(a, b)", "SQRT(SUMSQ(si.a,si.b))"),
        ("max(a, b, c)", "MAX(si.a,si.b,si.c)"),
        ("log(a)", "LN(si.a)"),
        ('at_least("s.x", a)', "INDEX(SIZES,SUMPRODUCT(--(VALUES<(si.a)-ABS(si.a)*1E-9))+1)"),
        ("a <= b", "IF((si.a)-(si.b)<=1E-09*MAX(ABS(si.a),ABS(si.b)),1,0)"),
    ],
)
def test_a_formula_is_written_as_a_spreadsheet_binds(
    formula_of: MakeFormula, text: str, excel: str
) -> None:
    assert excel_form(formula_of(text), "", CELLS, COLUMNS) == excel


def test_an_empirical_formula_converts_its_cells_and_its_result(formula_of: MakeFormula) -> None:
    formula = formula_of("2*force + length", force="kN", length="m")
    assert excel_form(formula, "mm", CELLS, COLUMNS) == "(2*(F1/1000)+L1)*0.001"


def test_a_function_without_a_spreadsheet_form_has_none(
    formula_of: MakeFormula, monkeypatch: pytest.MonkeyPatch
) -> None:
    sine = FUNCTIONS["sin"]
    without = type(sine)("sin", 1, 1, sine.reads_column, sine.compute, sine.rule, sine.form, None)
    monkeypatch.setattr("gripcourse.formula.excel.FUNCTIONS", {**FUNCTIONS, "sin": without})
    assert excel_form(formula_of("2*sin(a)"), "", CELLS, COLUMNS) is None
    assert excel_form(formula_of("2*cos(a)"), "", CELLS, COLUMNS) == "2*COS(si.a)"


def test_a_formula_too_long_for_a_cell_has_no_form(formula_of: MakeFormula) -> None:
    text = "a"
    for _ in range(12):
        text = f"cbrt({text})"
    assert excel_form(formula_of(text), "", CELLS, COLUMNS) is None


# ---- LibreOffice computes the same ----

VALUES = {"a": 0.25, "b": 1.5, "c": 0.7, "d": 3.0, "e": -0.4}
SERIES = Column(np.array([0.04, 0.05, 0.063, 0.08, 0.1]), np.array([0.2, 0.25, 1.5, 2.0, 3.0]))
ADDRESSES = {name: f"data!$A${row}" for row, name in enumerate(VALUES, start=1)}
RANGES = {"s.x": ("data!$B$1:$B$5", "data!$C$1:$C$5")}
SPECIAL = [
    "-a**2",
    "(-a)**2",
    "2**3**2",
    "(2**3)**2",
    "a**-2",
    "-a**-2",
    "10 - 4 - 3",
    "24/4/2",
    "24/(4*2)",
    "a - (b - c)",
    "-(a + b)*-c",
    "cbrt(e)",
    "cbrt(-8)",
    "atan2(a, e)",
    "atan2(e, a)",
    "atan2(e, e)",
    "hypot(a, b)**2",
    "asin(c) + acos(c) + atan(c)",
    "log(exp(b))",
    "abs(e) + min(a, b, e) - max(a, b, e)",
    "a < b",
    "a <= a",
    "0.1 + 0.2 <= 0.3",
    "0.3 < 0.1 + 0.2",
    "0.1 + 0.2 == 0.3",
    "a > 0 and b > 0 and e > 0",
    "a > 0 and b > 0 and e < 0",
    *(f'at_least("s.x", {x})' for x in ("e", "0", "a", "a*(1 + 1e-10)", "0.26", "b", "d")),
    *(f'nearest("s.x", {x})' for x in ("e", "a", "0.874", "0.875", "0.876", "b", "9")),
    *(f'lookup("s.x", {x})' for x in ("0.04", "0.063*(1 + 1e-10)", "0.1")),
    *(f'interpolate("s.x", {x})' for x in ("0.04", "0.07", "0.08", "0.1*(1 + 1e-10)")),
    'at_least("s.x", nearest("s.x", b)*4)',
]
WITHOUT_VALUE = [
    "sqrt(e)",
    "1/0",
    "log(0)",
    "asin(2)",
    "e**0.3",
    "atan(1/0)",
    'at_least("s.x", 3.1)',
    'lookup("s.x", 0.051)',
    'lookup("s.x", e)',
    'interpolate("s.x", 0.039)',
    'interpolate("s.x", 0.11)',
    "sqrt(e) > 0",
    "exp(1000)",
]


def _random_formula(chance: random.Random, depth: int) -> str:
    """Return a formula whose powers have positive bases: LibreOffice roots negative ones."""
    if depth == 0:
        return chance.choice([*VALUES, "2", "0.5", "pi", "13"])
    one, two = (_random_formula(chance, chance.randrange(depth)) for _ in range(2))
    return chance.choice(
        [
            f"({one}) + ({two})",
            f"({one}) - ({two})",
            f"({one})*({two})",
            f"({one})/({two})",
            f"abs({one})**(({two})/7)",
            f"-({one})**2",
            f"sqrt(abs({one}))",
            f"cbrt({one})",
            f"sin({one})*cos({two})",
            f"atan2({one}, {two})",
            f"hypot({one}, {two})",
            f"max({one}, {two})",
            f"exp(-abs({one}))",
        ]
    )


@pytest.mark.office
def test_a_spreadsheet_computes_what_we_compute(tmp_path: Path) -> None:
    chance = random.Random(20)  # noqa: S311 - the formulas must be the same every time
    random_ones = [_random_formula(chance, 4) for _ in range(300)]
    formulas = [*SPECIAL, *WITHOUT_VALUE, *random_ones]
    computed = _computed_by_libreoffice([_excel(formula) for formula in formulas], tmp_path)
    for formula, found in zip(formulas, computed, strict=True):
        expected = _expected(formula)
        if math.isnan(expected):
            assert isinstance(found, str), (formula, found)
            assert found.startswith("#"), (formula, found)
        else:
            assert found == pytest.approx(expected, rel=1e-9, abs=1e-12), formula


def test_the_formulas_that_a_spreadsheet_is_tried_with_have_the_values_they_should() -> None:
    assert all(math.isfinite(_expected(formula)) for formula in SPECIAL)
    assert all(math.isnan(_expected(formula)) for formula in WITHOUT_VALUE)


def _expected(text: str) -> float:
    values = {name: np.asarray(value) for name, value in VALUES.items()}
    return float(evaluate(Formula(text, parse(text), {}), "", values, {"s.x": SERIES}))


def _excel(text: str) -> str:
    written = excel_form(Formula(text, parse(text), {}), "", ADDRESSES, RANGES)
    assert written is not None
    return written


def _computed_by_libreoffice(formulas: list[str], folder: Path) -> list[object]:
    """Write formulas to a workbook, let LibreOffice compute it, and read the values."""
    book = openpyxl.Workbook()
    sheet = book.active
    assert sheet is not None
    for row, formula in enumerate(formulas, start=1):
        sheet.cell(row, 1, f"={formula}")
    data = book.create_sheet("data")
    for row, value in enumerate(VALUES.values(), start=1):
        data.cell(row, 1, value)
    for row, (size, value) in enumerate(zip(SERIES.sizes, SERIES.values, strict=True), start=1):
        data.cell(row, 2, float(size))
        data.cell(row, 3, float(value))
    book.save(folder / "formulas.xlsx")
    profile = (folder / "profile").as_uri()
    command = ["soffice", f"-env:UserInstallation={profile}", "--headless", "--convert-to", "xlsx"]
    subprocess.run(  # noqa: S603 - a fixed command on our own file
        [*command, "--outdir", str(folder / "out"), str(folder / "formulas.xlsx")],
        check=True,
        capture_output=True,
        timeout=180,
    )
    computed = openpyxl.load_workbook(folder / "out" / "formulas.xlsx", data_only=True).worksheets[
        0
    ]
    return [computed.cell(row, 1).value for row in range(1, len(formulas) + 1)]
