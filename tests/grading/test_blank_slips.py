"""A wrong method in a step that was left blank: it has cost there, however many answers show it."""

import math
from dataclasses import replace
from typing import TYPE_CHECKING

import pytest

from gripcourse.course.quantity import Kind
from gripcourse.formula.parse import parse
from gripcourse.formula.tree import Formula
from gripcourse.grading.model import Outcome

if TYPE_CHECKING:
    from collections.abc import Callable

    from conftest import Case
    from gripcourse.submission.model import Answer

    Typed = Callable[[str, float, int], Answer]

BLANK = "wrap_angle"


@pytest.fixture(scope="module")
def radians(flat_belt: "Case", typed: "Typed") -> "dict[str, float | Answer | None]":
    """α₁ = 180° − 2·arcsin((d₂ − d₁)/2a), with the arc sine in radians, and never written down."""
    known, given = flat_belt.reference, flat_belt.given
    ratio = (known["large_diameter"] - known["small_diameter"]) / (2 * given["centre_distance"])
    later = flat_belt.following(**{BLANK: 180 - 2 * math.asin(ratio)})
    numbers = {one.id for one in flat_belt.plan.answered if one.kind is Kind.FORMULA}
    return {
        name: None if name == BLANK else typed(name, value, 5) if name in numbers else value
        for name, value in later.items()
    }


class TestSharedBlankStep:
    def test_all_that_follows_from_it_costs_nothing_more(
        self, flat_belt: "Case", radians: "dict[str, float | Answer | None]"
    ) -> None:
        assert flat_belt.lost(radians) == {BLANK}

    def test_every_answer_that_shows_it_names_it(
        self, flat_belt: "Case", radians: "dict[str, float | Answer | None]"
    ) -> None:
        findings = flat_belt.findings(radians)
        for name in ("wrap_factor", "pull_limit"):
            found = findings[name]
            assert found.outcome is Outcome.CARRIED
            assert found.roots == (BLANK,)
            assert found.slip is not None
            assert "blank" in str(found.message)
            assert "angle_unit" in {one.kind for one in (found.slip, *found.tied)}

    def test_a_mistake_of_its_own_costs_all_the_same(
        self, flat_belt: "Case", typed: "Typed", radians: "dict[str, float | Answer | None]"
    ) -> None:
        wrong = typed("shaft_force", 0.37 * flat_belt.reference["shaft_force"], 5)
        assert "shaft_force" in flat_belt.lost({**radians, "shaft_force": wrong})


def test_another_unit_in_a_blank_step_is_told_by_the_answers_that_use_it(
    flat_belt: "Case", typed: "Typed"
) -> None:
    """The length of the belt was not written down, and its metres were taken for millimetres."""
    names = ("run_frequency", "take_up")
    metres = flat_belt.following(belt_length=flat_belt.reference["belt_length"] / 1000)
    off = {name: typed(name, metres[name], 5) for name in names}
    findings = flat_belt.findings({**flat_belt.answers, "belt_length": None, **off})
    for name in names:
        assert findings[name].points == findings[name].max_points
        assert findings[name].roots == ("belt_length",)
        assert str(findings[name].slip) == "unit:m"


def test_what_was_not_written_was_not_written_in_another_unit(
    flat_belt: "Case", typed: "Typed"
) -> None:
    """The force on the shaft is blank; a moment a thousand times too small is a unit of its own."""
    small = typed("bending_moment", flat_belt.reference["bending_moment"] / 1000, 5)
    answers = {**flat_belt.answers, "shaft_force": None, "hinge_arm_required": None}
    found = flat_belt.findings({**answers, "bending_moment": small})["bending_moment"]
    assert found.outcome is Outcome.SLIP
    assert found.points < found.max_points


def test_an_input_in_another_unit_in_one_of_its_places_is_no_hindrance(
    hydraulic: "Case", typed: "Typed"
) -> None:
    """Of (a/a)·b a thousandth comes of an a in another unit, in one place, and of another unit."""
    text = "lifting_load/lifting_load*grip_force"
    quantity = replace(
        hydraulic.plan.quantities["drive_force"],
        formula=Formula(text, parse(text), {}),
        slips=(),
        as_printed=(),
    )
    quantities = {**hydraulic.plan.quantities, "drive_force": quantity}
    case = replace(hydraulic, plan=replace(hydraulic.plan, quantities=quantities))
    small = typed("drive_force", case.reference["grip_force"] / 1000, 5)
    found = case.findings({**case.answers, "drive_force": small})["drive_force"]
    assert str(found.slip) == "unit:kN"
