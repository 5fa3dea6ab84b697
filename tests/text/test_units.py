import csv
from fractions import Fraction
from importlib.resources import files

import pint
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gripcourse.text import units
from gripcourse.text.units import PLAIN, Dimension, UnitError, dimension, factor, known, read_unit

LANGUAGES = ("en", "ru", "uk")
TABLE = tuple(csv.DictReader((files("gripcourse") / "text" / "units.csv").read_text().splitlines()))
LENGTH = Dimension((("length", Fraction(1)),))

_atoms = st.sampled_from(["mm", "m", "N", "kg", "s", "MPa", "kW", "min", "l"])
_powers = st.integers(2, 4)
_factors = st.one_of(_atoms, st.builds(lambda unit, power: f"{unit}**{power}", _atoms, _powers))
_compounds = st.builds(
    lambda first, rest: first + "".join(sign + part for sign, part in rest),
    _factors,
    st.lists(st.tuples(st.sampled_from("*/"), _factors), max_size=3),
)
_dimensions = st.builds(dimension, _compounds)
_exponents = st.fractions(-3, 3, max_denominator=6)


@pytest.mark.parametrize(
    ("unit", "size"),
    [
        ("", 1.0),
        ("mm", 1e-3),
        ("kN", 1e3),
        ("MPa", 1e6),
        ("bar", 1e5),
        ("kgf", 9.80665),  # the standard weight of a kilogram, ISO 80000-3
        ("deg", 3.141592653589793 / 180),
        ("l/min", 1e-3 / 60),
        ("mm**2", 1e-6),
        ("N*m", 1.0),
        ("%", 0.01),
        ("t", 1000.0),
        ("rpm", 3.141592653589793 / 30),
        ("A/mm**2", 1e6),
        ("ohm*mm**2/m", 1e-6),
        ("mmHg", 133.322387415),  # 13595.1 kg/m³ of mercury, 1 mm high, at the standard gravity
        ("metric_horsepower", 735.49875),  # 75 kgf·m/s
        ("kohm*nF", 1e-6),
        ("T", 1.0),
        ("N/A**2", 1.0),
    ],
)
def test_a_value_in_a_unit_times_its_factor_is_in_si(unit: str, size: float) -> None:
    assert factor(unit) == pytest.approx(size, rel=1e-15)


def test_every_unit_of_the_table_can_be_multiplied_and_has_a_text_in_each_language() -> None:
    for row in TABLE:
        assert factor(row["unit"]) > 0
        assert all(row[name] == units.unit_text(row["unit"], name) != "" for name in LANGUAGES)


def test_every_text_and_accepted_spelling_of_the_table_reads_back_as_its_unit() -> None:
    for row in TABLE:
        for spelling in (row["unit"], *(row[name] for name in LANGUAGES), *row["also"].split()):
            assert read_unit(spelling) == row["unit"], spelling


@given(_compounds, st.sampled_from(LANGUAGES))
def test_a_compound_reads_back_from_its_text_with_the_same_meaning(
    unit: str, language: str
) -> None:
    found = read_unit(units.unit_text(unit, language))
    assert found is not None
    assert dimension(found) == dimension(unit)
    assert factor(found) == pytest.approx(factor(unit), rel=1e-12)


@given(_compounds)
def test_what_is_read_is_in_our_spelling(unit: str) -> None:
    found = read_unit(unit)
    assert found is not None
    assert known(found)


@pytest.mark.parametrize(
    ("typed", "unit"),
    [
        ("мм", "mm"),
        (" мм. ", "mm"),
        ("[мм]", "mm"),
        (", мм", "mm"),
        ("MM", "mm"),
        ("Н", "N"),
        ("H", "N"),  # Latin aitch
        ("кH", "kN"),
        ("КГС", "kgf"),
        ("мм рт. ст.", "mmHg"),
        ("мм.рт.ст.", "mmHg"),
        ("ММ РТ СТ", "mmHg"),
        ("mm Hg", "mmHg"),
        ("торр", "mmHg"),
        ("л.с.", "metric_horsepower"),
        ("к. с.", "metric_horsepower"),
        ("Н.м", "N*m"),
        ("кв. мм", "mm**2"),
        ("об./мин", "rpm"),
        ("кг/(м с)", "kg/m/s"),
        ("МПа", "MPa"),
        ("MПa", "MPa"),  # three letters of the other alphabet
        ("мпа", "MPa"),
        ("Н/мм2", "N/mm**2"),
        ("Н/мм^2", "N/mm**2"),
        ("кгс/см²", "kgf/cm**2"),
        ("м/с2", "m/s**2"),
        ("м/c²", "m/s**2"),  # Latin cee
        ("м / с**2", "m/s**2"),
        ("Н*м", "N*m"),
        ("Н·м", "N*m"),
        ("Н м", "N*m"),
        ("Нм", "N*m"),
        ("Nm", "N*m"),
        ("кг/(м·с)", "kg/m/s"),
        ("с⁻¹", "1/s"),
        ("°", "deg"),
        ("º", "deg"),
        ("град.", "deg"),
        ("л/мин", "l/min"),
        ("л/хв", "l/min"),
        ("об/мин", "rpm"),
        ("сек", "s"),
        ("ч", "h"),
        ("год", "h"),
        ("%", "%"),
        ("А", "A"),  # Cyrillic
        ("\N{OHM SIGN}", "ohm"),
        ("k\N{OHM SIGN}", "kohm"),
        ("кОм", "kohm"),
        ("МОм", "Mohm"),
        ("мОм", "mohm"),
        ("mA", "mA"),
        ("мкА", "uA"),
        ("кВ", "kV"),
        ("мВ", "mV"),
        ("µF", "uF"),
        ("uF", "uF"),
        ("мкФ", "uF"),
        ("нФ", "nF"),
        ("пФ", "pF"),
        ("МГц", "MHz"),
        ("Ом·мм²/м", "ohm*mm**2/m"),
        ("Тл", "T"),
        ("т", "t"),
        ("", ""),
        ("—", ""),
    ],
)
def test_people_may_spell_units_in_many_ways(typed: str, unit: str) -> None:
    assert read_unit(typed) == unit


