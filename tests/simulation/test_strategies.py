"""Whoever computes nothing earns next to nothing, and the measured grader says so."""

from dataclasses import replace

import pytest

from gripcourse.course.model import Course
from gripcourse.policy.model import Policy
from gripcourse.simulation.cohort import make_classroom
from gripcourse.simulation.confusion import evaluate
from gripcourse.simulation.mix import load_mix
from gripcourse.simulation.strategies import Strategy, StrategyScore, missed, scores_of


@pytest.fixture(scope="module")
def scores(course: Course, policy: Policy) -> tuple[StrategyScore, ...]:
    mix = load_mix(course)
    room = make_classroom(course, policy, mix, 2, 3, "pinion_racks")
    return scores_of(room.context, 1, 3)


def test_no_strategy_earns_much_where_ratios_are_the_same_in_all_variants(
    course: Course, scores: tuple[StrategyScore, ...]
) -> None:
    assert [one.strategy for one in scores] == list(Strategy)
    assert missed(scores, load_mix(course).required.strategy_earned) == ()


def test_a_strategy_that_pays_is_named(course: Course) -> None:
    paying = StrategyScore(Strategy.ZERO, 10, mean=0.29, most=0.4)
    found = evaluate((), load_mix(course), [paying])
    assert "zero" in found.missed
    assert evaluate((), load_mix(course), [replace(paying, mean=0.01)]).missed == ()
