"""How reliable a score is: Cronbach's alpha.

Works of different schemes answer different quantities. So all works are compared by the points of
their sections, and the works of one scheme by the points of the quantities that all of them have;
an item has the same points in all works, so that variants do not tell works apart.
"""

from typing import TYPE_CHECKING, Any

from gripcourse.grading.analytics.shares import FEWEST, VIEWS

# pandas takes 400 ms to import.
# ruff: noqa: PLC0415

if TYPE_CHECKING:
    import pandas as pd

_FEWEST_ITEMS = 2
_NO_SPREAD = 1e-12


def alpha(points: "pd.DataFrame") -> float | None:
    """Return Cronbach's alpha of a table of points, a row for each work, a column for each item.

    None for fewer than `FEWEST` works or two items, or where all works earned the same. Alpha is a
    lower bound of reliability where the errors of items do not depend on each other.
    """
    works, items = points.shape
    total = float(points.sum(axis="columns").var())
    if works < FEWEST or items < _FEWEST_ITEMS or total < _NO_SPREAD:
        return None
    return items / (items - 1) * (1 - float(points.var().sum()) / total)


def reliability_table(shares: "pd.DataFrame") -> "pd.DataFrame":
    """Return alpha for all works over sections, then for each scheme over its quantities.

    Args:
        shares: see `share_table`.

    Returns:
        Columns `scheme` (empty for all), `items` (sections or quantities), `works`, `count` of
        items, `alpha_with` and `alpha_without` consequences.
    """
    import pandas as pd

    rows = [_row("", "section", shares)]
    rows += [_row(str(scheme), "quantity", group) for scheme, group in shares.groupby("scheme")]
    return pd.DataFrame(rows)


def _row(scheme: str, item: str, shares: "pd.DataFrame") -> dict[str, Any]:
    tables = [_points(shares, item, view) for view in VIEWS]
    found = {f"alpha_{view}": alpha(one) for view, one in zip(VIEWS, tables, strict=True)}
    works, count = tables[0].shape
    named = {"section": "sections", "quantity": "quantities"}[item]
    return {"scheme": scheme, "items": named, "works": works, "count": count, **found}


def _points(shares: "pd.DataFrame", item: str, view: str) -> "pd.DataFrame":
    """Return the points of each work in each item that all of them have.

    How many points an item has depends on the variant, and on what waits for a person: by them
    alone works that are all right would differ. So an item counts in all of them with its mean.
    """
    points = shares[["work", item, "weight"]].assign(earned=shares[view] * shares["weight"])
    earned, possible = (
        points.pivot_table(index="work", columns=item, values=one, aggfunc="sum")
        for one in ("earned", "weight")
    )
    # An item that is worth nothing in some work is none that all of them have.
    return (earned / possible * possible.mean()).dropna(axis="columns")
