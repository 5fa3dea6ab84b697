"""What the desk keeps for good: files handed in, self-checks, requests, publications."""

from dataclasses import dataclass
from datetime import datetime
from pathlib import PurePath
from typing import Final

DRAWINGS: Final = frozenset({".pdf", ".png", ".jpg", ".jpeg", ".svg", ".dxf"})
"""Suffixes of what is handed in beside the workbook."""


def is_drawing(name: str) -> bool:
    """Tell by what a file is called whether it is a drawing."""
    return PurePath(name).suffix.lower() in DRAWINGS


@dataclass(frozen=True, slots=True)
class Allowance:
    """At most so many times within so many seconds."""

    times: int
    seconds: float


class TooOftenError(Exception):
    """It would be more often than is allowed; nothing was kept."""


@dataclass(frozen=True, slots=True)
class HandIn:
    """A file that a student handed in.

    Attributes:
        student: id.
        number: counts the student's files from 1.
        digest: SHA-256 of its bytes, hexadecimal; the file is kept under it.
        size: in bytes.
        name: as the student calls it.
        at: when its bytes were safe on the disk.
    """

    student: str
    number: int
    digest: str
    size: int
    name: str
    at: datetime

    @property
    def is_drawing(self) -> bool:
        """Whether a person looks at it; everything else is meant as the workbook."""
        return is_drawing(self.name)


@dataclass(frozen=True, slots=True)
class LoggedCheck:
    """A self-check: of which bytes, whether numbers were compared, and how many were left then."""

    student: str
    number: int
    digest: str
    told: bool
    left: int | None
    at: datetime


@dataclass(frozen=True, slots=True)
class RegradeRequest:
    """A student asks in a sentence to have an item looked at again."""

    student: str
    number: int
    item: str
    sentence: str
    at: datetime


@dataclass(frozen=True, slots=True)
class GradedBatch:
    """Files were graded into the gradebook.

    Attributes:
        number: counts from 1.
        files: how many.
        by: who had them graded.
        why: may be empty.
        at: the time of the attempts that it added.
    """

    number: int
    files: int
    by: str
    why: str
    at: datetime


@dataclass(frozen=True, slots=True)
class Publication:
    """Results were published, or the last publication was withdrawn, by whom and why."""

    number: int
    published: bool
    by: str
    why: str
    at: datetime
