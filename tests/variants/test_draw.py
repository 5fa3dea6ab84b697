"""Drawn variants can be solved, differ, and come again with the same seed."""

import re
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from gripcourse.course.model import Course
from gripcourse.errors import TableError
from gripcourse.solver.plan import make_plan
from gripcourse.text.words import message
from gripcourse.variants.cases import Cases
from gripcourse.variants.draw import draw, nothing_left
from gripcourse.variants.explain import why_infeasible
from gripcourse.variants.search import TOO_NEAR, Batch, Search, Sifted
from gripcourse.variants.space import load_spaces
from gripcourse.variants.tally import Refusal

Change = Callable[[str, str], Course]


def test_the_same_seed_gives_the_same_variants(small_course: Course) -> None:
    spaces = load_spaces(small_course)
    assert draw(small_course, spaces, 40, 7) == draw(small_course, spaces, 40, 7)


def test_another_seed_gives_other_variants(small_course: Course) -> None:
    spaces = load_spaces(small_course)
    one, other = (draw(small_course, spaces, 40, seed).variants for seed in (7, 8))
    assert [variant.given for variant in one] != [variant.given for variant in other]


def test_variants_are_numbered_with_leading_zeros(small_course: Course) -> None:
    drawn = draw(small_course, load_spaces(small_course), 12, 7)
    assert [variant.id for variant in drawn.variants] == [f"{n:03d}" for n in range(1, 13)]


def test_no_two_variants_have_the_same_numbers(small_course: Course) -> None:
    drawn = draw(small_course, load_spaces(small_course), 200, 7)
    numbers = {(*variant.options.values(), *variant.given.values()) for variant in drawn.variants}
    assert len(numbers) == 200


def test_every_variant_is_feasible_and_on_the_grid(small_course: Course) -> None:
    spaces = load_spaces(small_course)
    cases = {case.options["fluid"]: case for case in spaces[0].cases}
    for variant in draw(small_course, spaces, 100, 7).variants:
        case = cases[variant.options["fluid"]]
        plan = make_plan(small_course, variant.scheme, variant.options)
        assert why_infeasible(plan, variant.given, case.constraints) == ()
        assert all(variant.given[id_] in allowed for id_, allowed in case.given.items())


def test_a_follower_follows_in_every_variant(small_course: Course) -> None:
    pairs = {17.0: 4.26, 20.0: 4.08, 25.0: 3.9}
    variants = draw(small_course, load_spaces(small_course), 50, 7).variants
    assert all(one.given["form_factor"] == pairs[one.given["teeth"]] for one in variants)
    assert {one.given["teeth"] for one in variants} == set(pairs)


def test_options_are_equally_frequent_and_mixed(small_course: Course) -> None:
    variants = draw(small_course, load_spaces(small_course), 40, 7).variants
    fluids = [variant.options["fluid"] for variant in variants]
    assert fluids.count("oil") == fluids.count("air") == 20
    assert {"oil", "air"} == set(fluids[:10])


def test_the_tally_counts_what_was_tried_and_why_it_was_refused(small_course: Course) -> None:
    (tally,) = draw(small_course, load_spaces(small_course), 40, 7).tallies
    assert tally.tried >= 2 * 256
    assert 0.3 < tally.acceptance < 1
    counts = [refusal.count for refusal in tally.refusals]
    assert counts == sorted(counts, reverse=True)
    assert "the answer is no: the pressure is allowed" in str(tally.refusals[0].what)


def test_an_impossible_space_is_given_up_with_the_main_reasons(small_with: Change) -> None:
    course = small_with("angle <= 60", "angle <= 1")
    with pytest.raises(TableError, match="angle <= 1 does not hold") as caught:
        draw(course, load_spaces(course), 5, 7)
    (problem,) = caught.value.problems
    assert problem.file == "variants/spaces/press.toml"
    assert re.search("only 0 can be handed out, [23] are wanted", str(problem.what))


