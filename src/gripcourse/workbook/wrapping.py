"""How many lines a text takes in a cell: office programs do not agree on growing rows."""

from typing import Final

# Arial's letters beside its digits, in which columns are measured: wide, narrow, and all
# others; each a little more than it takes on average.
_WIDE: Final = frozenset("шщжюмфыШЩЖЮМФЫДЭОmwMWQGO—%@")
_NARROW: Final = frozenset(".,:;()[]{}|ilfjtrIгсІіїЇ'’-/!\"·")
_WIDE_LETTER, _NARROW_LETTER, _LETTER, _SPACE = 1.44, 0.62, 1.08, 0.53
_INDENT: Final = 1.3  # what the edges of a cell take


def lines_taken(text: str, width: float) -> int:
    """Return how many lines a text takes that breaks between words.

    Args:
        text: as it is written.
        width: of the column, in digits.
    """
    room = width - _INDENT
    lines, used = 1, 0.0
    for word in text.split():
        needed = sum(map(_width, word))
        if used and used + _SPACE + needed > room:
            lines += 1
            used = 0.0
        used += needed if not used else _SPACE + needed
        while used > room:
            lines += 1
            used -= room
    return lines


def _width(letter: str) -> float:
    if letter in _WIDE:
        return _WIDE_LETTER
    return _NARROW_LETTER if letter in _NARROW else _LETTER
