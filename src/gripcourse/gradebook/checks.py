"""Counting self-checks: who may be told how often whether numbers fit each other.

A file, kept by a server that answers and has no desk (ours counts in its database): a workbook can
be changed to name anybody, so who asks is what the server knows of whoever is signed in.
"""

import sqlite3
from contextlib import closing, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from gripcourse.machine.files import make_private

_SECONDS_TO_WAIT: Final = 30.0


@dataclass(frozen=True, slots=True)
class CheckLedger:
    """Where self-checks are counted, and for whom.

    Attributes:
        path: of the file; it is made where there is none, and only its owner may read it.
        who: the student, as the server knows who is signed in.
    """

    path: Path
    who: str


def take_one(ledger: CheckLedger, most: int) -> int | None:
    """Count one more self-check.

    Args:
        ledger: where, and for whom.
        most: how many the student may have.

    Returns:
        How many are left after this one; None where there was none left.

    Raises:
        OSError: the file cannot be written.
    """
    taken = _taken(ledger, most, more=True)
    return most - taken - 1 if taken < most else None


def left_of(ledger: CheckLedger, most: int) -> int:
    """Return how many self-checks a student still has; see `take_one`."""
    return max(0, most - _taken(ledger, most, more=False))


def _taken(ledger: CheckLedger, most: int, *, more: bool) -> int:
    """Return how many a student had before, and add one more where it is wanted and allowed."""
    with suppress(FileExistsError):
        make_private(ledger.path)
    try:
        with closing(sqlite3.connect(ledger.path, _SECONDS_TO_WAIT, isolation_level=None)) as file:
            # Two questions of one student at once must not both get the last one.
            file.execute("BEGIN IMMEDIATE")
            file.execute(
                "CREATE TABLE IF NOT EXISTS checks (who TEXT PRIMARY KEY, taken INTEGER NOT NULL)"
            )
            question = "SELECT taken FROM checks WHERE who = ?"
            row = file.execute(question, (ledger.who,)).fetchone()
            taken = 0 if row is None else int(row[0])
            if more and taken < most:
                file.execute(
                    "INSERT INTO checks VALUES (?, 1)"
                    " ON CONFLICT (who) DO UPDATE SET taken = taken + 1",
                    (ledger.who,),
                )
            file.execute("COMMIT")
    except sqlite3.Error as fault:
        raise OSError(None, str(fault), str(ledger.path)) from fault
    return taken
