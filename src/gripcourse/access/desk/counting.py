"""Counting what a student did, in the transaction that adds one more: servers count together."""

from collections.abc import Callable, Mapping, Sequence
from datetime import datetime, timedelta
from typing import Any, TypeAlias

from sqlalchemy import ColumnElement, Connection, Table, func, select

from gripcourse.access.desk import schema
from gripcourse.access.desk.model import Allowance, TooOftenError

Complete: TypeAlias = Callable[[Connection, Sequence[ColumnElement[bool]]], Mapping[str, Any]]
"""Counts the rows of the same student, and returns columns of the one that is to be added."""


def refuse_too_many(
    connection: Connection,
    table: Table,
    same: Sequence[ColumnElement[bool]],
    now: datetime,
    allowed: Allowance,
) -> None:
    """Refuse one more where there are as many as are allowed about a time.

    Raises:
        TooOftenError: there are.
    """
    # Either way in time: another server's clock, or its request before ours, may be ahead.
    span = timedelta(seconds=allowed.seconds)
    about_now = (table.c.at > now - span, table.c.at < now + span)
    question = select(func.count()).select_from(table).where(*same, *about_now)
    if connection.execute(question).scalar_one() >= allowed.times:
        raise TooOftenError


def ration(
    connection: Connection, same: Sequence[ColumnElement[bool]], *, most: int
) -> Mapping[str, Any]:
    """Let a self-check tell more than the reading where that was done less often than it may be."""
    table = schema.checks
    question = select(func.count()).select_from(table).where(*same, table.c.told)
    told = connection.execute(question).scalar_one()
    return {"told": told < most, "left": max(0, most - told - 1)}
