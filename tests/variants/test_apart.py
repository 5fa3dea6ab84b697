"""What two variants share, against the plain comparison of every variant with every other."""

from collections.abc import Mapping
from dataclasses import replace
from typing import TypeAlias

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind
from gripcourse.policy.bands import band, within
from gripcourse.policy.model import Policy
from gripcourse.policy.points import points_of
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import solve_variant
from gripcourse.text.units import factor
from gripcourse.variants.answers import AnswerItem, items_of, section_totals, solve_groups
from gripcourse.variants.apart import ApartLimits, measure, shared_points
from gripcourse.variants.draw import draw
from gripcourse.variants.model import Variant
from gripcourse.variants.space import load_spaces

SECTIONS = 3
LIMITS = ApartLimits(0.1, 0.5)
Solved: TypeAlias = tuple[Plan, Mapping[str, float], Mapping[str, float]]


def item(quantity: str, values: list[float], width: float, section: int = 0) -> AnswerItem:
    size = len(values)
    return AnswerItem(
        quantity=quantity,
        rows=np.arange(size),
        values=np.array(values, dtype=np.float64),
        half_widths=np.maximum(np.abs(np.array(values)) * width, 1e-3),
        points=np.full(size, 2.0),
        sections=np.full(size, section),
        schemes=np.zeros(size, dtype=np.intp),
    )


def all_pairs(items: list[AnswerItem], size: int) -> NDArray[np.float64]:
    """Compare everybody with everybody: points by who gets the answers, whose, and section."""
    shared = np.zeros((size, size, SECTIONS))
    for one in items:
        for i, own in enumerate(one.rows):
            for j, other in enumerate(one.rows):
                fits = abs(one.values[j] - one.values[i]) <= one.half_widths[i] * (1 + 1e-9)
                if i != j and fits:
                    shared[own, other, one.sections[i]] += one.points[i]
    return shared


def test_answers_without_points_are_nothing_that_is_shared() -> None:
    alike = replace(item("q", [1.0, 1.0, 2.0], 0.01), points=np.zeros(3))
    found = measure([alike], np.zeros((3, SECTIONS)), LIMITS)
    assert found.whole.share.tolist() == [0.0, 0.0, 0.0]
    assert found.beyond == ()


@st.composite
def tables(draw_: st.DrawFn) -> tuple[list[AnswerItem], int]:
    size = draw_(st.integers(2, 25))
    numbers = st.one_of(st.integers(-4, 4).map(float), st.floats(-3, 3, width=32))
    items = []
    for number in range(draw_(st.integers(1, 5))):
        values = draw_(st.lists(numbers, min_size=size, max_size=size))
        whole = item(f"q{number}", values, draw_(st.sampled_from([0.0, 0.01, 0.5])), number % 3)
        rows = np.flatnonzero(draw_(st.lists(st.booleans(), min_size=size, max_size=size)))
        items.append(
            replace(
                whole,
                rows=rows,
                values=whole.values[rows],
                half_widths=whole.half_widths[rows],
                points=whole.points[rows],
                sections=whole.sections[rows],
                schemes=whole.schemes[rows],
            )
        )
    return items, size


@settings(max_examples=75)
@given(table=tables(), budget=st.integers(1, 500))
def test_sorted_windows_find_what_comparing_all_pairs_finds(
    table: tuple[list[AnswerItem], int], budget: int
) -> None:
    items, size = table
    expected = all_pairs(items, size)
    found = np.zeros((size, size, SECTIONS))
    for chunk in shared_points(items, size, SECTIONS, budget):
        dense = chunk.points.toarray().reshape(chunk.stop - chunk.start, SECTIONS, size)
        found[chunk.start : chunk.stop] = dense.transpose(0, 2, 1)
    assert found == pytest.approx(expected)


