"""Works: the files that a student handed in, each with the attempt that stands for it now."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from datetime import datetime

from gripcourse.gradebook.model import Attempt, GradebookEntry
from gripcourse.gradebook.results import Result
from gripcourse.grading.model import PointSums


@dataclass(frozen=True, slots=True)
class StudentWork:
    """One file of one student, however often it was graded.

    Attributes:
        student: id.
        number: counts the student's works from 1, in the order in which they were graded first.
        first: its first attempt.
        attempt: the attempt that stands for it.
        handed_in: when; what a person said last goes before the file's own time. None: unknown.
    """

    student: str
    number: int
    first: Attempt
    attempt: Attempt
    handed_in: datetime | None

    @property
    def digest(self) -> str:
        """SHA-256 of the file's bytes, hexadecimal."""
        return self.attempt.digest


def works_of(standing: Iterable[Attempt]) -> dict[str, tuple[StudentWork, ...]]:
    """Return the works of each student, in the order in which they were graded first.

    Args:
        standing: attempts of any students, without those that were taken back.
    """
    by_student: dict[str, dict[str, list[Attempt]]] = {}
    for one in sorted(standing, key=lambda one: one.number):
        by_student.setdefault(one.student, {}).setdefault(one.digest, []).append(one)
    return {
        student: tuple(
            StudentWork(student, number, attempts[0], attempts[-1], _handed_in(attempts))
            for number, attempts in enumerate(by_file.values(), start=1)
        )
        for student, by_file in by_student.items()
    }


def in_order(works: Iterable[StudentWork]) -> list[StudentWork]:
    """Return the works of one student in the order in which they were handed in."""
    return sorted(works, key=lambda one: (one.handed_in or one.first.graded_at, one.number))


def _handed_in(attempts: Sequence[Attempt]) -> datetime | None:
    said = [one.handed_in for one in attempts if one.handed_in_said]
    return said[-1] if said else attempts[0].handed_in


def latest_judged(standing: Iterable[Attempt]) -> dict[str, Attempt]:
    """Return what stands for the last work of each student that could be judged, by student."""
    return {
        student: judged[-1].attempt
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
