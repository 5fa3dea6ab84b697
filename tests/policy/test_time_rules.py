"""A policy says what lateness costs and which work counts, or nothing."""

from gripcourse.course.toml_table import Table
from gripcourse.policy.keys import POLICY
from gripcourse.policy.model import Policy
from gripcourse.policy.time_rules import Counts, read_attempt_rule, read_late_rule

LATE: dict[str, object] = {"per_day": 0.1, "zone": "Europe/Kyiv"}


def read(**tables: dict[str, object]) -> tuple[object, object, list[str]]:
    table = Table(tables, "policy.toml", "", [], POLICY)
    late = read_late_rule(table.table("late"))
    attempts = read_attempt_rule(table.table("attempts"))
    return late, attempts, [str(one.what) for one in table.problems]


def test_the_reference_course_asks_for_nothing(policy: Policy) -> None:
    assert (policy.late, policy.attempts) == (None, None)
    assert read() == (None, None, [])


def test_what_is_left_out_has_no_bound() -> None:
    late, attempts, problems = read(late=LATE, attempts={"counts": "best"})
    assert problems == []
    assert (late.per_day, late.most, late.grace) == (0.1, 1.0, 0.0)  # type: ignore[attr-defined]
    assert (attempts.counts, attempts.most) == (Counts.BEST, 0)  # type: ignore[attr-defined]


def test_what_is_no_rule_is_named() -> None:
    *_, problems = read(
        late={**LATE, "zone": "Kiew", "per_day": 2, "pre_day": 1},
        attempts={"counts": "worst", "most": 1.5},
    )
    assert sorted(problems) == [
        "The number is 1.5.",
        "The share is 2.",
        "There is no rule 'worst'.",
        "There is no time zone 'Kiew'.",
        "This key means nothing here.",
    ]
