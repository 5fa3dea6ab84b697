"""Opening a database: a file by default, any database by its URL.

What is not there yet is made; what an earlier program made is brought up, with a copy kept beside.
Two programs may try either at once: one does it, the other finds it done.
"""

import os
import re
import sqlite3
from collections.abc import Iterator
from contextlib import closing, contextmanager
from functools import lru_cache
from pathlib import Path
from typing import Any, Final

from sqlalchemy import Connection, Engine, create_engine, event
from sqlalchemy.engine import URL, make_url
from sqlalchemy.exc import ArgumentError, DBAPIError, NoSuchModuleError
from sqlalchemy.pool import NullPool, StaticPool

from gripcourse.errors import NextStep
from gripcourse.machine.database.migrate import NEWEST, REVISIONS, bring_up, revision_of
from gripcourse.machine.database.option_values import refuse_values
from gripcourse.machine.database.said import (
    another_was_faster,
    failure,
    refusals_named,
    unusable,
    without_password,
    wrong_options,
)
from gripcourse.machine.database.storable import storable
from gripcourse.machine.files import make_private, make_private_folder, making, replacing
from gripcourse.text.words import message

__all__ = [
    "another_was_faster",
    "demand_writing",
    "engine_of",
    "open_engine",
    "refusals_named",
    "without_password",
    "writing",
]

_SECONDS_TO_WAIT: Final = 60  # for another program that writes to the same database
_SECONDS_TO_CONNECT: Final = 10
_TRIES = 5
_POSTGRESQL: Final = "postgresql"
_PLUGIN: Final = "plugin"  # an option of SQLAlchemy's own


def open_engine(place: str) -> Engine:
    """Open a database; make it where there is none yet, bring it up where it is an old one.

    Args:
        place: path of a file, or a database URL such as `postgresql+psycopg://user@host/name`.

    Raises:
        GradebookError: it cannot be opened, is no gradebook, or is one of a later program.
    """
    url = _url(place)
    file = _file_of(url)
    if file is not None:
        if "://" not in place:
            make_private_folder(file.parent)
        if not file.exists():
            _make(file)
        _refuse_empty(file)
    engine = _connected(url)
    with refusals_named(without_password(url)):
        _bring_up(engine, file)
    return engine


def engine_of(place: str) -> Engine:
    """Return the engine of a place as it is: nothing is made, nothing brought up.

    Raises:
        GradebookError: the place is none, or its driver is missing.
    """
    return _connected(_url(place))


@contextmanager
def writing(engine: Engine) -> Iterator[Connection]:
    """Open a transaction that changes something: kept whole, or not at all where it fails.

    One program writes at a time, and sees what all before it have written. SQLite is asked for that
    at once: a reader that wants to write later can be refused without waiting. PostgreSQL lets all
    write at once, and what is read before another commits is not looked at again: a lock of our
    own is taken, which the end of the transaction gives back.
    """
    with engine.begin() as connection:
        if engine.dialect.name == "sqlite":
            connection.exec_driver_sql("BEGIN IMMEDIATE")
        elif engine.dialect.name == _POSTGRESQL:
            connection.exec_driver_sql("SELECT pg_advisory_xact_lock(hashtext('gripcourse'))")
        yield connection


def demand_writing(engine: Engine) -> None:
    """Refuse a database that can only be read, before anybody works for what shall be kept there.

    Raises:
        GradebookError: nothing can be written to it.
    """
    place = without_password(engine.url)
    with refusals_named(place), engine.connect() as connection:
        if engine.dialect.name == "sqlite":
            connection.exec_driver_sql("BEGIN IMMEDIATE")
            # To change anything takes a file beside it, in a folder that may be protected. It is
            # taken back when the connection ends.
            connection.exec_driver_sql("PRAGMA user_version = 0")


def _url(place: str) -> URL:
    if "://" not in place:
        return URL.create("sqlite", database=place)
    try:
        # Other programs write the first word so.
        url = make_url(re.sub(r"^postgres(?=://)", _POSTGRESQL, place))
    except (ArgumentError, ValueError) as fault:
        # Not shown: whatever it is, a password may be in it.
        raise failure(
            place.partition("://")[0] + "://…",
            message("This is no URL of a database."),
            message("Write the path of a file, or a URL like postgresql+psycopg://user@host/name."),
        ) from fault
    _refuse_options(url)
    return url


def _refuse_options(url: URL) -> None:
    """Refuse what a file of a gradebook does not heed, and what would load other programs."""
    refused = [one for one in url.query if one == _PLUGIN or url.get_backend_name() == "sqlite"]
    if refused:
        raise wrong_options(without_password(url), f'invalid connection option "{refused[0]}"')
    if url.get_backend_name() == _POSTGRESQL:
        refuse_values(url)


def _file_of(url: URL) -> Path | None:
    return Path(url.database) if url.get_backend_name() == "sqlite" and url.database else None


