"""What a student may have computed instead: from the tree of any formula, and as declared."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import TypeAlias

import numpy as np
import pytest

from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind
from gripcourse.formula.evaluate import evaluate
from gripcourse.formula.parse import parse
from gripcourse.formula.tree import Formula
from gripcourse.policy.model import Policy
from gripcourse.policy.slips import SlipKind
from gripcourse.slips.candidates import candidates_of
from gripcourse.slips.generic import GENERATORS
from gripcourse.slips.model import DECLARED, Candidate, SlipId
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.text.words import LANGUAGES
from gripcourse.variants.space import load_spaces

Slips: TypeAlias = Callable[..., dict[str, Candidate]]
SCHEME = "rack_parallelogram"


@pytest.fixture(scope="session")
def slips_of(plan: Plan, policy: Policy) -> Slips:
    """Candidates of a quantity of the plan whose formula is replaced, by id."""

    def slips(formula: str, quantity: str = "drive_force") -> dict[str, Candidate]:
        declared = replace(
            plan.quantities[quantity],
            formula=Formula(formula, parse(formula), {}),
            slips=(),
            as_printed=(),
        )
        changed = replace(plan, quantities={**plan.quantities, quantity: declared})
        return {one.id: one for one in candidates_of(changed, quantity, policy.slips)}

    return slips


def value(candidate: Candidate, **values: float) -> float:
    known = {name: np.asarray(one) for name, one in values.items()}
    return float(evaluate(candidate.formula, "", known, {}))


class TestGenericSlips:
    @pytest.mark.parametrize(
        ("formula", "slip", "values", "wrong"),
        [
            ("grip_force*force_ratio", "power_of_ten:10", {"grip_force": 3, "force_ratio": 2}, 60),
            ("grip_force*force_ratio", "unit:kN", {"grip_force": 3, "force_ratio": 2}, 0.006),
            ("grip_force*force_ratio", "factor_left_out:11", {"grip_force": 3}, 3),
            (
                "grip_force/sin(arm_angle_open)",
                "factor_left_out:11",
                {"grip_force": 3},
                3,
            ),
            (
                "grip_force*max(cos(arm_angle_open), cos(arm_angle_at_min))**2",
                "factor_left_out:11",
                {"grip_force": 3},
                3,
            ),
            (
                "grip_force/mechanism_efficiency",
                "multiplied_for_divided:mechanism_efficiency",
                {"grip_force": 3, "mechanism_efficiency": 0.5},
                1.5,
            ),
            ("4*grip_force", "number_left_out:0", {"grip_force": 3}, 3),
            ("grip_force/pi", "number_left_out:11", {"grip_force": 3}, 3),
            ("sqrt(grip_force)", "power:0", {"grip_force": 9}, 9),
            ("grip_force**2", "power:0", {"grip_force": 9}, 9),
            (
                "hypot(grip_force, tooth_force)",
                "power:0",
                {"grip_force": 3, "tooth_force": 4},
                7,
            ),
            (
                "grip_force + tooth_force",
                "term_left_out:13",
                {"grip_force": 3},
                3,
            ),
            ("grip_force - tooth_force", "sign:0", {"grip_force": 3, "tooth_force": 4}, 7),
            (
                "max(grip_force, tooth_force)",
                "minimum_for_maximum:0",
                {"grip_force": 3, "tooth_force": 4},
                3,
            ),
            (
                "grip_force/tooth_force",
                "swapped:grip_force,tooth_force",
                {"grip_force": 3, "tooth_force": 4},
                4 / 3,
            ),
            (
                "grip_force*sin(arm_angle_open)",
                "wrong_function:11,cos",
                {"grip_force": 3, "arm_angle_open": 0.5},
                3 * np.cos(0.5),
            ),
            (
                "grip_force*sin(arm_angle_open)",
                "angle_unit:all",
                {"grip_force": 3, "arm_angle_open": 0.5},
                3 * np.sin(np.degrees(0.5)),
            ),
            (
                "grip_force*diameter_max",
                "radius_for_diameter:diameter_max,0.5",
                {"grip_force": 3, "diameter_max": 0.2},
                0.3,
            ),
            (
                "diameter_max*diameter_max + diameter_max",
                "radius_for_diameter:diameter_max,0.5,13",
                {"diameter_max": 0.2},
                0.22,
            ),
            (
                "grip_force*(diameter_max + diameter_min)",
                "radius_for_diameter:all,0.5",
                {"grip_force": 3, "diameter_max": 0.2, "diameter_min": 0.1},
                0.45,
            ),
            (
                "pitch_radius*asin(friction)",
                "angle_unit:outside",
                {"pitch_radius": 2, "friction": 0.5},
                60,
            ),
            (
                "grip_force*diameter_max",
                "wrong_end:diameter_max",
                {"grip_force": 3, "diameter_min": 0.1},
                0.3,
            ),
            (
                "grip_force*diameter_max - diameter_max",
                "wrong_end:diameter_max,diameter_min,26",
                {"grip_force": 3, "diameter_max": 0.2, "diameter_min": 0.1},
                0.5,
            ),
            (
                "grip_force*force_ratio",
                "wrong_end:force_ratio,force_ratio_at_min",
                {"grip_force": 3, "force_ratio_at_min": 0.5},
                1.5,
            ),
            (
                "friction/mass",
                "multiplied_for_divided:friction",
                {"friction": 0.5, "mass": 4},
                0.5,
            ),
            ("mass*gravity", "gravity_left_out:5", {"mass": 12}, 12),
            ("mass*(gravity + acceleration)", "mass_for_weight:mass,0", {"mass": 12}, 12),
            (
                "dynamic_factor*lifting_load/friction",
                "mass_for_weight:mass,15",
                {"mass": 12, "dynamic_factor": 1.5, "friction": 0.5},
                36,
            ),
            (
                "pi*bore**2/4",
                "ring_for_circle:bore,3",
                {"bore": 4, "rod": 2},
                3 * np.pi,
            ),
            (
                "dynamic_factor*mass",
                "counted_twice:dynamic_factor",
                {"dynamic_factor": 1.5, "mass": 4},
                9,
            ),
            (
                "grip_force*(friction + mechanism_efficiency)",
                "brackets:11",
                {"grip_force": 3, "friction": 0.5, "mechanism_efficiency": 0.8},
                2.3,
            ),
            (
                "grip_force/(friction*mechanism_efficiency*force_ratio)",
                "brackets:11",
                {"grip_force": 3, "friction": 0.5, "mechanism_efficiency": 0.8, "force_ratio": 2},
                9.6,
            ),
            ("atan(friction)", "ratio_for_angle:0", {"friction": 0.5}, 0.5),
            ("atan(friction)", "ratio_for_angle:0,deg", {"friction": 0.5}, np.radians(0.5)),
            (
                "atan2(friction, mechanism_efficiency)",
                "ratio_for_angle:0",
                {"friction": 0.4, "mechanism_efficiency": 0.8},
                0.5,
            ),
            (
                "grip_force*(friction*mechanism_efficiency)",
                "added_for_multiplied:21",
                {"grip_force": 3, "friction": 0.5, "mechanism_efficiency": 0.8},
                3.9,
            ),
            ("friction**3", "power:0,2", {"friction": 0.5}, 0.25),
            ("cbrt(grip_force)", "power:0,body", {"grip_force": 8}, 8),
            ("sqrt(grip_force)", "power:0,cbrt", {"grip_force": 8}, 2),
            ("1.4**3*grip_force", "number_left_out:0", {"grip_force": 8}, 8),
            (
                "grip_force*arm_length",
                "counted_twice:dynamic_factor,grip_force",
                {"dynamic_factor": 1.5, "grip_force": 4, "arm_length": 2},
                12,
            ),
            (
                "pitch_radius*arm_angle_open",
                "angle_unit:outside",
                {"pitch_radius": 2, "arm_angle_open": 0.5},
                2 * np.degrees(0.5),
            ),
            (
                "mass*(gravity + acceleration)",
                "gravity_left_out:6",
                {"mass": 2, "acceleration": 3},
                6,
            ),
            ("dynamic_factor*mass", "safety_left_out:0", {"mass": 2}, 2),
            (
                "mass/(acceleration*friction)",
                "multiplied_for_divided:brackets0",
                {"mass": 12, "acceleration": 2, "friction": 0.5},
                3,
            ),
            (
                "mass*diameter_max",
                "input_unit:diameter_max,1000",
                {"mass": 2, "diameter_max": 0.2},
                400,
            ),
            (
                "mass*diameter_max + diameter_max",
                "input_unit:diameter_max,1000,20",
                {"mass": 2, "diameter_max": 0.2},
                200.4,
            ),
        ],
    )
    def test_each_kind_makes_its_mistake(
        self,
        slips_of: Slips,
        formula: str,
        slip: str,
        values: Mapping[str, float],
        wrong: float,
    ) -> None:
        found = slips_of(formula)
        assert SlipId.parse(slip) in found, sorted(found)
        assert value(found[SlipId.parse(slip)], **values) == pytest.approx(wrong)

    @pytest.mark.parametrize(
        ("slip", "wrong"),
        [("angle_unit:given", 180 - 2 * np.arcsin(0.5)), ("ratio_for_angle:7,deg", 179)],
    )
    def test_an_angle_that_comes_out_in_radians_is_taken_for_degrees(
        self, slips_of: Slips, slip: str, wrong: float
    ) -> None:
        """180° less twice 30°, on a calculator in radians: 180 − 2·0.5236."""
        found = slips_of("pi - 2*asin(friction)", "arm_angle_open")[SlipId.parse(slip)]
        assert np.degrees(value(found, friction=0.5)) == pytest.approx(wrong)

    def test_a_calculator_in_radians_takes_and_gives_them(self, slips_of: Slips) -> None:
        """The tangent of 20 is taken for that of 20°, and its angle read as degrees."""
        found = slips_of("atan(2*tan(arm_angle_open))", "arm_angle_at_min")
        wrong = value(found[SlipId.parse("angle_unit:mode")], arm_angle_open=np.radians(20))
        assert np.degrees(wrong) == pytest.approx(np.arctan(2 * np.tan(20)))

    def test_a_table_may_be_read_in_another_row(self, plan: Plan, policy: Policy) -> None:
        found = candidates_of(plan, "flange_bolt_circle", policy.slips)
        rows = [one for one in found if one.kind == SlipKind.OTHER_ROW]
        assert len(rows) == plan.columns["flange.bolt_circle"].sizes.size
        values = {name: np.asarray(1.0) for name in plan.quantities}
        read = {float(evaluate(one.formula, "mm", values, plan.columns)) for one in rows}
        assert read == set(plan.columns["flange.bolt_circle"].values.tolist())

    def test_rows_with_one_entry_are_one_way_to_read_wrongly(
        self, course: Course, policy: Policy
    ) -> None:
        """A bore of 80 mm has the rod of one of 100: nobody can tell which row was read."""
        example = course.schemes[SCHEME].example
        assert example is not None
        plan = make_plan(course, SCHEME, {**example.options, "drive": "pneumatic"})
        rows = [
            one
            for one in candidates_of(plan, "rod", policy.slips)
            if one.kind == SlipKind.OTHER_ROW
        ]
        entries = plan.columns["bore_pneumatic.rod"].values
        assert len(rows) == len(set(entries.tolist())) < entries.size
        assert any("80; 100" in one.hint.of("en") for one in rows)

    def test_a_table_inside_a_formula_may_be_read_in_another_row(
        self, course: Course, policy: Policy
    ) -> None:
        example = course.schemes["screw"].example
        assert example is not None
        plan = make_plan(course, "screw", example.options)
        rows = [
            one
            for one in candidates_of(plan, "screw_stress", policy.slips)
            if one.kind == SlipKind.OTHER_ROW
        ]
        assert len(rows) > plan.columns["trapezoidal_thread.core_diameter"].sizes.size
        assert len({one.id for one in rows}) == len(rows)

    def test_a_plain_product_has_no_slip_of_angles_or_roots(self, slips_of: Slips) -> None:
        kinds = {one.kind for one in slips_of("grip_force*force_ratio").values()}
        assert kinds.isdisjoint({SlipKind.ANGLE_UNIT, SlipKind.POWER, SlipKind.WRONG_FUNCTION})

    def test_brackets_of_a_function_and_those_of_no_use_are_not_left_out(
        self, slips_of: Slips
    ) -> None:
        for formula in ("sqrt(grip_force/force_ratio)", "grip_force + (force_ratio*mass)"):
            assert not any(one.kind == "brackets" for one in slips_of(formula).values()), formula

    def test_unlike_things_and_numbers_of_the_formula_are_not_added(self, slips_of: Slips) -> None:
        for formula in ("grip_force*friction", "2*friction", "pi*friction", "2 + friction"):
            kinds = {one.kind for one in slips_of(formula).values()}
            assert "added_for_multiplied" not in kinds, formula

    def test_a_kind_that_the_course_leaves_out_is_not_made(
        self, plan: Plan, policy: Policy
    ) -> None:
        kinds = {k: v for k, v in policy.slips.kinds.items() if k is not SlipKind.POWER_OF_TEN}
        without = replace(policy.slips, kinds=kinds)
        found = candidates_of(plan, "drive_force", without)
        assert SlipKind.POWER_OF_TEN not in {one.kind for one in found}

    def test_every_kind_has_a_generator(self) -> None:
        assert set(GENERATORS) == set(SlipKind)


class TestCandidates:
    def test_every_kind_of_the_course_finds_a_place_in_some_scheme(
        self, course: Course, policy: Policy
    ) -> None:
        missing = set(policy.slips.kinds)
        for scheme in course.schemes:
            plan = _without_declared(_first_plan(course, scheme))
            for quantity in plan.answered if missing else ():
                found = candidates_of(plan, quantity.id, policy.slips)
                missing -= {one.kind for one in found}
        assert missing == set()

    def test_declared_slips_come_first(self, plan: Plan, policy: Policy) -> None:
        found = candidates_of(plan, "drive_force", policy.slips)
        declared = [SlipId.declared(one.id) for one in plan.quantities["drive_force"].slips]
        assert [one.id for one in found[: len(declared)]] == declared

    def test_none_is_the_right_formula_and_none_is_made_twice(
        self, course: Course, policy: Policy
    ) -> None:
        for scheme in course.schemes:
            plan = _first_plan(course, scheme)
            for quantity in plan.answered:
                found = candidates_of(plan, quantity.id, policy.slips)
                trees = [one.formula.tree for one in found]
                formula = plan.reference_formula(quantity.id)
                assert formula is not None
                assert formula.tree not in trees
                assert len(set(trees)) == len(trees)

    def test_decisions_and_verdicts_have_only_declared_ones(
        self, plan: Plan, policy: Policy
    ) -> None:
        for one in plan.answered:
            if one.kind in {Kind.CHOICE, Kind.VERDICT}:
                kinds = {c.kind for c in candidates_of(plan, one.id, policy.slips)}
                assert kinds <= {DECLARED}

    def test_the_prior_of_a_kind_is_shared_among_its_ways(
        self, slips_of: Slips, policy: Policy
    ) -> None:
        found = [
            one
            for one in slips_of("grip_force*force_ratio").values()
            if one.kind == SlipKind.POWER_OF_TEN
        ]
        total = sum(one.prior for one in found)
        assert total == pytest.approx(policy.slips.kinds[SlipKind.POWER_OF_TEN].prior)

    def test_hints_have_no_open_place_in_any_language(self, course: Course, policy: Policy) -> None:
        for scheme in course.schemes:
            plan = _first_plan(course, scheme)
            for quantity in plan.answered:
                for one in candidates_of(plan, quantity.id, policy.slips):
                    for language in LANGUAGES:
                        said = one.hint.of(language)
                        assert said
                        assert not set("{}") & set(said)

    def test_every_candidate_can_be_computed_wherever_the_formula_can(
        self, course: Course, policy: Policy
    ) -> None:
        """A candidate that never has a value is no candidate."""
        for space in load_spaces(course):
            combinations = space.cases.combinations
            plan = make_plan(course, space.scheme, combinations[len(combinations) // 2])
            values = {name: np.asarray(0.4) for name in plan.quantities}
            for quantity in plan.answered:
                for one in candidates_of(plan, quantity.id, policy.slips):
                    result = evaluate(one.formula, quantity.unit, values, plan.columns)
                    assert result.shape == ()


def _without_declared(plan: Plan) -> Plan:
    """The same formulas, for which nobody has thought of a mistake."""
    bare = {name: replace(one, slips=()) for name, one in plan.quantities.items()}
    return replace(plan, quantities=bare)


def _first_plan(course: Course, scheme: str) -> Plan:
    options = {option.id: option.choices[0].id for option in course.schemes[scheme].options}
    return make_plan(course, scheme, options)
