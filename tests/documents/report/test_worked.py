"""A line of calculation: symbols, numbers with units, result; golden numbers are the guide's."""

from dataclasses import replace

import pytest

from gripcourse.documents.report.worked import entering_units, worked_line
from gripcourse.formula.markup import text
from gripcourse.formula.parse import parse
from gripcourse.formula.tree import Formula
from gripcourse.solver.plan import Plan
from gripcourse.text.words import Words

RUSSIAN = Words("ru")


def line(
    plan: Plan,
    quantity: str,
    inputs: dict[str, float],
    result: float | None = None,
    words: Words = RUSSIAN,
) -> str:
    box = worked_line(plan.quantities[quantity], inputs, result, plan, words)
    assert box is not None
    return text(box).replace("\u00a0", " ").replace("\u202f", "")


def test_a_formula_is_written_in_symbols_in_numbers_and_as_its_result(plan: Plan) -> None:
    # Guide, equation 29: S = (200 - 60)/2 + 20 = 90 mm.
    inputs = {"diameter_max": 200.0, "diameter_min": 60.0, "release_travel": 20.0}
    written = line(plan, "jaw_travel", inputs, 90.0)
    symbols, numbers, result = written.removeprefix("S = ").split(" = ")
    assert "D_max − D_min" in symbols
    assert "200 мм − 60 мм" in numbers
    assert result == "90 мм"


def test_an_angle_is_printed_in_degrees(plan: Plan) -> None:
    written = line(plan, "arm_angle_open", {"jaw_travel": 90.0, "arm_length": 150.0}, 36.8699)
    assert written.endswith("= 36,87°")


def test_an_angle_that_counts_as_a_number_is_put_in_in_radians(plan: Plan) -> None:
    inputs = {"pitch_radius": 51.0, "arm_angle_open": 36.8699, "arm_angle_at_min": 0.0}
    written = line(plan, "stroke_required", inputs, 32.819)
    assert "51 мм · (0,6435 рад − 0 рад) = 32,819 мм" in written


def test_a_number_that_is_not_known_stays_a_symbol(plan: Plan) -> None:
    written = line(plan, "arm_angle_open", {"arm_length": 150.0})
    _, symbols, numbers = written.split(" = ")
    assert "l" in symbols
    assert "S" in numbers
    assert "150 мм" in numbers


def test_without_any_number_only_the_symbols_are_written(plan: Plan) -> None:
    assert line(plan, "arm_angle_open", {}).count("=") == 1


def test_the_number_of_a_formula_that_is_a_name_would_be_the_result(plan: Plan) -> None:
    hidden = line(plan, "pin_length", {"lever_width": 40.0})
    assert "40" not in hidden
    assert line(plan, "pin_length", {"lever_width": 40.0}, 40.0).endswith("= 40 мм")


def test_what_is_the_same_twice_is_written_once(plan: Plan) -> None:
    assert line(plan, "pin_length", {"lever_width": 40.0}, 40.0).count("40") == 1


def test_a_choice_is_written_as_a_step_up_to_a_series(plan: Plan) -> None:
    # Guide, section 5, with the worst position: bore 60.08 -> 63 mm.
    written = line(plan, "bore_first", {"bore_required": 60.08}, 63.0)
    assert written == "D_I ≥ D_тр = 60,08 мм → 63 мм"


def test_a_choice_without_a_result_ends_at_what_is_required(plan: Plan) -> None:
    assert line(plan, "bore_first", {"bore_required": 60.08}) == "D_I ≥ D_тр = 60,08 мм"


def test_a_verdict_shows_both_sides_and_the_answer(plan: Plan) -> None:
    # Guide, section 5, with the length of the pin corrected: 24.4 MPa.
    inputs = {"bearing_stress": 24.375, "bearing_stress_allowed": 80.0}
    written = line(plan, "bearing_ok", inputs, 1.0, Words("en"))
    assert written == "σ_br = 24.375 MPa ≤ [σ]_br = 80 MPa: yes"
    assert line(plan, "bearing_ok", inputs, 0.0, Words("en")).endswith(": no")


def test_a_value_from_a_table_names_the_size_it_was_read_at(plan: Plan) -> None:
    written = line(plan, "flange_bolt_circle", {"flange_size": 90.0}, 110.0)
    assert written == "D_1(d_ф) = D_1(90 мм) = 110 мм"


def test_an_empirical_formula_has_bare_numbers_in_its_own_units(plan: Plan) -> None:
    formula = plan.quantities["module_required"].formula
    assert formula is not None
    assert formula.units["gear_torque"] == "N*m"
    inputs = dict.fromkeys(plan.inputs["module_required"], 2.0) | {"gear_torque": 585.0}
    numbers = line(plan, "module_required", inputs, 5.1057).split(" = ")[-2]
    assert "585" in numbers
    assert "Н·м" not in numbers
    assert ("T", "Н·м") in entering_units(plan.quantities["module_required"], plan, RUSSIAN)


def test_other_formulas_need_no_note_on_units(plan: Plan) -> None:
    assert entering_units(plan.quantities["bore_required"], plan, RUSSIAN) == ()


def test_what_is_not_computed_has_no_line(plan: Plan) -> None:
    assert worked_line(plan.quantities["mass"], {}, 60.0, plan, RUSSIAN) is None


@pytest.mark.parametrize("language", ["en", "ru", "uk"])
def test_every_answer_can_be_worked_in_every_language(
    plan: Plan, values: dict[str, float], language: str
) -> None:
    for quantity in plan.answered:
        inputs = {name: values[name] for name in plan.inputs[quantity.id]}
        assert line(plan, quantity.id, inputs, values[quantity.id], Words(language))


def reading(plan: Plan, quantity: str, formula: str, inputs: dict[str, float]) -> str:
    """Print a quantity that has another formula, which reads tables."""
    declared = plan.quantities[quantity]
    changed = replace(declared, formula=Formula(formula, parse(formula), {}))
    quantities = {**plan.quantities, quantity: changed}
    box = worked_line(changed, inputs, None, replace(plan, quantities=quantities), Words("en"))
    assert box is not None
    return text(box).replace("\u00a0", " ")


def test_a_value_between_rows_has_the_symbol_of_what_is_read(plan: Plan) -> None:
    formula = 'interpolate("flange.bolt_circle", flange_size/2)'
    written = reading(plan, "flange_bolt_circle", formula, {"flange_size": 90.0})
    assert written == "D_1(d_f/2) = D_1((90 mm)/2)"


def test_a_value_read_inside_a_formula_has_not_the_symbol_of_the_result(plan: Plan) -> None:
    """It has the symbol of the quantity that is read there, else the name of the column."""
    formula = '2*lookup("flange.bolt_circle", flange_size) + lookup("flange.bolt_count", 9)'
    written = reading(plan, "pin_length", formula, {})
    assert written == "l_p = 2 · D_1(d_f) + bolt_count(9)"


def test_a_table_is_entered_with_an_angle_as_it_is_declared(plan: Plan) -> None:
    formula = 'interpolate("flange.bolt_circle", arm_angle_open)'
    written = reading(plan, "flange_bolt_circle", formula, {"arm_angle_open": 36.5})
    assert written.endswith("(36.5°)")
