"""Rows that are kept of who comes in, as values of the model."""

from collections.abc import Mapping
from typing import Any

from gripcourse.machine.database.moments import in_utc


def values_of(row: Mapping[Any, Any], *left_out: str) -> dict[str, Any]:
    """Return what a value of the model is made of.

    Args:
        row: with its moment in the column `at`.
        left_out: columns that the value does not have.
    """
    kept = {name: value for name, value in row.items() if name not in left_out}
    return {**kept, "at": in_utc(kept["at"])}
