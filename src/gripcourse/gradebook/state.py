"""What a database says that decides over grades, as a digest: the same digest, the same grades."""

import hashlib
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import datetime
from typing import Any, Final

from sqlalchemy import Connection, Row, Table, select

from gripcourse.gradebook import schema
from gripcourse.issuing.schema import issued, persons, withdrawals
from gripcourse.machine.database.home import exists
from gripcourse.machine.database.moments import stored
from gripcourse.machine.database.opening import open_engine, refusals_named, without_password

# Results are kept in one transaction with their attempt and never changed: its row stands for them.
_DECIDE: Final = (
    issued,
    persons,
    withdrawals,
    schema.attempts,
    schema.marks,
    schema.mark_lines,
    schema.regrades,
    schema.publications,
    schema.waivers,
    schema.words,
)
_AT_ONCE: Final = 500  # rows


@dataclass(frozen=True, slots=True)
class DatabaseState:
    """Digests of what a database says.

    Attributes:
        whole: of all.
        others: of all but what a batch of one moment keeps.
    """

    whole: str
    others: str


def state_of(place: str, moment: datetime) -> DatabaseState:
    """Digest a database, as far as it decides over grades.

    Args:
        place: a path or a database URL; what is not there says what an empty one says.
        moment: attempts that were graded just then, and what was said then of whose files are, are
            left out of `others`.

    Raises:
        GradebookError: the database cannot be used.
    """
    at = stored(moment)
    whole, others = hashlib.sha256(), hashlib.sha256()
    if exists(place):
        engine = open_engine(place)
        with refusals_named(without_password(engine.url)), engine.connect() as connection:
            for table, row in _rows(connection):
                told = f"{table.name}{tuple(row)!r}".encode()
                whole.update(told)
                if not _is_of(table, row, at):
                    others.update(told)
    return DatabaseState(whole.hexdigest(), others.hexdigest())


def _rows(connection: Connection) -> Iterator[tuple[Table, Row[Any]]]:
    for table in _DECIDE:
        question = select(table).order_by(*table.primary_key.columns)
        with connection.execute(question, execution_options={"yield_per": _AT_ONCE}) as rows:
            for row in rows:
                yield table, row


def _is_of(table: Table, row: Row[Any], at: datetime) -> bool:
    """Tell whether a row is what a batch of some moment keeps."""
    if table is schema.attempts:
        return bool(row.graded_at == at)
    return table is schema.words and bool(row.said_at == at)
