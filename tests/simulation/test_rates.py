"""Shares and what chance can do to them."""

import math

import pytest

from gripcourse.simulation.rates import Rate


# R. G. Newcombe, Two-sided confidence intervals for the single proportion, Statist. Med. 17 (1998),
# 857–872, table I, method 3.
@pytest.mark.parametrize(
    ("hits", "total", "low", "high"),
    [
        (81, 263, 0.2553, 0.3662),
        (15, 148, 0.0624, 0.1605),
        (0, 20, 0.0, 0.1611),
        (1, 29, 0.0061, 0.1718),
    ],
)
def test_the_interval_is_the_published_one(hits: int, total: int, low: float, high: float) -> None:
    assert Rate(hits, total).interval == pytest.approx((low, high), abs=5e-5)


def test_everything_and_nothing_reach_the_end() -> None:
    assert Rate(0, 50).interval[0] == 0.0
    assert Rate(50, 50).interval[1] == 1.0


def test_a_share_is_held_to_what_is_required() -> None:
    assert Rate(1, 1000, at_most=0.001).reached
    assert not Rate(2, 1000, at_most=0.001).reached
    assert Rate(95, 100, at_least=0.95).reached
    assert not Rate(94, 100, at_least=0.95).reached
    assert not Rate(1, 10).required


def test_a_share_of_nothing_misses_nothing() -> None:
    assert math.isnan(Rate(0, 0, at_least=0.95).share)
    assert Rate(0, 0, at_least=0.95).reached
    assert Rate(0, 0).interval == (0.0, 1.0)
