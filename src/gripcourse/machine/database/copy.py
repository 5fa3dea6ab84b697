"""All rows of a database as text, and back into a database of either kind.

A row is a JSON list, a table has one row a line, in the order of its key: the same rows are the
same bytes, whatever database they come from.
"""

import json
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from datetime import datetime
from typing import Any, Final

from sqlalchemy import Column, Connection, DateTime, Engine, MetaData, Table, func, insert, select

from gripcourse.machine.database.storable import in_code_order

OURS: Final = ("gradebook_", "register_", "desk_", "lti_")
"""How the names of all our tables begin; there may be others' in the same database."""

# Who is signed in is no part of a term, and the other two say which program made the tables.
_LEFT_OUT: Final = ("desk_sign_in", "desk_session", "desk_sign_out", "gradebook_format")
_AT_ONCE: Final = 500  # rows


@contextmanager
def standing_still(engine: Engine) -> Iterator[Connection]:
    """Open a transaction that reads one state of the database, whatever is written meanwhile."""
    if engine.dialect.name == "postgresql":
        engine = engine.execution_options(isolation_level="REPEATABLE READ")
    with engine.connect() as connection, connection.begin():
        if engine.dialect.name == "sqlite":
            connection.exec_driver_sql("BEGIN")
        yield connection


def our_tables(connection: Connection) -> tuple[Table, ...]:
    """Return the tables with what a term leaves, each after those that it refers to."""
    found = MetaData()
    found.reflect(connection, only=lambda name, _: name.startswith(OURS) and name not in _LEFT_OUT)
    return tuple(found.sorted_tables)


def lines_of(connection: Connection, table: Table) -> Iterator[bytes]:
    """Yield the names of the columns, then the rows of a table."""
    yield _line([column.name for column in table.columns])
    key = in_code_order(connection.engine, *table.primary_key.columns)
    question = select(table).order_by(*key)
    with connection.execute(question, execution_options={"yield_per": _AT_ONCE}) as streamed:
        for row in streamed:
            yield _line([one.isoformat() if isinstance(one, datetime) else one for one in row])


def add_lines(connection: Connection, table: Table, lines: Iterable[bytes]) -> None:
    """Add the rows that `lines_of` wrote.

    Raises:
        ValueError, TypeError, KeyError: they are not as it writes them.
    """
    columns: list[Column[Any]] = []
    rows: list[dict[str, object]] = []
    for line in lines:
        values = json.loads(line)
        if not isinstance(values, list):
            raise TypeError(f"{values!r} is no row")
        if not columns:
            columns = [table.c[name] for name in values]
            continue
        pairs = zip(columns, values, strict=True)
        rows.append({column.name: _value(column, one) for column, one in pairs})
        if len(rows) == _AT_ONCE:
            connection.execute(insert(table), rows)
            rows = []
    if rows:
        connection.execute(insert(table), rows)


def holds_anything(connection: Connection) -> bool:
    """Tell whether any of our tables has a row."""
    counts = (
        connection.execute(select(func.count()).select_from(table)).scalar_one()
        for table in our_tables(connection)
    )
    return any(counts)


def _value(column: Column[Any], written: object) -> object:
    if isinstance(column.type, DateTime) and written is not None:
        return datetime.fromisoformat(str(written))
    return written


def _line(values: list[object] | list[str]) -> bytes:
    return json.dumps(values, ensure_ascii=False, allow_nan=False).encode() + b"\n"
