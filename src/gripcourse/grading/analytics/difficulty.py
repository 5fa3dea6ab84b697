"""Whether schemes, and variants of one scheme, were equally hard: the test of Kruskal and Wallis.

It compares ranks, so that scores need not be normal. It assumes that works do not depend on each
other and that chance decided who got what: else it tells the students of groups apart, not tasks.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

from gripcourse.grading.analytics.shares import VIEWS

# pandas and scipy take half a second to import.
# ruff: noqa: PLC0415

if TYPE_CHECKING:
    import pandas as pd

FEWEST_OF_GROUP: Final = 5
"""Works from which on a group takes part: the distribution of the test is told for such groups."""
_FEWEST_GROUPS = 2


@dataclass(frozen=True, slots=True)
class EqualDifficulty:
    """What the test says.

    Attributes:
        groups, works: that took part.
        statistic: H, with a correction for ties.
        p_value: how often chance alone makes equally hard groups differ as much.
        effect: epsilon squared, 0…1: the share of the spread of ranks that the groups explain.
    """

    groups: int
    works: int
    statistic: float
    p_value: float
    effect: float


def equally_hard(scores: "pd.Series", groups: "pd.Series") -> EqualDifficulty | None:
    """Test whether the groups of scores differ by more than chance.

    Args:
        scores: of each work.
        groups: the group of each work.

    Returns:
        None where fewer than two groups are large enough, or all scores are the same.
    """
    large = [one for _, one in scores.groupby(groups) if len(one) >= FEWEST_OF_GROUP]
    works = sum(map(len, large))
    if len(large) < _FEWEST_GROUPS or len({value for one in large for value in one}) == 1:
        return None
    from scipy.stats import kruskal

    found = kruskal(*large)
    statistic = float(found.statistic)
    return EqualDifficulty(
        len(large), works, statistic, float(found.pvalue), statistic / (works - 1)
    )


def difficulty_table(scores: "pd.DataFrame") -> "pd.DataFrame":
    """Return the test for all schemes, and for the variants of each scheme where they can be told.

    Args:
        scores: see `score_table`.

    Returns:
        Columns `compared` (schemes, or variants), `scheme` (empty for all), `view`, and the numbers
        of `EqualDifficulty`.
    """
    import pandas as pd

    columns = ["compared", "scheme", "view", "groups", "works", "H", "p_value", "effect"]
    return pd.DataFrame(list(_rows(scores)), columns=columns)


def _rows(scores: "pd.DataFrame") -> Iterator[Mapping[str, Any]]:
    asked = [("schemes", "", scores, "scheme")]
    asked += [
        ("variants", str(scheme), group, "variant") for scheme, group in scores.groupby("scheme")
    ]
    for compared, scheme, group, column in asked:
        for view in VIEWS:
            found = equally_hard(group[view], group[column])
            if found is not None:
                yield {
                    "compared": compared,
                    "scheme": scheme,
                    "view": view,
                    "groups": found.groups,
                    "works": found.works,
                    "H": found.statistic,
                    "p_value": found.p_value,
                    "effect": found.effect,
                }
