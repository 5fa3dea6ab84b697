"""Works: the files that a student handed in, each with the attempt that stands for it now."""

from collections.abc import Container, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import datetime
from itertools import accumulate
from types import MappingProxyType
from typing import Final

from gripcourse.gradebook.model import Attempt, GradebookEntry
from gripcourse.gradebook.results import Result
from gripcourse.grading.model import PointSums

_NOTHING: Final[Mapping[tuple[str, str], int]] = MappingProxyType({})


@dataclass(frozen=True, slots=True)
class StudentWork:
    """One file of one student, however often it was graded.

    Attributes:
        student: id.
        number: counts the student's works from 1, in the order in which they were graded first.
        first: its first attempt.
        attempt: the attempt that stands for it.
        handed_in: when; what a person said last goes before the file's own time. None: unknown.
            Of two that were said under two ids of one person the earlier, until a person says more.
        taken: its place among what the desk took of the student; None where it came otherwise.
        of_two: whether that is the earlier of two times that were said under two ids.
    """

    student: str
    number: int
    first: Attempt
    attempt: Attempt
    handed_in: datetime | None
    taken: int | None = None
    of_two: bool = False

    @property
    def digest(self) -> str:
        """SHA-256 of the file's bytes, hexadecimal."""
        return self.attempt.digest


def standing_of(attempts: Iterable[Attempt], undone: Container[int | None]) -> tuple[Attempt, ...]:
    """Return attempts but those of regrades that were taken back.

    When a work was handed in is no result: what a person said of it meanwhile stays said.

    Args:
        attempts: of any students, oldest first for each.
        undone: numbers of the regrades that were taken back.
    """
    found: list[Attempt] = []
    place_of: dict[tuple[str, str], int] = {}
    for one in attempts:
        key = one.student, one.digest
        if one.regrade not in undone:
            place_of[key] = len(found)
            found.append(one)
        elif one.handed_in_said and key in place_of:
            before = found[place_of[key]]
            found[place_of[key]] = replace(before, handed_in=one.handed_in, handed_in_said=True)
    return tuple(found)


def works_of(
    standing: Iterable[Attempt], taken: Mapping[tuple[str, str], int] = _NOTHING
) -> dict[str, tuple[StudentWork, ...]]:
    """Return the works of each student, in the order in which they were graded first.

    Args:
        standing: attempts of any students, without those that were taken back, oldest first for
            each student.
        taken: by student and digest, the place of a work among what the desk took of the student.
    """
    by_student: dict[str, dict[str, list[Attempt]]] = {}
    for one in standing:
        by_student.setdefault(one.student, {}).setdefault(one.digest, []).append(one)
    return {
        student: tuple(
            StudentWork(
                student,
                number,
                attempts[0],
                _standing(attempts),
                _handed_in(attempts),
                taken.get((student, digest)),
                _earlier_of_two(attempts) is not None,
            )
            for number, (digest, attempts) in enumerate(by_file.items(), start=1)
        )
        for student, by_file in by_student.items()
    }


def in_order(works: Iterable[StudentWork]) -> list[StudentWork]:
    """Return the works of one student in the order in which they were handed in.

    What the desk took stands in the order in which it did, also where the clock was set back
    meanwhile; among it other works stand by their times.
    """
    known = tuple(works)
    by_desk = sorted((one for one in known if one.taken is not None), key=_place)
    times = accumulate((_time(one) for one in by_desk), max)
    at_least = {one.digest: time for one, time in zip(by_desk, times, strict=True)}
    return sorted(
        known, key=lambda one: (at_least.get(one.digest, _time(one)), _place(one), one.number)
    )


def _time(work: StudentWork) -> datetime:
    return work.handed_in or work.first.graded_at


def _place(work: StudentWork) -> int:
    return work.taken or 0


def _standing(attempts: Sequence[Attempt]) -> Attempt:
    return next((one for one in reversed(attempts) if not one.outranked), attempts[-1])


def _handed_in(attempts: Sequence[Attempt]) -> datetime | None:
    if (earlier := _earlier_of_two(attempts)) is not None:
        return earlier
    said = [one.handed_in for one in attempts if one.handed_in_said]
    return said[-1] if said else attempts[0].handed_in


def _earlier_of_two(attempts: Sequence[Attempt]) -> datetime | None:
    """Return the earlier of two times that were said under two ids, while nobody decides."""
    if any(one.handed_in_said and one.other_time is None for one in attempts):
        return None
    return next((one.other_time for one in attempts if one.other_time is not None), None)


def latest_judged(standing: Iterable[Attempt]) -> dict[str, Attempt]:
    """Return what stands for the last work of each student that could be judged, by student.

    It is the one that was handed in last, as for what counts.
    """
    return {
        student: in_order(judged)[-1].attempt
        for student, works in works_of(standing).items()
        if (judged := [one for one in works if one.attempt.judged])
    }


def points_of(results: Iterable[Result], marked: Mapping[str, GradebookEntry]) -> PointSums:
    """Add up the points of automatic results with the marks that count, as a report does.

    Args:
        results: of one attempt.
        marked: the marks of the student that count, by quantity.
    """
    score = most = waiting = 0.0
    for one in results:
        entry = marked.get(one.quantity)
        if entry is None and one.outcome.traits.waits:
            waiting += one.max_points
            continue
        # A withdrawn mark, the only one without a credit, does not count.
        credit = None if entry is None else entry.mark.credit
        score += one.points if credit is None else credit * one.max_points
        most += one.max_points
    return PointSums(score, most, waiting)
