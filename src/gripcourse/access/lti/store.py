"""What is kept of platforms, in the database: rows are added, nothing is changed or removed."""

import hashlib
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, replace
from datetime import datetime
from typing import TYPE_CHECKING, Any, TypeVar

from sqlalchemy import Engine, Table, insert, select

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
            self._insert(schema.used_states, row)
        except GradebookError as fault:
            if another_was_faster(fault):
                return False
            raise
        return True

    def add_bond(self, bond: Bond) -> None:
        """Keep that a user is a student; the last word counts."""
        self._add(schema.bonds, bond)

    def bonds(self) -> Mapping[UserKey, Bond]:
        """Return what holds now, by user."""
        last = {one.key: one for one in self._rows(schema.bonds, Bond)}
        return {key: one for key, one in last.items() if one.student}

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
        row = asdict(one)
        self._insert(table, {**row, "course": self.course, "at": stored(row["at"])})

    def _insert(self, table: Table, row: Mapping[str, Any]) -> None:
        place = without_password(self.engine.url)
        with refusals_named(place), writing(self.engine) as connection:
            connection.execute(insert(table), row)

    def _rows(self, table: Table, make: Callable[..., _Made]) -> tuple[_Made, ...]:
        question = select(table).where(table.c.course == self.course).order_by(table.c.number)
        place = without_password(self.engine.url)
        with refusals_named(place), self.engine.connect() as connection:
            found = connection.execute(question).mappings()
            return tuple(make(**values_of(row, "number", "course")) for row in found)


def _where(place: PlatformPlace) -> tuple[str, str, str, str]:
    return (place.issuer, place.client, place.context, place.link)
