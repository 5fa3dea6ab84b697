"""What the commands share: their common options, and what these mean."""

import os
import sys
from datetime import date, datetime
from itertools import pairwise
from pathlib import Path
from typing import Annotated

import typer

from gripcourse.cli import text as cli_text
from gripcourse.text.words import LANGUAGES, Words, message

# What a command says with its exit code; see `cli`.
DONE, NEEDS_PERSON, WRONG_USE, OUR_MISTAKE = 0, 1, 2, 3

CourseOption = Annotated[
    Path | None,
    typer.Option(
        "--course",
        help="Folder of the course; default: this folder if it is one, else the one shipped.",
    ),
]


def _inherited(context: typer.Context, chosen: str | None) -> str | None:
    """Return the language of a command: its own, else the one named before the command."""
    return chosen or (context.parent.params.get("language") if context.parent else None)


LanguageOption = Annotated[
    str | None,
    typer.Option(
        "--language",
        metavar="en|ru|uk",
        callback=_inherited,
        help="Language of the output; default: the system's, for documents the course's.",
    ),
]
TableOption = Annotated[
    Path | None, typer.Option("--table", help="Variant table; default: the course's main table.")
]
OutOption = Annotated[Path, typer.Option("--out", help="Where to write.")]
OutFileOption = Annotated[Path | None, typer.Option("--out", help="File to write.")]
OutTableOption = Annotated[Path, typer.Option("--out", help="Table to write, .csv or .xlsx.")]
SchemeOption = Annotated[str | None, typer.Option("--scheme", help="Only this scheme.")]
SeedOption = Annotated[
    int, typer.Option("--seed", min=0, help="The same seed gives the same variants and students.")
]
CountOption = Annotated[int, typer.Option("--count", min=1, max=100_000, help="How many.")]
LinkDaysOption = Annotated[
    int,
    typer.Option(
        "--link-days",
        min=0,
        max=1000,
        help="Print each student's personal link on the sheet, good for so many days; 0: none.",
    ),
]
DateOption = Annotated[
    datetime | None,
    typer.Option("--date", formats=["%Y-%m-%d"], help="Day to print; default: today."),
]
WorkersOption = Annotated[
    int,
    typer.Option(
        "--workers", min=0, help="How many processes; 0: this one alone.", show_default="processors"
    ),
]
ClusterOption = Annotated[
    str | None,
    typer.Option(
        "--cluster",
        metavar="address",
        help="Dask scheduler whose workers grade instead: tcp://HOST:PORT or tls://HOST:PORT.",
    ),
]
ByOption = Annotated[
    str | None, typer.Option("--by", help="Who does it; default: the user of this machine.")
]
AllowLowerOption = Annotated[
    bool, typer.Option("--allow-lower", help="Published results may get worse.")
]
WhyOption = Annotated[str, typer.Option("--why", help="Why, in a few words; it is kept.")]
PROCESSORS = os.cpu_count() or 1
AfreshOption = Annotated[
    bool,
    typer.Option("--afresh", help="Grade and print also what has not changed since last time."),
]
RecalculateOption = Annotated[
    bool,
    typer.Option(
        "--recalculate", help="Compute all formulas once more; flag stored results that differ."
    ),
]
WhoseOption = Annotated[
    list[str] | None,
    typer.Option(
        "--whose", metavar="file=student", help="Who handed a file in, where it is in doubt."
    ),
]
PatternOption = Annotated[
    str | None,
    typer.Option("--pattern", metavar="pattern", help="Where your own paths say whose a file is."),
]
EitherVersionOption = Annotated[
    bool | None,
    typer.Option(
        "--either-version/--own-version",
        help="Of what was reissued: the version that gives more points, or the workbook's own.",
        show_default="as before, else the workbook's own",
    ),
]
GradebookOption = Annotated[
    str | None,
    typer.Option(
        "--gradebook", help="File or database URL; default: private/gradebook.sqlite of the course."
    ),
]


def chosen_words() -> Words:
    """Return the language before a command is known, as for its help, or after it failed.

    The command line itself tells: nothing has been parsed yet. The last one named counts, as in a
    command; one that the program does not speak is refused by the command, in the system's.
    """
    chosen = [
        two if one == "--language" else two.removeprefix("--language=")
        for one, two in pairwise(sys.argv)
        if one == "--language" or two.startswith("--language=")
    ]
    return words_for(chosen[-1] if chosen and chosen[-1] in LANGUAGES else None)


def course_folder(course: Path | None) -> Path:
    """Return the course to work on: the named one, else this folder if it is one, else ours."""
    from gripcourse.machine.resources import course_root, is_course  # noqa: PLC0415 (not for --help)

    here = Path.cwd()
    return course_root(course or (here if is_course(here) else None))


def course_apart(course: Path | None, out: Path) -> Path:
    """Return the course to work on, whose results go to a folder apart from its own files.

    Raises:
        UsageError: they would get among them.
    """
    from gripcourse.machine.resources import expect_apart  # noqa: PLC0415 (not for --help)

    root = course_folder(course)
    expect_apart(out, root)
    return root


def main_table(root: Path) -> Path:
    """Return where a course keeps the table that it issues from."""
    return root / "variants" / "tables" / "main.csv"


def day_of(chosen: datetime | None) -> date:
    """Return the chosen day, else today."""
    return chosen.date() if chosen else datetime.now().astimezone().date()


def gradebook_place(chosen: str | None, root: Path) -> str:
    """Return the gradebook to use: the named one, else the course's."""
    from gripcourse.machine.database.home import home_of  # noqa: PLC0415 (not for --help)

    return chosen or home_of(root)


def say_limits(words: Words) -> None:
    """Say on the error output what a person should know of the memory of workers, if anything."""
    from gripcourse.machine.jobs.limits import Limits, memory_notice  # noqa: PLC0415 (not for --help)

    notice = memory_notice(Limits())
    if notice is not None:
        typer.echo(words.say(notice), err=True)


def decimal_number(written: str) -> float:
    """Read a number with a decimal point or comma.

    Raises:
        BadParameter: it is none.
    """
    from gripcourse.variants.cells import exact_number  # noqa: PLC0415 (not for --help)

    value = exact_number(written, decimal_comma=True)
    if value is None:
        said = message("'{text}' is no number.", text=written)
        raise typer.BadParameter(chosen_words().say(said))
    return value


def words_for(language: str | None) -> Words:
    """Return the language that the command line speaks: chosen, else the system's, else English."""
    if language is not None:
        return Words(known_language(language))
    system = os.environ.get("LC_ALL") or os.environ.get("LC_MESSAGES") or os.environ.get("LANG", "")
    return Words(system[:2] if system[:2] in LANGUAGES else LANGUAGES[0])


def document_language(chosen: str | None, course: str) -> str:
    """Return the language of a document: chosen, else the course's."""
    return known_language(chosen) if chosen is not None else course


def known_language(language: str) -> str:
    """Return the language if the program speaks it.

    Raises:
        UsageError: it does not.
    """
    if language not in LANGUAGES:
        raise cli_text.misuse(
            message("There is no language '{language}': en, ru or uk.", language=language)
        )
    return language
