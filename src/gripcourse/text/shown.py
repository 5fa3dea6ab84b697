"""Text from elsewhere, before anybody sees it: names, file names, what was typed into cells.

A terminal obeys control characters, XML cannot hold them, and signs that turn the direction of
writing round let a name pass for another. None of them is ever part of what somebody wrote.
"""

import re
from collections.abc import Sequence
from typing import Final

# C0 and C1 but tab and line end, what embeds, overrides and isolates a direction (Unicode UAX #9),
# half surrogates and the two that are no characters.
_UNSEEN: Final = re.compile(
    "[\x00-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069\ud800-\udfff\ufffe\uffff]"
)
_LINE_ENDS: Final = re.compile("[\r\n\u2028\u2029]+")
_REPLACEMENT: Final = "\ufffd"


def shown(text: str) -> str:
    """Return a text with the sign of an unknown character in the place of each such one."""
    return _UNSEEN.sub(_REPLACEMENT, text)


def first_of(names: Sequence[str], most: int) -> str:
    """Return the first of several names, and an ellipsis where there are more."""
    return ", ".join(names[:most]) + (", …" if len(names) > most else "")


def one_line(text: str) -> str:
    """Return a text as `shown` does, on one line: none of it can pass for a line of ours."""
    return shown(_LINE_ENDS.sub(" ", text.strip("\r\n\u2028\u2029")))
