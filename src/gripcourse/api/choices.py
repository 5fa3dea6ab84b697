"""What callers choose by name."""

import reprlib
from datetime import date, datetime
from numbers import Integral

from gripcourse.course.quantity import Convention
from gripcourse.errors import Problem, UsageError
from gripcourse.text.shown import shown
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import LANGUAGES, Message, message


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


def whole_number(parameter: str, value: object, least: int) -> int:
    """Return how many of something are wanted, or another whole number.

    Raises:
        UsageError: it is none, or is below the least.
    """
    if not isinstance(value, Integral) or isinstance(value, bool):
        raise _refusal(parameter, value, message("A whole number is wanted."))
    count = int(value)
    if count >= least:
        return count
    what = message("The number is {value}.", value=count)
    remedy = (
        message("Write a whole number from 1 on.")
        if least == 1
        else message("Write a whole number from 0 on.")
    )
    raise UsageError([Problem("", "", what, remedy, parameter=parameter)])


def a_text(parameter: str, value: object) -> str:
    """Return a text, for example the id of a variant, which is none of the whole numbers.

    Raises:
        UsageError: it is none.
    """
    if isinstance(value, str):
        return value
    raise _refusal(parameter, value, message("A text is wanted."))


def a_name(parameter: str, value: object) -> str:
    """Return the name of somebody.

    Raises:
        UsageError: nobody is named.
    """
    name = a_text(parameter, value)
    if name.strip():
        return name
    what, remedy = message("Nobody is named."), message("Say who it is.")
    raise UsageError([Problem("", "", what, remedy, parameter=parameter)])


def a_day(parameter: str, value: object) -> date | None:
    """Return a day; of a moment its day, None for none.

    Raises:
        UsageError: it is none: a text is not read as one, for it may be of another order.
    """
    if isinstance(value, datetime):
        return value.date()
    if value is None or isinstance(value, date):
        return value
    raise _refusal(parameter, value, message("A date (datetime.date) is wanted."))


def _refusal(parameter: str, value: object, wanted: Message) -> UsageError:
    what = message("{value} is of the kind {kind}.", value=brief(value), kind=type(value).__name__)
    return UsageError([Problem("", "", what, wanted, parameter=parameter)])


def brief(value: object) -> str:
    """Show the beginning of any value, as in a sentence."""
    return shown(reprlib.repr(value).partition("\n")[0])


def nothing(_: object) -> None:
    """Show no progress."""


def today_here() -> date:
    """Return the day as the clock of this machine has it."""
    return datetime.now().astimezone().date()
