"""How long what a course says may be: a title of ten thousand letters keeps a page busy."""

from collections.abc import Iterator
from typing import Final

from gripcourse.errors import Problem
from gripcourse.text.words import message

LONGEST_TEXT: Final = 2000  # signs; the longest of the shipped courses has 844
LONGEST_KEY: Final = 100
_SHOWN: Final = 40  # signs of a key that is too long
_REMEDY: Final = message("Shorten it: it has to find room on a page.")


def shorten_long(values: dict[str, object], file: str, problems: list[Problem]) -> None:
    """Cut texts and keys that are too long, with a problem for each, so that reading can go on.

    Args:
        values: of a TOML file; changed where something is too long.
        file: its name for messages.
        problems: takes what is wrong.
    """
    left: list[tuple[str, object]] = [("", values)]
    while left:
        place, found = left.pop()
        for key, value in _inside(found):
            is_long = isinstance(key, str) and len(key) > LONGEST_KEY
            is_long_text = isinstance(value, str) and len(value) > LONGEST_TEXT
            holds_more = isinstance(value, dict | list)
            if not (is_long or is_long_text or holds_more):
                continue
            shown = f"{str(key)[:_SHOWN]}…" if is_long else str(key)
            where = ".".join(part for part in (place, shown) if part)
            if is_long:
                what = message(
                    "The key has {count} signs; {most} at most are read.",
                    count=len(str(key)),
                    most=LONGEST_KEY,
                )
                problems.append(Problem(file, where, what, _REMEDY))
                _put(found, key, None, shown)
            elif isinstance(value, str) and is_long_text:
                what = message(
                    "The text has {count} signs; {most} at most are read.",
                    count=len(value),
                    most=LONGEST_TEXT,
                )
                problems.append(Problem(file, where, what, _REMEDY))
                _put(found, key, f"{value[:_SHOWN]}…")
            elif holds_more:
                left.append((where, value))


def _inside(found: object) -> Iterator[tuple[str | int, object]]:
    """Return what a table or a list holds; a copy, because it may be changed meanwhile."""
    if isinstance(found, dict):
        return iter(list(found.items()))
    return iter(list(enumerate(found))) if isinstance(found, list) else iter(())


def _put(found: object, key: str | int, value: object, instead: str = "") -> None:
    """Put a value in place of another; where a key is given instead, the old one goes."""
    if isinstance(found, dict):
        if instead:
            found[instead] = found.pop(key)
        else:
            found[key] = value
    elif isinstance(found, list) and isinstance(key, int):
        found[key] = value
