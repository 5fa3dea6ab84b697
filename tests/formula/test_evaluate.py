from collections.abc import Callable
from types import MappingProxyType

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gripcourse.formula.evaluate import Column, evaluate
from gripcourse.formula.parse import parse
from gripcourse.formula.tree import Formula

MakeFormula = Callable[..., Formula]
NAN = float("nan")
COLUMNS = MappingProxyType(
    {"bores.size": Column(np.array([0.04, 0.05, 0.063]), np.array([0.04, 0.05, 0.063]))}
)


def _value(text: str, **values: float) -> float:
    given_values = {name: np.asarray(value) for name, value in values.items()}
    result = evaluate(Formula(text, parse(text), {}), "", given_values, COLUMNS)
    return float(result)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("2 + 3*4", 14.0),
        ("-2**2", -4.0),
        ("(-2)**2", 4.0),
        ("2**3**2", 512.0),
        ("10 - 4 - 3", 3.0),
        ("24/4/2", 3.0),
        ("2*pi", 2 * np.pi),
        ("sqrt(9) + cbrt(-27)", 0.0),
        ("hypot(3, 4)", 5.0),
        ("exceeds(2, 1)", 1.0),
        ("exceeds(1, 1)", 0.0),
        ("sin(pi/6)", 0.5),
        ("cos(pi/3)", 0.5),
        ("tan(pi/4)", 1.0),
        ("asin(0.5)*6/pi", 1.0),
        ("acos(0.5)*3/pi", 1.0),
        ("atan(1)*4/pi", 1.0),
        ("atan2(1, -1)*4/pi", 3.0),
        ("abs(-3)", 3.0),
        ("min(3, 1, 2)", 1.0),
        ("max(3, 1, 2)", 3.0),
        ("log(exp(2))", 2.0),
        ('at_least("bores.size", 0.0537)', 0.063),
        ('nearest("bores.size", 0.0537)', 0.05),
        ('lookup("bores.size", 0.05)', 0.05),
    ],
)
def test_a_formula_is_computed_as_it_is_read(text: str, value: float) -> None:
    assert _value(text) == pytest.approx(value, rel=1e-12, abs=1e-12)


@pytest.mark.parametrize(
    "text",
    [
        "sqrt(-1)",
        "asin(1.1)",
        "log(0)",
        "log(-1)",
        "1/0",
        "0/0",
        "(-8)**0.5",
        "0**-1",
        "exp(1000)",
        "1e300*1e300",
        "atan(1/0)",  # numpy alone would say a right angle
        "1/(1/0)",  # and zero here
        "min(1, 1/0)",
        "(0/0)**0",
        "1**(0/0)",
        "1/0 > 0",
        "1 < 2 and 0/0 > 1",
        'at_least("bores.size", 0.064)',
        'lookup("bores.size", 0.051)',
        'nearest("bores.size", 0/0)',
    ],
)
def test_what_has_no_value_is_nan_and_stays_nan(text: str) -> None:
    assert np.isnan(_value(text))


@pytest.mark.parametrize("text", ["a**0", "a*0", "max(a, 1)", "a < 1", "a == a", "1**a", "atan(a)"])
@pytest.mark.parametrize("value", [NAN, float("inf"), -float("inf")])
def test_what_was_not_supplied_gives_no_value(text: str, value: float) -> None:
    assert np.isnan(_value(text, a=value))


@pytest.mark.parametrize(
    ("text", "holds"),
    [
        ("24.4 <= 24.4", 1.0),
        ("0.1 + 0.2 <= 0.3", 1.0),  # 0.30000000000000004
        ("0.3 >= 0.1 + 0.2", 1.0),
        ("0.1 + 0.2 == 0.3", 1.0),
        ("0.1 + 0.2 > 0.3", 0.0),
        ("0.3 < 0.1 + 0.2", 0.0),
        ("1 < 1.00000001", 1.0),
        ("1.00000001 <= 1", 0.0),
        ("-1.00000001 >= -1", 0.0),
        ("0 > 0", 0.0),
        ("1e-12 > 0", 1.0),
        ("1 < 2 and 2 < 3", 1.0),
        ("1 < 2 and 3 < 2", 0.0),
        ("1 < 2 and 3 < 4 and 5 < 4", 0.0),
    ],
)
def test_a_condition_is_one_or_zero_and_sees_no_difference_of_a_billionth(
    text: str, holds: float
) -> None:
    assert _value(text) == holds


@given(st.floats(-1e9, 1e9), st.floats(-1e9, 1e9))
def test_exactly_one_of_below_and_not_below_holds(a: float, b: float) -> None:
    assert _value("a < b", a=a, b=b) + _value("a >= b", a=a, b=b) == 1.0
    assert _value("a > b", a=a, b=b) + _value("a <= b", a=a, b=b) == 1.0
    assert _value("a <= b", a=a, b=b) == _value("b >= a", a=a, b=b)


def test_an_empirical_formula_takes_its_names_and_gives_its_result_in_its_own_units(
    formula_of: MakeFormula,
) -> None:
    formula = formula_of("3*force*length", force="kN", length="cm")
    values = {"force": np.array(2000.0), "length": np.array(0.05)}
    assert float(evaluate(formula, "mm", values, {})) == pytest.approx(3 * 2 * 5 / 1000)


def test_the_unit_of_a_formula_that_is_not_empirical_changes_nothing(
    formula_of: MakeFormula,
) -> None:
    assert float(evaluate(formula_of("2*a"), "mm", {"a": np.array(3.0)}, {})) == 6.0


@pytest.mark.parametrize("text", ["a + b", "a**b", "max(a, 2)*pi", "a <= b", "sqrt(a - b)", "3"])
def test_many_variants_are_computed_as_one_by_one(formula_of: MakeFormula, text: str) -> None:
    formula = formula_of(text)
    a, b = np.array([1.0, 2.0, NAN, 4.0]), np.array([3.0, 2.0, 1.0, 0.5])
    together = np.broadcast_to(evaluate(formula, "", {"a": a, "b": b}, {}), a.shape)
    alone = [float(evaluate(formula, "", {"a": a[row], "b": b[row]}, {})) for row in range(a.size)]
    np.testing.assert_array_equal(together, alone)


def test_whole_numbers_are_computed_as_numbers(formula_of: MakeFormula) -> None:
    values = {"a": np.array([2, 3])}
    result = evaluate(formula_of("a**-1"), "", values, {})
    np.testing.assert_allclose(result, [0.5, 1 / 3])
    assert values["a"].dtype.kind == "i"


def test_the_values_that_were_handed_in_stay_as_they_are(formula_of: MakeFormula) -> None:
    a = np.array([1.0, float("inf")])
    evaluate(formula_of("a/0"), "", {"a": a}, {})
    np.testing.assert_array_equal(a, [1.0, float("inf")])


def test_the_published_bore_is_reproduced() -> None:
    """The guide's section 5: 18352.9 N at 10 MPa and 0.87·0.93 need 53.74 mm, so 63 mm."""
    bore = _value("sqrt(4*P/(pi*p*n))", P=18352.9, p=10e6, n=0.87 * 0.93)
    assert bore == pytest.approx(53.74e-3, abs=5e-6)
    assert _value('at_least("bores.size", bore)', bore=bore) == 0.063
