import math
from datetime import date, datetime, time, timedelta

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gripcourse.solver.plan import Plan
from gripcourse.submission.measure import Understood
from gripcourse.submission.raw import RawCell
from gripcourse.submission.understand import LONGEST_SHOWN, cell_text, understand
from gripcourse.text.words import LANGUAGES, Message, Words

VALUES = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(),
    st.integers(10**300, 10**320),
    st.floats(),
    st.text(),
    st.text(alphabet="0123456789.,-+eЕ ·*^³⁻()=≈xмНкПа%°±…#/!", max_size=30),
    st.datetimes(),
    st.dates(),
    st.times(),
    st.timedeltas(),
)
FORMATS = st.sampled_from(["General", "0.00%", "@", "dd/mm/yy", ""])


@given(value=VALUES, number_format=FORMATS, error=st.booleans(), data=st.data())
def test_whatever_a_cell_holds_it_is_a_finite_value_a_blank_or_a_reason(
    plan: Plan, *, value: object, number_format: str, error: bool, data: st.DataObject
) -> None:
    quantity = data.draw(st.sampled_from(plan.answered))
    cell = RawCell(value, number_format, error, "", "Лист!E6")  # type: ignore[arg-type]
    result = understand(quantity, cell)
    assert len(cell_text(cell)) <= LONGEST_SHOWN
    if isinstance(result, Understood):
        assert math.isfinite(result.value)
        assert math.isfinite(result.half_unit)
    said = result.remarks if isinstance(result, Understood) else [result] if result else []
    for remark in said:
        assert isinstance(remark, Message)
        assert all(Words(language).say(remark) for language in LANGUAGES)


def test_a_cell_is_shown_as_one_short_line() -> None:
    def show(value: object, formula: str = "") -> str:
        return cell_text(RawCell(value, "General", False, formula, "x!E6"))  # type: ignore[arg-type]

    assert show("12,5\n  мм\x07") == "12,5 мм"
    assert show(0.1 + 0.2) == "0.3"
    assert show(1500.0) == "1500"
    assert show(True) == "TRUE"
    assert show(datetime(2026, 5, 1)) == "01.05.2026"  # noqa: DTZ001 - cells have no zone
    assert show(date(2026, 5, 1)) == "2026-05-01"
    assert show(time(1, 30)) == "01:30:00"
    assert show(timedelta(hours=30)) == "1 day, 6:00:00"
    assert show(None, "=A1") == "=A1"
    assert show("я" * 500) == "я" * LONGEST_SHOWN


@pytest.mark.parametrize("fit", ["H7", "h6", "H7/f7", "js6", "k6"])
def test_a_tolerance_of_fit_is_no_unit(plan: Plan, fit: str) -> None:
    raw = RawCell(f"Ø16{fit}", "General", error=False, formula="", cell="A1")
    read = understand(plan.quantities["pin_diameter"], raw)
    assert isinstance(read, Understood)
    assert (read.value, read.unit_fits) == (16.0, True)


@pytest.mark.parametrize(
    ("number_format", "value", "fits"),
    [('0.0" кН"', 3900.0, True), ('#,##0.0 "kN"', 3900.0, True), ('0.0" Н"', 3.9, True),
     ('0.0" кг"', 3.9, False), ('0.0" около"', 3.9, True), ("0.00", 3.9, True)],
)  # fmt: skip
def test_the_unit_that_a_number_format_shows_is_the_students(
    plan: Plan, number_format: str, value: float, *, fits: bool
) -> None:
    raw = RawCell(3.9, number_format, error=False, formula="", cell="A1")
    read = understand(plan.quantities["grip_force"], raw)
    assert isinstance(read, Understood)
    assert (read.value, read.unit_fits) == (pytest.approx(value), fits)
