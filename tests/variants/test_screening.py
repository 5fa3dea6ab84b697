"""Drawn variants keep the rules that an audit measures, and the drawing tells what it refused."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind
from gripcourse.errors import TableError
from gripcourse.policy.model import Policy
from gripcourse.variants.accepted import Accepted
from gripcourse.variants.answers import AnswerItem, items_of, section_totals, solve_groups
from gripcourse.variants.apart import ApartLimits, limits_of, measure, shared_points
from gripcourse.variants.audit import audit
from gripcourse.variants.cases import Cases
from gripcourse.variants.draw import draw
from gripcourse.variants.screening import sifter
from gripcourse.variants.space import load_spaces

SECTIONS = 2


@pytest.mark.usefixtures("few_slips_counted")
def test_a_drawn_table_passes_its_audit(course: Course, policy: Policy) -> None:
    spaces = load_spaces(course)
    found = draw(course, spaces, 20, 11, sifter(policy, len(course.sections)))
    audited = audit(course, policy, found.variants, spaces)
    assert audited.passed, [one for one in audited.variants if not one.passed]
    assert audited.apart.whole.share.max() <= policy.variants.shared_points


def test_a_table_over_all_schemes_keeps_the_limits(course: Course, policy: Policy) -> None:
    sections = len(course.sections)
    variants = draw(course, load_spaces(course), 100, 7, sifter(policy, sections)).variants
    assert {one.scheme for one in variants} == set(course.schemes)
    items = items_of(solve_groups(course, variants), policy, Kind.FORMULA)
    found = measure(items, section_totals(items, 100, sections), limits_of(policy))
    assert found.whole.above == 0
    assert [one.above for one in found.sections] == [0] * sections


def test_options_without_room_for_one_more_are_made_up_by_others_of_the_scheme(
    course: Course, policy: Policy
) -> None:
    (space,) = (one for one in load_spaces(course) if one.scheme == "wedge_slide")
    first, *others = [space.cases[place] for place in range(6)]
    single = replace(first, given={id_: allowed[:1] for id_, allowed in first.given.items()})
    narrow = replace(space, cases=Cases.of((single, *others)))
    variants = draw(course, [narrow], 12, 5, sifter(policy, len(course.sections))).variants
    assert len(variants) == 12
    with pytest.raises(TableError):  # without a rule that needs room it is a fault of the space
        draw(course, [narrow], 12, 5)


def test_the_same_seed_gives_the_same_table(course: Course, policy: Policy) -> None:
    spaces = [one for one in load_spaces(course) if one.scheme in {"screw", "wedge_slide"}]
    one, other = (
        draw(course, spaces, 12, 5, sifter(policy, len(course.sections))) for _ in range(2)
    )
    assert one == other


def test_what_was_set_aside_is_counted_by_reason(course: Course, policy: Policy) -> None:
    (space,) = (one for one in load_spaces(course) if one.scheme == "wedge_roller")
    (tally,) = draw(course, [space], 12, 5, sifter(policy, len(course.sections))).tallies
    said = [str(refusal.what) for refusal in tally.set_aside]
    slips = [one for one in said if "gives nearly the right result: " in one]
    edges = [one for one in said if "lies at the edge of its step: " in one]
    assert slips
    assert edges
    assert len(set(said)) == len(said)  # each slip and each size once, over all batches
    assert all(one.endswith(")") for one in (*slips, *edges))  # which quantity: its id in brackets


def test_a_limit_that_nothing_keeps_is_told_with_its_reason(course: Course, policy: Policy) -> None:
    (space,) = (one for one in load_spaces(course) if one.scheme == "screw")
    case = space.cases[0]
    given = {id_: all_ if id_ == "mass" else all_[:1] for id_, all_ in case.given.items()}
    narrow = replace(space, cases=Cases.of([replace(case, given=given, constraints=())]))
    loose = replace(policy, variants=replace(policy.variants, keep_apart=(), step_margin=0.0))
    with pytest.raises(TableError, match=r"no room for another: .* too near to one of these"):
        draw(course, [narrow], 30, 5, sifter(loose, len(course.sections)))


@given(
    values=st.lists(st.lists(st.integers(1, 6), min_size=4, max_size=4), min_size=2, max_size=12),
    limit=st.sampled_from([0.0, 0.25, 0.5, 0.75]),
    section=st.sampled_from([0.0, 0.5, 1.0]),
)
def test_a_candidate_is_let_through_exactly_when_no_pair_goes_above_a_limit(
    values: list[list[int]], limit: float, section: float
) -> None:
    table = np.array(values, dtype=np.float64)
    items = [
        AnswerItem(
            quantity=f"q{column}",
            rows=np.arange(len(table)),
            values=table[:, column],
            half_widths=np.full(len(table), 0.1),
            points=np.full(len(table), 1.0 + column),
            sections=np.full(len(table), column % SECTIONS),
            schemes=np.zeros(len(table), dtype=np.intp),
        )
        for column in range(table.shape[1])
    ]
    totals = section_totals(items, len(table), SECTIONS)
    shared = next(shared_points(items, len(table), SECTIONS)).points.toarray()
    shared = shared.reshape(len(table), SECTIONS, len(table))
    accepted = Accepted(ApartLimits(limit, section), SECTIONS)
    answers = accepted.answers(items, len(table))
    kept: list[int] = []
    for row in range(len(table)):
        mine, theirs = shared[row][:, kept], shared[kept, :, row].T
        within = all(
            (points.sum(axis=0) <= limit * totals[0].sum() + 1e-6).all()
            and (points <= section * totals[0][:, None] + 1e-6).all()
            for points in (mine, theirs)
        )
        assert accepted.take(answers, row) == within
        kept += [row] if within else []


def test_what_is_drawn_keeps_apart_from_another_table(course: Course, policy: Policy) -> None:
    (space,) = (one for one in load_spaces(course) if one.scheme == "screw")
    sections = len(course.sections)
    last_year = draw(course, [space], 3, 5, sifter(policy, sections)).variants
    others = solve_groups(course, last_year)
    this_year = draw(course, [space], 3, 5, sifter(policy, sections, None, others)).variants
    both = (*last_year, *this_year)
    items = items_of(solve_groups(course, both), policy, Kind.FORMULA)
    found = measure(items, section_totals(items, len(both), sections), limits_of(policy))
    assert found.whole.above == 0
    assert not {tuple(one.given.items()) for one in last_year} & {
        tuple(one.given.items()) for one in this_year
    }
