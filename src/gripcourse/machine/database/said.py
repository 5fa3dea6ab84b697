"""What a database says when something fails, as errors with place and remedy."""

import errno
import sqlite3
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Final

from sqlalchemy.engine import URL
from sqlalchemy.exc import (
    DBAPIError,
    IntegrityError,
    OperationalError,
    ProgrammingError,
    SQLAlchemyError,
)

from gripcourse.errors import GradebookError, NextStep, Problem, system_problem
from gripcourse.text.words import Message, message

# The states of SQL that PostgreSQL names, for its sentences may be in any language.
_TAKEN: Final = "23505"
_LOCKED: Final = "55P03"
_FULL: Final = "53100"
_GONE: Final = ("08", "57P", "53300")  # lost connections, a server that ends or begins, too many
_PRIMARY: Final = 0xFF  # of a code of SQLite; what is above tells a sort of it
_AGAIN: Final = message(
    "Start the same again when it is back: each step is kept whole or not at all, and none is kept"
    " twice."
)
# What a URL may ask for that is no secret. Anything else may be one, under a mistyped name too.
_SHOWN: Final = frozenset({"host", "hostaddr", "port", "service", "sslmode", "connect_timeout"})


def without_password(url: URL) -> str:
    """Write a URL for a person, without its password; a plain file as its path."""
    if url.get_backend_name() == "sqlite" and url.database:
        return url.database
    return url.difference_update_query(url.query.keys() - _SHOWN).render_as_string(
        hide_password=True
    )


@contextmanager
def refusals_named(place: str) -> Iterator[None]:
    """Turn what a database says into an error that names the place.

    Raises:
        GradebookError: the database failed.
    """
    try:
        yield
    except SQLAlchemyError as fault:
        raise _refusal(place, fault) from fault
    except ValueError as fault:
        # A damaged file may still open, and hold texts that are none, moments, or words of ours.
        raise unusable(place, f"{type(fault).__name__}: {fault}") from fault


def another_was_faster(fault: GradebookError) -> bool:
    """Tell whether rows were refused because others with their keys came first."""
    cause = fault.__cause__
    if not isinstance(cause, IntegrityError):
        return False
    if isinstance(cause.orig, sqlite3.Error):
        taken = (sqlite3.SQLITE_CONSTRAINT_PRIMARYKEY, sqlite3.SQLITE_CONSTRAINT_UNIQUE)
        return _code(cause) in taken
    return _state(cause) == _TAKEN


def unusable(place: str, said: str) -> GradebookError:
    """Return the error of a database that says why it cannot be used."""
    return failure(
        place,
        message("The gradebook cannot be used: {fault}.", fault=" ".join(said.split()).rstrip(".")),
        message("Check the place and your rights to it; restore a damaged file from a backup."),
    )


def wrong_options(place: str, said: str) -> GradebookError:
    """Return the error of a URL whose options the driver of its database does not take."""
    return failure(
        place,
        message("The URL of the gradebook cannot be used: {fault}.", fault=said.rstrip(".")),
        message(
            "Correct or remove what stands behind its question mark. PostgreSQL takes its own"
            " parameters there, for example sslmode=require; a file takes none."
        ),
    )


def failure(
    place: str, what: Message, remedy: Message, step: NextStep | None = None
) -> GradebookError:
    """Return an error of one problem."""
    return GradebookError([Problem(place, "", what, remedy, step=step)])


def _refusal(place: str, fault: SQLAlchemyError) -> GradebookError:
    if not isinstance(fault, DBAPIError):
        return unusable(place, str(fault))
    said, state = str(fault.orig), _state(fault)
    if state == _LOCKED or "database is locked" in said:
        return _busy(place, is_file=state != _LOCKED)
    of_the_disk = _of_the_disk(place, fault, state)
    if of_the_disk is not None:
        return of_the_disk
    return _of_the_server(place, fault, state) or unusable(place, said)


def _of_the_server(place: str, fault: DBAPIError, state: str) -> GradebookError | None:
    """Return the error where a server is not reached, or is gone; None for everything else."""
    said = str(fault.orig)
    if not state and fault.statement is None and isinstance(fault, ProgrammingError):
        return wrong_options(place, _sentence(said))  # nobody was asked yet
    if fault.connection_invalidated or state.startswith(_GONE):
        return failure(
            place,
            message("The database has gone away: {fault}.", fault=_sentence(said)),
            _AGAIN,
        )
    if (
        not state
        and isinstance(fault, OperationalError)
        and not isinstance(fault.orig, sqlite3.Error)
    ):
        # Nobody was reached who would give a reason that a program can read.
        return failure(
            place,
            message("The database cannot be reached: {fault}.", fault=_sentence(said)),
            message(
                "Check address, name and your rights to it. If it was only away: {again}",
                again=_AGAIN,
            ),
        )
    return None


def _busy(place: str, *, is_file: bool) -> GradebookError:
    again = message("Nothing was written; end that program, or try again in a minute.")
    if is_file:  # SQLite says the same where locks cannot be had
        again = message(
            "{again} If there is none: network disks without locks do not bear this file; keep it"
            " on another disk.",
            again=again,
        )
    what = message("Another program writes to the gradebook and does not end.")
    return failure(place, what, again)


def _of_the_disk(place: str, fault: DBAPIError, state: str) -> GradebookError | None:
    """Return the error where nothing can be written; None for everything else."""
    code = (_code(fault) or 0) & _PRIMARY
    if state == _FULL or code == sqlite3.SQLITE_FULL:
        full = system_problem(OSError(errno.ENOSPC, ""))
        return failure(place, full.what, full.remedy)
    if code == sqlite3.SQLITE_READONLY:
        return failure(
            place,
            message("The gradebook can be read, but not written."),
            message("Check your rights to the file and its folder, and that its disk is writable."),
        )
    return None


def _sentence(said: str) -> str:
    """Return the first line that a database says; the others guess at what may have happened."""
    return next(iter(said.strip().splitlines()), "").rstrip(".")


def _code(fault: DBAPIError) -> int | None:
    # The driver's own complaints, of texts that are no UTF-8 for one, carry no code.
    return getattr(fault.orig, "sqlite_errorcode", None)


def _state(fault: DBAPIError) -> str:
    return str(getattr(fault.orig, "sqlstate", None) or "")
