"""Steps left blank: what is lost there is not told from what is lost in steps that are written."""

import math
from typing import TYPE_CHECKING

import pytest

from gripcourse.grading.model import Outcome

if TYPE_CHECKING:
    from collections.abc import Callable

    from conftest import Case, DrawMore
    from gripcourse.submission.model import Answer

    Typed = Callable[[str, float, int], Answer]

ANGLE, OFFSET = "nominal_lever_angle", "apex_offset_at_min"


def offset_of(case: "Case", angle: float) -> float:
    """The offset of the apex on the smallest object, by a pocket calculator: mm from degrees."""
    given = case.given
    half = math.radians(given["prism_angle"] / 2)
    rise = given["lever_length"] * math.sin(math.radians(angle))
    return given["diameter_min"] / (2 * math.sin(half)) - rise


def angle_by(case: "Case", pi: float) -> float:
    """The angle of the lever, degrees, if a right angle is half of this number."""
    given = case.given
    others = math.radians(given["prism_angle"] / 2 + given["attachment_angle"])
    return math.degrees(pi / 2 - others)


@pytest.fixture(scope="module")
def prisms(draw_more: "DrawMore") -> "list[Case]":
    """Variants in which half of 3.14 moves the difference of near numbers out of its band."""
    cases = [case.without_errata for case in draw_more(["prism_lever"])]
    found = [
        case
        for case in cases
        if abs(offset_of(case, angle_by(case, 3.14)) / case.reference[OFFSET] - 1) > 0.015
    ]
    assert found
    return found


def test_the_calculator_of_these_tests_computes_what_the_course_declares(
    prisms: "list[Case]",
) -> None:
    for case in prisms:
        assert angle_by(case, math.pi) == pytest.approx(case.reference[ANGLE])
        assert offset_of(case, case.reference[ANGLE]) == pytest.approx(case.reference[OFFSET])


@pytest.mark.parametrize("figures", [3, 4, 5])
def test_a_short_pi_in_a_blank_step_costs_nothing_where_the_next_answer_magnifies_it(
    prisms: "list[Case]", typed: "Typed", figures: int
) -> None:
    for case in prisms:
        offset = typed(OFFSET, offset_of(case, angle_by(case, 3.14)), figures)
        finding = case.findings({**case.answers, ANGLE: None, OFFSET: offset})[OFFSET]
        assert finding.outcome is Outcome.CARRIED, case.label
        assert finding.points == finding.max_points
        assert "3.14" in str(finding.message)


def test_it_costs_nothing_either_where_the_step_is_written(
    prisms: "list[Case]", typed: "Typed"
) -> None:
    for case in prisms:
        angle = angle_by(case, 3.14)
        answers = {ANGLE: typed(ANGLE, angle, 5), OFFSET: typed(OFFSET, offset_of(case, angle), 5)}
        assert case.lost({**case.answers, **answers}) <= {"prism_tilt"}, case.label


@pytest.mark.parametrize("pi", [3.1, 3.0, 3.2, 22 / 7])
def test_a_pi_that_nobody_shortens_so_makes_no_wrong_number_right(
    prisms: "list[Case]", typed: "Typed", pi: float
) -> None:
    for case in prisms:
        offset = offset_of(case, angle_by(case, pi))
        if abs(offset / case.reference[OFFSET] - 1) > 0.012:
            answers = {**case.answers, ANGLE: None, OFFSET: typed(OFFSET, offset, 5)}
            assert OFFSET in case.lost(answers), case.label


def test_what_a_short_pi_explains_is_wrong_where_the_step_stands_in_its_cell_rightly(
    prisms: "list[Case]", typed: "Typed"
) -> None:
    for case in prisms:
        offset = typed(OFFSET, offset_of(case, angle_by(case, 3.14)), 5)
        answers = {**case.answers, ANGLE: typed(ANGLE, case.reference[ANGLE], 6), OFFSET: offset}
        assert OFFSET in case.lost(answers), case.label
