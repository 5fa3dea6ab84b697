"""Whose works are that were graded under an id which was joined with another's. Pure.

Rows stay under the id under which they were kept; see `joined`. Of the same bytes that are known
under several ids of a person, one result stands: what was published last, else what was found last.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from datetime import datetime
from heapq import merge
from itertools import accumulate, groupby
from typing import TypeAlias

from gripcourse.gradebook.model import Attempt
from gripcourse.issuing.withdrawal import Join, persons_of

Key: TypeAlias = tuple[str, int]
"""The id under which an attempt is kept, and its number there."""


def attempts_of_persons(
    kept: Iterable[Attempt], joins: Sequence[Join], told: Mapping[Key, datetime]
) -> tuple[Attempt, ...]:
    """Return attempts as those of the persons whom ids stand for now, oldest first for each.

    Args:
        kept: all attempts of some persons and of the ids that were joined with theirs, oldest first
            for each id.
        joins: that stand, oldest first.
        told: by attempt, when its student was told of it last.
    """
    persons = persons_of(joins)
    series: dict[str, list[list[tuple[datetime, Attempt]]]] = {}
    for student, group in groupby(kept, key=lambda one: one.student):
        person = persons.get(student, student)
        of_id = [_as_of(one, person) for one in group]
        # Of one id the last one counts, also where the clock was set back before it.
        times = accumulate((one.graded_at for one in of_id), max)
        found = series.setdefault(person, [])
        timed = list(zip(times, of_id, strict=True))
        # Of two at the same moment the one of the id that the person keeps is the later.
        found[:] = [*found, timed] if student == person else [timed, *found]
    return tuple(
        one for person, all_ in series.items() for one in _of_person(person, all_, joins, told)
    )


def _as_of(attempt: Attempt, person: str) -> Attempt:
    if attempt.student == person:
        return attempt
    return replace(attempt, student=person, kept_as=attempt.student)


def _of_person(
    person: str,
    series: Sequence[Sequence[tuple[datetime, Attempt]]],
    joins: Sequence[Join],
    told: Mapping[Key, datetime],
) -> Iterator[Attempt]:
    timed = list(merge(*series, key=lambda one: one[0]))
    if len(series) == 1:
        yield from (one for _, one in timed)
        return
    by_bytes: dict[str, list[Attempt]] = {}
    for _, one in timed:
        by_bytes.setdefault(one.digest, []).append(one)
    joined_at = max(one.at for one in joins if one.person == person)
    outranked: set[Key] = set()
    other_times: dict[str, datetime] = {}
    for digest, attempts in by_bytes.items():
        if len({one.key[0] for one in attempts}) > 1:
            outranked.update(_outranked(attempts, told))
            if (other := _other_time(attempts, joined_at)) is not None:
                other_times[digest] = other
    for _, one in timed:
        is_outranked, other = one.key in outranked, other_times.get(one.digest)
        changed = is_outranked or other is not None
        yield replace(one, outranked=is_outranked, other_time=other) if changed else one


def _outranked(attempts: Sequence[Attempt], told: Mapping[Key, datetime]) -> Iterator[Key]:
    """Yield what does not stand, of attempts on the same bytes: another id was told later."""
    known = [(told[one.key], place) for place, one in enumerate(attempts) if one.key in told]
    if not known:
        return
    at, place = max(known)
    teller, _ = attempts[place].key
    for one in attempts:
        is_regraded_since = one.regrade is not None and one.graded_at > at
        if one.key[0] != teller and not is_regraded_since:
            yield one.key


def _other_time(attempts: Sequence[Attempt], joined_at: datetime) -> datetime | None:
    """Return the earlier of two times that were said under different ids and differ, if it is open.

    Whoever said a time after the joining knew of both.
    """
    said = [one for one in attempts if one.handed_in_said and one.handed_in is not None]
    if any(one.graded_at > joined_at for one in said):
        return None
    last = {one.key[0]: one.handed_in for one in said if one.handed_in is not None}
    return min(last.values()) if len(set(last.values())) > 1 else None
