"""Naming a slip: at the precision that was typed, weighed against chance, two where they tie."""

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
import pytest

from gripcourse.formula.parse import parse
from gripcourse.formula.tree import Formula
from gripcourse.grading.model import Against, Finding, Outcome
from gripcourse.submission.model import Answer
from gripcourse.text.words import LANGUAGES, Texts

if TYPE_CHECKING:
    from collections.abc import Callable

    from conftest import Case

    Typed = Callable[[str, float, int], Answer]


@pytest.fixture
def answer(read_answer: "Callable[..., Answer]") -> "Callable[..., Answer]":
    """An answer as it is read from a cell."""
    return read_answer


def finding(case: "Case", name: str, answer: Answer) -> Finding:
    """Judge one wrong answer among right ones."""
    return case.findings({**case.answers, name: answer})[name]


def said(text: str) -> Texts:
    """Make a hint that reads the same in each language."""
    return Texts(dict.fromkeys(LANGUAGES, text))


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("times", [1e-30, 1e30, -1e30])
def test_no_wrong_number_is_so_far_off_that_nothing_can_be_weighed(
    hydraulic: "Case", typed: "Typed", times: float
) -> None:
    """The least of a spreadsheet's digits where 0 was meant, and what is divided by it."""
    off = {
        name: typed(name, by * hydraulic.reference[name], 5)
        for name, by in (("lifting_load", times), ("grip_force", 7 * times))
    }
    found = hydraulic.findings({**hydraulic.answers, **off})
    assert found["lifting_load"].outcome is Outcome.WRONG
    assert found["grip_force"].outcome is Outcome.WRONG


@pytest.mark.parametrize("gravity", [9.80665, 9.81])
def test_a_force_in_kilograms_is_named_by_whichever_gravity_it_was_divided(
    hydraulic: "Case", typed: "Typed", gravity: float
) -> None:
    force = hydraulic.reference["drive_force"] / gravity
    found = finding(hydraulic, "drive_force", typed("drive_force", force, 6))
    assert str(found.slip) == "unit:kgf"
    assert found.tied == ()


class TestTypedPrecision:
    def test_a_slip_is_matched_at_the_precision_that_was_typed(
        self, hydraulic: "Case", typed: "Typed"
    ) -> None:
        slip = 2 * hydraulic.reference["grip_force"]
        near = slip * 1.004  # inside the band of the grade, far outside the last digit
        assert finding(hydraulic, "grip_force", typed("grip_force", slip, 5)).slip
        assert not finding(hydraulic, "grip_force", typed("grip_force", near, 5)).slip

    def test_cutting_digits_off_is_typing_too(self, hydraulic: "Case", typed: "Typed") -> None:
        slip = 2 * hydraulic.reference["grip_force"]
        cut = float(np.floor(slip / 10) * 10)
        assert cut != slip
        assert finding(hydraulic, "grip_force", typed("grip_force", cut, 3)).slip
        beyond = float(np.ceil(slip / 10) * 10)  # nobody comes to more by cutting off
        assert beyond - slip > 5  # half a unit of the last digit
        assert not finding(hydraulic, "grip_force", typed("grip_force", beyond, 3)).slip

    def test_the_rounding_of_earlier_answers_widens_the_match(
        self, hydraulic: "Case", typed: "Typed"
    ) -> None:
        """The slip was computed from the load in the calculator, the load typed with 3 figures."""
        load = hydraulic.reference["lifting_load"]
        slip = 2 * hydraulic.reference["grip_force"]
        answers = {
            **hydraulic.answers,
            "lifting_load": typed("lifting_load", load, 3),
            "grip_force": typed("grip_force", slip, 5),
        }
        assert str(hydraulic.findings(answers)["grip_force"].slip) == "one_jaw_only"

    def test_zeros_that_a_cell_has_lost_do_not_hide_a_slip(
        self, hydraulic: "Case", answer: "Callable[..., Answer]"
    ) -> None:
        """The cell shows 102, the student computed 102.00: module times teeth, not half of it."""
        whole = 2 * hydraulic.reference["pitch_radius"]
        assert whole == int(whole)
        shown = replace(answer("pitch_radius", whole), half_unit=0.5)
        assert str(finding(hydraulic, "pitch_radius", shown).slip) == "diameter_for_radius"

    def test_a_large_number_rounded_to_three_figures_is_named(
        self, hydraulic: "Case", answer: "Callable[..., Answer]"
    ) -> None:
        """The cell shows 22700, the student computed 22650.6: five digits, three count."""
        slip = 2 * hydraulic.reference["tooth_force"]
        rounded = float(f"{slip:.2e}")
        assert abs(rounded - slip) > 0.5
        shown = replace(answer("tooth_force", rounded), half_unit=0.5, figures=3)
        assert finding(hydraulic, "tooth_force", shown).slip
        as_typed = replace(shown, figures=5)
        assert not finding(hydraulic, "tooth_force", as_typed).slip

    def test_a_zero_is_explained_by_nothing(
        self, hydraulic: "Case", answer: "Callable[..., Answer]"
    ) -> None:
        found = finding(hydraulic, "drive_force", answer("drive_force", 0.0))
        assert (found.outcome, found.slip) == (Outcome.WRONG, None)


