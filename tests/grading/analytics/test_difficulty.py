"""The test of equal difficulty, against the example of who published it."""

import numpy as np
import pandas as pd
import pytest

from gripcourse.grading.analytics import difficulty
from gripcourse.grading.analytics.difficulty import difficulty_table, equally_hard

# W. H. Kruskal, W. A. Wallis, Use of ranks in one-criterion variance analysis, Journal of the
# American Statistical Association 47 (1952), 583-621: daily output of three machines, H = 5.656.
MACHINES = {"a": (340, 345, 330, 342, 338), "b": (339, 333, 344), "c": (347, 343, 349, 355)}


def test_the_statistic_is_that_of_the_published_example(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(difficulty, "FEWEST_OF_GROUP", 3)
    pairs = [(name, float(one)) for name, all_ in MACHINES.items() for one in all_]
    names, output = zip(*pairs, strict=True)
    found = equally_hard(pd.Series(output), pd.Series(names))
    assert found is not None
    assert found.statistic == pytest.approx(5.656, abs=0.0005)
    assert (found.groups, found.works) == (3, 12)
    # Chi squared with two degrees of freedom is an exponential distribution.
    assert found.p_value == pytest.approx(np.exp(-found.statistic / 2))
    assert found.effect == pytest.approx(found.statistic / 11)


def test_chance_alone_is_called_unlikely_as_often_as_it_says() -> None:
    """Scores are dealt out to schemes anew: what depends on nothing must not be found often."""
    draw = np.random.default_rng(26063)
    scores, schemes = pd.Series(draw.beta(5, 2, 40)), pd.Series(list("abcd") * 10)
    found = [equally_hard(scores, pd.Series(draw.permutation(schemes))) for _ in range(300)]
    share = np.mean([one is not None and one.p_value < 0.1 for one in found])
    assert 0.04 < share < 0.16


def test_a_hard_scheme_is_found_and_small_groups_take_no_part() -> None:
    scores = pd.DataFrame({
        "scheme": ["easy"] * 6 + ["hard"] * 6 + ["rare"] * 2,
        "variant": [f"{number}" for number in range(14)],
        "with": [0.9, 0.95, 1.0, 0.97, 0.92, 0.99, 0.4, 0.5, 0.3, 0.45, 0.55, 0.35, 0.0, 0.0],
        "without": [1.0] * 14,
    })  # fmt: skip
    table = difficulty_table(scores)
    (row,) = table.to_dict("records")
    assert (row["compared"], row["view"], row["groups"], row["works"]) == (
        "schemes",
        "with",
        2,
        12,
    )
    assert row["p_value"] < 0.01


def test_variants_are_compared_where_enough_students_had_them() -> None:
    scores = pd.DataFrame({
        "scheme": ["one"] * 10,
        "variant": ["1"] * 5 + ["2"] * 5,
        "with": np.linspace(0, 1, 10),
        "without": np.linspace(0, 1, 10),
    })  # fmt: skip
    assert list(difficulty_table(scores)["compared"]) == ["variants", "variants"]
