"""Whose files are as was said or found before: who was asked once need not answer again."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from datetime import datetime

from gripcourse.batch.context import GradingContext
from gripcourse.batch.graded import Graded, reports_of
from gripcourse.gradebook.store import Gradebook, open_gradebook
from gripcourse.gradebook.words import (
    End,
    WhoseWord,
    end_of,
    keep_words,
    students_by_file,
    words_of,
)
from gripcourse.machine.content import Readable, shown_name
from gripcourse.machine.database.home import exists


def with_answers(context: GradingContext, place: str, files: Iterable[Readable]) -> GradingContext:
    """Return the context that knows whose the files of a batch were when they were graded before.

    What a person said goes before the name of a file. Of what was graded before words were kept
    nobody knows whether its name told it: that counts only where nothing else tells whose a file
    is, for then a person said so. A file is the same if the end of its path is, and what it holds.

    Args:
        context: of the course.
        place: of the gradebook.
        files: of the batch.

    Raises:
        GradebookError: the gradebook is there and cannot be used.
    """
    if not exists(place):
        return context
    book = open_gradebook(place)
    names = [shown_name(file) for file in files]
    said = ((one.student, one.file, one.digest) for one in words_of(book))
    return replace(
        context,
        answered=_of_names(names, students_by_file(book.files())),
        said=_of_names(names, students_by_file(said)),
    )


def keep_said(
    graded: Sequence[Graded], context: GradingContext, book: Gradebook, now: datetime
) -> None:
    """Keep what a person said of whose files of a batch are.

    Args:
        graded: the batch.
        context: that it was graded with.
        book: the gradebook.
        now: when the batch was graded.

    Raises:
        GradebookError: the gradebook cannot be used.
    """
    if context.whose:
        keep_words(
            book,
            (
                WhoseWord(one.file, one.digest, context.whose[one.file], now)
                for one in reports_of(graded)
                if one.digest and one.file in context.whose
            ),
        )


def _of_names(
    names: Iterable[str], known: Mapping[End, Mapping[str, str]]
) -> dict[str, Mapping[str, str]]:
    ends = ((name, end_of(name)) for name in names)
    return {name: known[end] for name, end in ends if end in known}
