"""Design decisions: a set of sound entries, by the reference or by the student's own numbers."""

import math
from dataclasses import replace
from typing import TYPE_CHECKING

import pytest

from gripcourse.course.quantity import Kind, Rounding
from gripcourse.grading.model import Against, Finding, Outcome
from gripcourse.solver.solve import solve_variant
from gripcourse.text.units import factor

if TYPE_CHECKING:
    from conftest import Case
    from gripcourse.variants.model import Issued

# The guide's example with g = 9.81 m/s² needs a bore of 59.7 mm, a module of 5.08 mm and a pin of
# 10.1 mm; the series are those of GOST 6540-68, GOST 9563-60 and GOST 9650-80.
SOUND_BORES = [63.0, 80.0, 100.0]
SOUND_SECOND_ROW = [70.0, 90.0]


def finding(case: "Case", quantity: str, value: float) -> Finding:
    return case.findings({**case.answers, quantity: value})[quantity]


def series(case: "Case", quantity: str) -> list[float]:
    """The preferred entries of a choice, in its declared unit."""
    declared = case.plan.quantities[quantity]
    assert declared.choice is not None
    sizes = case.plan.columns[declared.choice.column].sizes / factor(declared.unit)
    return [float(f"{size:.12g}") for size in sizes]


class TestSoundSet:
    @pytest.mark.parametrize("bore", [*SOUND_BORES, *SOUND_SECOND_ROW])
    def test_entries_up_to_two_steps_above_are_sound_in_both_rows(
        self, hydraulic: "Case", bore: float
    ) -> None:
        found = finding(hydraulic, "bore", bore)
        assert (found.outcome, found.points) == (Outcome.CORRECT, found.max_points)

    def test_each_choice_takes_exactly_its_steps(self, case: "Case") -> None:
        """Of the preferred row: the reference, and as many entries above it as the rule says."""
        for quantity in (one for one in case.plan.answered if one.kind is Kind.CHOICE):
            rule = quantity.choice
            assert rule is not None
            if rule.steps is None:
                continue
            sizes = series(case, quantity.id)
            first = sizes.index(pytest.approx(case.reference[quantity.id]))
            last = first + rule.steps
            near = sizes[max(first - 2, 0) : last + 3]
            found = {size: finding(case, quantity.id, size).against for size in near}
            sound = [size for size in near if found[size] is Against.REFERENCE]
            assert sound == sizes[first : last + 1], quantity.id

    def test_the_largest_size_is_no_new_fault_where_a_mistake_asks_for_more(
        self, hydraulic: "Case"
    ) -> None:
        """A stroke of R·θ in degrees: 57 times too long for any cylinder."""
        wrong = {"stroke_required": 57.3 * hydraulic.reference["stroke_required"]}
        sizes = series(hydraulic, "stroke")
        assert wrong["stroke_required"] > sizes[-1]
        largest = hydraulic.findings({**hydraulic.answers, **wrong, "stroke": sizes[-1]})["stroke"]
        assert (largest.outcome, largest.against) == (Outcome.CARRIED, Against.OWN_INPUTS)
        assert "No size is large enough" in str(largest.message)
        other = hydraulic.findings({**hydraulic.answers, **wrong, "stroke": sizes[-2]})["stroke"]
        assert other.outcome is Outcome.WRONG

    def test_a_condition_bounds_the_set_instead_of_steps(self, hydraulic: "Case") -> None:
        """A rod from 0.3 to 0.7 of the bore of 63 mm: from 18.9 to 44.1 mm."""
        sound = [
            rod
            for rod in series(hydraulic, "rod")
            if finding(hydraulic, "rod", rod).outcome is Outcome.CORRECT
        ]
        assert sound == [20, 22, 25, 28, 32, 36, 40]

    def test_an_entry_typed_with_a_rounding_error_is_that_entry(self, hydraulic: "Case") -> None:
        assert finding(hydraulic, "bore", 63 * (1 + 1e-12)).outcome is Outcome.CORRECT


