"""Attempts and time: what lateness costs, and which work of a student counts. Pure."""

import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from zoneinfo import ZoneInfo

from gripcourse.gradebook.model import GradebookEntry
from gripcourse.gradebook.works import StudentWork, in_order, points_of
from gripcourse.grading.model import Timing
from gripcourse.policy.model import Policy
from gripcourse.policy.time_rules import AttemptRule, Counts, LateRule

_DAY = timedelta(days=1)


@dataclass(frozen=True, slots=True)
class Waiver:
    """That somebody's lateness is not counted; the last one of a student counts.

    Attributes:
        student: id.
        number: counts the student's from 1; 0 before it is kept.
        until: until when handing in costs nothing; None for ever.
        withdrawn: whether the waivers before it count no longer.
        person, done_at, why: who decided, when and why.
    """

    student: str
    number: int
    until: datetime | None
    withdrawn: bool
    person: str
    done_at: datetime
    why: str


@dataclass(frozen=True, slots=True)
class Rules:
    """What a policy says of time and attempts; see `policy.time_rules`."""

    late: LateRule | None
    attempts: AttemptRule | None


def timings_by_policy(
    policy: Policy,
    works: Sequence[StudentWork],
    marked: Mapping[str, GradebookEntry],
    deadline: datetime | None,
    waived: Sequence[Waiver],
) -> dict[str, Timing]:
    """Return the timing of each work of one student, by digest; none where no rule asks for it.

    Whoever tells what counts asks here: grading and the desk must not differ.

    Args:
        policy: of the course.
        works: of the student.
        marked: the marks of the student that count, by quantity.
        deadline: of the student; None for none. It means nothing where lateness costs nothing.
        waived: the student's waivers, oldest first.
    """
    if policy.late is None and policy.attempts is None:
        return {}
    costly = deadline if policy.late is not None else None
    last = waived[-1] if waived else None
    return timings_of(works, marked, costly, last, Rules(policy.late, policy.attempts))


def timings_of(
    works: Sequence[StudentWork],
    marked: Mapping[str, GradebookEntry],
    deadline: datetime | None,
    waiver: Waiver | None,
    rules: Rules,
) -> dict[str, Timing]:
    """Return the timing of each work of one student, by digest.

    Args:
        works: of the student.
        marked: the marks of the student that count, by quantity.
        deadline: of the student; None for none.
        waiver: the student's last; None for none.
        rules: of the policy.
    """
    ordered = in_order(works)
    costs = {one.digest: lateness(one.handed_in, deadline, waiver, rules.late) for one in ordered}
    most = rules.attempts.most if rules.attempts else 0
    may = [one for one in (ordered[:most] if most else ordered) if one.attempt.judged]
    counting = _counting(may, marked, {name: cost for name, (_, cost) in costs.items()}, rules)
    counted = waiver if waiver is not None and not waiver.withdrawn else None
    return {
        one.digest: Timing(
            number=number,
            of=len(ordered),
            counts=counting is None or one.digest == counting,
            handed_in=one.handed_in,
            deadline=deadline,
            days_late=costs[one.digest][0],
            deduction=costs[one.digest][1],
            waived=counted.why if counted else "",
            waived_until=counted.until if counted else None,
        )
        for number, one in enumerate(ordered, start=1)
    }


def is_settled(
    rule: AttemptRule | None, timings: Collection[Timing], works: Sequence[StudentWork]
) -> bool:
    """Tell whether the rule for attempts says which work of a student counts.

    Args:
        rule: None for none.
        timings: of the works.
        works: of the student.
    """
    if rule is None:
        return False
    if rule.counts is Counts.BEST and (not rule.most or len(works) <= rule.most):
        # All of them may count: points and lateness decide, whichever came first.
        return not any(one.is_unknown for one in timings)
    if all(one.taken is not None for one in works):
        return True
    times = [one.handed_in for one in timings]
    return None not in times and len(set(times)) == len(times)


def lateness(
    handed_in: datetime | None,
    deadline: datetime | None,
    waiver: Waiver | None,
    rule: LateRule | None,
) -> tuple[int, float]:
    """Return the days begun after the deadline, and the share of the points that they cost."""
    if rule is None or handed_in is None or deadline is None:
        return 0, 0.0
    last = deadline
    if waiver is not None and not waiver.withdrawn:
        if waiver.until is None:
            return 0, 0.0
        last = max(deadline, waiver.until)
    # A deadline's last second counts to its end.
    at = handed_in.astimezone(UTC).replace(microsecond=0)
    if at - last.astimezone(UTC) <= timedelta(hours=rule.grace):
        return 0, 0.0
    days = _days_begun(last, at, rule.time_zone)
    return days, min(days * rule.per_day, rule.most)


def _days_begun(last: datetime, at: datetime, zone: ZoneInfo) -> int:
    """Count the days begun after a deadline by the clock on the wall.

    The day on which clocks are set back has 25 hours and is one day all the same.
    """
    wall_last, wall_at = (one.astimezone(zone).replace(tzinfo=None) for one in (last, at))
    return max(1, math.ceil((wall_at - wall_last) / _DAY))


def _counting(
    works: Sequence[StudentWork],
    marked: Mapping[str, GradebookEntry],
    costs: Mapping[str, float],
    rules: Rules,
) -> str | None:
    """Return the digest of the work that counts; None where the policy has no rule."""
    if rules.attempts is None:
        return None
    if not works:
        return ""
    if rules.attempts.counts is Counts.FIRST:
        return works[0].digest
    if rules.attempts.counts is Counts.LAST:
        return works[-1].digest

    def worth(work: StudentWork) -> float:
        sums = points_of(work.attempt.results, marked)
        possible = sums.max_score + sums.open_points
        return sums.score * (1 - costs[work.digest]) / possible if possible else 0.0

    # Of two that are worth the same the later one: its report is the one that was read last.
    return max(reversed(works), key=worth).digest