@settings(max_examples=50)
@given(table=tables())
def test_the_measure_tells_the_nearest_and_counts_what_is_above(
    table: tuple[list[AnswerItem], int],
) -> None:
    items, size = table
    totals = section_totals(items, size, SECTIONS)
    expected = all_pairs(items, size)
    with np.errstate(invalid="ignore", divide="ignore"):
        whole = np.nan_to_num(expected.sum(axis=2) / totals.sum(axis=1)[:, None])
        sections = np.nan_to_num(expected / totals[:, None, :])
    found = measure(items, totals, LIMITS)
    assert found.pairs == size * (size - 1)
    assert found.coincidences == round(expected.sum() / 2.0)
    assert found.whole.share == pytest.approx(whole.max(axis=1))
    assert found.whole.above == (whole > 0.1 + 1e-9).sum()
    assert found.whole.histogram.sum() == found.pairs
    for number, shares in enumerate(found.sections):
        assert shares.share == pytest.approx(sections[:, :, number].max(axis=1))
        assert shares.above == (sections[:, :, number] > 0.5 + 1e-9).sum()
    for row, nearest in enumerate(found.whole.nearest):
        if nearest >= 0:
            assert whole[row, nearest] == pytest.approx(found.whole.share[row])
    beyond = {frozenset(pair) for pair in found.beyond}
    above = np.argwhere((whole > 0.1 + 1e-9) | (sections > 0.5 + 1e-9).any(axis=2))
    assert beyond == {frozenset(pair) for pair in above.tolist()}
    assert len(beyond) == len(found.beyond)


def test_a_wide_band_takes_a_narrow_ones_answer_and_not_the_other_way_round() -> None:
    # The band is a share of the own right answer: 101 lies within 1 % of 102, 102 not of 101.
    one = item("force", [101.0, 102.0], 0.00985)
    chunk = next(shared_points([one], 2, SECTIONS))
    dense = chunk.points.toarray().reshape(2, SECTIONS, 2)
    assert dense[1, 0, 0] == 2.0
    assert dense[0, 0, 1] == 0.0


def drawn(course: Course, count: int) -> tuple[Variant, ...]:
    return draw(course, load_spaces(course), count, 7).variants


def solved(course: Course, policy: Policy, variant: Variant) -> Solved:
    """Solve a variant with the scalar functions that grading uses; with the points of its items."""
    plan = make_plan(course, variant.scheme, variant.options)
    return plan, solve_variant(plan, variant.given), points_of(plan, policy)


def by_hand(policy: Policy, own: Solved, other: Solved) -> float:
    """Compute the share of one pair with the scalar functions that grading uses."""
    plan, values, points = own
    other_plan, others, _ = other
    got = total = 0.0
    for quantity in plan.answered:
        if quantity.kind is not Kind.FORMULA:
            continue
        total += points[quantity.id]
        foreign = other_plan.quantities.get(quantity.id)
        if foreign is not None and foreign.kind is Kind.FORMULA:
            answer = others[quantity.id] * factor(foreign.unit) / factor(quantity.unit)
            width = band(quantity, values[quantity.id], policy)
            got += points[quantity.id] * within(answer, values[quantity.id], width)
    return got / total


def test_shares_across_schemes_and_options_are_those_of_the_grader(
    course: Course, policy: Policy
) -> None:
    variants = drawn(course, 32)
    items = items_of(solve_groups(course, variants), policy, Kind.FORMULA)
    totals = section_totals(items, len(variants), len(course.sections))
    shared = np.concatenate([
        chunk.points.toarray().reshape(-1, len(course.sections), len(variants)).sum(axis=1)
        for chunk in shared_points(items, len(variants), len(course.sections))
    ])  # fmt: skip
    shares = shared / totals.sum(axis=1)[:, None]
    assert len({variant.scheme for variant in variants}) == len(course.schemes)
    alone = [solved(course, policy, variant) for variant in variants]
    for own in range(len(variants)):
        for other in range(own % 3, len(variants), 3):
            if own != other:
                expected = by_hand(policy, alone[own], alone[other])
                assert shares[own, other] == pytest.approx(expected), (own, other)


def test_the_work_grows_with_the_coincidences_and_not_with_all_pairs(
    course: Course, policy: Policy
) -> None:
    variants = drawn(course, 400)
    items = items_of(solve_groups(course, variants), policy, Kind.FORMULA)
    totals = section_totals(items, len(variants), len(course.sections))
    found = measure(items, totals, LIMITS)
    compared_naively = sum(len(one.rows) * (len(one.rows) - 1) for one in items)
    assert found.coincidences < 0.1 * compared_naively
