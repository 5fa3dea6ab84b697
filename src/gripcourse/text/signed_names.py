"""Names as people sign papers with them, where a row is too short for the whole name."""

import re
from typing import Final

# Surname, first name and patronymic, in this order: only a patronymic at the end tells it.
_SURNAME_FIRST: Final = re.compile(
    r"(?P<surname>[^\W\d_][\w’'ʼ-]+) (?P<first>[^\W\d_])[\w’'ʼ-]+ "
    r"(?P<second>[^\W\d_])[\w’'ʼ-]*(?:вич|вна|ьич|мич|нич|кич|чна|шна)"
)


def surname_of(name: str) -> str:
    """Return the surname of a name that ends with a patronymic; any other name stays whole."""
    found = _SURNAME_FIRST.fullmatch(" ".join(name.split()))
    return found["surname"] if found else name


def signed_name(name: str) -> str:
    """Return surname and initials, `Шевченко О. К.`, of a name that ends with a patronymic.

    Any other name stays whole: nobody knows which of its words is the surname.
    """
    found = _SURNAME_FIRST.fullmatch(" ".join(name.split()))
    return f"{found['surname']} {found['first']}. {found['second']}." if found else name
