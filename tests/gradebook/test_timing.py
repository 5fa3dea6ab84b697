"""Lateness costs what the policy says, and one of several works counts."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from datetime import UTC, datetime, timedelta

import pytest

from gripcourse.gradebook.model import Attempt
from gripcourse.gradebook.timing import Rules, Waiver, timings_of
from gripcourse.gradebook.works import StudentWork, works_of
from gripcourse.grading.model import Outcome, Report, Timing
from gripcourse.policy.time_rules import AttemptRule, Counts, LateRule

MakeReport = Callable[..., Report]
MakeAttempts = Callable[..., Sequence[Attempt]]

DEADLINE = datetime(2026, 12, 1, 22, tzinfo=UTC)
RULE = LateRule(per_day=0.1, most=0.35, grace=2, zone="UTC")
GOOD, POOR = (Outcome.CORRECT, 2.0, 2.0), (Outcome.WRONG, 0.0, 2.0)


@pytest.fixture
def hand_in(report: MakeReport, attempts: MakeAttempts) -> Callable[..., tuple[StudentWork, ...]]:
    """Works of one student, each by its hours after the deadline and what was found."""

    def works(*given: tuple[float | None, tuple[Outcome, float, float]]) -> tuple[StudentWork, ...]:
        kept = []
        for number, (hours, bore) in enumerate(given, start=1):
            (one,) = attempts(report(digest=str(number) * 64, bore=bore))
            at = None if hours is None else DEADLINE + timedelta(hours=hours)
            kept.append(replace(one, number=number, handed_in=at))
        return works_of(kept)["s01"]

    return works


def timings(
    works: Sequence[StudentWork],
    waiver: Waiver | None = None,
    counts: AttemptRule | None = None,
    deadline: datetime | None = DEADLINE,
) -> list[Timing]:
    found = timings_of(works, {}, deadline, waiver, Rules(RULE, counts))
    return [found[one.digest] for one in works]


def waiver(until: datetime | None = None, *, withdrawn: bool = False) -> Waiver:
    return Waiver("s01", 1, until, withdrawn, "Петров", DEADLINE, "болезнь")


@pytest.mark.parametrize(
    ("hours", "days", "share"),
    [(-1, 0, 0), (0, 0, 0), (2, 0, 0), (2.1, 1, 0.1), (24, 1, 0.1), (25, 2, 0.2), (240, 10, 0.35)],
)
def test_each_day_begun_after_the_grace_costs_up_to_the_most(
    hand_in: Callable[..., tuple[StudentWork, ...]], hours: float, days: int, share: float
) -> None:
    (timing,) = timings(hand_in((hours, GOOD)))
    assert (timing.days_late, timing.deduction) == (days, pytest.approx(share))


@pytest.mark.parametrize(
    ("deadline", "handed_in", "days"),
    [
        # Set back at 4:00 on the 25th, a day of 25 hours; set forward at 3:00 on the 29th: 23.
        ("2026-10-24 23:59:59", "2026-10-25 23:59:59", 1),
        ("2026-10-24 23:59:59", "2026-10-26 00:00:00", 2),
        ("2026-10-24 18:00:00", "2026-10-25 18:00:00", 1),
        ("2026-03-28 23:59:59", "2026-03-29 23:59:59", 1),
        ("2026-03-28 23:59:59", "2026-03-30 00:00:00", 2),
        ("2026-12-01 18:00:00", "2026-12-01 18:00:00.7", 0),
        ("2026-12-01 18:00:00", "2026-12-01 18:00:01", 1),
    ],
)
def test_a_day_is_one_by_the_clock_on_the_wall(
    hand_in: Callable[..., tuple[StudentWork, ...]], deadline: str, handed_in: str, days: int
) -> None:
    kyiv = LateRule(per_day=0.1, most=1, grace=0, zone="Europe/Kyiv")
    last, at = (
        datetime.fromisoformat(one).replace(tzinfo=kyiv.time_zone) for one in (deadline, handed_in)
    )
    (work,) = hand_in((0, GOOD))
    attempt = replace(work.attempt, handed_in=at.astimezone(UTC))
    works = works_of([attempt])["s01"]
    (timing,) = timings_of(works, {}, last, None, Rules(kyiv, None)).values()
    assert timing.days_late == days


def test_without_a_deadline_or_a_time_nothing_is_late(
    hand_in: Callable[..., tuple[StudentWork, ...]],
) -> None:
    assert timings(hand_in((100, GOOD)), deadline=None)[0].deduction == 0
    assert timings(hand_in((None, GOOD)))[0].deduction == 0


def test_a_waiver_moves_the_deadline_or_takes_it_away_until_it_is_withdrawn(
    hand_in: Callable[..., tuple[StudentWork, ...]],
) -> None:
    works = hand_in((49, GOOD))
    until = DEADLINE + timedelta(days=1)
    shares = [
        timings(works, one)[0].deduction
        for one in (None, waiver(), waiver(until), waiver(withdrawn=True))
    ]
    assert shares == pytest.approx([0.3, 0, 0.2, 0.3])
    assert timings(works, waiver())[0].waived == "болезнь"
    told = [timings(works, one)[0].waived_until for one in (None, waiver(), waiver(until))]
    assert told == [None, None, until]
    assert timings(works, waiver(until, withdrawn=True))[0].waived_until is None


@pytest.mark.parametrize(
    ("counts", "most", "expected"),
    [
        (Counts.FIRST, 0, [True, False, False]),
        (Counts.LAST, 0, [False, False, True]),
        (Counts.BEST, 0, [False, True, False]),
        (Counts.LAST, 2, [False, True, False]),
        (Counts.BEST, 1, [True, False, False]),
    ],
)
def test_one_work_counts(
    hand_in: Callable[..., tuple[StudentWork, ...]], counts: Counts, most: int, expected: list[bool]
) -> None:
    works = hand_in((-9, POOR), (-5, GOOD), (-1, POOR))
    assert [one.counts for one in timings(works, counts=AttemptRule(counts, most))] == expected


def test_the_best_is_the_best_after_what_lateness_costs(
    hand_in: Callable[..., tuple[StudentWork, ...]],
) -> None:
    works = hand_in((-1, (Outcome.CARRIED, 1.8, 2.0)), (100, GOOD))
    assert [one.counts for one in timings(works, counts=AttemptRule(Counts.BEST, 0))] == [
        True,
        False,
    ]


def test_works_are_counted_in_the_order_in_which_they_were_handed_in(
    hand_in: Callable[..., tuple[StudentWork, ...]],
) -> None:
    later, earlier = timings(hand_in((5, GOOD), (-5, GOOD)), counts=AttemptRule(Counts.LAST, 0))
    assert (earlier.number, later.number, later.counts) == (1, 2, True)


def test_without_a_rule_each_work_is_reported_for_itself(
    hand_in: Callable[..., tuple[StudentWork, ...]],
) -> None:
    assert all(one.counts for one in timings(hand_in((-2, GOOD), (-1, POOR))))
