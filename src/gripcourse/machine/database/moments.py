"""Moments as databases keep them: in UTC, without saying so, since not every one keeps zones."""

from datetime import UTC, datetime


def stored(moment: datetime) -> datetime:
    """Return a moment, which has a zone, as it is kept."""
    return moment.astimezone(UTC).replace(tzinfo=None)


def in_utc(moment: datetime) -> datetime:
    """Return a kept moment with its zone."""
    return moment.replace(tzinfo=UTC)
