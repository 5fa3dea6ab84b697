"""A wrong method in two formulas that are alike, at both ends of a range, is one mistake."""

from math import asin, cos, degrees, radians, sin, tan
from typing import TYPE_CHECKING

import pytest

from gripcourse.formula.parse import parse
from gripcourse.formula.tree import form
from gripcourse.grading.model import Outcome

if TYPE_CHECKING:
    from collections.abc import Callable

    from conftest import Case, DrawMore
    from gripcourse.submission.model import Answer

ENDS = ("force_ratio_at_max", "force_ratio_at_min")


@pytest.fixture(scope="module")
def levers(table: "tuple[Case, ...]") -> "Case":
    """Two levers, whose ratio P/F is asked for at both ends of the range."""
    return next(one for one in table if one.plan.scheme.id == "plain_lever")


@pytest.fixture(scope="module")
def rockers(table: "tuple[Case, ...]") -> "Case":
    """Two rockers, whose slots stand at an angle that is asked for in three positions."""
    return next(one for one in table if one.plan.scheme.id == "tangent_slider")


def for_one_jaw(case: "Case") -> dict[str, float]:
    """P/F as if the rod closed one of the two jaws: half of it, at both ends."""
    return case.following(**{name: case.reference[name] / 2 for name in ENDS})


class TestOneWayOfThinkingAtBothEnds:
    def test_it_costs_the_first_end_alone(self, levers: "Case") -> None:
        assert levers.lost(for_one_jaw(levers)) == {ENDS[0]}

    def test_the_other_end_says_where_it_has_cost(self, levers: "Case") -> None:
        later = levers.findings(for_one_jaw(levers))[ENDS[1]]
        assert later.outcome is Outcome.CARRIED
        assert later.roots == (ENDS[0],)
        assert str(later.message).startswith("The same mistake as in force ratio")

    def test_a_sign_that_is_wrong_in_every_position_costs_once(self, levers: "Case") -> None:
        # β = 90° − χ − ψ, and ψ the wrong way round.
        names = [f"drive_arm_angle_{position}" for position in ("at_max", "at_min", "open")]
        twice = 2 * levers.given["drive_arm_tilt"]
        answers = levers.following(**{name: levers.reference[name] + twice for name in names})
        assert levers.lost(answers) == {names[0]}

    def test_an_angle_that_is_left_in_radians_in_every_cell_costs_once(
        self, levers: "Case"
    ) -> None:
        names = [f"drive_arm_angle_{position}" for position in ("at_max", "at_min", "open")]
        answers = dict(levers.answers)
        answers |= {name: levers.reference[name] / 57.29578 for name in names}
        assert levers.lost(answers) == {names[0]}

    def test_a_small_angle_in_radians_costs_once_with_the_large_one_beside_it(
        self, draw_more: "DrawMore", typed: "Callable[..., Answer]"
    ) -> None:
        # Of half a degree nobody can tell radians from the sine.
        small, large = "grip_arm_tilt_at_max", "grip_arm_tilt_at_min"

        def in_radians(case: "Case", *names: str) -> "dict[str, Answer]":
            meant = case.answers | {name: case.reference[name] / 57.29578 for name in names}
            return {name: typed(name, value, 6) for name, value in meant.items()}

        doubtful = [
            one
            for one in draw_more({"cross_cylinder", "slot_crosshead", "plain_lever"})
            if abs(one.reference[small]) < 1
            and abs(one.reference[large]) > 5
            and one.findings(in_radians(one, small))[small].tied
        ]
        assert doubtful
        for case in doubtful:
            found = [case.findings(in_radians(case, small, large))[name] for name in (small, large)]
            assert sorted(one.outcome for one in found) == [Outcome.CARRIED, Outcome.SLIP]
            assert found[0].roots + found[1].roots in {(small,), (large,)}

    def test_a_work_that_calculates_nothing_earns_nothing_by_it(self, levers: "Case") -> None:
        nothing = dict.fromkeys(levers.answers, 7.0) | for_one_jaw_alone(levers)
        findings = levers.findings(nothing)
        assert findings[ENDS[1]].points == 0


def for_one_jaw_alone(case: "Case") -> dict[str, float]:
    return {name: case.reference[name] / 2 for name in ENDS}


class TestEveryPosition:
    """Open jaws stand a release travel beyond the largest object: their formula has a term more."""

    ANGLES = tuple(f"rocker_angle_{position}" for position in ("open", "at_max", "at_min"))

    def by_arcsine(self, case: "Case", *names: str) -> dict[str, float]:
        """tan θ is how far the pin stands beyond the pivot over b; taken for the sine."""
        return case.following(
            **{name: degrees(asin(tan(radians(case.reference[name])))) for name in names}
        )

    def test_one_wrong_function_costs_the_first_position_alone(self, rockers: "Case") -> None:
        findings = rockers.findings(self.by_arcsine(rockers, *self.ANGLES))
        paid = {name for name in self.ANGLES if findings[name].outcome is Outcome.CARRIED}
        assert len(rockers.lost(self.by_arcsine(rockers, *self.ANGLES))) == 1
        assert len(paid) == len(self.ANGLES) - 1

    def test_another_mistake_at_another_position_costs_for_itself(self, rockers: "Case") -> None:
        open_jaws, *_, closed = self.ANGLES
        wrong = rockers.following(
            **{
                open_jaws: self.by_arcsine(rockers, open_jaws)[open_jaws],
                closed: -rockers.reference[closed],
            }
        )
        assert rockers.lost(wrong) == {open_jaws, closed}

    def test_forces_added_as_numbers_at_both_ends_cost_once(
        self, table: "tuple[Case, ...]"
    ) -> None:
        # At D_max both components have cells of their own, at D_min they stand in the formula.
        links = next(one for one in table if one.plan.scheme.id.startswith("link_lever"))
        right = links.reference
        gamma = radians(right["link_angle_at_min"])
        at_min = right["grip_force"] + right["link_force_at_min"] * (sin(gamma) + cos(gamma))
        at_max = right["joint_force_x"] + right["joint_force_y"]
        wrong = links.following(joint_force_at_max=at_max, joint_force_at_min=at_min)
        assert len(links.lost(wrong)) == 1


