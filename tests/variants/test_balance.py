"""Of many sound candidates those are drawn that let what has two outcomes come out either way."""

import numpy as np

from gripcourse.variants.balance import Balance, Outcomes, choose
from gripcourse.variants.feasible import Array


def outcomes_of(marks: Array, sizes: tuple[bool, ...], weights: tuple[float, ...]) -> Outcomes:
    names = tuple((f"q{n}", "14") if size else (f"q{n}",) for n, size in enumerate(sizes))
    return Outcomes(names, np.array(weights), np.array(sizes), np.asarray(marks, np.float64))


def test_a_rare_outcome_comes_out_as_often_as_the_other() -> None:
    marks = np.where(np.arange(100) % 10 == 0, 1.0, -1.0)[:, None]
    chosen = choose(outcomes_of(marks, (False,), (1.0,)), np.zeros(1), {0: range(100)}, {0: 12})
    assert len(set(chosen)) == 12
    assert marks[chosen].sum() == 0


def test_what_was_drawn_before_is_made_up_for() -> None:
    marks = np.array([1.0, -1.0] * 20)[:, None]
    outcomes = outcomes_of(marks, (False,), (1.0,))
    balance = Balance()
    for _ in range(4):
        balance.count("press", outcomes, 0)
    ahead = balance.of("press", outcomes)
    assert ahead.tolist() == [4]
    assert balance.of("another", outcomes).tolist() == [0]
    chosen = choose(outcomes, ahead, {0: range(40)}, {0: 6})
    assert marks[chosen].sum() == -4


def test_two_outcomes_that_pull_against_each_other_are_both_kept_near_the_middle() -> None:
    rng = np.random.default_rng(7)
    first = np.where(rng.random(300) < 0.2, 1.0, -1.0)
    second = np.where(rng.random(300) < 0.5, -first, np.where(rng.random(300) < 0.2, 1.0, -1.0))
    marks = np.column_stack([first, second])
    both = outcomes_of(marks, (False, False), (1, 1))
    chosen = choose(both, np.zeros(2), {0: range(300)}, {0: 40})
    assert (np.abs(marks[chosen].sum(axis=0)) <= 2).all()


def test_a_size_is_unwelcome_only_where_more_than_half_have_it() -> None:
    marks = np.array([1.0] * 8 + [-1.0] * 8)[:, None]
    outcomes = outcomes_of(marks, (True,), (0.5,))
    balance = Balance()
    for place in (0, 8, 9, 10):
        balance.count("press", outcomes, place)
    assert balance.of("press", outcomes).tolist() == [1]
    drawn = choose(outcomes, np.array([-6.0]), {0: range(16)}, {0: 4})
    assert len(drawn) == 4  # whichever: nothing is gained by fewer than half
    most = choose(outcomes, np.zeros(1), {0: range(16)}, {0: 8})
    assert marks[most].sum() <= 0


def test_each_combination_gets_its_own_candidates_as_far_as_there_are_any() -> None:
    marks = np.array([1.0, 1.0, 1.0, -1.0, -1.0])[:, None]
    waiting = {3: [0, 1], 5: [2, 3, 4]}
    chosen = choose(outcomes_of(marks, (False,), (1.0,)), np.zeros(1), waiting, {3: 4, 5: 2})
    assert sorted(set(chosen) & {0, 1}) == [0, 1]
    assert sorted(set(chosen) & {2, 3, 4}) == [3, 4]


def test_of_equally_good_candidates_the_first_is_taken_however_sums_are_rounded() -> None:
    marks = np.array([[1.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    weights = (0.1, 0.2, 0.3)
    assert weights[0] + weights[1] > weights[2]  # by the last place
    for some in (marks, marks[:, ::-1]):
        outcomes = outcomes_of(some, (False,) * 3, weights if some is marks else weights[::-1])
        assert choose(outcomes, np.zeros(3), {0: range(2)}, {0: 1}) == [0]
