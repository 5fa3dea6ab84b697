"""Moments as people read them: by the clock of a course, with the difference from UTC."""

from datetime import datetime, timedelta, tzinfo
from typing import Final
from zoneinfo import ZoneInfo

from gripcourse.text.amounts import NO_BREAK_SPACE
from gripcourse.text.words import Words

_MINUTES: Final = "d MMM y, HH:mm"
_SECONDS: Final = "d MMM y, HH:mm:ss"
_HOUR: Final = "HH:mm"


def moment_text(
    moment: datetime, words: Words, zone: tzinfo | None, *, seconds: bool = False
) -> str:
    """Write a moment: `1 Dec 2026, 18:00 UTC+2`; once in a year a clock shows an hour twice.

    Args:
        moment: with a zone, whichever.
        words: language of the reader.
        zone: of the course; None for that of this machine.
        seconds: whether they are told.
    """
    return _written(moment.astimezone(zone), _SECONDS if seconds else _MINUTES, words)


def hour_text(moment: datetime, words: Words) -> str:
    """Write the hour of a moment in its own zone: `18:00 UTC+2`."""
    return _written(moment, _HOUR, words)


def zone_name(zone: tzinfo | None) -> str:
    """Return what a zone is called, where that says more than the difference from UTC."""
    return zone.key if isinstance(zone, ZoneInfo) and zone.key != "UTC" else ""


def _written(local: datetime, pattern: str, words: Words) -> str:
    from babel.dates import format_datetime  # noqa: PLC0415 (only who prints a moment pays)

    told = format_datetime(local, pattern, tzinfo=local.tzinfo, locale=words.language)
    written = f"{told} {_difference(local)}"
    return written.replace(" ", NO_BREAK_SPACE).replace(f",{NO_BREAK_SPACE}", ", ")


def _difference(local: datetime) -> str:
    minutes = round((local.utcoffset() or timedelta()).total_seconds() / 60)
    hours, rest = divmod(abs(minutes), 60)
    sign = "\N{MINUS SIGN}" if minutes < 0 else "+"
    return f"UTC{sign}{hours}" + (f":{rest:02}" if rest else "") if minutes else "UTC"
