"""The signs and words that formulas are written with; a sentence for every other sign."""

import re
from typing import Final

from gripcourse.formula.fault import FormulaFault
from gripcourse.text.words import Message, message

_DEEPEST: Final = 60

_WORD: Final = re.compile(
    r"""(?u:\s)+
    | (?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?(?![\w.])   # a number
    | [A-Za-z_][A-Za-z_0-9]*                       # a name
    | "[^"\n]*" | '[^'\n]*'                            # a catalogue's column
    | \*\*(?!\*) | <= | >= | == | [-+*/(),<>]
    """,
    re.ASCII | re.VERBOSE,
)


def check_signs(text: str) -> None:
    """Refuse signs that are not of the language, and brackets that do not pair."""
    place, depth, open_at = 0, 0, [0]
    while place < len(text):
        found = _WORD.match(text, place)
        if found is None:
            raise _foreign(text, place)
        if found[0] == "(":
            depth += 1
            open_at[depth:] = [place]
        elif found[0] == ")":
            if depth == 0:
                raise FormulaFault(message("This bracket closes nothing."), found.span())
            depth -= 1
        elif found[0] == "," and depth == 0:
            raise FormulaFault(comma(), found.span())
        if depth > _DEEPEST:
            raise FormulaFault(too_deep(), found.span())
        place = found.end()
    if depth:
        span = (open_at[depth], open_at[depth] + 1)
        raise FormulaFault(message("This bracket is never closed."), span)


_HINTS: Final[tuple[tuple[str, Message], ...]] = (
    ("^", message("A power is written **.")),
    ("×·⋅", message("A product is written *.")),
    ("÷:", message("A quotient is written /.")),
    ("−–—", message("A minus is written with the plain sign -.")),
    ("≤≥≠", message("A comparison is written with <, <=, >, >= or ==.")),
    ("=", message("A comparison for equality is written ==.")),
    ("√", message("A root is written sqrt(…) or cbrt(…).")),
    ("[]{}", message("Only round brackets group.")),
    (".", message('A point stands only in numbers, and in a column of a catalogue: "bolts.size".')),
    ("\"'", message('Quotation marks only name a column of a catalogue: "bolts.size".')),
)


def _foreign(text: str, place: int) -> FormulaFault:
    """Say why no word of the language begins here."""
    if text[place].isdecimal():
        what = message("This is not a number as formulas write it: 12.5, 1e-3.")
        end = next((i for i in range(place, len(text)) if not text[i].isalnum()), len(text))
        return FormulaFault(what, (place, end))
    return FormulaFault(_of_sign(text[place]), (place, place + 1))


def _of_sign(sign: str) -> Message:
    """Say why a sign is not of the language."""
    for signs, hint in _HINTS:
        if sign in signs:
            return hint
    if sign.isalpha():
        return message(
            "Names are written with Latin letters, and the sign {sign} is none.", sign=sign
        )
    return message("The sign {sign} has no meaning in a formula.", sign=sign)


def comma() -> Message:
    """Say that a comma is no decimal sign."""
    return message("A number is written with a decimal point, not a comma.")


def too_deep() -> Message:
    """Say that a formula is nested too deeply."""
    return message("The formula is nested too deeply; divide it into several quantities.")
