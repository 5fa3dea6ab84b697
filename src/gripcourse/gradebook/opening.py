"""Opening a gradebook: a file by default, any database by its URL.

The tables are made on first use. Two programs may try that at once: one makes them, the other finds
them made.
"""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from sqlalchemy import Connection, Engine, create_engine, insert, inspect, select
from sqlalchemy.engine import URL, make_url
from sqlalchemy.exc import ArgumentError, DBAPIError, NoSuchModuleError, SQLAlchemyError
from sqlalchemy.pool import NullPool

from gripcourse.errors import GradebookError, NextStep, Problem
from gripcourse.gradebook.schema import VERSION, format_table, metadata
from gripcourse.text.words import Message, message

_PRIVATE = 0o600
_SECONDS_TO_WAIT = 60.0  # for another program that writes to the same file
_TRIES = 5


def gradebook_path(root: Path) -> Path:
    """Return where a course keeps its gradebook: beside its register."""
    return root / "private" / "gradebook.sqlite"


def exists(place: str) -> bool:
    """Tell whether there may be a gradebook: a file is looked for, a database is believed."""
    return "://" in place or Path(place).is_file()


def open_engine(place: str) -> Engine:
    """Open a gradebook and make its tables where there are none yet.

    Args:
        place: path of a file, or a database URL such as `postgresql+psycopg://user@host/name`.

    Raises:
        GradebookError: it cannot be opened, is no gradebook, or is one of another version.
    """
    url = _url(place)
    if url.get_backend_name() == "sqlite" and url.database and "://" not in place:
        _make_private(Path(url.database))
    try:
        engine = _engine(url)
    except (NoSuchModuleError, ModuleNotFoundError) as fault:
        raise _failure(
            without_password(url),
            message("The driver of this database is not installed: {fault}.", fault=str(fault)),
            message("Install it, for example psycopg for PostgreSQL, or name another gradebook."),
            NextStep.NAME_GRADEBOOK,
        ) from fault
    with refusals_named(without_password(url)):
        _make_tables(engine)
        _check_version(engine)
    return engine


def without_password(url: URL) -> str:
    """Write a URL for a person, without its password; a plain file as its path."""
    if url.get_backend_name() == "sqlite" and url.database:
        return url.database
    return url.render_as_string(hide_password=True)


@contextmanager
def writing(engine: Engine) -> Iterator[Connection]:
    """Open a transaction that changes something: kept whole, or not at all where it fails.

    SQLite is asked for the right to write at once: a reader that wants to write later can be
    refused without waiting.
    """
    with engine.begin() as connection:
        if engine.dialect.name == "sqlite":
            connection.exec_driver_sql("BEGIN IMMEDIATE")
        yield connection


@contextmanager
def refusals_named(place: str) -> Iterator[None]:
    """Turn what a database says into an error that names the place.

    Raises:
        GradebookError: the database failed.
    """
    try:
        yield
    except SQLAlchemyError as fault:
        said = str(fault.orig) if isinstance(fault, DBAPIError) else str(fault)
        raise _failure(
            place,
            message("The gradebook cannot be used: {fault}.", fault=said.strip().rstrip(".")),
            message("Check the place and your rights to it; restore a damaged file from a backup."),
        ) from fault


def _url(place: str) -> URL:
    if "://" not in place:
        return URL.create("sqlite", database=place)
    try:
        return make_url(place)
    except ArgumentError as fault:
        raise _failure(
            place,
            message("This is no URL of a database."),
            message("Write the path of a file, or a URL like postgresql+psycopg://user@host/name."),
        ) from fault


def _engine(url: URL) -> Engine:
    if url.get_backend_name() == "sqlite":
        # Its driver gives up after five seconds otherwise, and would commit each table it makes.
        arguments = {"timeout": _SECONDS_TO_WAIT, "isolation_level": None}
        return create_engine(url, poolclass=NullPool, connect_args=arguments)
    return create_engine(url, poolclass=NullPool)


def _make_private(path: Path) -> None:
    """Make an empty file that only its owner may read, for marks have names on them."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists():
        os.close(os.open(path, os.O_RDWR | os.O_CREAT, _PRIVATE))


def _make_tables(engine: Engine) -> None:
    for attempt in range(1, _TRIES + 1):
        if _is_made(engine):
            return
        try:
            with writing(engine) as connection:
                metadata.create_all(connection, checkfirst=False)
                connection.execute(insert(format_table).values(version=VERSION))
        except DBAPIError:
            # Another program makes them at the same time, or this one may not.
            if attempt == _TRIES and not _is_made(engine):
                raise


def _is_made(engine: Engine) -> bool:
    with engine.connect() as connection:
        if not inspect(connection).has_table(format_table.name):
            return False
        return connection.execute(select(format_table.c.version)).first() is not None


def _check_version(engine: Engine) -> None:
    with engine.connect() as connection:
        found = connection.execute(select(format_table.c.version)).scalars().all()
    if found != [VERSION]:
        raise _failure(
            without_password(engine.url),
            message(
                "The gradebook has the format {found}, this program knows {known}.",
                found=", ".join(map(str, found)),
                known=VERSION,
            ),
            message("Use the version of the program that wrote it, or a later one."),
        )


def _failure(
    place: str, what: Message, remedy: Message, step: NextStep | None = None
) -> GradebookError:
    return GradebookError([Problem(place, "", what, remedy, step=step)])