class TestCertainty:
    def test_few_wrong_numbers_are_taken_for_a_slip_by_chance(
        self, table: "tuple[Case, ...]", typed: "Typed"
    ) -> None:
        """At the band of the grade one in seven would be; at the last digit hardly any is."""
        random = np.random.default_rng(20260907)
        names = ("drive_force", "grip_force", "pin_diameter_required", "lever_bending_moment")
        named = total = 0
        for case in table[:24]:
            for name in names:
                if name not in case.answers:
                    continue
                wrong = case.reference[name] * float(np.exp(random.normal()))
                found = finding(case, name, typed(name, wrong, 4))
                named += found.outcome is Outcome.SLIP
                total += 1
        assert total > 40
        assert named <= 0.03 * total

    def test_an_entry_of_a_table_that_is_read_between_its_rows_is_met_by_chance(
        self, v_belt: "Case", typed: "Typed"
    ) -> None:
        """Written in hundredths, every fourth number above 1 is one: further digits tell."""
        name = "length_factor"
        entries = [float(one) for one in v_belt.plan.columns["v_length_factor.factor"].values]
        others = [one for one in entries[:-1] if one > 1.05 * v_belt.reference[name]]
        assert len(others) > 1
        for figures, outcome in ((3, Outcome.WRONG), (5, Outcome.SLIP)):
            for wrong in others:
                assert finding(v_belt, name, typed(name, wrong, figures)).outcome is outcome

    def test_two_methods_that_no_number_tells_apart_are_both_named(
        self, hydraulic: "Case", typed: "Typed"
    ) -> None:
        quantity = hydraulic.plan.quantities["grip_force"]
        text = "2*(dynamic_factor*lifting_load/(2*friction))"
        formula, own = Formula(text, parse(text), {}), quantity.slips[0]
        slip = 2 * hydraulic.reference["grip_force"]
        for hint, sentences in ((said("Another."), 2), (own.hint, 1)):  # nothing is said twice
            twin = replace(own, id="twin", formula=formula, hint=hint)
            changed = replace(quantity, slips=(*quantity.slips, twin))
            quantities = {**hydraulic.plan.quantities, "grip_force": changed}
            case = replace(hydraulic, plan=replace(hydraulic.plan, quantities=quantities))
            found = finding(case, "grip_force", typed("grip_force", slip, 5))
            assert {str(one) for one in (found.slip, *found.tied)} == {"one_jaw_only", "twin"}
            assert str(found.message).count("Or:") == sentences - 1

    def test_of_methods_that_a_number_does_not_tell_apart_all_are_named_that_it_takes(
        self, hydraulic: "Case", typed: "Typed"
    ) -> None:
        """Each of three would be certain without the others, and together they are."""
        quantity = hydraulic.plan.quantities["grip_force"]
        right = quantity.formula
        assert right is not None
        texts = {
            name: f"{by}*({right.text})" for name, by in (("a", 3), ("b", 3.0001), ("c", 2.9999))
        }
        alike = tuple(
            replace(
                quantity.slips[0],
                id=name,
                formula=Formula(text, parse(text), {}),
                hint=said(f"Method {name}."),
            )
            for name, text in texts.items()
        )
        for count, named in ((1, 1), (2, 2), (3, 3)):
            changed = replace(quantity, slips=alike[:count])
            quantities = {**hydraulic.plan.quantities, "grip_force": changed}
            case = replace(hydraulic, plan=replace(hydraulic.plan, quantities=quantities))
            wrong = typed("grip_force", 3 * hydraulic.reference["grip_force"], 3)
            found = finding(case, "grip_force", wrong)
            assert len({found.slip, *found.tied}) == named
            assert str(found.message).count("Or:") == named - 1

    def test_a_unit_that_comes_of_an_input_in_another_one_is_named_with_the_input(
        self, hydraulic: "Case", typed: "Typed"
    ) -> None:
        """N·m over MPa is cm³: a torque in N·m gives the module in cm, which nobody thought of."""
        module = typed("module_required", 0.1 * hydraulic.reference["module_required"], 4)
        finding = hydraulic.findings({**hydraulic.answers, "module_required": module})[
            "module_required"
        ]
        assert str(finding.slip) == "unit:cm"
        assert [str(one) for one in finding.tied] == ["input_unit:gear_torque,0.001"]

    def test_a_unit_that_is_plainly_another_one_is_named_alone(
        self, hydraulic: "Case", typed: "Typed"
    ) -> None:
        torque = typed("gear_torque", 1000 * hydraulic.reference["gear_torque"], 4)
        finding = hydraulic.findings({**hydraulic.answers, "gear_torque": torque})["gear_torque"]
        assert (str(finding.slip), finding.tied) == ("unit:N*mm", ())

    def test_a_hint_names_a_quantity_without_the_rule_behind_its_colon(
        self, table: "tuple[Case, ...]"
    ) -> None:
        case = next(one for one in table if one.plan.scheme.id == "electromagnet")
        core = case.plan.quantities["core_diameter"].title.of("en")
        area = 4 * case.reference["pole_area"]
        said = str(case.findings({**case.answers, "pole_area": area})["pole_area"].message)
        assert ": " in core
        assert core not in said
        assert core.partition(": ")[0] in said

    def test_a_coarse_number_decides_nothing(
        self, hydraulic: "Case", answer: "Callable[..., Answer]"
    ) -> None:
        slip = 2 * hydraulic.reference["grip_force"]
        coarse = replace(answer("grip_force", float(round(slip, -3))), half_unit=500.0)
        assert finding(hydraulic, "grip_force", coarse).outcome is Outcome.WRONG

    def test_a_shortened_pi_does_not_hide_a_slip(self, hydraulic: "Case", typed: "Typed") -> None:
        """A diameter taken for a radius, with 3.14."""
        slip = hydraulic.reference["bore_required"] / 2 * (np.pi / 3.14) ** 0.5
        found = finding(hydraulic, "bore_required", typed("bore_required", float(slip), 6))
        assert found.outcome is Outcome.SLIP

    def test_what_was_computed_on_from_a_slip_makes_it_more_certain(
        self, hydraulic: "Case", typed: "Typed"
    ) -> None:
        """Three figures were typed, but the next answer shows the digits of the calculator."""
        wrong = hydraulic.reference["lifting_load"] * 1.62
        slip = hydraulic.given["dynamic_factor"] * wrong / hydraulic.given["friction"]
        later = hydraulic.following(lifting_load=wrong, grip_force=slip)
        answers = {
            name: typed(name, value, 6) if name in {"drive_force", "gear_torque"} else value
            for name, value in later.items()
        }
        answers |= {"lifting_load": wrong, "grip_force": typed("grip_force", slip, 3)}
        assert str(hydraulic.findings(answers)["grip_force"].slip) == "one_jaw_only"


