"""What is kept of platforms, in the database: rows are added, nothing is changed or removed."""

import hashlib
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import asdict, dataclass, replace
from datetime import datetime
from typing import TYPE_CHECKING, TypeVar

from sqlalchemy import Connection, Engine, Table, insert, select

from gripcourse.access.kept_rows import values_of
from gripcourse.access.lti import schema
from gripcourse.access.lti.model import Bond, PlatformPlace, SentScore, Stranger, UserKey
from gripcourse.errors import GradebookError
from gripcourse.machine.database.moments import stored
from gripcourse.machine.database.opening import (
    another_was_faster,
    refusals_named,
    without_password,
    writing,
)

if TYPE_CHECKING:
    from _typeshed import DataclassInstance

_Made = TypeVar("_Made")


@dataclass(frozen=True, slots=True)
class LtiStore:
    """What a course keeps of platforms.

    Attributes:
        engine: of the database; each call takes a connection of its own.
        course: id.
    """

    engine: Engine
    course: str

    def use_state(self, state: str, now: datetime) -> bool:
        """Use up a state; False where it was used before."""
        digest = hashlib.sha256(state.encode()).hexdigest()
        row = {"state": digest, "course": self.course, "at": stored(now)}
        try:
            with self._written() as connection:
                connection.execute(insert(schema.used_states), row)
        except GradebookError as fault:
            if another_was_faster(fault):
                return False
            raise
        return True

    def bind(self, bond: Bond) -> Bond | None:
        """Keep that a user is a student, or nobody; the last word counts.

        Returns:
            None where it is kept; whose student that is already, where another user of the same
            platform is. Both is one transaction: of two who come at once, one is the student.
        """
        with self._written() as connection:
            for other in self._bonds(connection).values():
                if bond.student == other.student and _is_another(other.key, bond.key):
                    return other
            self._add_by(connection, schema.bonds, bond)
        return None

    def bonds(self) -> Mapping[UserKey, Bond]:
        """Return what holds now, by user."""
        with self._read() as connection:
            return self._bonds(connection)

    def add_stranger(self, stranger: Stranger) -> None:
        """Keep that somebody could not be told to be a student; the same again is not kept."""
        known = {one.key: one for one in self._rows(schema.strangers, Stranger)}.get(stranger.key)
        if known is None or replace(known, at=stranger.at) != stranger:
            self._add(schema.strangers, stranger)

    def strangers(self) -> tuple[Stranger, ...]:
        """Return those who came and are still nobody of the roster: of each the last time."""
        last = {one.key: one for one in self._rows(schema.strangers, Stranger)}
        known = self.bonds()
        return tuple(one for key, one in last.items() if key not in known)

    def note_place(self, place: PlatformPlace) -> None:
        """Keep where the assignment stands; nothing where that is known already."""
        known = [one for one in self.places() if _where(one) == _where(place)]
        if not known or replace(known[0], at=place.at) != place:
            self._add(schema.places, place)

    def places(self) -> tuple[PlatformPlace, ...]:
        """Return all places, of each what was said last."""
        return tuple(
            {_where(one): one for one in self._rows(schema.places, PlatformPlace)}.values()
        )

    def add_sent(self, sent: SentScore) -> None:
        """Keep that a platform took a score."""
        self._add(schema.sent_scores, sent)

    def sent(self) -> tuple[SentScore, ...]:
        """Return all scores that were taken, oldest first."""
        return self._rows(schema.sent_scores, SentScore)

    def _add(self, table: Table, one: "DataclassInstance") -> None:
        with self._written() as connection:
            self._add_by(connection, table, one)

    def _add_by(self, connection: Connection, table: Table, one: "DataclassInstance") -> None:
        row = asdict(one)
        values = {**row, "course": self.course, "at": stored(row["at"])}
        connection.execute(insert(table), values)

    def _bonds(self, connection: Connection) -> Mapping[UserKey, Bond]:
        last = {one.key: one for one in self._rows_by(connection, schema.bonds, Bond)}
        return {key: one for key, one in last.items() if one.student}

    def _rows(self, table: Table, make: Callable[..., _Made]) -> tuple[_Made, ...]:
        with self._read() as connection:
            return self._rows_by(connection, table, make)

    def _rows_by(
        self, connection: Connection, table: Table, make: Callable[..., _Made]
    ) -> tuple[_Made, ...]:
        question = select(table).where(table.c.course == self.course).order_by(table.c.number)
        found = connection.execute(question).mappings()
        return tuple(make(**values_of(row, "number", "course")) for row in found)

    @contextmanager
    def _read(self) -> Iterator[Connection]:
        with refusals_named(without_password(self.engine.url)), self.engine.connect() as connection:
            yield connection

    @contextmanager
    def _written(self) -> Iterator[Connection]:
        with refusals_named(without_password(self.engine.url)), writing(self.engine) as connection:
            yield connection


def _is_another(one: UserKey, other: UserKey) -> bool:
    """Tell whether these are two users of the same platform."""
    return one != other and (one.issuer, one.client) == (other.issuer, other.client)


def _where(place: PlatformPlace) -> tuple[str, str, str, str]:
    return (place.issuer, place.client, place.context, place.link)
