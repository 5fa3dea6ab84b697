"""Whose files were when they were graded before: who was asked once need not answer again."""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import PurePath

from gripcourse.batch.context import GradingContext
from gripcourse.gradebook.store import open_gradebook
from gripcourse.machine.content import Readable, shown_name
from gripcourse.machine.database.home import exists

_PARTS = 2  # of a path that tell a file: somebody's folder, or what was downloaded, and its name


def with_answers(context: GradingContext, place: str, files: Iterable[Readable]) -> GradingContext:
    """Return the context that knows whose the files of a batch were when they were graded before.

    It counts only where nothing else tells whose one is: then a person said so. A file is the same
    if the end of its path is, and what it holds.

    Args:
        context: of the course.
        place: of the gradebook.
        files: of the batch.

    Raises:
        GradebookError: the gradebook is there and cannot be used.
    """
    if not exists(place):
        return context
    before = _whose(open_gradebook(place).files())
    names = ((shown_name(file), _end(shown_name(file))) for file in files)
    return replace(context, answered={name: before[end] for name, end in names if end in before})


def _whose(
    attempts: Iterable[tuple[str, str, str]],
) -> Mapping[tuple[str, ...], Mapping[str, str]]:
    """Return ids by the end of a path and the digest of the bytes; of several the last one.

    A path may hold other bytes each time, and those of before once more.
    """
    found: dict[tuple[str, ...], dict[str, str]] = {}
    for student, file, digest in attempts:
        found.setdefault(_end(file), {})[digest] = student
    return found


def _end(file: str) -> tuple[str, ...]:
    return PurePath(file).parts[-_PARTS:]