def _connected(url: URL) -> Engine:
    if url.get_backend_name() == "sqlite":
        # Its driver gives up after five seconds otherwise, and would commit each table it makes.
        arguments = {"timeout": _SECONDS_TO_WAIT, "isolation_level": None}
        return _cleaning(create_engine(url, poolclass=NullPool, connect_args=arguments))
    try:
        return _patient(_cleaning(create_engine(url, poolclass=NullPool, **_options(url))))
    except (NoSuchModuleError, ModuleNotFoundError) as fault:
        raise failure(
            without_password(url),
            message("The driver of this database is not installed: {fault}.", fault=str(fault)),
            message("Install gripcourse with its extra 'postgresql', or name another gradebook."),
            NextStep.NAME_GRADEBOOK,
        ) from fault


def _options(url: URL) -> dict[str, Any]:
    """Return how PostgreSQL is asked, whatever the server and the environment are set to."""
    if url.get_backend_name() != _POSTGRESQL:
        return {}
    arguments: dict[str, object] = {"client_encoding": "utf8"}
    if "connect_timeout" not in url.query:
        arguments["connect_timeout"] = _SECONDS_TO_CONNECT
    # A transaction that waited for another must see what that one wrote.
    return {"connect_args": arguments, "isolation_level": "READ COMMITTED"}


def _cleaning(engine: Engine) -> Engine:
    """Let every text that is written be one that every database keeps."""

    @event.listens_for(engine, "before_cursor_execute", retval=True)
    def clean(
        _connection: Connection,
        _cursor: object,
        statement: str,
        parameters: Any,  # noqa: ANN401 (as the driver wants them)
        _context: object,
        _many: bool,  # noqa: FBT001 (as the library calls it)
    ) -> tuple[str, Any]:
        return statement, storable(parameters)

    return engine


def _patient(engine: Engine) -> Engine:
    """Let nothing wait for ever, a reader neither: who locks a table may have gone to lunch."""
    if engine.dialect.name == _POSTGRESQL:

        @event.listens_for(engine, "begin")
        def wait_no_longer(connection: Connection) -> None:
            connection.exec_driver_sql(f"SET LOCAL lock_timeout = '{_SECONDS_TO_WAIT}s'")

    return engine


def _make(file: Path) -> None:
    """Make a file that only its owner may read, for marks have names on them; whole or not."""
    try:
        with making(file) as temporary, refusals_named(str(file)):
            make_private(temporary)
            with temporary.open("r+b") as stream:
                stream.write(_empty())
                stream.flush()
                os.fsync(stream.fileno())
    except OSError as fault:
        raise unusable(str(file), fault.strerror or str(fault)) from fault


@lru_cache(maxsize=1)
def _empty() -> bytes:
    """Return the content of a new database: running all revisions takes longer than copying it."""
    with closing(sqlite3.connect(":memory:", isolation_level=None)) as memory:
        engine = create_engine("sqlite://", creator=lambda: memory, poolclass=StaticPool)
        with writing(engine) as connection:
            bring_up(connection, None)
        return bytes(memory.serialize())


def _refuse_empty(file: Path) -> None:
    """Refuse a file that lost its content: an empty gradebook looks as if nobody had a mark."""
    if file.stat().st_size == 0:
        raise failure(
            str(file),
            message("The gradebook is empty: a file of 0 bytes, which this program never makes."),
            message("Restore it from a backup; if nothing was ever kept in it, remove the file."),
        )


def _bring_up(engine: Engine, file: Path | None) -> None:
    """Run the revisions that are missing; `file` is copied first where it holds anything."""
    for attempt in range(1, _TRIES + 1):
        with engine.connect() as connection:
            _refuse_encoding(connection)
            if _known(engine, revision_of(connection)) == NEWEST:
                return
        try:
            with writing(engine) as connection:
                # Another program may have been faster: only who may write can tell.
                found = _known(engine, revision_of(connection))
                if found == NEWEST:
                    return
                if found is not None and file is not None:
                    _keep_copy(file)
                bring_up(connection, found)
        except DBAPIError:
            # Another program does it at the same time, or this one may not.
            if attempt == _TRIES:
                raise


def _refuse_encoding(connection: Connection) -> None:
    """Refuse a database that cannot hold the names of all students."""
    if connection.dialect.name != _POSTGRESQL:
        return
    encoding = connection.exec_driver_sql("SHOW server_encoding").scalar_one()
    if encoding != "UTF8":
        raise failure(
            without_password(connection.engine.url),
            message("The database keeps its texts as {encoding}.", encoding=str(encoding)),
            message("Make one that keeps UTF-8, from the template template0."),
        )


def _known(engine: Engine, found: str | None) -> str | None:
    if found is None or found in REVISIONS:
        return found
    raise failure(
        without_password(engine.url),
        message(
            "The gradebook has the format {found}, this program knows {known}.",
            found=found,
            known=NEWEST,
        ),
        message("Use the version of the program that wrote it, or a later one."),
    )


def _keep_copy(file: Path) -> None:
    """Copy a database beside itself, named by the revision that it is brought up to.

    SQLite itself copies: who opens and closes the file besides it takes its locks away.
    """
    with replacing(file.with_name(f"{file.name}.before-{NEWEST}")) as temporary:
        make_private(temporary)
        source = f"{file.absolute().as_uri()}?mode=ro"
        with (
            closing(sqlite3.connect(source, uri=True)) as old,
            closing(sqlite3.connect(temporary)) as copy,
        ):
            old.backup(copy)
