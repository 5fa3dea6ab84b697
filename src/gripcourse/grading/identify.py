"""Who handed a file in: told by its path first, by what the workbook says second."""

import re
import unicodedata
from collections.abc import Mapping
from pathlib import PurePath

from gripcourse.variants.model import Issued

# Learning platforms and people join an id to other words with these.
_JOINTS = re.compile(r"[\s_()\[\],;]+")


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
    tokens = dict.fromkeys(_JOINTS.split(part))
    return [register[token] for token in tokens if token in register]
