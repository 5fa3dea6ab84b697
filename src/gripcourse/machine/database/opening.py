"""Opening a database: a file by default, any database by its URL.

What is not there yet is made; what an earlier program made is brought up, with a copy kept beside.
Two programs may try either at once: one does it, the other finds it done.
"""

import sqlite3
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path

from sqlalchemy import Connection, Engine, create_engine
from sqlalchemy.engine import URL, make_url
from sqlalchemy.exc import ArgumentError, DBAPIError, NoSuchModuleError, SQLAlchemyError
from sqlalchemy.pool import NullPool

from gripcourse.errors import GradebookError, NextStep, Problem
from gripcourse.machine.database.migrate import NEWEST, REVISIONS, bring_up, revision_of
from gripcourse.machine.files import make_private, make_private_folder, making, replacing
from gripcourse.text.words import Message, message

_SECONDS_TO_WAIT = 60.0  # for another program that writes to the same file
_TRIES = 5


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
        raise _unusable(place, said) from fault


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


def _file_of(url: URL) -> Path | None:
    return Path(url.database) if url.get_backend_name() == "sqlite" and url.database else None


def _connected(url: URL) -> Engine:
    if url.get_backend_name() == "sqlite":
        # Its driver gives up after five seconds otherwise, and would commit each table it makes.
        arguments = {"timeout": _SECONDS_TO_WAIT, "isolation_level": None}
        return create_engine(url, poolclass=NullPool, connect_args=arguments)
    try:
        return create_engine(url, poolclass=NullPool)
    except (NoSuchModuleError, ModuleNotFoundError) as fault:
        raise _failure(
            without_password(url),
            message("The driver of this database is not installed: {fault}.", fault=str(fault)),
            message("Install it, for example psycopg for PostgreSQL, or name another gradebook."),
            NextStep.NAME_GRADEBOOK,
        ) from fault


def _make(file: Path) -> None:
    """Make a file that only its owner may read, for marks have names on them; whole or not."""
    try:
        with making(file) as temporary, refusals_named(str(file)):
            make_private(temporary)
            _bring_up(_connected(URL.create("sqlite", database=str(temporary))), None)
    except OSError as fault:
        raise _unusable(str(file), fault.strerror or str(fault)) from fault


def _refuse_empty(file: Path) -> None:
    """Refuse a file that lost its content: an empty gradebook looks as if nobody had a mark."""
    if file.stat().st_size == 0:
        raise _failure(
            str(file),
            message("The gradebook is empty: a file of 0 bytes, which this program never makes."),
            message("Restore it from a backup; if nothing was ever kept in it, remove the file."),
        )


def _bring_up(engine: Engine, file: Path | None) -> None:
    """Run the revisions that are missing; `file` is copied first where it holds anything."""
    for attempt in range(1, _TRIES + 1):
        with engine.connect() as connection:
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


def _known(engine: Engine, found: str | None) -> str | None:
    if found is None or found in REVISIONS:
        return found
    raise _failure(
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


def _unusable(place: str, said: str) -> GradebookError:
    if "database is locked" in said:
        return _failure(
            place,
            message("Another program writes to the gradebook and does not end."),
            message("Nothing was written; end that program, or try again in a minute."),
        )
    return _failure(
        place,
        message("The gradebook cannot be used: {fault}.", fault=said.strip().rstrip(".")),
        message("Check the place and your rights to it; restore a damaged file from a backup."),
    )


def _failure(
    place: str, what: Message, remedy: Message, step: NextStep | None = None
) -> GradebookError:
    return GradebookError([Problem(place, "", what, remedy, step=step)])
