"""Names that may have been meant."""

from collections.abc import Iterable
from difflib import get_close_matches
from typing import Final

from gripcourse.text.words import Message, message

_MOST_LISTED: Final = 12


def did_you_mean(name: str, known: Iterable[str]) -> Message:
    """Suggest the nearest known name, or list what is known where nothing is near."""
    choices = sorted(known)
    near = get_close_matches(name, choices, n=1)
    if near:
        return message("Did you mean '{near}'?", near=near[0])
    names = ", ".join(choices[:_MOST_LISTED])
    more = len(choices) - _MOST_LISTED
    if more > 0:
        return message("Known here: {names}, and {count} more.", names=names, count=more)
    return message("Known here: {names}.", names=names or "—")
