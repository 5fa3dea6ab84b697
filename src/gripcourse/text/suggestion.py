"""Names that may have been meant."""

from collections.abc import Iterable, Sequence
from difflib import get_close_matches
from typing import Final

from gripcourse.text.words import Message, message

_MOST_LISTED: Final = 12


def did_you_mean(name: str, known: Iterable[str]) -> Message:
    """Suggest the nearest known name, or list what is known where nothing is near."""
    choices = sorted(filter(None, known))  # a column may have no heading
    near = get_close_matches(name, choices, n=1)
    if near:
        return message("Did you mean '{near}'?", near=near[0])
    return message("Known here: {names}.", names=shortened(choices) if choices else "—")


def shortened(names: Sequence[str]) -> Message:
    """List names; of many the first ones, and how many more there are."""
    listed = message("{names}", names=", ".join(names[:_MOST_LISTED]))
    more = len(names) - _MOST_LISTED
    return message("{names}, and {count} more", names=listed, count=more) if more > 0 else listed
