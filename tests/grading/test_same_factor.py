"""A wrong factor without a name costs once where formulas are alike, and by chance hardly ever."""

from typing import TYPE_CHECKING

import numpy as np
import pytest

from gripcourse.grading.model import Outcome

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Mapping

    from conftest import Case
    from gripcourse.submission.model import Answer

    Typed = Callable[[str, float, int], Answer]

ENDS = ("cylinder_span_open", "cylinder_span_at_min")
NO_METHOD = 0.3717  # times the right number: no wrong method comes to it


@pytest.fixture(scope="session")
def two_ends(drawn: "tuple[Case, ...]") -> "tuple[Case, ...]":
    """Variants of a cylinder whose length is asked for at both ends of its stroke."""
    return tuple(one for one in drawn if set(ENDS) <= one.answers.keys())


def judged(case: "Case", wrong: "Mapping[str, Answer]") -> "Iterator[tuple[str, Outcome]]":
    """What is said of both ends, in a work that goes on with the wrong ones."""
    follows = case.following(**{name: one.value or 0.0 for name, one in wrong.items()})
    found = case.findings({**follows, **wrong})
    yield from ((name, found[name].outcome) for name in ENDS)


def test_one_factor_at_both_ends_costs_once(two_ends: "tuple[Case, ...]", typed: "Typed") -> None:
    assert two_ends
    for case in two_ends:
        wrong = {name: typed(name, NO_METHOD * case.reference[name], 5) for name in ENDS}
        outcomes = [one for _, one in judged(case, wrong)]
        assert outcomes == [Outcome.WRONG, Outcome.CARRIED], case.label


def test_two_factors_cost_twice(two_ends: "tuple[Case, ...]", typed: "Typed") -> None:
    case = two_ends[0]
    wrong = {
        name: typed(name, factor * case.reference[name], 5)
        for name, factor in zip(ENDS, (NO_METHOD, 1.03 * NO_METHOD), strict=True)
    }
    assert [one for _, one in judged(case, wrong)] == [Outcome.WRONG, Outcome.WRONG]


def test_few_figures_do_not_tell_one_factor(two_ends: "tuple[Case, ...]", typed: "Typed") -> None:
    case = two_ends[0]
    wrong = {name: typed(name, NO_METHOD * case.reference[name], 2) for name in ENDS}
    assert Outcome.CARRIED not in [one for _, one in judged(case, wrong)]


def test_two_mistakes_are_hardly_ever_taken_for_one(
    two_ends: "tuple[Case, ...]", typed: "Typed"
) -> None:
    """Numbers that are wrong for two reasons are as many times the right ones by chance only."""
    random = np.random.default_rng(20261129)
    taken = total = 0
    for case in two_ends:
        for _ in range(40):
            factors = np.exp(random.normal(size=2))
            wrong = {
                name: typed(name, float(factor) * case.reference[name], 4)
                for name, factor in zip(ENDS, factors, strict=True)
            }
            outcomes = [one for _, one in judged(case, wrong)]
            total += outcomes[0] is Outcome.WRONG
            taken += outcomes == [Outcome.WRONG, Outcome.CARRIED]
    assert total > 50
    assert taken <= 0.02 * total