class TestUnsound:
    @pytest.mark.parametrize(
        ("bore", "said"),
        [
            (50.0, "The size is below the required value."),
            (56.0, "The size is below the required value."),
            (125.0, "Wastefully large: more than 2 steps above the smallest size that fits."),
            (65.0, "This size is not in the series."),
        ],
    )
    def test_what_is_wrong_is_named(self, hydraulic: "Case", bore: float, said: str) -> None:
        found = finding(hydraulic, "bore", bore)
        assert (found.outcome, found.points) == (Outcome.WRONG, 0)
        assert str(found.message) == said

    def test_a_rod_too_thick_for_the_bore_breaks_the_condition(self, hydraulic: "Case") -> None:
        found = finding(hydraulic, "rod", 45.0)
        assert str(found.message) == "The size does not satisfy the condition of the rule."

    def test_a_smaller_entry_costs_the_decision_only(self, case: "Case") -> None:
        entries = series(case, "bore")
        smaller = entries[entries.index(pytest.approx(case.reference["bore"])) - 1]
        lost = case.lost(case.following(bore=smaller))
        assert lost == {"bore"}


class TestRequiredValueCutOff:
    """What is required with the reserve is no answer: 125.6 mm may be cut off to 125 on the way."""

    @pytest.mark.parametrize(
        ("required", "outcome"), [(125.6, Outcome.CARRIED), (126.4, Outcome.WRONG)]
    )
    def test_a_size_may_follow_from_it(
        self, table: "tuple[Case, ...]", required: float, outcome: Outcome
    ) -> None:
        case = next(
            one
            for one in table
            if "bore_required" in one.plan.inputs.get("bore", ()) and "drive_reserve" in one.given
        )
        own = required / math.sqrt(case.given["drive_reserve"])
        findings = case.findings({**case.following(bore_required=own), "bore": 125.0})
        assert findings["bore"].outcome is outcome


class TestWrongRule:
    """140 kg bend the flange by nearly 1200 N·m: I bears 1300 at 90 mm, II 1100 at 120 mm."""

    def test_the_loads_of_the_other_execution_are_a_known_slip(self, square: "Case") -> None:
        found = finding(square, "flange_first", 90.0)
        assert (found.outcome, found.points) == (Outcome.SLIP, 0)
        assert str(found.slip) == "loads_of_the_round_flange"
        assert "version I" in str(found.message)

    def test_another_size_is_only_too_small(self, square: "Case") -> None:
        found = finding(square, "flange_first", 120.0)
        assert found.outcome is Outcome.WRONG
        assert str(found.message) == "The size is below the required value."

    def test_where_both_executions_bear_the_same_there_is_no_slip(self, square: "Case") -> None:
        found = square.findings({**square.following(mount_bending=399.0), "flange_first": 40.0})
        assert found["flange_first"].outcome is Outcome.WRONG


def by_row(case: "Case") -> dict[str, float]:
    """What the row of the bore decides, as in the reference."""
    return {name: case.reference[name] for name in ("rod", "stroke")}


class TestOwnNumbers:
    def test_the_students_own_required_value_counts(self, hydraulic: "Case") -> None:
        answers = {**hydraulic.answers, "bore_required": 130.0, "bore": 160.0}
        found = hydraulic.findings(answers)["bore"]
        assert (found.outcome, found.against) == (Outcome.CARRIED, Against.OWN_INPUTS)
        assert found.points == found.max_points

    def test_a_decision_is_used_downstream(self, hydraulic: "Case") -> None:
        findings = hydraulic.findings(hydraulic.following(bore=80))
        assert findings["bore"].outcome is Outcome.CORRECT
        assert findings["piston_area"].outcome is Outcome.CARRIED
        assert findings["piston_area"].inputs["bore"] == 80

    def test_a_sound_decision_other_than_the_reference_costs_nothing(
        self, hydraulic: "Case"
    ) -> None:
        for bore in (*SOUND_BORES, *SOUND_SECOND_ROW):
            assert hydraulic.lost(hydraulic.following(bore=bore)) == set()

    def test_a_bore_of_no_catalogue_does_not_lose_what_follows(self, pneumatic: "Case") -> None:
        """No row pairs such a bore with a rod or a stroke: those of the reference stand in."""
        answers = pneumatic.following(bore=77.0, **by_row(pneumatic))
        findings = pneumatic.findings(answers)
        assert str(findings["bore"].message) == "This size is not in the series."
        assert pneumatic.lost(answers) == {"bore"}
        assert findings["drive_force_actual"].outcome is Outcome.CARRIED

    def test_with_such_a_bore_a_blank_rod_is_blank_and_nothing_else_is_lost(
        self, pneumatic: "Case"
    ) -> None:
        answers = pneumatic.following(bore=77.0, **by_row(pneumatic))
        assert pneumatic.lost({**answers, "rod": None}) == {"bore", "rod"}


