from collections.abc import Callable
from types import MappingProxyType

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gripcourse.formula.dimension import check_dimension, is_condition, measured_by
from gripcourse.formula.fault import FormulaFault
from gripcourse.formula.parse import parse
from gripcourse.formula.tree import Formula
from gripcourse.text.units import PLAIN, dimension

DIMENSIONS = MappingProxyType(
    {
        "mass": dimension("kg"),
        "acceleration": dimension("m/s**2"),
        "force": dimension("N"),
        "length": dimension("mm"),
        "pressure": dimension("MPa"),
        "efficiency": PLAIN,
        "angle": dimension("deg"),
        "torque": dimension("N*m"),
    }
)
COLUMNS = MappingProxyType(
    {
        "flanges.load": (dimension("mm"), dimension("N")),
        "bores.size": (dimension("mm"), dimension("mm")),
    }
)
MakeFormula = Callable[..., Formula]


@pytest.mark.parametrize(
    ("text", "unit"),
    [
        ("mass*(acceleration + 9.81*acceleration)", "N"),
        ("sqrt(4*force/(pi*pressure*efficiency))", "mm"),
        ("cbrt(length**3)", "m"),
        ("length**(1/3)*length**(2/3)", "m"),
        ("length**0.5*length**0.5", "m"),
        ("length**-2*force", "Pa"),
        ("length**(3*0.5 - 1/2 + 1)", "mm**2"),
        ("force*length", "N*m"),
        ("sin(angle)*length", "mm"),
        ("asin(length/length)", "deg"),
        ("atan2(force, force)", "rad"),
        ("hypot(force, mass*acceleration)", "N"),
        ("max(force, mass*acceleration, 0)", "N"),
        ("abs(-force)", "N"),
        ("exp(efficiency)*log(angle)", ""),
        ("efficiency**efficiency", ""),
        ("force > 0", ""),
        ("0 <= length and length <= 2*length", ""),
        ("0 - force", "N"),
        ("force + -0*1", "N"),
        ("0", "mm"),
        ("0*force", "mm"),  # a zero is a zero of anything
        ("0/force + length", "mm"),
        ('at_least("flanges.load", force)', "mm"),
        ('nearest("flanges.load", force)', "mm"),
        ('lookup("flanges.load", length)', "N"),
        ('at_least("bores.size", length)', "mm"),
        ("torque/length", "kN"),
    ],
)
def test_a_formula_of_the_right_dimension_passes(
    formula_of: MakeFormula, text: str, unit: str
) -> None:
    formula = formula_of(text)
    check_dimension(formula, unit, DIMENSIONS, COLUMNS)
    if not text.startswith("0"):
        assert measured_by(formula.tree, DIMENSIONS, COLUMNS) == dimension(unit)


@pytest.mark.parametrize(
    ("text", "unit", "what", "place"),
    [
        ("force", "mm", "gives N, but its quantity is declared in mm", "force"),
        ("force/force", "mm", "gives a plain number", "force/force"),
        ("force + length", "N", "'+' needs like with like, but here N stands against mm", "length"),
        ("force - length", "N", "'-' needs like with like", "length"),
        ("1 + length", "mm", "a plain number stands against mm", "length"),
        ("force > length", "", "'>' needs like with like", "length"),
        ("force > 0 and mass > force", "", "kg stands against N", "force"),
        ("max(force, 0, length)", "N", "max() needs like with like", "length"),
        ("hypot(force, 1)", "N", "hypot() needs like with like", "1"),
        ("atan2(force, length)", "", "atan2() needs like with like", "length"),
        ("sin(length)", "", "sin() needs a plain number here, not mm", "length"),
        ("exp(force/length)", "", "needs a plain number here, not kg/s²", "force/length"),
        ("length**efficiency", "mm", "must be a number that is written out", "efficiency"),
        ("length**(1/0)", "mm", "must be a number that is written out", "1/0"),
        ("2**length", "", "exponent is a plain number, not mm", "length"),
        ("lenght", "mm", "no quantity lenght; did you mean length?", "lenght"),
        ("zzz*2", "mm", "no quantity zzz.", "zzz"),
        ('at_least("flanges.load", length)', "mm", "at_least() needs N here, not mm", "length"),
        ('lookup("flanges.load", force)', "N", "lookup() needs mm here, not N", "force"),
        (
            'nearest("flanges.laod", force)',
            "mm",
            "column flanges.laod; did you mean flanges.load?",
            'nearest("flanges.laod", force)',
        ),
        ('nearest("x.y", force)', "mm", "no catalogue column x.y.", 'nearest("x.y", force)'),
        ("force", "furlong", "unit furlong is not in the table", "force"),
    ],
)
def test_a_formula_of_the_wrong_dimension_is_refused_where_it_goes_wrong(
    formula_of: MakeFormula, text: str, unit: str, what: str, place: str
) -> None:
    with pytest.raises(FormulaFault) as caught:
        check_dimension(formula_of(text), unit, DIMENSIONS, COLUMNS)
    assert what in str(caught.value.what)
    assert text[slice(*caught.value.span)] == place


