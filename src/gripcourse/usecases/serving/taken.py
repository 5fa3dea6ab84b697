"""What persons handed in under all their ids, in the order in which it was taken.

The order of one id is that of its receipts: a clock that was set back between two of them does not
make the later one the earlier. Between two ids of one person nothing but the clock tells.
"""

from collections.abc import Callable, Iterable, Sequence
from datetime import datetime
from heapq import merge
from itertools import accumulate, groupby
from typing import Protocol, TypeVar

from gripcourse.access.desk.model import HandIn, LoggedCheck, RegradeRequest
from gripcourse.access.desk.store import Desk
from gripcourse.gradebook.joined import family
from gripcourse.issuing.withdrawal import Join, persons_of


class _Numbered(Protocol):
    @property
    def student(self) -> str:
        """Id under which it came."""

    @property
    def at(self) -> datetime:
        """When, by the clock of then."""


_Row = TypeVar("_Row", bound=_Numbered)


def hand_ins_by_person(desk: Desk, joins: Sequence[Join]) -> dict[str, tuple[HandIn, ...]]:
    """Return what everybody handed in, by the id that stands for the person now.

    Each file keeps the id and the number of its receipt.
    """
    return _by_person(desk.hand_ins(), joins)


def hand_ins_of(desk: Desk, student: str, joins: Sequence[Join]) -> tuple[HandIn, ...]:
    """Return what a person handed in, under whatever id."""
    return _of_person(desk.hand_ins, student, joins)


def requests_of(desk: Desk, student: str, joins: Sequence[Join]) -> tuple[RegradeRequest, ...]:
    """Return what a person asked to be looked at again, under whatever id."""
    return _of_person(desk.requests, student, joins)


def requests_by_person(desk: Desk, joins: Sequence[Join]) -> dict[str, tuple[RegradeRequest, ...]]:
    """Return what everybody asked to be looked at again, by the id that stands for them now."""
    return _by_person(desk.requests(), joins)


def checks_of(desk: Desk, student: str, joins: Sequence[Join]) -> tuple[LoggedCheck, ...]:
    """Return the self-checks of a person, under whatever id."""
    return _of_person(desk.checks, student, joins)


def checks_by_person(desk: Desk, joins: Sequence[Join]) -> dict[str, tuple[LoggedCheck, ...]]:
    """Return the self-checks of everybody, by the id that stands for them now."""
    return _by_person(desk.checks(), joins)


def order_of_works(desk: Desk, joins: Sequence[Join]) -> dict[tuple[str, str], int]:
    """Return by person and digest which place a work has among what the person handed in.

    The same bytes once more stand where they came last.
    """
    return {
        (person, one.digest): place
        for person, files in hand_ins_by_person(desk, joins).items()
        for place, one in enumerate(files, start=1)
    }


def _of_person(
    rows_of: Callable[[str], Sequence[_Row]], student: str, joins: Sequence[Join]
) -> tuple[_Row, ...]:
    rows = [one for id_ in sorted(family({student}, joins)) for one in rows_of(id_)]
    return _by_person(rows, joins).get(student, ())


def _by_person(rows: Iterable[_Row], joins: Sequence[Join]) -> dict[str, tuple[_Row, ...]]:
    """Put rows that stand in the order of their numbers, id by id, together by person."""
    persons = persons_of(joins)
    series: dict[str, list[list[tuple[datetime, _Row]]]] = {}
    for student, group in groupby(rows, key=_student):
        kept = tuple(group)
        times = accumulate((one.at for one in kept), max)
        series.setdefault(persons.get(student, student), []).append(
            list(zip(times, kept, strict=True))
        )
    return {
        person: tuple(one for _, one in merge(*all_, key=_time)) for person, all_ in series.items()
    }


def _student(row: _Numbered) -> str:
    return row.student


def _time(timed: tuple[datetime, object]) -> datetime:
    return timed[0]