class TestOneNumberAtBothEnds:
    def test_what_gives_it_at_both_costs_once_though_it_may_be_copied(
        self, table: "tuple[Case, ...]"
    ) -> None:
        # P/F of a wedge is 3·(b/c)·tan(θ + ρ) at both ends where the tilts are left out.
        wedge = next(one for one in table if one.plan.scheme.id == "wedge_roller_3")
        arms = wedge.given["grip_arm"] / wedge.given["roller_arm"]
        face = radians(wedge.given["wedge_angle"] + wedge.given["friction_angle"])
        wrong = wedge.following(**dict.fromkeys(ENDS, 3 * arms * tan(face)))
        assert len(wedge.lost(wrong)) == 1

    def test_a_number_that_no_method_gives_costs_at_each_end(self, levers: "Case") -> None:
        between = 1.234 * max(levers.reference[name] for name in ENDS)
        assert levers.lost(levers.following(**dict.fromkeys(ENDS, between))) == {*ENDS}


class TestTheLoadAtTheFlange:
    def test_a_factor_left_out_of_both_moments_costs_once(self, table: "tuple[Case, ...]") -> None:
        # Whoever takes the load as G takes it so for bending and for torque.
        moments = ("mount_bending", "mount_torque")
        with_flange = (one for one in table if {*moments, "drive_force"} <= one.answers.keys())
        case = next(one for one in with_flange if one.given["dynamic_factor"] > 1.1)
        factor = case.given["dynamic_factor"]
        wrong = case.following(**{name: case.reference[name] / factor for name in moments})
        assert len(case.lost(wrong)) == 1


class TestMistakesOfTheirOwn:
    def test_two_wrong_methods_cost_twice(self, levers: "Case") -> None:
        # One end for one jaw, the other with the arms upside down: P/F = 2·h2·sin β/(h1·cos χ).
        upside_down = 4 / levers.reference[ENDS[1]]
        answers = levers.following(**{ENDS[0]: levers.reference[ENDS[0]] / 2, ENDS[1]: upside_down})
        assert levers.lost(answers) == {*ENDS}

    def test_one_end_alone_costs_that_end(self, levers: "Case") -> None:
        answers = levers.following(**{ENDS[1]: levers.reference[ENDS[1]] / 2})
        assert levers.lost(answers) == {ENDS[1]}

    def test_two_numbers_that_nothing_explains_cost_twice(self, levers: "Case") -> None:
        right = levers.reference
        answers = levers.following(
            **{ENDS[0]: 1.37 * right[ENDS[0]], ENDS[1]: 1.61 * right[ENDS[1]]}
        )
        assert levers.lost(answers) == {*ENDS}


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("2*a*cos(b)/c", "2*d*cos(e)/c"),
        ("a*(b - c)/c", "d*(e - f)/f"),
        ("max(a, b)", "max(c, d)"),
    ],
)
def test_formulas_are_alike_that_compute_alike_with_other_quantities(one: str, other: str) -> None:
    assert form(parse(one)) == form(parse(other))


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("2*a*cos(b)/c", "2*a*sin(b)/c"),
        ("2*a*cos(b)/c", "3*a*cos(b)/c"),
        ("a*(b - c)/c", "a*(b - c)/b"),
        ("a - b", "a + b"),
        ("-a", "a"),
        ("pi*a", "b*a"),
    ],
)
def test_formulas_are_not_alike_that_compute_otherwise(one: str, other: str) -> None:
    assert form(parse(one)) != form(parse(other))


class TestOneRowForSeveralColumns:
    """Useful stress of a flat belt, k0 = s - w·δ/d: both stand in the row of the stress at rest."""

    def test_the_wrong_row_costs_the_first_column_alone(self, flat_belt: "Case") -> None:
        read = flat_belt.following(stress_straight=2.7, stress_bending=11.0)
        assert flat_belt.lost(read) == {"stress_straight"}

    def test_two_wrong_rows_cost_each_for_itself(self, flat_belt: "Case") -> None:
        read = flat_belt.following(stress_straight=2.7, stress_bending=9.0)
        assert flat_belt.lost(read) == {"stress_straight", "stress_bending"}


def test_a_calculator_set_to_radians_costs_once_in_formulas_that_are_not_alike(
    table: "tuple[Case, ...]",
) -> None:
    # Q_O = Q·cos β·cos α, Q_N = Q·cos β·sin α, Q_B = Q·sin β: 30° as 30 radians.
    names = ("load_axial", "load_normal", "load_binormal")
    case = next(one for one in table if {"load", *names} <= one.answers.keys())
    load = case.reference["load"]
    alpha, beta = (
        case.reference.get(one, case.given.get(one, 0.0))
        for one in ("load_angle", "load_elevation")
    )
    wrong = (load * cos(beta) * cos(alpha), load * cos(beta) * sin(alpha), load * sin(beta))
    answers = {**case.answers, **dict(zip(names, wrong, strict=True))}
    found = case.findings({name: float(f"{value:.6g}") for name, value in answers.items()})
    assert str(found[names[0]].slip).startswith("angle_unit:")
    for later in names[1:]:
        assert found[later].outcome is Outcome.CARRIED
        assert found[later].roots == (names[0],)
        assert found[later].points == found[later].max_points
