"""What waits for a person: items without a mark, and marks to look at again."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass

from gripcourse.gradebook.model import (
    Attempt,
    GradebookEntry,
    is_outdated,
    latest_marks,
)
from gripcourse.gradebook.results import Result
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


@dataclass(frozen=True, slots=True)
class ItemNow:
    """An item of a student's last work as it stands, whether it waits for a person or not.

    Attributes:
        item: as one that somebody looks at.
        found: what the program found.
        marked: the mark that counts; None for none.
    """

    item: Waiting
    found: Result
    marked: GradebookEntry | None

    @property
    def overrules(self) -> bool:
        """Whether a mark of it overrules what the program found."""
        return not self.found.outcome.traits.waits


def item_now(
    attempt: Attempt, marked: Mapping[str, GradebookEntry], quantity: str
) -> ItemNow | None:
    """Return how an item of an attempt stands; None where it has no such item.

    Args:
        attempt: the student's last one that was judged.
        marked: the marks of the student that count, by quantity.
        quantity: id of the item.
    """
    found, entry = attempt.by_quantity.get(quantity), marked.get(quantity)
    if found is None:
        return None
    again = entry is not None and is_outdated(entry, attempt.digest, attempt.results)
    item = Waiting(attempt.student, quantity, attempt.file, found.outcome, again)
    return ItemNow(item, found, entry)


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
        now = item_now(attempt, marked, result.quantity)
        if now is not None and (now.item.again or (now.marked is None and not now.overrules)):
            yield now.item
