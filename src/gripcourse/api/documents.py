"""Documents of a course: what a program can have written beside the results of `Course`."""

import secrets
from datetime import date
from pathlib import Path
from typing import TYPE_CHECKING

from gripcourse.api.choices import a_day, today_here
from gripcourse.api.course import Course
from gripcourse.api.refusals import refusals_said
from gripcourse.api.sources import FileLike, path_of
from gripcourse.text.words import Words

if TYPE_CHECKING:
    from gripcourse.machine.doctor import MachineCheck
    from gripcourse.usecases.solving.audit import WrittenAudit

# Every call imports what it needs itself: laying out costs half a second to import.
# ruff: noqa: PLC0415


@refusals_said
def init_course(
    folder: str | Path,
    *,
    source: str | Path | None = None,
    language: str = "en",
    templates: bool = False,
) -> Course:
    """Make a course of one's own with a key of its own, and load it.

    Args:
        folder: new or empty.
        source: course to copy; None for the reference course.
        language: of the short guide in it.
        templates: whether the program's templates are copied too, for who changes the look.

    Raises:
        UsageError: the folder is in use or cannot be written.
    """
    from gripcourse.usecases.authoring.init import init_course as make

    origin = None if source is None else path_of(source)
    key = secrets.token_bytes(32)
    make(path_of(folder), key, Words(language), origin, with_templates=templates)
    return Course.load(folder)


@refusals_said
def doctor(folder: str | Path = ".") -> "tuple[MachineCheck, ...]":
    """Check this machine: what it has and lacks, each lack with its remedy."""
    from gripcourse.machine.doctor import checks

    return checks(path_of(folder))


@refusals_said
def write_solution(
    course: Course, variant: str, out: str | Path, *, table: FileLike | None = None
) -> Path:
    """Write the worked solution of a variant as PDF and return where it is."""
    from gripcourse.usecases.solving.solve import write_solution as write

    return write(course.solved(variant, table), path_of(out), course.words)


@refusals_said
def write_key(
    course: Course, variant: str, out: str | Path, *, table: FileLike | None = None
) -> Path:
    """Write the instructor's workbook with live formulas and return where it is."""
    from gripcourse.usecases.solving.solve import write_key as write

    return write(course.solved(variant, table), path_of(out), course.words)


@refusals_said
def write_general_view(
    course: Course,
    variant: str,
    out: str | Path,
    *,
    table: FileLike | None = None,
    student: str = "",
) -> tuple[Path, ...]:
    """Write the general view of a variant as DXF and SVG into a folder; return the files."""
    from gripcourse.usecases.solving.draw import write_general_view as write

    return tuple(write(course.solved(variant, table), path_of(out), student, course.words))


@refusals_said
def audit_variants(
    course: Course,
    out: str | Path,
    *,
    table: FileLike | None = None,
    today: date | None = None,
) -> "WrittenAudit":
    """Audit a table of variants; write its certificate and numbers into a folder."""
    from gripcourse.usecases.solving.audit import audit_table

    day, folder = a_day("today", today) or today_here(), path_of(out)
    return audit_table(course.definition, course.table_source(table), folder, course.words, day)


@refusals_said
def import_variants(course: Course, table: FileLike, out: str | Path) -> int:
    """Check an instructor's own table, write it and return the number of its variants."""
    from gripcourse.usecases.solving.variants import import_table

    read = import_table(course.definition, course.table_source(table), path_of(out))
    return len(read.variants)


@refusals_said
def draw_atlas(course: Course, atlas: str, out: str | Path) -> tuple[Path, ...]:
    """Reproduce the figures of a source into a folder; return the files."""
    from gripcourse.usecases.authoring.atlas import draw_atlas as write

    return tuple(write(course.definition, atlas, path_of(out), course.words))


@refusals_said
def write_reference(course: Course, out: str | Path) -> tuple[Path, ...]:
    """Write the formula reference into a folder; return the pages."""
    from gripcourse.usecases.authoring.reference import write_reference as write

    return tuple(write(course.definition, path_of(out), course.words))
