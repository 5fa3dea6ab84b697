"""The journal of the gradebook: regrades with their reasons, and what students were told.

Entries are added, never changed: taking a regrade back is an entry, too.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import datetime
from itertools import groupby

from sqlalchemy import select

from gripcourse.gradebook import schema
from gripcourse.gradebook.joined import waivers_of_persons
from gripcourse.gradebook.model import Attempt
from gripcourse.gradebook.numbering import new_attempts
from gripcourse.gradebook.rows import Row
from gripcourse.gradebook.store import Gradebook, Writing, attempt_rows
from gripcourse.gradebook.timing import Waiver
from gripcourse.gradebook.works import StudentWork
from gripcourse.grading.model import PointSums
from gripcourse.issuing.withdrawal import persons_of
from gripcourse.machine.database.moments import in_utc, stored
from gripcourse.machine.database.opening import refusals_named
from gripcourse.machine.database.storable import in_code_order


@dataclass(frozen=True, slots=True)
class Signed:
    """Who did something, when and why; the reason is empty where none is asked for."""

    person: str
    done_at: datetime
    why: str = ""


@dataclass(frozen=True, slots=True)
class Regrade:
    """A regrade that was applied, or one that takes another back.

    Attributes:
        number: counts all from 1.
        undoes: number of the regrade that it takes back; None for one that was applied.
        signed: by whom, when and why.
    """

    number: int
    undoes: int | None
    signed: Signed


@dataclass(frozen=True, slots=True)
class Published:
    """What a student was told about one work.

    Attributes:
        number: of the publication.
        student: id.
        attempt: number of the attempt that stood then.
        points, max_points: with the marks that counted then.
        signed: by whom and when.
        kept_as: id under which the attempt is kept, where that was joined with the student's; else
            empty.
    """

    number: int
    student: str
    attempt: int
    points: float
    max_points: float
    signed: Signed
    kept_as: str = ""

    @property
    def key(self) -> tuple[str, int]:
        """The id under which the attempt is kept, and its number there."""
        return self.kept_as or self.student, self.attempt


def regrades(book: Gradebook) -> tuple[Regrade, ...]:
    """Return all regrades, oldest first.

    Raises:
        GradebookError: the database failed.
    """
    question = select(schema.regrades).order_by(schema.regrades.c.number)
    with refusals_named(book.place), book.engine.connect() as connection:
        found = list(connection.execute(question).mappings())
    return tuple(
        Regrade(
            row["number"],
            row["undoes"],
            Signed(row["person"], in_utc(row["done_at"]), row["why"]),
        )
        for row in found
    )


def applied(all_: Sequence[Regrade]) -> tuple[Regrade, ...]:
    """Return the regrades that stand: applied, and not taken back."""
    undone = {one.undoes for one in all_}
    return tuple(one for one in all_ if one.undoes is None and one.number not in undone)


def keep_regrade(
    book: Gradebook, attempts: Sequence[Attempt], signed: Signed
) -> tuple[Attempt, ...]:
    """Keep a regrade: its entry and the attempts that stand from now on, whole or not at all.

    Args:
        book: the gradebook.
        attempts: of works that are known.
        signed: by whom, when and why.

    Returns:
        The attempts with their numbers; none where all stand just so already, without an entry.

    Raises:
        GradebookError: the database failed; nothing was kept.
    """
    students = {one.student for one in attempts}

    def fresh() -> tuple[Attempt, ...]:
        number = _next_regrade(book)
        found = new_attempts(attempts, book.attempts(students), book.undone())
        return tuple(replace(one, regrade=number) for one in found)

    def rows_of(found: tuple[Attempt, ...]) -> Writing:
        number = next(one.regrade for one in found)
        entry = _regrade_row(Regrade(number or 0, None, signed))
        return [(schema.regrades, [entry]), *attempt_rows(found)]

    return book.add(fresh, rows_of)


def keep_undoing(book: Gradebook, signed: Signed) -> tuple[Regrade, ...]:
    """Take the last regrade that stands back, by a new entry.

    Returns:
        The entry; nothing where no regrade stands.

    Raises:
        GradebookError: the database failed; nothing was kept.
    """

    def fresh() -> tuple[Regrade, ...]:
        stands = applied(regrades(book))
        return (Regrade(_next_regrade(book), stands[-1].number, signed),) if stands else ()

    return book.add(fresh, lambda found: [(schema.regrades, [_regrade_row(found[0])])])


def publications(book: Gradebook) -> tuple[Published, ...]:
    """Return what students were told, oldest first; what an id was told that was joined, too.

    Raises:
        GradebookError: the database failed.
    """
    one = schema.publications.c
    columns = in_code_order(book.engine, one.number, one.student, one.attempt)
    question = select(schema.publications).order_by(*columns)
    with refusals_named(book.place), book.engine.connect() as connection:
        found = list(connection.execute(question).mappings())
    persons = persons_of(book.joins)
    return tuple(
        Published(
            number=row["number"],
            student=persons.get(row["student"], row["student"]),
            kept_as=row["student"] if row["student"] in persons else "",
            attempt=row["attempt"],
            points=row["points"],
            max_points=row["max_points"],
            signed=Signed(row["person"], in_utc(row["done_at"])),
        )
        for row in found
    )


def keep_publication(
    book: Gradebook, told: Mapping[StudentWork, PointSums], signed: Signed
) -> tuple[Published, ...]:
    """Keep that students are told what stands; who was told just so already is not kept twice.

    Raises:
        GradebookError: the database failed; nothing was kept.
    """

    def fresh() -> tuple[Published, ...]:
        before = publications(book)
        # The last one of each attempt.
        known = {one.key: one.points for one in before}
        number = max((one.number for one in before), default=0) + 1
        return tuple(
            Published(
                number,
                work.student,
                work.attempt.number,
                sums.score,
                sums.max_score,
                signed,
                work.attempt.kept_as,
            )
            for work, sums in told.items()
            if known.get(work.attempt.key) != sums.score
        )

    return book.add(
        fresh, lambda found: [(schema.publications, [_published_row(one) for one in found])]
    )


def published_works(book: Gradebook) -> frozenset[tuple[str, str]]:
    """Return student and digest of each work that its student was told about.

    Raises:
        GradebookError: the database failed.
    """
    told = publications(book)
    return told_works(told, book.attempts({one.student for one in told}) if told else ())


def told_works(
    told: Iterable[Published], attempts: Iterable[Attempt]
) -> frozenset[tuple[str, str]]:
    """Return student and digest of each of some students' works that its student was told about.

    Args:
        told: what students were told.
        attempts: all attempts of these students.
    """
    digests = {one.key: one.digest for one in attempts}
    return frozenset((one.student, digests[one.key]) for one in told if one.key in digests)


def waivers(book: Gradebook) -> dict[str, tuple[Waiver, ...]]:
    """Return the waivers of each student, oldest first.

    Raises:
        GradebookError: the database failed.
    """
    return waivers_of_persons(_kept_waivers(book), book.joins)


def _kept_waivers(book: Gradebook) -> dict[str, tuple[Waiver, ...]]:
    one = schema.waivers.c
    question = select(schema.waivers).order_by(*in_code_order(book.engine, one.student, one.number))
    with refusals_named(book.place), book.engine.connect() as connection:
        found = list(connection.execute(question).mappings())
    made = [
        Waiver(
            student=row["student"],
            number=row["number"],
            until=None if row["until"] is None else in_utc(row["until"]),
            withdrawn=bool(row["withdrawn"]),
            person=row["person"],
            done_at=in_utc(row["done_at"]),
            why=row["why"],
        )
        for row in found
    ]
    return {name: tuple(group) for name, group in groupby(made, key=lambda one: one.student)}


def keep_waiver(book: Gradebook, waiver: Waiver) -> Waiver:
    """Keep a waiver, numbered.

    Raises:
        GradebookError: the database failed; nothing was kept.
    """

    def fresh() -> tuple[Waiver, ...]:
        before = _kept_waivers(book).get(waiver.student, ())
        return (replace(waiver, number=len(before) + 1),)

    return book.add(fresh, lambda found: [(schema.waivers, [_waiver_row(found[0])])])[0]


def _waiver_row(one: Waiver) -> Row:
    return {
        "student": one.student,
        "number": one.number,
        "until": None if one.until is None else stored(one.until),
        "withdrawn": one.withdrawn,
        "person": one.person,
        "done_at": stored(one.done_at),
        "why": one.why,
    }


def _next_regrade(book: Gradebook) -> int:
    return max((one.number for one in regrades(book)), default=0) + 1


def _regrade_row(one: Regrade) -> Row:
    return {
        "number": one.number,
        "undoes": one.undoes,
        "person": one.signed.person,
        "done_at": stored(one.signed.done_at),
        "why": one.signed.why,
    }


def _published_row(one: Published) -> Row:
    student, attempt = one.key
    return {
        "number": one.number,
        "student": student,
        "attempt": attempt,
        "person": one.signed.person,
        "done_at": stored(one.signed.done_at),
        "points": one.points,
        "max_points": one.max_points,
    }
