"""Commands on a course as a whole, and on the machine: parse, one call, print. No logic."""

from pathlib import Path
from typing import Annotated

import typer

from gripcourse.cli import text as cli_text
from gripcourse.cli.help import SpokenCommand
from gripcourse.cli.options import (
    DONE,
    WRONG_USE,
    CourseOption,
    LanguageOption,
    OutOption,
    course_folder,
    document_language,
    words_for,
)
from gripcourse.errors import GripcourseError
from gripcourse.text.words import LANGUAGES, Words, message

# Every command imports what it needs itself, as in `cli`.
# ruff: noqa: PLC0415

app = typer.Typer()


@app.command(cls=SpokenCommand)
def validate(course: CourseOption = None, language: LanguageOption = None) -> None:
    """Check a whole course and list all its problems at once."""
    from gripcourse.usecases.validate import all_problems

    words = words_for(language)
    problems = all_problems(course_folder(course))
    if problems:
        raise GripcourseError(problems)
    typer.echo(words.say(message("The course is valid.")))


@app.command(cls=SpokenCommand)
def init(
    folder: Annotated[Path, typer.Argument(metavar="folder", help="New folder of the course.")],
    *,
    source: Annotated[
        Path | None,
        typer.Option(
            "--from", help="Course to copy, without its students; default: the one shipped."
        ),
    ] = None,
    empty: Annotated[
        bool, typer.Option("--empty", help="A small course to begin with, of any subject.")
    ] = False,
    language: LanguageOption = None,
) -> None:
    """Make a course of your own, with a key of its own: a copy of another, or a small one."""
    import secrets

    from gripcourse.usecases.init import empty_course, init_course

    words = words_for(language)
    if empty and source is not None:
        raise cli_text.misuse(message("--from and --empty exclude each other."))
    if empty:
        empty_course(folder, secrets.token_bytes(32), words)
    else:
        init_course(folder, secrets.token_bytes(32), words, source)
    typer.echo(words.say(message("The course is in {folder}.", folder=str(folder))))


@app.command(cls=SpokenCommand)
def doctor(language: LanguageOption = None) -> None:
    """Check this machine and say how to mend what it lacks."""
    from gripcourse.machine.doctor import checks

    words = words_for(language)
    found = checks(Path.cwd())
    typer.echo(cli_text.doctor_text(found, words))
    raise typer.Exit(WRONG_USE if any(one.required and not one.ok for one in found) else DONE)


@app.command(cls=SpokenCommand)
def atlas(
    name: Annotated[
        str, typer.Argument(metavar="atlas", help="Atlas of the course, for example lever-arms.")
    ],
    *,
    out: OutOption = Path("atlas"),
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Reproduce the figures and cases of a source from the course's own formulas."""
    from gripcourse.course.load import load_course
    from gripcourse.usecases.atlas import draw_atlas

    loaded = load_course(course_folder(course))
    words = Words(document_language(language, loaded.language))
    for path in draw_atlas(loaded, name, out, words):
        typer.echo(str(path))


@app.command(cls=SpokenCommand)
def reference(
    *,
    out: OutOption = Path("reference"),
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Write the formula reference: a page for each scheme, made from the declarations alone."""
    from gripcourse.course.load import load_course
    from gripcourse.usecases.reference import write_reference

    words = Words(document_language(language, LANGUAGES[0]))
    for path in write_reference(load_course(course_folder(course)), out, words):
        typer.echo(str(path))
