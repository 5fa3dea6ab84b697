"""What counts of a student's works: which of them, and what lateness leaves of its points."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace
from typing import Final

from gripcourse.gradebook.journal import waivers
from gripcourse.gradebook.model import Attempt, latest_marks_of_all
from gripcourse.gradebook.store import Gradebook
from gripcourse.gradebook.timing import timings_by_policy
from gripcourse.gradebook.works import in_order, points_of, works_of
from gripcourse.grading.model import PointSums, Timing, after_lateness
from gripcourse.policy.time_rules import AttemptRule, Counts
from gripcourse.text.words import Message, message
from gripcourse.usecases.serving.desk import DeskContext


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


_WHICH: Final[Mapping[Counts, Message]] = {
    Counts.FIRST: message("The first workbook counts."),
    Counts.LAST: message("The last workbook counts."),
    Counts.BEST: message("The best workbook counts."),
}
_WHICH_OF: Final[Mapping[Counts, Message]] = {
    Counts.FIRST: _WHICH[Counts.FIRST],
    Counts.LAST: message("Of the first {most} workbooks the last one counts."),
    Counts.BEST: message("Of the first {most} workbooks the best one counts."),
}


def which_counts(rule: AttemptRule | None) -> Message:
    """Say which of several workbooks of a student counts."""
    if rule is None:
        return _WHICH[Counts.LAST]
    if rule.most == 1:
        return _WHICH[Counts.FIRST]
    if not rule.most:
        return _WHICH[rule.counts]
    return replace(_WHICH_OF[rule.counts], values={"most": rule.most})


def counted_works(
    context: DeskContext, students: Collection[str] | None = None
) -> dict[str, CountedWork]:
    """Return the work that counts of each student of the register who has one.

    Where no rule says which of several works counts, it is the one handed in last of those that
    could be judged.

    Args:
        context: of the course.
        students: of whom alone; None for all.

    Raises:
        RegisterError: the register cannot be used.
        GradebookError: the gradebook cannot be used.
    """
    book, policy, register = Gradebook(context.desk.engine), context.policy, context.register()
    names = None if students is None else set(students)
    marked, waived = latest_marks_of_all(book.entries(names)), waivers(book)
    found = {}
    for student, works in works_of(book.standing(names)).items():
        if student not in register:
            continue
        marks = marked.get(student, {})
        deadline = context.deadlines.of(register[student])
        timings = timings_by_policy(policy, works, marks, deadline, waived.get(student, ()))
        counting = [
            one
            for one in works
            if one.attempt.judged and (one.digest not in timings or timings[one.digest].counts)
        ]
        if counting:
            one = in_order(counting)[-1].attempt
            found[student] = CountedWork(
                one, points_of(one.results, marks), timings.get(one.digest)
            )
    return found
