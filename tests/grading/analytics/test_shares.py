"""Facility and discrimination agree with the report's own way of computing them, made apart."""

from collections.abc import Callable
from dataclasses import replace

import pytest

from gripcourse.documents.report.items import item_statistics
from gripcourse.grading.analytics.shares import VIEWS, item_table, score_table, share_table
from gripcourse.grading.model import Against, Outcome, Report

Change = Callable[..., Report]


@pytest.fixture
def cohort(perfect: Report, wrong: Change, with_finding: Change) -> list[Report]:
    """Nine works, some of which are wrong here and there; in two an answer follows from another."""
    asked = [one.quantity for one in perfect.findings if one.max_points and not one.is_open]
    works = [perfect]
    for place in range(1, 9):
        report = perfect
        for quantity in asked[:: place + 1]:
            report = wrong(report, quantity, place / 9)
        if place % 4 == 0:
            report = with_finding(
                report,
                "drive_force",
                outcome=Outcome.CARRIED,
                against=Against.OWN_INPUTS,
                roots=("grip_force",),
            )
        works.append(report)
    return works


def test_items_are_those_of_the_report_computed_otherwise(cohort: list[Report]) -> None:
    table = item_table(share_table(cohort)).set_index("quantity")
    statistics = item_statistics(cohort)
    assert set(table.index) == set(statistics)
    told = 0
    for name, expected in statistics.items():
        for view, one in zip(VIEWS, (expected.with_consequences, expected.without), strict=True):
            row = table.loc[name]
            assert row[f"facility_{view}"] == pytest.approx(one.facility)
            found = row[f"discrimination_{view}"]
            if one.discrimination is None:
                assert found != found  # noqa: PLR0124 (no number)
            else:
                assert found == pytest.approx(one.discrimination)
                told += 1
    assert told > 5


def test_a_score_is_the_share_of_all_points(cohort: list[Report], rejected: Change) -> None:
    scores = score_table(share_table([cohort[1], rejected(cohort[1]), cohort[0]]))
    assert list(scores["work"]) == [0, 2]
    shares = [cohort[1].score / cohort[1].max_score, 1.0]
    assert list(scores["without"]) == pytest.approx(shares)


def test_what_waits_or_was_not_judged_is_not_counted(perfect: Report, rejected: Change) -> None:
    assert share_table([rejected(perfect)]).empty
    assert item_table(share_table([replace(perfect, findings=())])).empty