class TestPrintedRounding:
    def test_a_size_rounded_as_the_guide_does_is_accepted_with_a_remark(
        self, hydraulic: "Case"
    ) -> None:
        """The guide takes a pin of 10 mm for a required 10.17 (erratum E13)."""
        found = finding(hydraulic, "pin_diameter_first", 10.0)
        assert (found.outcome, found.against) == (Outcome.CORRECT, Against.PRINTED)
        assert any("E13" in str(remark) for remark in found.remarks)

    def test_a_policy_may_refuse_it(self, hydraulic: "Case") -> None:
        found = finding(hydraulic.with_policy(printed_credit=None), "pin_diameter_first", 10.0)
        assert (found.outcome, found.points) == (Outcome.WRONG, 0)
        assert str(found.message) == "The size is below the required value."


class TestNearest:
    """The guide's bore of 59.7 mm between 50 and 63 mm, taken to the nearest size."""

    @pytest.fixture
    def nearest(self, hydraulic: "Case") -> "Case":
        return rounding_to_nearest(hydraulic, None)

    def test_the_nearest_size_is_sound_and_no_other(self, nearest: "Case") -> None:
        found = {size: finding(nearest, "bore_first", size) for size in (50.0, 63.0, 80.0)}
        assert {size: one.outcome for size, one in found.items()} == {
            50.0: Outcome.WRONG,
            63.0: Outcome.CORRECT,
            80.0: Outcome.WRONG,
        }
        assert "another one is nearer" in str(found[50.0].message)
        assert "another one is nearer" in str(found[80.0].message)

    def test_a_size_below_what_is_required_may_be_the_nearest(self, nearest: "Case") -> None:
        """A mass of 39 kg needs about 52.7 mm: 50 mm is nearest, 63 mm too large."""
        given = {**nearest.given, "mass": 39.0}
        light = replace(nearest, issued=issued_with(nearest, given),
                        reference=solve_variant(nearest.plan, given))  # fmt: skip
        assert light.reference["bore_required"] == pytest.approx(52.7, abs=0.2)
        assert light.reference["bore_first"] == pytest.approx(50)
        assert finding(light, "bore_first", 50.0).outcome is Outcome.CORRECT
        assert finding(light, "bore_first", 63.0).outcome is Outcome.WRONG

    def test_so_many_steps_are_sound_on_either_side(self, hydraulic: "Case") -> None:
        case = rounding_to_nearest(hydraulic, 1)
        sizes = series(case, "bore_first")
        place = sizes.index(63.0)
        found = [finding(case, "bore_first", size) for size in sizes[place - 2 : place + 3]]
        right, wrong = Outcome.CORRECT, Outcome.WRONG
        assert [one.outcome for one in found] == [wrong, right, right, right, wrong]
        assert "more than 1 step from the nearest size" in str(found[0].message)

    def test_a_second_row_is_sound_where_it_is_as_near(self, nearest: "Case") -> None:
        """70 mm of the second row is farther from 59.7 mm than 63 mm."""
        assert finding(nearest, "bore_first", 70.0).outcome is Outcome.WRONG

    def test_the_students_own_required_value_counts_too(self, nearest: "Case") -> None:
        answers = {**nearest.answers, "bore_required": 82.0, "bore_first": 80.0}
        found = nearest.findings(answers)["bore_first"]
        assert found.outcome is Outcome.CARRIED


def rounding_to_nearest(case: "Case", steps: int | None) -> "Case":
    """The case in a course that rounds the bore to the nearest size."""
    bore_first = case.plan.quantities["bore_first"]
    assert bore_first.choice is not None
    rule = replace(bore_first.choice, rounding=Rounding.NEAREST, steps=steps)
    changed = {**case.plan.quantities, "bore_first": replace(bore_first, choice=rule)}
    answered = tuple(changed[one.id] for one in case.plan.answered)
    plan = replace(case.plan, quantities=changed, answered=answered)
    return replace(case, plan=plan, reference=solve_variant(plan, case.given))


def issued_with(case: "Case", given: dict[str, float]) -> "Issued":
    return replace(case.issued, variant=replace(case.issued.variant, given=given))
