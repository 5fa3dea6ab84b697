"""Whom the demo issues to, and what: the course's own sample, else one that is made up."""

from pathlib import Path
from typing import Final

from gripcourse.course.model import Course
from gripcourse.machine.files import write_bytes, write_text
from gripcourse.text.words import Words, message
from gripcourse.usecases.solving.variants import draw_table
from gripcourse.variants.table import read_table

_ROSTER: Final = Path("variants") / "roster.csv"
_TABLE: Final = Path("variants") / "tables" / "main.csv"
_STUDENTS, _SEED = 9, 1


def sample_roster(source: Path, course: Course, table: Path, words: Words) -> Path:
    """Return the roster of a demo: a copy of the source's, else one with students made up.

    Args:
        source: the course that the demo was asked for.
        course: the demo's copy of it.
        table: of the variants; nobody is made up who would get none.
        words: language of the names.
    """
    roster = course.root / _ROSTER
    if (source / _ROSTER).is_file():
        write_bytes(roster, (source / _ROSTER).read_bytes(), private=True)
    else:
        count = min(_STUDENTS, len(read_table(table, course)))
        names = [words.say(message("Student {number}", number=one + 1)) for one in range(count)]
        rows = [f"s{one + 1},{name}" for one, name in enumerate(names)]
        write_text(roster, "\n".join(("student,name", *rows)) + "\n", private=True)
    return roster


def sample_table(course: Course) -> Path:
    """Return the variants of a demo: the course's main table, else one drawn from its spaces."""
    table = course.root / _TABLE
    if not table.is_file():
        draw_table(course, _STUDENTS, _SEED, None, table, freely=True)
    return table
