"""What counts of a student's works: which of them, and what lateness leaves of its points. Pure."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from datetime import datetime

from gripcourse.gradebook.model import Attempt, GradebookEntry
from gripcourse.gradebook.timing import Waiver, timings_by_policy
from gripcourse.gradebook.works import StudentWork, in_order, points_of
from gripcourse.grading.model import PointSums, Timing, after_lateness
from gripcourse.policy.model import Policy


@dataclass(frozen=True, slots=True)
class CountedWork:
    """The work of a student that counts, as it stands in the gradebook.

    Attributes:
        attempt: that stands for it.
        sums: its points before lateness, with the marks of persons.
        timing: of the work; None where the policy has no rule.
    """

    attempt: Attempt
    sums: PointSums
    timing: Timing | None

    @property
    def earned(self) -> float:
        """Points that count, after what lateness takes off."""
        return after_lateness(self.sums.score, self.timing)


def counted_work(
    policy: Policy,
    works: Sequence[StudentWork],
    marked: Mapping[str, GradebookEntry],
    deadline: datetime | None,
    waived: Sequence[Waiver],
) -> CountedWork | None:
    """Return the work of one student that counts; None where no work could be judged.

    Where no rule says which of several works counts, it is the one handed in last of those that
    could be judged.

    Args:
        policy: of the course.
        works: of the student.
        marked: the marks of the student that count, by quantity.
        deadline: of the student; None for none.
        waived: the student's waivers, oldest first.
    """
    timings = timings_by_policy(policy, works, marked, deadline, waived)
    counting = [
        one
        for one in works
        if one.attempt.judged and (one.digest not in timings or timings[one.digest].counts)
    ]
    if not counting:
        return None
    attempt = in_order(counting)[-1].attempt
    return CountedWork(attempt, points_of(attempt.results, marked), timings.get(attempt.digest))
