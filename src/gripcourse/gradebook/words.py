"""What persons said of whose files are, kept for good; of the same file the last word counts."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from datetime import datetime
from itertools import count
from pathlib import PurePath
from types import MappingProxyType
from typing import Final, TypeAlias

from sqlalchemy import select

from gripcourse.gradebook import schema
from gripcourse.gradebook.rows import Row
from gripcourse.gradebook.store import Gradebook, Writing
from gripcourse.machine.database.moments import in_utc, stored
from gripcourse.machine.database.opening import refusals_named

# Of a path that tell a file: somebody's folder, or what was downloaded, and its name.
_PARTS: Final = 2

End: TypeAlias = tuple[str, ...]
"""The end of a path, by which a file is known again together with its bytes."""

NOTHING: Final[Mapping[str, str]] = MappingProxyType({})


@dataclass(frozen=True, slots=True)
class WhoseWord:
    """That a person said whose a file is.

    Attributes:
        file: path under which it lay.
        digest: SHA-256 of its bytes, hexadecimal.
        student: the id that was named.
        said_at: when.
    """

    file: str
    digest: str
    student: str
    said_at: datetime


def end_of(file: str) -> End:
    """Return the end of a path: folders above it are another's, or of another day."""
    return PurePath(file).parts[-_PARTS:]


def students_by_file(said: Iterable[tuple[str, str, str]]) -> dict[End, dict[str, str]]:
    """Return ids by the end of a path and the digest of the bytes; of several the last one.

    A path may hold other bytes each time, and those of before once more.

    Args:
        said: student, file and digest, oldest first.
    """
    found: dict[End, dict[str, str]] = {}
    for student, file, digest in said:
        found.setdefault(end_of(file), {})[digest] = student
    return found


def words_of(book: Gradebook) -> tuple[WhoseWord, ...]:
    """Return all that was said, oldest first.

    Raises:
        GradebookError: the database failed.
    """
    return tuple(word for _, word in _numbered(book))


def keep_words(book: Gradebook, words: Iterable[WhoseWord]) -> tuple[WhoseWord, ...]:
    """Keep what was said; what counts just so already is not kept twice.

    Returns:
        Those that are new.

    Raises:
        GradebookError: the database failed; nothing was kept.
    """
    wanted = tuple(words)

    def fresh() -> tuple[tuple[int, WhoseWord], ...]:
        known = _numbered(book)
        last = students_by_file((one.student, one.file, one.digest) for _, one in known)
        new = [
            one
            for one in wanted
            if last.get(end_of(one.file), NOTHING).get(one.digest) != one.student
        ]
        return tuple(zip(count(known[-1][0] + 1 if known else 1), new, strict=False))

    def rows_of(found: tuple[tuple[int, WhoseWord], ...]) -> Writing:
        return [(schema.words, [_row(number, word) for number, word in found])]

    return tuple(word for _, word in book.add(fresh, rows_of)) if wanted else ()


def _numbered(book: Gradebook) -> tuple[tuple[int, WhoseWord], ...]:
    question = select(schema.words).order_by(schema.words.c.number)
    with refusals_named(book.place), book.engine.connect() as connection:
        return tuple(
            (row.number, WhoseWord(row.file, row.digest, row.student, in_utc(row.said_at)))
            for row in connection.execute(question)
        )


def _row(number: int, word: WhoseWord) -> Row:
    return {
        "number": number,
        "file": word.file,
        "digest": word.digest,
        "student": word.student,
        "said_at": stored(word.said_at),
    }
