"""Tables from version to version: what a database holds, and bringing it up to this program.

The revisions are Alembic's. All of them that a database lacks run in one transaction: a program
that is killed on the way leaves the database as it was.
"""

from threading import Lock
from typing import Final

from sqlalchemy import Connection, inspect, text

REVISIONS: Final = ("1", "2", "3", "4", "5", "6", "7", "8", "9", "10")
"""All that this program knows, oldest first; a module for each stands in `migrations.versions`."""

NEWEST: Final = REVISIONS[-1]
VERSION_TABLE: Final = "gripcourse_revision"

# What the first version wrote in place of a revision.
_FORMAT_TABLE = "gradebook_format"

# The library holds what it works on in names of a module: two threads would take each other's.
_BRINGING_UP: Final = Lock()


def revision_of(connection: Connection) -> str | None:
    """Return the revision of a database, known to this program or not; None without any tables."""
    tables = inspect(connection)
    for table, column in ((VERSION_TABLE, "version_num"), (_FORMAT_TABLE, "version")):
        if tables.has_table(table):
            question = text(f"SELECT {column} FROM {table}")  # noqa: S608 (two constants)
            found = connection.execute(question).scalars().all()
            return ", ".join(map(str, found)) or None
    return None


def bring_up(connection: Connection, found: str | None, to: str = NEWEST) -> None:
    """Run the revisions that a database lacks, in the transaction of the connection.

    Args:
        connection: in a transaction that changes something.
        found: the revision that is there; None where there are no tables.
        to: the revision that is wanted.
    """
    from alembic import command  # noqa: PLC0415 (150 ms, and rarely needed)
    from alembic.config import Config  # noqa: PLC0415 (as above)

    config = Config()
    config.set_main_option("script_location", f"{__package__}:migrations")
    config.attributes["connection"] = connection
    with _BRINGING_UP:
        if found is not None and not inspect(connection).has_table(VERSION_TABLE):
            command.stamp(config, found)
        command.upgrade(config, to)
