"""What waits for a person: items without a mark, and marks to look at again."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass

from gripcourse.gradebook.model import (
    Attempt,
    GradebookEntry,
    is_outdated,
    latest_marks,
)
from gripcourse.gradebook.works import latest_judged
from gripcourse.grading.model import Outcome


@dataclass(frozen=True, slots=True)
class Waiting:
    """One item that somebody should look at.

    Attributes:
        student, quantity: ids.
        file: the student's last file that could be judged, as it was graded.
        outcome: what the program found: MANUAL, NOT_JUDGED, or what a person overruled.
        again: whether a person marked it already, before the automatic part changed.
    """

    student: str
    quantity: str
    file: str
    outcome: Outcome
    again: bool


def waiting(attempts: Iterable[Attempt], entries: Iterable[GradebookEntry]) -> tuple[Waiting, ...]:
    """Return what waits for a person, by student and in the order of the assignment.

    Args:
        attempts: all that stand in the gradebook.
        entries: all marks that it keeps.
    """
    by_student: dict[str, list[GradebookEntry]] = {}
    for entry in entries:
        by_student.setdefault(entry.mark.student, []).append(entry)
    return tuple(
        one
        for student, attempt in sorted(latest_judged(attempts).items())
        for one in _waiting(attempt, latest_marks(by_student.get(student, ())))
    )


def _waiting(attempt: Attempt, marked: Mapping[str, GradebookEntry]) -> Iterator[Waiting]:
    for result in attempt.results:
        entry = marked.get(result.quantity)
        again = entry is not None and is_outdated(entry, attempt.digest, attempt.results)
        if again or (entry is None and result.outcome.traits.waits):
            yield Waiting(attempt.student, result.quantity, attempt.file, result.outcome, again)
