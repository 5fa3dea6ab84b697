"""A moment is told by the clock of the course; a reader can tell which clock that is."""

from datetime import UTC, datetime, timedelta, timezone
from zoneinfo import ZoneInfo

import pytest

from gripcourse.text.amounts import NO_BREAK_SPACE
from gripcourse.text.moments import hour_text, moment_text, zone_name
from gripcourse.text.words import Words

KYIV = ZoneInfo("Europe/Kyiv")


@pytest.mark.parametrize(
    ("language", "written"),
    [
        ("en", "1 Dec 2026, 18:00 UTC+2"),
        ("ru", "1 дек. 2026, 18:00 UTC+2"),
        ("uk", "1 груд. 2026, 18:00 UTC+2"),
    ],
)
def test_a_moment_is_told_by_the_clock_of_the_course(language: str, written: str) -> None:
    told = moment_text(datetime(2026, 12, 1, 16, tzinfo=UTC), Words(language), KYIV)
    assert told.replace(NO_BREAK_SPACE, " ") == written


def test_an_hour_that_clocks_show_twice_is_told_apart() -> None:
    twice = (datetime(2026, 10, 25, hour, 30, tzinfo=UTC) for hour in (0, 1))
    first, second = (moment_text(one, Words("en"), KYIV) for one in twice)
    assert first.endswith(f"03:30{NO_BREAK_SPACE}UTC+3")
    assert second.endswith(f"03:30{NO_BREAK_SPACE}UTC+2")


@pytest.mark.parametrize(
    ("minutes", "written"), [(0, "UTC"), (330, "UTC+5:30"), (-210, "UTC\N{MINUS SIGN}3:30")]
)
def test_the_difference_from_utc_is_told_as_people_write_it(minutes: int, written: str) -> None:
    zone = timezone(timedelta(minutes=minutes))
    told = hour_text(datetime(2026, 12, 1, 18, tzinfo=zone), Words("en"))
    assert told == f"18:00{NO_BREAK_SPACE}{written}"


def test_a_zone_is_named_where_its_name_says_more_than_the_difference() -> None:
    assert [zone_name(one) for one in (KYIV, ZoneInfo("UTC"), UTC, None)] == [
        "Europe/Kyiv",
        *[""] * 3,
    ]
