"""Sums that several documents print."""

import math
from collections.abc import Callable

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gripcourse.documents.report.totals import (
    peer_quartiles,
    quantity_totals,
    section_shares,
    section_totals,
    shares,
    spread,
)
from gripcourse.grading.model import Outcome, Report
from gripcourse.text.words import Words

Change = Callable[..., Report]


def test_sections_add_up_to_the_score(perfect: Report, wrong: Change) -> None:
    report = wrong(perfect, "drive_force", 1.0)
    totals = section_totals(report).values()
    assert math.isclose(sum(total.points for total in totals), report.score)
    assert math.isclose(sum(total.max_points for total in totals), report.max_score)
    assert math.isclose(sum(total.open_points for total in totals), report.open_points)


def test_a_file_that_was_not_judged_has_no_share(perfect: Report, rejected: Change) -> None:
    assert shares([perfect, rejected(perfect)]) == [1.0]


def test_outcomes_of_a_quantity_are_counted(perfect: Report, wrong: Change) -> None:
    totals = quantity_totals([perfect, perfect, wrong(perfect, "drive_force", 1.0)])
    found = next(total for total in totals if total.quantity == "drive_force")
    assert found.outcomes == {Outcome.CORRECT: 2, Outcome.WRONG: 1}


def test_a_section_has_a_share_of_each_judged_report(
    perfect: Report, wrong: Change, rejected: Change
) -> None:
    shares = section_shares([perfect, wrong(perfect, "drive_force", 1.0), rejected(perfect)])
    found = shares["drive"]
    assert len(found) == 2
    assert found[0] == 1.0 > found[1]
    assert set(shares) == {one.section for one in perfect.findings if one.max_points}


@pytest.mark.parametrize("scores", [[], [0.5]])
def test_too_few_scores_have_no_spread(scores: list[float]) -> None:
    found = spread(scores)
    assert found.deviation is None
    assert (found.mean is None) == (not scores)


@given(st.lists(st.floats(0, 1), min_size=2))
def test_mean_and_median_lie_between_the_lowest_and_the_highest(scores: list[float]) -> None:
    found = spread(scores)
    assert found.lowest is not None
    assert found.highest is not None
    for middle in (found.mean, found.median):
        assert middle is not None
        assert found.lowest - 1e-9 <= middle <= found.highest + 1e-9


def test_a_class_is_told_in_quartiles_and_a_few_works_not_at_all() -> None:
    earned = [number / 10 for number in range(1, 10)]
    said = peer_quartiles(earned, Words("en"))
    assert "9 in all, earned from 30% to 70%" in said
    assert said.endswith("the median is 50%.")
    assert peer_quartiles(earned[:5], Words("en")) == ""
