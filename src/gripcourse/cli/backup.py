"""The commands that keep and put back a whole term: parse, one call, print, exit code. No logic."""

from datetime import UTC, datetime
from pathlib import Path
from typing import Annotated

import typer

from gripcourse.cli.help import SpokenCommand
from gripcourse.cli.loudness import confirm
from gripcourse.cli.options import CourseOption, LanguageOption, course_folder, words_for
from gripcourse.text.words import message

# Every command imports what it needs itself: the database costs half a second.
# ruff: noqa: PLC0415

app = typer.Typer()


@app.command(cls=SpokenCommand)
def backup(
    *,
    out: Annotated[Path, typer.Option("--out", help="File to make.")],
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Write a whole term into one file: course, key, register, gradebook, what was handed in."""
    from gripcourse.usecases.term.backup import back_up

    done = back_up(course_folder(course), out, datetime.now(UTC))
    said = message(
        "{place}: {count} files of the course '{course}'. Keep it secret: the key is in it."
        " SHA-256: {digest}",
        place=str(out),
        count=done.files,
        course=done.course,
        digest=done.sha256,
    )
    confirm(words_for(language).say(said))


@app.command(cls=SpokenCommand)
def restore(
    file: Annotated[Path, typer.Argument(metavar="file", help="What `backup` wrote.")],
    *,
    course: Annotated[Path, typer.Option("--course", help="Folder to make.")],
    database: Annotated[
        str | None,
        typer.Option("--database", help="URL of an empty database; default: a file of the course."),
    ] = None,
    language: LanguageOption = None,
) -> None:
    """Put a whole term back as it was; nothing is overwritten."""
    from gripcourse.usecases.term.restore import restore as command

    done = command(file, course, database)
    said = message(
        "{place}: {count} files of the course '{course}', every signature verified.",
        place=str(course),
        count=len(done.members),
        course=done.course,
    )
    confirm(words_for(language).say(said))
