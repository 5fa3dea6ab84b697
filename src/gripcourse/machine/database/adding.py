"""Adding many rows: as the driver takes them, where the library would change nothing in them."""

from collections.abc import Iterable, Mapping
from itertools import islice
from operator import itemgetter
from typing import Final

from sqlalchemy import Connection, Double, Integer, String, Table, insert

_AT_ONCE: Final = 500  # rows
# Of which every driver takes Python's own values; a moment is another thing in each database.
_AS_THEY_ARE: Final = frozenset({String, Integer, Double})


def add_many(connection: Connection, table: Table, rows: Iterable[Mapping[str, object]]) -> None:
    """Add rows to a table, some hundred at a time.

    The library looks at each value of each row once more, which takes as long as the database does
    for them. A table of which every column goes to the driver as it is has no need of that.

    Args:
        connection: in a transaction.
        table: where to.
        rows: values by column, each with all columns of the table.
    """
    left = iter(rows)
    statement = insert(table).compile(dialect=connection.dialect)
    as_they_are = all(type(column.type) in _AS_THEY_ARE for column in table.columns)
    ordered = itemgetter(*(statement.positiontup or ("",)))
    while portion := list(islice(left, _AT_ONCE)):
        if not as_they_are:
            connection.execute(insert(table), portion)
        elif statement.positional:
            connection.exec_driver_sql(str(statement), [ordered(row) for row in portion])
        else:
            connection.exec_driver_sql(str(statement), portion)
