"""The desk's part of the database: rows are added, nothing is ever changed or removed."""

import hashlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass
from datetime import datetime
from functools import partial
from typing import Any, Final, TypeVar

from sqlalchemy import Engine, Table, func, insert, select

from gripcourse.access.desk import schema
from gripcourse.access.desk.counting import Complete, ration, refuse_too_many
from gripcourse.access.desk.model import (
    Allowance,
    GradedBatch,
    HandIn,
    LoggedCheck,
    Publication,
    RegradeRequest,
)
from gripcourse.access.kept_rows import values_of
from gripcourse.errors import GradebookError
from gripcourse.machine.database.moments import stored
from gripcourse.machine.database.opening import (
    another_was_faster,
    open_engine,
    refusals_named,
    without_password,
    writing,
)
from gripcourse.machine.database.storable import in_code_order

_TRIES: Final = 50  # each refusal means that another server got through
_Made = TypeVar("_Made")


@dataclass(frozen=True, slots=True)
class Desk:
    """The open desk of a course.

    Attributes:
        engine: of the database; each call takes a connection of its own.
        course: id.
    """

    engine: Engine
    course: str

    def add_hand_in(
        self,
        student: str,
        digest: str,
        size: int,
        name: str,
        now: datetime,
        allowed: Allowance | None = None,
    ) -> HandIn:
        """Keep that a file was handed in; the same again right after is not kept twice.

        The same bytes by another name are another file: the name tells a drawing from a workbook.

        Raises:
            TooOftenError: it would be more than is allowed, of all servers together.
        """
        row = {"digest": digest, "size": size, "name": name, "at": stored(now)}
        of = {"student": student}
        kept = self._append(schema.hand_ins, of, row, once=("digest", "name"), allowed=allowed)
        return HandIn(**values_of(kept, "course"))

    def hand_ins(self, student: str | None = None) -> tuple[HandIn, ...]:
        """Return what was handed in, by one student or by all, oldest first for each."""
        return self._rows(schema.hand_ins, HandIn, student)

    def log_check(
        self,
        student: str,
        digest: str,
        most: int | None,
        now: datetime,
        allowed: Allowance | None = None,
    ) -> LoggedCheck:
        """Keep that a student checked a workbook, and whether more than its reading may be told.

        Args:
            student: id.
            digest: of the workbook.
            most: how often more may be told, by all servers together; None where nobody asks.
            now: with its zone.
            allowed: how often may be checked at all; None for any number.

        Raises:
            TooOftenError: it would be more than is allowed, of all servers together.
        """
        row = {"digest": digest, "told": False, "left": None, "at": stored(now)}
        rationed = None if most is None else partial(ration, most=most)
        kept = self._append(
            schema.checks, {"student": student}, row, allowed=allowed, complete=rationed
        )
        return LoggedCheck(**values_of(kept, "course"))

    def checks(self, student: str | None = None) -> tuple[LoggedCheck, ...]:
        """Return the self-checks of one student or of all."""
        return self._rows(schema.checks, LoggedCheck, student)

    def add_request(
        self,
        student: str,
        item: str,
        sentence: str,
        now: datetime,
        allowed: Allowance | None = None,
    ) -> RegradeRequest:
        """Keep that a student asks for an item to be looked at again.

        Raises:
            TooOftenError: it would be more than is allowed, of all servers together.
        """
        row = {"item": item, "sentence": sentence, "at": stored(now)}
        kept = self._append(schema.requests, {"student": student}, row, allowed=allowed)
        return RegradeRequest(**values_of(kept, "course"))

    def requests(self, student: str | None = None) -> tuple[RegradeRequest, ...]:
        """Return the requests of one student or of all."""
        return self._rows(schema.requests, RegradeRequest, student)

    def revoke(self, student: str, by: str, now: datetime) -> None:
        """Let no link that a student has open anything any more."""
        self._append(schema.revocations, {"student": student}, {"by": by, "at": stored(now)})

    def revoked(self, student: str) -> int:
        """Return how often the links of a student were revoked."""
        table = schema.revocations.c
        question = select(func.count()).where(table.course == self.course, table.student == student)
        with refusals_named(self.place), self.engine.connect() as connection:
            return int(connection.execute(question).scalar_one())

    def add_publication(self, number: int, by: str, why: str, now: datetime) -> Publication | None:
        """Keep that results were published under a number; None where that is taken."""
        made = Publication(number, published=True, by=by, why=why, at=now)
        row = {**asdict(made), "course": self.course, "at": stored(now)}
        return made if self._insert(schema.publications, row) else None

    def add_withdrawal(self, by: str, why: str, now: datetime) -> Publication:
        """Keep that the last publication was withdrawn."""
        row = {"published": False, "by": by, "why": why, "at": stored(now)}
        return Publication(**values_of(self._append(schema.publications, {}, row), "course"))

    def publications(self) -> tuple[Publication, ...]:
        """Return all publications and withdrawals, oldest first; the last one counts."""
        return self._rows(schema.publications, Publication, None)

    def add_batch(self, files: int, by: str, why: str, now: datetime) -> GradedBatch:
        """Keep that files were graded into the gradebook."""
        row = {"files": files, "by": by, "why": why, "at": stored(now)}
        return GradedBatch(**values_of(self._append(schema.batches, {}, row), "course"))

    def batches(self) -> tuple[GradedBatch, ...]:
        """Return all batches, oldest first."""
        return self._rows(schema.batches, GradedBatch, None)

    def add_sign_in(self, token: str, name: str, expires: datetime) -> None:
        """Keep that a token lets somebody sign in once."""
        row = {"token": digest_of(token), "course": self.course, "name": name}
        self._insert(schema.sign_ins, row | {"expires": stored(expires)})

    def begin_session(self, sign_in: str, session: str, expires: datetime, now: datetime) -> bool:
        """Use up a sign-in for a session; False where it is none, too late, or was used before."""
        table, token = schema.sign_ins.c, digest_of(sign_in)
        question = select(table.token).where(
            table.token == token, table.course == self.course, table.expires > stored(now)
        )
        with refusals_named(self.place), self.engine.connect() as connection:
            if connection.execute(question).first() is None:
                return False
        row = {"sign_in": token, "token": digest_of(session), "expires": stored(expires)}
        return self._insert(schema.sessions, row)

    def session_name(self, session: str, now: datetime) -> str | None:
        """Return who is signed in with a session; None where it is none or has ended."""
        one, sign_in, out = schema.sessions.c, schema.sign_ins.c, schema.sign_outs.c
        question = (
            select(sign_in.name)
            .join_from(schema.sessions, schema.sign_ins, one.sign_in == sign_in.token)
            .outerjoin(schema.sign_outs, out.session == one.token)
            .where(
                one.token == digest_of(session),
                one.expires > stored(now),
                sign_in.course == self.course,
                out.session.is_(None),
            )
        )
        with refusals_named(self.place), self.engine.connect() as connection:
            found = connection.execute(question).scalar()
        return None if found is None else str(found)

    def end_session(self, session: str, now: datetime) -> None:
        """Sign out."""
        self._insert(schema.sign_outs, {"session": digest_of(session), "at": stored(now)})

    @property
    def place(self) -> str:
        """Where it is, for a person."""
        return without_password(self.engine.url)

    def _rows(
        self, table: Table, make: Callable[..., _Made], student: str | None
    ) -> tuple[_Made, ...]:
        question = select(table).where(table.c.course == self.course)
        if student is not None:
            question = question.where(table.c.student == student)
        question = question.order_by(*in_code_order(self.engine, *table.primary_key.columns))
        with refusals_named(self.place), self.engine.connect() as connection:
            found = connection.execute(question).mappings()
            return tuple(make(**values_of(row, "course")) for row in found)

    def _append(
        self,
        table: Table,
        of: Mapping[str, str],
        row: Mapping[str, Any],
        once: Sequence[str] = (),
        allowed: Allowance | None = None,
        complete: Complete | None = None,
    ) -> Mapping[str, Any]:
        """Add a row with the next number; somebody faster only makes it the one after.

        Where the last row has the same in the columns `once`, it is returned, and none added.
        Counting and adding are one transaction: two servers never both add the last one allowed.
        What `complete` returns of the rows that are the same is counted there too.

        Raises:
            TooOftenError: there are as many as are allowed about this time.
        """
        fixed = {"course": self.course, **of}
        same = [table.c[name] == value for name, value in fixed.items()]
        last = select(table).where(*same).order_by(table.c.number.desc()).limit(1)
        for left in reversed(range(_TRIES)):
            try:
                with refusals_named(self.place), writing(self.engine) as connection:
                    before = connection.execute(last).mappings().first()
                    if before is not None and once and all(before[one] == row[one] for one in once):
                        return dict(before)
                    if allowed is not None:
                        refuse_too_many(connection, table, same, row["at"], allowed)
                    number = 1 if before is None else before["number"] + 1
                    made = {**fixed, "number": number, **row}
                    made |= {} if complete is None else complete(connection, same)
                    connection.execute(insert(table), made)
            except GradebookError as fault:
                if left and another_was_faster(fault):
                    continue
                raise
            return made
        raise AssertionError

    def _insert(self, table: Table, row: Mapping[str, Any]) -> bool:
        """Add a row; False where there is one with its key."""
        try:
            with refusals_named(self.place), writing(self.engine) as connection:
                connection.execute(insert(table), row)
        except GradebookError as fault:
            if another_was_faster(fault):
                return False
            raise
        return True


def open_desk(place: str, course: str) -> Desk:
    """Open the desk of a course; see `database.opening`."""
    return Desk(open_engine(place), course)


def batches_by_time(engine: Engine) -> dict[datetime, GradedBatch]:
    """Return the batches of every course of a database by the time of their attempts."""
    with refusals_named(without_password(engine.url)), engine.connect() as connection:
        found = connection.execute(select(schema.batches)).mappings()
        batches = [GradedBatch(**values_of(row, "course")) for row in found]
    return {one.at: one for one in batches}


def digest_of(token: str) -> str:
    """Return what is kept of a token."""
    return hashlib.sha256(token.encode()).hexdigest()
