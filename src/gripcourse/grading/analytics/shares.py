"""What every answer of a cohort earned, as one table: with consequences of mistakes, and without.

With them an answer that follows from an earlier mistake is not right either; without them it is.
"""

from collections.abc import Collection, Sequence
from typing import TYPE_CHECKING, Final, Protocol

from gripcourse.grading.model import Outcome

# pandas takes 400 ms to import.
# ruff: noqa: PLC0415

if TYPE_CHECKING:
    import pandas as pd

VIEWS: Final = ("with", "without")
"""The two columns of shares, named after consequences."""
FEWEST: Final = 8
"""Works from which on a correlation or a reliability is told; with fewer chance decides."""


class ScoredAnswer(Protocol):
    """What is asked of a judged answer; see `grading.model.Finding`."""

    @property
    def quantity(self) -> str: ...  # noqa: D102
    @property
    def section(self) -> str: ...  # noqa: D102
    @property
    def outcome(self) -> Outcome: ...  # noqa: D102
    @property
    def points(self) -> float: ...  # noqa: D102
    @property
    def max_points(self) -> float: ...  # noqa: D102
    @property
    def roots(self) -> tuple[str, ...]: ...  # noqa: D102
    @property
    def decision(self) -> object | None: ...  # noqa: D102


class ScoredWork(Protocol):
    """What is asked of a judged work; see `grading.model.Report`."""

    @property
    def scheme(self) -> str: ...  # noqa: D102
    @property
    def variant(self) -> str: ...  # noqa: D102
    @property
    def judged(self) -> bool: ...  # noqa: D102
    @property
    def findings(self) -> Collection[ScoredAnswer]: ...  # noqa: D102


def share_table(works: Sequence[ScoredWork]) -> "pd.DataFrame":
    """Return a row for each answer that has points and waits for nobody.

    The columns: `work` (its place), `scheme`, `variant`, `section`, `quantity`, `weight` (points
    that can be had), and the shares of them, 0…1, `with` and `without` consequences.
    """
    import pandas as pd

    columns = ["work", "scheme", "variant", "section", "quantity", "weight", *VIEWS]
    rows = [
        (place, work.scheme, work.variant, one.section, one.quantity, one.max_points, *_views(one))
        for place, work in enumerate(works)
        if work.judged
        for one in work.findings
        if one.max_points and not (one.outcome.traits.waits and one.decision is None)
    ]
    return pd.DataFrame(rows, columns=columns)


def score_table(shares: "pd.DataFrame") -> "pd.DataFrame":
    """Return for each work its scheme, its variant and its share of all points in both views."""
    earned = shares[["work", "scheme", "variant", "weight"]].copy()
    for view in VIEWS:
        earned[view] = shares[view] * shares["weight"]
    scores = earned.groupby(["work", "scheme", "variant"]).sum().reset_index()
    for view in VIEWS:
        scores[view] /= scores["weight"]
    return scores


def item_table(shares: "pd.DataFrame") -> "pd.DataFrame":
    """Return a row for each quantity: works, facility, and discrimination in both views.

    Facility is the mean share; discrimination the correlation of the share with that of all other
    points of the same work, empty below `FEWEST` works or where either does not vary.
    """
    import pandas as pd

    rows = []
    possible = shares.groupby("work")["weight"].transform("sum") - shares["weight"]
    table = shares.copy()
    for view in VIEWS:
        points = shares[view] * shares["weight"]
        others = points.groupby(shares["work"]).transform("sum") - points
        table[f"rest_{view}"] = others / possible.where(possible > 0)
    for (section, quantity), group in table.groupby(["section", "quantity"], sort=False):
        row = {"section": section, "quantity": quantity, "works": len(group)}
        row |= {f"facility_{view}": group[view].mean() for view in VIEWS}
        row |= {f"discrimination_{view}": _correlation(group, view) for view in VIEWS}
        rows.append(row)
    return pd.DataFrame(rows)


def _views(answer: ScoredAnswer) -> tuple[float, float]:
    share = answer.points / answer.max_points
    if not answer.outcome.traits.follows:
        return share, share
    return (0.0 if answer.roots else share), 1.0


def _correlation(group: "pd.DataFrame", view: str) -> float | None:
    if len(group) < FEWEST:
        return None
    pair = group[[view, f"rest_{view}"]].dropna()
    spread = pair.max() - pair.min()
    if len(pair) < FEWEST or (spread < 1e-9).any():  # noqa: PLR2004 (but for the last bits)
        return None
    return float(pair[view].corr(pair[f"rest_{view}"]))