@pytest.mark.parametrize("typed", ["foo", "мм мм мм??", "12", "kg/", "*", "м//с", "℧", "мм2м2)("])
def test_what_is_no_unit_is_not_read_as_one(typed: str) -> None:
    assert read_unit(typed) is None


@given(st.text(max_size=20))
def test_reading_never_fails(typed: str) -> None:
    found = read_unit(typed)
    assert found is None or known(found)


@pytest.mark.parametrize("unit", ["furlong", "degF", "mm^2", "мм", "kg/", "import os", "m**"])
def test_only_the_spellings_of_the_table_are_known(unit: str) -> None:
    assert not known(unit)
    with pytest.raises(UnitError):
        factor(unit)
    with pytest.raises(UnitError):
        dimension(unit)
    with pytest.raises(UnitError):
        units.unit_text(unit, "en")


@pytest.mark.parametrize("unit", ["mm**123", "mm**99999999999999999999", "1/s**1000"])
def test_a_power_that_no_unit_has_is_refused_before_it_is_computed(unit: str) -> None:
    assert not known(unit)
    assert read_unit(unit.replace("**", "^")) is None


def test_sizes_and_dimensions_are_those_that_another_library_knows() -> None:
    registry = pint.UnitRegistry()
    compounds = ["kgf/cm**2", "ohm*mm**2/m", "l/min", "N*m/rad", "A/mm**2", "1/s", "kg/m/s"]
    for unit in [*(row["unit"] for row in TABLE), *compounds]:
        # A temperature counts from 0 °C: a degree of it is one of a difference.
        one = registry.Quantity(1.0, unit.replace("degC", "delta_degC")).to_base_units()
        measured = {str(base).strip("[]"): power for base, power in one.dimensionality.items()}
        assert factor(unit) == pytest.approx(one.magnitude, rel=1e-14), unit
        assert dict(dimension(unit).exponents) == measured, unit


@pytest.mark.parametrize(
    ("unit", "language", "text"),
    [
        ("m/s**2", "ru", "м/с²"),
        ("N*m", "uk", "Н·м"),
        ("mm/s", "en", "mm/s"),
        ("l/min", "uk", "л/хв"),
        ("kg/m/s", "ru", "кг/(м·с)"),
        ("1/s", "ru", "1/с"),
        ("deg", "ru", "°"),
        ("", "ru", ""),
        ("kgf/cm**2", "ru", "кгс/см²"),
    ],
)
def test_units_are_written_as_people_write_them(unit: str, language: str, text: str) -> None:
    assert units.unit_text(unit, language) == text


def test_an_angle_is_a_plain_number() -> None:
    assert dimension("deg") == dimension("rad") == dimension("%") == PLAIN
    assert PLAIN.dimensionless


@given(_dimensions, _dimensions)
def test_a_product_divided_by_a_factor_is_the_other_factor(a: Dimension, b: Dimension) -> None:
    assert a * b / b == a
    assert a * b == b * a


@given(_dimensions, _exponents, _exponents)
def test_powers_of_a_dimension_add_up(a: Dimension, p: Fraction, q: Fraction) -> None:
    assert a**p * a**q == a ** (p + q)
    assert (a**p) ** q == a ** (p * q)
    assert hash(a**p * a**q) == hash(a ** (p + q))


@given(_compounds, _compounds)
def test_the_dimension_and_size_of_a_product_are_the_products(a: str, b: str) -> None:
    product = f"{a}*{b}"
    assert dimension(product) == dimension(a) * dimension(b)
    assert factor(product) == pytest.approx(factor(a) * factor(b), rel=1e-12)


@pytest.mark.parametrize(
    ("measured", "language", "text"),
    [
        (dimension("N"), "en", "N"),
        (dimension("m"), "en", "mm"),
        (dimension("kg") * LENGTH, "ru", "м·кг"),
        (dimension("kg") / dimension("s") / LENGTH, "ru", "кг/(м·с)"),
        (LENGTH ** Fraction(1, 2), "ru", "м^(1/2)"),
        (LENGTH ** Fraction(-4), "en", "1/m⁴"),
    ],
)
def test_a_dimension_is_named_by_a_unit_that_people_know(
    measured: Dimension, language: str, text: str
) -> None:
    assert units.dimension_text(measured, language) == text
