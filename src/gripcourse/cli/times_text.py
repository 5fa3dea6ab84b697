"""What is said of works of which nobody knows when they were handed in."""

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Final

from gripcourse.grading.platforms import platform_part
from gripcourse.text.shown import first_of, one_line
from gripcourse.text.words import Words, message

if TYPE_CHECKING:
    from gripcourse.grading.model import Report

_NAMED: Final = 5


def without_times(reports: Sequence["Report"], words: Words) -> Iterator[str]:
    """Say which works cannot be late because nobody knows when they came, though lateness costs.

    A zip of a platform holds the time at which it was packed, and that is not believed.
    """
    files = [
        one.file
        for one in reports
        if one.judged and one.timing is not None and one.timing.is_unknown
    ]
    if not files:
        return
    names = [one_line(Path(one).name) for one in files]
    said = message(
        "Nobody knows when these were handed in, so none of them is late ({count}): {names}. Say it"
        " with --handed-in, for all, for a file, or by the grading worksheet of Moodle.",
        count=len(names),
        names=first_of(names, _NAMED),
    )
    yield words.say(said)
    late = [one for one in files if (part := platform_part(one)) is not None and part.late]
    if late:
        said = message(
            "By their names the platform took these for late ({count}), and that takes nothing off"
            " here: {names}.",
            count=len(late),
            names=", ".join(one_line(Path(one).name) for one in late),
        )
        yield words.say(said)


def without_deadlines(students: Sequence[str], words: Words) -> Iterator[str]:
    """Say who cannot be late because nobody set a deadline, though lateness costs."""
    if not students:
        return
    said = message(
        "Lateness costs, but these students have no deadline ({count}): {names}. Write one into"
        " variants/deadlines.csv: for all, for a group or for a student.",
        count=len(students),
        names=first_of(students, _NAMED),
    )
    yield words.say(said)
