"""Points, shares, days and amounts as a reader of a document sees them."""

from datetime import date

from gripcourse.text.conventions import is_english
from gripcourse.text.number_text import format_number
from gripcourse.text.units import stands_close, unit_text
from gripcourse.text.words import LANGUAGES, Texts, Words

NO_BREAK_SPACE = "\u00a0"
_DAY_PATTERN = "d MMMM y"


def points_text(value: float, words: Words) -> str:
    """Write points with at most two decimals."""
    # Rounded first: four significant figures of 100.25 would lose the quarter of a point.
    return words.number(round(value, 2), 7)


def counted_points(value: float, words: Words) -> str:
    """Write points with their word: `1 point`, `25 points`, `9.05 points`."""
    count = _whole(value)
    form = (
        words.translate("{points} points")  # of a part of a point
        if count is None
        else words.counted("{points} point", "{points} points", count)
    )
    return _unbroken(form, value, words)


def points_up_to(value: float, words: Words) -> str:
    """Write points as a limit: `up to 25 points`; languages decline them after it."""
    count = _whole(value)
    form = (
        words.translate("up to {points} points")
        if count is None
        else words.counted("up to {points} point", "up to {points} points", count)
    )
    return _unbroken(form, value, words)


def points_out_of(value: float, words: Words) -> str:
    """Write the points that could be had: `of 25 points`; likewise."""
    count = _whole(value)
    form = (
        words.translate("of {points} points")
        if count is None
        else words.counted("of {points} point", "of {points} points", count)
    )
    return _unbroken(form, value, words)


def _whole(value: float) -> int | None:
    """Return points as they are printed as a whole number, None where they are none."""
    printed = round(value, 2)
    return int(printed) if printed == int(printed) else None


def _unbroken(form: str, value: float, words: Words) -> str:
    return form.format(points=points_text(value, words)).replace(" ", NO_BREAK_SPACE)


def percent_text(share: float, words: Words) -> str:
    """Write a share of one as a percentage: `12.5%`, `12,5 %`."""
    space = "" if is_english(words.language) else NO_BREAK_SPACE
    return f"{words.number(round(100 * share, 1), 5)}{space}%"


def day_text(day: date, words: Words) -> str:
    """Write a date out, the month in words; it is never broken across lines."""
    from babel.dates import format_date  # noqa: PLC0415 (only who prints a day pays for it)

    written = str(format_date(day, _DAY_PATTERN, locale=words.language))
    return written.replace(" ", NO_BREAK_SPACE)


def amount_text(value: float, unit: str, words: Words, figures: int = 5) -> str:
    """Write a number with its unit, never broken across lines: `60,08 мм`, `36,87°`."""
    number, written = words.number(value, figures), unit_text(unit, words.language)
    joint = "" if stands_close(written) else NO_BREAK_SPACE
    return f"{number}{joint}{written}"


def amount_texts(value: float, unit: str, figures: int = 5) -> Texts:
    """Write a number with its unit in every language, for a message."""
    return Texts(
        {
            language: " ".join(
                filter(None, (format_number(value, language, figures), unit_text(unit, language)))
            )
            for language in LANGUAGES
        }
    )