class TestLeftOutSteps:
    def test_a_slip_in_a_blank_step_shows_in_the_next_answer_and_costs_once(
        self, hydraulic: "Case", typed: "Typed"
    ) -> None:
        slip = 2 * hydraulic.reference["grip_force"]
        later = hydraulic.following(grip_force=slip)
        answers = {
            **later,
            "grip_force": None,
            "drive_force": typed("drive_force", later["drive_force"], 5),
        }
        found = hydraulic.findings(answers)["drive_force"]
        assert found.outcome is Outcome.CARRIED
        assert (str(found.slip), found.roots) == ("one_jaw_only", ("grip_force",))
        assert found.points == pytest.approx(found.max_points)

    def test_a_sound_size_that_was_not_written_down_may_be_used(self, hydraulic: "Case") -> None:
        sizes = hydraulic.plan.columns["flange.bolt_circle"].sizes * 1000
        size = float(sizes[np.searchsorted(sizes, hydraulic.reference["flange_size"]) + 1])
        later = hydraulic.following(flange_size=size)
        findings = hydraulic.findings({**later, "flange_size": None})
        assert findings["flange_size"].outcome is Outcome.BLANK
        assert findings["flange_bolt_circle"].outcome is Outcome.CARRIED
        assert findings["flange_bolt_circle"].against is Against.OWN_INPUTS
