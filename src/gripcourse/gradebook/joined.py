"""Whose marks and waivers are that were given under an id which was joined with another's. Pure.

Rows stay as they were kept, under the id under which they were given: joining and taking it back
are entries of the register, and whose a mark is follows from them each time somebody reads it.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from datetime import datetime, timedelta
from itertools import groupby

from gripcourse.gradebook.model import Attempt, GradebookEntry, same_decision
from gripcourse.gradebook.timing import Waiver
from gripcourse.issuing.withdrawal import Join, Withdrawal

_NEXT = timedelta(microseconds=1)  # as finely as databases keep moments


def family(students: Iterable[str], joins: Sequence[Join]) -> frozenset[str]:
    """Return students with the ids that were joined with theirs."""
    found = set(students)
    # Who was joined with somebody, was so before that one was joined with a third.
    for join in reversed(joins):
        if join.person in found:
            found.add(join.student)
    return frozenset(found)


def ever_joined(student: str, withdrawals: Iterable[Withdrawal]) -> frozenset[str]:
    """Return the ids that were ever joined with a student's, taken back or not, and that one."""
    pairs = [{one.student, one.same_as} for one in withdrawals if one.same_as]
    found = {student}
    for _ in pairs:
        found.update(*(pair for pair in pairs if pair & found))
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
    since = [one for one in (last, given) if one is not None and one.mark.marked_at > join.at]
    if since:
        # What was decided since is about both, whichever work it was entered against.
        decided = max(since, key=lambda one: one.mark.marked_at)
        return own if decided is last else (*own, _carried(given, last, join))
    if given.mark.credit is None:
        return own
    if last is None or last.mark.credit is None:
        return (*own, _carried(given, last, join))
    rivals = tuple(
        _carried(one, None, join)
        for one in (given, *given.rivals)
        if not same_decision(one.mark, last.mark)
    )
    return (*own[:-1], replace(last, rivals=(*last.rivals, *rivals)))


def _carried(given: GradebookEntry, last: GradebookEntry | None, join: Join) -> GradebookEntry:
    mark = replace(
        given.mark,
        student=join.person,
        number=1 if last is None else last.mark.number + 1,
        kept_as=given.mark.kept_under,
    )
    return replace(given, mark=mark)


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


def not_before_joining(
    student: str, joins: Iterable[Join], now: datetime, before: GradebookEntry | None = None
) -> datetime:
    """Return when a person decides: after the joining, also where the clock was set back since.

    Args:
        student: who was joined with.
        joins: that stand.
        now: by the clock.
        before: the mark that counts up to now; None for none.
    """
    of_student = [one.at for one in joins if one.person == student]
    if of_student and before is not None:
        of_student.append(before.mark.marked_at)
    return max([now, *(one + _NEXT for one in of_student)])


def joining_after(
    entries: Iterable[GradebookEntry], attempts: Iterable[Attempt], now: datetime
) -> datetime:
    """Return when ids are joined: not before anything that was decided or found of them."""
    return max(
        [now, *(one.mark.marked_at for one in entries), *(one.graded_at for one in attempts)]
    )


def _item(one: GradebookEntry) -> tuple[str, str]:
    return one.mark.student, one.mark.quantity
