"""Cronbach's alpha, against what Cronbach showed it to be: the mean of all split-half coefficients.

L. J. Cronbach, Coefficient alpha and the internal structure of tests, Psychometrika 16 (1951),
297-334: the mean over all ways to halve the items of 4 cov(half, half) / var(total).
"""

import statistics
from itertools import combinations

import numpy as np
import pandas as pd
import pytest

from gripcourse.grading.analytics.reliability import alpha, reliability_table


def split_half_mean(points: np.ndarray) -> float:
    items = range(points.shape[1])
    total = statistics.variance(points.sum(axis=1))
    found = []
    for half in combinations(items, len(items) // 2):
        rest = [one for one in items if one not in half]
        first, second = points[:, list(half)].sum(axis=1), points[:, rest].sum(axis=1)
        found.append(4 * statistics.covariance(first, second) / total)
    return statistics.fmean(found)


@pytest.mark.parametrize("items", [2, 4, 6])
def test_alpha_is_the_mean_of_all_split_halves(items: int) -> None:
    draw = np.random.default_rng(items)
    points = draw.normal(size=(20, 1)) + draw.normal(size=(20, items)) * draw.uniform(0.5, 2, items)
    assert alpha(pd.DataFrame(points)) == pytest.approx(split_half_mean(points))


def test_items_that_say_the_same_are_wholly_reliable() -> None:
    one = [0.0, 1.0, 2.0, 5.0, 7.0, 7.5, 8.0, 9.0]
    assert alpha(pd.DataFrame(dict.fromkeys("abc", one))) == pytest.approx(1.0)


@pytest.mark.parametrize(
    "points", [np.eye(7), np.ones((9, 3)), np.arange(9.0)[:, None]], ids=["few", "same", "one"]
)
def test_nothing_is_told_where_chance_decides(points: np.ndarray) -> None:
    assert alpha(pd.DataFrame(points)) is None


def test_works_of_other_schemes_are_compared_by_sections_alone() -> None:
    draw = np.random.default_rng(1)
    rows = [
        (work, scheme, "1", section, f"{section}{place}" + scheme * place, 2.0, share, 1.0)
        for work in range(16)
        for scheme in ["ab"[work % 2]]
        for level in [draw.uniform()]
        for section in ("one", "two")
        for place in (0, 1)
        for share in [float(draw.uniform() < level)]
    ]
    columns = ["work", "scheme", "variant", "section", "quantity", "weight", "with", "without"]
    table = reliability_table(pd.DataFrame(rows, columns=columns))
    assert list(table["scheme"]) == ["", "a", "b"]
    assert list(table["items"]) == ["sections", "quantities", "quantities"]
    assert list(table["works"]) == [16, 8, 8]
    assert list(table["count"]) == [2, 4, 4]
    assert table["alpha_with"].notna().all()
    assert table["alpha_without"].isna().all()


def test_works_that_are_all_right_do_not_differ_by_what_their_variants_ask() -> None:
    """A variant with more drawings to mark by hand has fewer points to be had so far."""
    rows = [
        (work, "a", str(work), section, section, weight, 1.0, 1.0)
        for work in range(9)
        for section, weight in (("one", 10.0 + work % 3), ("two", 20.0 - work % 2))
    ]
    columns = ["work", "scheme", "variant", "section", "quantity", "weight", "with", "without"]
    table = reliability_table(pd.DataFrame(rows, columns=columns))
    assert list(table["works"]) == [9, 9]
    assert table["alpha_with"].isna().all()


def test_a_batch_without_a_judged_work_has_no_reliability() -> None:
    columns = ["work", "scheme", "variant", "section", "quantity", "weight", "with", "without"]
    table = reliability_table(pd.DataFrame([], columns=columns))
    assert list(table["works"]) == [0]
    assert table["alpha_with"].isna().all()
