"""What callers choose by name."""

from datetime import date, datetime

from gripcourse.course.quantity import Convention
from gripcourse.errors import Problem, UsageError
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import LANGUAGES, message


def chosen_convention(name: str | None) -> Convention | None:
    """Return a convention; None for the course's.

    Raises:
        UsageError: there is none of this name.
    """
    if name is None:
        return None
    if name not in list(Convention):
        what = message("There is no convention '{name}'.", name=name)
        remedy = did_you_mean(name, list(Convention))
        raise UsageError([Problem("", "", what, remedy, parameter="convention")])
    return Convention(name)


def chosen_language(name: str) -> str:
    """Return a language that the program speaks.

    Raises:
        UsageError: it does not speak it.
    """
    if name not in LANGUAGES:
        what = message("There is no language '{language}'.", language=name)
        remedy = did_you_mean(name, LANGUAGES)
        raise UsageError([Problem("", "", what, remedy, parameter="language")])
    return name


def from_one(count: int) -> int:
    """Return how many of something are wanted.

    Raises:
        UsageError: none.
    """
    if count >= 1:
        return count
    what = message("The number is {value}.", value=count)
    remedy = message("Write a whole number from 1 on.")
    raise UsageError([Problem("", "", what, remedy, parameter="count")])


def today_here() -> date:
    """Return the day as the clock of this machine has it."""
    return datetime.now().astimezone().date()
