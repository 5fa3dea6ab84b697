"""Digits with spaces, points and commas between them: which part groups, which is the decimal sign.

What could be several numbers, or a date, is none.
"""

from dataclasses import dataclass

from gripcourse.text.words import Message, message

DIGITS = "0123456789"
SEPARATORS = ".,"
_GROUP = 3  # digits between two group signs
NO_NUMBER = message("The cell does not begin with a number.")
SEVERAL = message("One number is needed, not a range, several numbers or a calculation.")
A_DATE = message("This looks like a date; one number is needed.")
_GROUPS = message("The points and commas do not make one number.")


class NotANumber(Exception):  # noqa: N818 - it never leaves the readers of numbers
    """A text is no single number.

    Attributes:
        reason: why, for the student.
    """

    def __init__(self, reason: Message) -> None:
        self.reason = reason
        super().__init__(reason)


@dataclass(frozen=True, slots=True)
class Digits:
    """Digits without separators; `decimals` of them stand behind the decimal sign."""

    text: str
    decimals: int
    remarks: tuple[Message, ...]


def taken(text: str, allowed: str) -> tuple[str, str]:
    """Split off the longest beginning that consists of allowed characters."""
    rest = text.lstrip(allowed)
    return text[: len(text) - len(rest)], rest


def digits_of(body: str) -> Digits:
    """Decide what the spaces, points and commas between digits mean."""
    if not body.strip(SEPARATORS + " "):
        raise NotANumber(NO_NUMBER)
    joined = _without_group_spaces(body)
    found = [sign for sign in joined if sign in SEPARATORS]
    if not found:
        return Digits(joined, 0, ())
    if len(set(found)) == 1 and len(found) > 1:
        return _only_groups(joined, found[0])
    whole, _, decimals = joined.rpartition(found[-1])
    if len(found) > 1:
        if found[-1] in found[:-1]:
            raise NotANumber(_GROUPS)
        whole = _join_groups(whole.split(found[0]), _GROUPS)
        return Digits(whole + decimals, len(decimals), (_groups_remark(),))
    ambiguous = len(decimals) == _GROUP and 0 < len(whole) <= _GROUP and whole.strip("0")
    return Digits(whole + decimals, len(decimals), (_decimal_remark(),) if ambiguous else ())


def _without_group_spaces(body: str) -> str:
    """Join `1 250 000,5`; anything else with a space inside is several numbers."""
    pieces = body.split(" ")
    if len(pieces) == 1:
        return body
    last, decimals = taken(pieces[-1], DIGITS)
    return _join_groups([*pieces[:-1], last], SEVERAL) + decimals


def _only_groups(joined: str, separator: str) -> Digits:
    """Read `1.250.000`; two signs that do not part groups look like a date."""
    pieces = joined.split(separator)
    is_date = len(pieces) == _GROUP and all(pieces)
    digits = _join_groups(pieces, A_DATE if is_date else SEVERAL)
    return Digits(digits, 0, (_groups_remark(),))


def _join_groups(pieces: list[str], reason: Message) -> str:
    """Join groups of three digits; the first may be shorter."""
    first, *others = pieces
    regular = 0 < len(first) <= _GROUP and all(len(piece) == _GROUP for piece in others)
    if not regular or not all(piece.isdigit() for piece in pieces):
        raise NotANumber(reason)
    return "".join(pieces)


def _groups_remark() -> Message:
    return message("The points or commas were read as signs between groups of three digits.")


def _decimal_remark() -> Message:
    return message("The single point or comma was read as the decimal sign.")
