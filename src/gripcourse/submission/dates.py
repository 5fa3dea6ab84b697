"""Numbers that a spreadsheet program turned into dates: told, shown both ways, never guessed."""

from datetime import date, timedelta
from functools import cache, reduce
from typing import Final

from gripcourse.text.words import LANGUAGES, Message, message

_EPOCH: Final = date(1899, 12, 30)  # day zero of serial dates from March 1900 on
_SERIALS: Final = (36526, 54789)  # 1 January 2000 and 31 December 2049
_FAR: Final = 2.0  # times the upper bound; nearer, a whole number is only a large one


def about_date(value: date) -> Message:
    """Tell that a cell holds a date, and which numbers a person may have typed to get it."""
    day, month, year = value.day, value.month, value.year
    typed = [float(f"{day}.{month}"), float(f"{day}.{month:02d}")]
    if day == 1:
        typed.append(float(f"{month}.{year}"))  # 5.1987 becomes the first of May
    readings = [message("{number}", number=number) for number in dict.fromkeys(typed)]
    return message(
        "The spreadsheet program turned the number into the date {date}; perhaps {readings} was "
        "typed. Set the cell's format to General and type the number with the decimal sign of the "
        "program.",
        date=f"{day:02d}.{month:02d}.{year}",
        readings=reduce(_either, readings),
    )


def _either(one: Message, two: Message) -> Message:
    return message("{one} or {two}", one=one, two=two)


def about_time() -> Message:
    """Tell that a cell holds a time of day."""
    return message(
        "The spreadsheet program turned the number into a time. Set the cell's format to General "
        "and type the number again."
    )


def is_serial_date(value: float, bounds: tuple[float, float]) -> bool:
    """Tell whether a number is a date in disguise: a whole serial far above what is thinkable."""
    first, last = _SERIALS
    return first <= value <= last and value == int(value) and value > _FAR * bounds[1]


def serial_date(value: float) -> date:
    """Return the date of a serial number."""
    return _EPOCH + timedelta(days=int(value))


def names_month(text: str) -> bool:
    """Tell whether a text is the name of a month, also a short one: `1.май` is a date."""
    return text.strip(". ").casefold() in _months()


@cache
def _months() -> frozenset[str]:
    from babel.dates import get_month_names  # noqa: PLC0415 (60 ms, and hardly ever needed)

    return frozenset(
        name.strip(".").casefold()
        for language in LANGUAGES
        for width in ("wide", "abbreviated")
        for context in ("format", "stand-alone")
        for name in get_month_names(width, context, language).values()
    )
