"""What a regrade would change: old against new, item by item. Pure."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from enum import StrEnum

from gripcourse.gradebook.model import Attempt, GradebookEntry
from gripcourse.gradebook.results import Result, same_results
from gripcourse.gradebook.works import StudentWork, points_of
from gripcourse.grading.model import PointSums

_SAME = 1e-6  # points of one policy are the same number on each machine but for the last bits


class Shift(StrEnum):
    """What a regrade does to a work; the value is typed at the command line."""

    RAISED = "raised"
    LOWERED = "lowered"
    UNCHANGED = "unchanged"


class ChangedPart(StrEnum):
    """What may have changed between two gradings."""

    ENGINE = "engine"
    VERSION = "version"  # of the assignment, that the work is judged by
    COURSE = "course"
    POLICY = "policy"


@dataclass(frozen=True, slots=True)
class ItemChange:
    """What a regrade changes about one item; None where it is not asked for.

    Attributes:
        quantity: id.
        before, after: what the program found.
    """

    quantity: str
    before: Result | None
    after: Result | None


@dataclass(frozen=True, slots=True)
class WorkChange:
    """What a regrade comes to for one work.

    Attributes:
        work: as it stands.
        new: the attempt that would stand for it, not kept yet.
        versions: what has changed since it was graded.
        items: those whose automatic result is another.
        before, after: points, with the marks that count.
        published: whether the student has been told the result.
    """

    work: StudentWork
    new: Attempt
    versions: tuple[ChangedPart, ...]
    items: tuple[ItemChange, ...]
    before: PointSums
    after: PointSums
    published: bool

    @property
    def direction(self) -> Shift:
        """Whether the share of all points grows or falls."""
        return direction_of(self.before, self.after)

    @property
    def is_lost(self) -> bool:
        """Whether a work that was judged cannot be judged any more: this is never applied."""
        return self.work.attempt.judged and not self.new.judged

    @property
    def changes(self) -> bool:
        """Whether there is anything to apply."""
        return not self.is_lost and (
            self.new.judged != self.work.attempt.judged or bool(self.items)
        )


def direction_of(before: PointSums, after: PointSums) -> Shift:
    """Tell whether the share of all points grows or falls."""
    difference = _share(after) - _share(before)
    if abs(difference) < _SAME:
        return Shift.UNCHANGED
    return Shift.RAISED if difference > 0 else Shift.LOWERED


def change_of(
    work: StudentWork, new: Attempt, marked: Mapping[str, GradebookEntry], *, published: bool
) -> WorkChange:
    """Compare what stands for a work with what it comes to now.

    Args:
        work: as it stands.
        new: of the same bytes.
        marked: the marks of the student that count, by quantity.
        published: whether the student has been told the result.
    """
    old = work.attempt
    return WorkChange(
        work=work,
        new=new,
        versions=tuple(_versions(old, new)),
        items=tuple(_items(old, new)),
        before=points_of(old.results, marked),
        after=points_of(new.results, marked),
        published=published,
    )


def _versions(old: Attempt, new: Attempt) -> Iterator[ChangedPart]:
    """Yield what is another; of another version of the assignment the course may be that of then.

    Nobody has changed the course where a work is judged by the version before.
    """
    before, after = old.fingerprints, new.fingerprints
    if before.engine != after.engine:
        yield ChangedPart.ENGINE
    if old.version != new.version:
        yield ChangedPart.VERSION
    elif before.course != after.course:
        yield ChangedPart.COURSE
    if before.policy != after.policy:
        yield ChangedPart.POLICY


def _items(old: Attempt, new: Attempt) -> Iterator[ItemChange]:
    before, after = old.by_quantity, new.by_quantity
    for name in dict.fromkeys((*before, *after)):
        pair = before.get(name), after.get(name)
        if not same_results(*([one] if one else [] for one in pair)):
            yield ItemChange(name, *pair)


def _share(sums: PointSums) -> float:
    most = sums.max_score + sums.open_points
    return sums.score / most if most else 0.0