def test_a_space_with_a_single_variant_cannot_give_two(small_course: Course) -> None:
    (space,) = load_spaces(small_course)
    (oil, _) = space.cases
    single = {id_: allowed[:1] for id_, allowed in oil.given.items()}
    narrow = replace(space, cases=Cases.of([replace(oil, given=single)]))
    assert len(draw(small_course, [narrow], 1, 7).variants) == 1
    with pytest.raises(TableError, match="the same numbers as another variant"):
        draw(small_course, [narrow], 2, 7)


def test_where_variants_leave_no_room_for_another_that_is_the_reason(small_course: Course) -> None:
    """Thousands may be refused for what they are: what stops a drawing is that it is full."""
    taken: list[int] = []

    def crowded(batch: Batch) -> Sifted:
        keep = np.zeros(len(batch.cases), dtype=np.bool_)
        for place in range(len(keep)):
            if len(taken) < 3 and batch.wanted[int(batch.cases[place])]:
                keep[place] = True
                taken.append(place)
        heavy = Refusal(message("too heavy"), 9 * len(keep))
        return Sifted(keep, (heavy, Refusal(TOO_NEAR, int((~keep).sum()))))

    with pytest.raises(TableError, match="8 variants are wanted, and after 3 there is no room"):
        draw(small_course, load_spaces(small_course), 8, 7, crowded)


def test_the_combinations_that_were_found_with_least_effort_come_first(
    small_course: Course,
) -> None:
    (space,) = load_spaces(small_course)

    def seldom(batch: Batch) -> Sifted:
        place = np.arange(len(batch.cases))
        keep = (batch.cases == 1) | (place % 40 == 0)
        return Sifted(keep, ())

    search = Search(small_course, space, seldom, np.random.default_rng(1))
    assert search.easiest() == []
    search.find({0: 30, 1: 30})
    assert search.easiest() == [1, 0]


def test_a_further_filter_sees_feasible_candidates_in_order(small_course: Course) -> None:
    sizes: list[int] = []

    def heavy(batch: Batch) -> Sifted:
        sizes.append(len(batch.cases))
        assert (np.diff(batch.cases) >= 0).all()
        assert all(wanted > 0 for wanted in batch.wanted.values())
        keep = batch.given["mass"] > 50
        return Sifted(keep, (Refusal(message("not heavy"), int((~keep).sum())),))

    drawn = draw(small_course, load_spaces(small_course), 20, 7, heavy)
    assert all(variant.given["mass"] > 50 for variant in drawn.variants)
    assert sizes
    (tally,) = drawn.tallies
    assert [str(refusal.what) for refusal in tally.set_aside] == ["not heavy"]
    assert tally.acceptance > sum(1 for _ in drawn.variants) / tally.tried


def test_numbers_are_spread_over_their_range(small_course: Course) -> None:
    variants = draw(small_course, load_spaces(small_course), 200, 7).variants
    masses = np.array([variant.given["mass"] for variant in variants])
    quarters = np.histogram(masses, bins=4, range=(10, 80))[0]
    assert quarters.min() > 0.1 * len(variants)


def test_the_reference_course_accepts_enough_of_what_is_tried(reference_course: Course) -> None:
    drawn = draw(reference_course, load_spaces(reference_course), 300, 7)
    assert len(drawn.variants) == 300
    for tally in drawn.tallies:
        # Three levers about one axis accept least: their links and fingers need room.
        assert tally.acceptance > 0.005, [f"{one.count} {one.what}" for one in tally.refusals[:3]]


def test_constraints_that_leave_nothing_together_are_told_with_what_each_refuses(
    small_with: Change,
) -> None:
    angle = '[[constraint]]\nformula = "angle <= 60"'
    few, many = (f'[[constraint]]\nformula = "teeth {one}"\n' for one in ("<= 17", ">= 20"))
    course = small_with(angle, f"{few}{many}{angle}")
    (problem, *_) = nothing_left(course, load_spaces(course))
    assert problem.file == "variants/spaces/press.toml"
    assert "teeth <= 17" in str(problem.what)
    assert "teeth >= 20" in str(problem.what)
    assert "loosen the constraints" in str(problem.remedy)


def test_a_space_that_can_be_drawn_from_has_no_problem(small_course: Course) -> None:
    assert not list(nothing_left(small_course, load_spaces(small_course)))
