"""What lateness costs and which of several works counts; a policy may be silent about either."""

from dataclasses import dataclass
from enum import StrEnum
from zoneinfo import ZoneInfo, ZoneInfoNotFoundError

from gripcourse.course.toml_table import Table
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import message


class Counts(StrEnum):
    """Which work of a student counts."""

    FIRST = "first"
    LAST = "last"
    BEST = "best"


@dataclass(frozen=True, slots=True)
class LateRule:
    """What lateness costs.

    Attributes:
        per_day: share of the points that each day begun takes off.
        most: share that lateness takes off at most.
        grace: hours after the deadline that cost nothing.
        zone: time zone of the course, in which deadlines are written: a name of the IANA base.
    """

    per_day: float
    most: float
    grace: float
    zone: str

    @property
    def time_zone(self) -> ZoneInfo:
        """The zone itself."""
        return ZoneInfo(self.zone)


@dataclass(frozen=True, slots=True)
class AttemptRule:
    """Which work counts.

    Attributes:
        counts: of those that may count.
        most: how many may, in the order in which they were handed in; 0 for any number.
    """

    counts: Counts
    most: int

    @property
    def asks_for_all(self) -> bool:
        """Whether the last work alone does not tell which one counts."""
        return self.counts is not Counts.LAST or self.most > 0


def read_late_rule(table: Table | None) -> LateRule | None:
    """Read what lateness costs; None where the policy says nothing of it."""
    if table is None:
        return None
    table.known_keys()
    zone = table.text("zone", "UTC")
    try:
        ZoneInfo(zone)
    except (ZoneInfoNotFoundError, ValueError, OSError):
        table.add(
            "zone",
            message("There is no time zone '{name}'.", name=zone),
            message("Write a name such as Europe/Kyiv or Europe/Moscow."),
        )
        zone = "UTC"
    return LateRule(
        per_day=table.share("per_day"),
        most=table.share("most", 1.0),
        grace=max(0.0, table.number("grace", 0.0)),
        zone=zone,
    )


def read_attempt_rule(table: Table | None) -> AttemptRule | None:
    """Read which work counts; None where the policy says nothing of it."""
    if table is None:
        return None
    table.known_keys()
    counts, most = table.text("counts"), table.number("most", 0.0)
    if counts not in list(Counts):
        table.add(
            "counts",
            message("There is no rule '{name}'.", name=counts),
            did_you_mean(counts, list(Counts)),
        )
        counts = Counts.LAST
    if most != int(most):
        table.add(
            "most",
            message("The number is {value}.", value=most),
            message("Write a whole number from 0 on."),
        )
    return AttemptRule(Counts(counts), int(most))


def zone_of(rule: LateRule | None) -> ZoneInfo:
    """Return the time zone of a course; UTC where its policy says nothing of time."""
    return ZoneInfo("UTC") if rule is None else rule.time_zone
