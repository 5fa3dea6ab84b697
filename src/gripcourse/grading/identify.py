"""Who handed a file in: told by its path first, by what the workbook says second."""

import re
import unicodedata
from collections.abc import Mapping
from pathlib import PurePath

from gripcourse.variants.model import Issued

# Learning platforms and people join an id to other words with what is left out here. An id may hold
# an underscore itself, so neighbouring words are tried together as well.
_WORD = re.compile(r"[^\s_()\[\],;]+")
_MOST_WORDS = 6  # of one id


def submitter(file: str, workbook_student: str, register: Mapping[str, Issued]) -> Issued | None:
    """Return the register's entry of whoever handed a file in.

    A folder or a file named after a student tells it; a path that names several students, or none,
    leaves it to the workbook. The nearest part of the path counts first.

    Args:
        file: path of the file.
        workbook_student: id in the workbook, empty where it says nothing.
        register: entries by student id.

    Returns:
        The entry, or None where nobody can be told.
    """
    for part in _parts(file):
        named = _named(part, register)
        if len(named) == 1:
            return named.pop()
    return register.get(workbook_student)


def _parts(file: str) -> tuple[str, ...]:
    path = PurePath(unicodedata.normalize("NFC", file))
    return (path.stem, *reversed(path.parts[:-1]))


def _named(part: str, register: Mapping[str, Issued]) -> list[Issued]:
    if part in register:
        return [register[part]]
    words = list(_WORD.finditer(part))
    spans = [
        (first.start(), last.end())
        for number, first in enumerate(words)
        for last in words[number : number + _MOST_WORDS]
        if part[first.start() : last.end()] in register
    ]
    # The `i` in `ivanov_i` is no student of its own.
    whole = [one for one in spans if not any(_lies_inside(one, other) for other in spans)]
    return [register[name] for name in dict.fromkeys(part[a:b] for a, b in whole)]


def _lies_inside(one: tuple[int, int], other: tuple[int, int]) -> bool:
    return one != other and other[0] <= one[0] and one[1] <= other[1]