def test_an_empirical_formula_may_mix_what_it_likes_if_each_name_has_its_unit(
    formula_of: MakeFormula,
) -> None:
    formula = formula_of("3*cbrt(torque) + length*pi", torque="N*m", length="cm")
    check_dimension(formula, "mm", DIMENSIONS, COLUMNS)
    assert formula.units == {"torque": "N*m", "length": "cm"}


@pytest.mark.parametrize(
    ("text", "units", "what"),
    [
        ("torque + length", {"torque": "N*m"}, "do not name length"),
        ("torque", {"torque": "mm"}, "torque enters in mm, but it is N·m"),
        ("torque", {"torque": "furlong"}, "furlong is not in the table"),
        (
            "torque",
            {"torque": "N*m", "length": "mm"},
            "name length, which the formula does not use",
        ),
        ("nothing", {"nothing": "mm"}, "no quantity nothing"),
        ('torque*nearest("bores.size", 1)', {"torque": "N*m"}, "cannot read a catalogue"),
    ],
)
def test_the_units_of_an_empirical_formula_must_fit_its_names(
    formula_of: MakeFormula, text: str, units: dict[str, str], what: str
) -> None:
    with pytest.raises(FormulaFault) as caught:
        check_dimension(formula_of(text, **units), "mm", DIMENSIONS, COLUMNS)
    assert what in str(caught.value.what)


@pytest.mark.parametrize(
    ("text", "condition"),
    [("force > 0", True), ("force > 0 and mass > 0", True), ("force", False), ("-mass*2", False)],
)
def test_a_condition_is_told_from_a_number(text: str, condition: object) -> None:
    assert is_condition(parse(text)) is condition


_names = st.sampled_from(sorted(DIMENSIONS))
_products = st.recursive(
    _names,
    lambda inner: (
        st.builds(lambda a, b: f"({a})*({b})", inner, inner)
        | st.builds(lambda a, n: f"({a})**{n}", inner, st.integers(1, 3))
    ),
    max_leaves=5,
)


@given(_products, _products)
def test_the_dimension_of_a_product_is_the_product_of_the_dimensions(a: str, b: str) -> None:
    def measure(text: str) -> object:
        return measured_by(parse(text), DIMENSIONS, COLUMNS)

    left = measured_by(parse(a), DIMENSIONS, COLUMNS)
    right = measured_by(parse(b), DIMENSIONS, COLUMNS)
    assert measure(f"({a})*({b})") == left * right
    assert measure(f"({a})/({b})") == left / right
    assert measure(f"sqrt(({a})*({a}))") == left


@given(_products, _products)
def test_only_like_things_add_up(a: str, b: str) -> None:
    left = measured_by(parse(a), DIMENSIONS, COLUMNS)
    right = measured_by(parse(b), DIMENSIONS, COLUMNS)
    if left == right:
        assert measured_by(parse(f"{a} + {b}"), DIMENSIONS, COLUMNS) == left
    else:
        with pytest.raises(FormulaFault):
            measured_by(parse(f"{a} + {b}"), DIMENSIONS, COLUMNS)
