"""Whose marks and waivers are that were given under an id which was joined with another's. Pure.

Rows stay as they were kept, under the id under which they were given: joining and taking it back
are entries of the register, and whose a mark is follows from them each time somebody reads it.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from datetime import datetime, timedelta
from itertools import groupby

from gripcourse.gradebook.model import GradebookEntry, same_decision
from gripcourse.gradebook.timing import Waiver
from gripcourse.issuing.withdrawal import Join

_NEXT = timedelta(microseconds=1)  # as finely as databases keep moments


def family(students: Iterable[str], joins: Sequence[Join]) -> frozenset[str]:
    """Return students with the ids that were joined with theirs."""
    found = set(students)
    # Who was joined with somebody, was so before that one was joined with a third.
    for join in reversed(joins):
        if join.person in found:
            found.add(join.student)
    return frozenset(found)


def marks_of_persons(
    entries: Iterable[GradebookEntry], joins: Sequence[Join]
) -> tuple[GradebookEntry, ...]:
    """Return marks as those of the persons whom ids stand for now.

    Of each item the mark of the id that a person keeps counts, else that of the other. Where both
    have one and they differ, the kept one has the other as its rival until somebody marks again.

    Args:
        entries: all marks of some persons and of the ids that were joined with theirs.
        joins: that stand, oldest first.
    """
    found: dict[tuple[str, str], tuple[GradebookEntry, ...]] = {}
    for key, group in groupby(
        sorted(entries, key=lambda one: (*_item(one), one.mark.number)), key=_item
    ):
        found[key] = tuple(group)
    for join in joins:
        for student, quantity in [one for one in found if one[0] == join.student]:
            given = found.pop((student, quantity))
            item = join.person, quantity
            carried = _with_carried(found.get(item, ()), given[-1], join)
            if carried:
                found[item] = carried
    return tuple(one for entries_of in found.values() for one in entries_of)


def _with_carried(
    own: tuple[GradebookEntry, ...], given: GradebookEntry, join: Join
) -> tuple[GradebookEntry, ...]:
    """Return the marks of an item of a person, with the one that counted under a joined id."""
    last = own[-1] if own else None
    if given.mark.credit is None or (last is not None and last.mark.marked_at > join.at):
        return own
    if last is None or last.mark.credit is None:
        number = 1 if last is None else last.mark.number + 1
        mark = replace(given.mark, student=join.person, number=number)
        return (*own, replace(given, mark=mark, given_to=given.given_to or join.student))
    rivals = tuple(
        replace(one, given_to=one.given_to or join.student)
        for one in (given, *given.rivals)
        if not same_decision(one.mark, last.mark)
    )
    return (*own[:-1], replace(last, rivals=(*last.rivals, *rivals)))


def waivers_of_persons(
    kept: Mapping[str, tuple[Waiver, ...]], joins: Sequence[Join]
) -> dict[str, tuple[Waiver, ...]]:
    """Return waivers as those of the persons whom ids stand for now; the more generous one counts.

    Args:
        kept: by the id under which they were given, oldest first.
        joins: that stand, oldest first.
    """
    found = dict(kept)
    for join in joins:
        given = found.pop(join.student, ())
        if not given or given[-1].withdrawn:
            continue
        own = found.get(join.person, ())
        before = tuple(one for one in own if one.done_at <= join.at)
        if not before or _is_more_generous(given[-1], before[-1]):
            carried = replace(given[-1], student=join.person)
            found[join.person] = (*before, carried, *own[len(before) :])
    return found


def _is_more_generous(one: Waiver, other: Waiver) -> bool:
    if other.withdrawn or one.until is None or other.until is None:
        return other.withdrawn or other.until is not None
    return one.until > other.until


def not_before_joining(student: str, joins: Iterable[Join], now: datetime) -> datetime:
    """Return when a person decides: after the joining, also where the clock was set back since."""
    return max([now, *(one.at + _NEXT for one in joins if one.person == student)])


def joining_after(entries: Iterable[GradebookEntry], now: datetime) -> datetime:
    """Return when ids are joined: not before anything that was decided of them."""
    return max([now, *(one.mark.marked_at for one in entries)])


def _item(one: GradebookEntry) -> tuple[str, str]:
    return one.mark.student, one.mark.quantity
