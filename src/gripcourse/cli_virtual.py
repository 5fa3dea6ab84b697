"""Commands that measure the grader: virtual students and tolerances."""

from pathlib import Path
from typing import Annotated

import typer

from gripcourse import cli_text
from gripcourse.cli_options import (
    PROCESSORS,
    CourseOption,
    LanguageOption,
    WorkersOption,
    course_folder,
    words_for,
)
from gripcourse.words import message

# Every command imports what it needs itself, as in `cli`.
# ruff: noqa: PLC0415

app = typer.Typer()

CountOption = Annotated[int, typer.Option("--count", min=1, max=100_000, help="How many students.")]
SeedOption = Annotated[int, typer.Option("--seed", min=0, help="The same seed, the same students.")]
SchemeOption = Annotated[str | None, typer.Option("--scheme", help="Only this scheme.")]


@app.command()
def evaluate(  # noqa: PLR0913 (one parameter per option)
    *,
    in_memory: Annotated[
        bool, typer.Option("--in-memory", help="Judge a cohort without writing workbooks.")
    ] = False,
    count: CountOption = 1000,
    seed: SeedOption = 1,
    scheme: SchemeOption = None,
    misses: Annotated[
        Path | None, typer.Option("--misses", help="CSV file of every miss to write.")
    ] = None,
    workers: WorkersOption = PROCESSORS,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Set what virtual students did against what the grader says."""
    from gripcourse.cli_virtual_text import evaluation_text
    from gripcourse.commands.virtual import Cohort, evaluate_in_memory
    from gripcourse.course.load import load_course
    from gripcourse.course.policy_load import load_policy

    words = words_for(language)
    loaded = load_course(course_folder(course))
    with cli_text.progress() as step:
        tick = step(words.say(message("Judging")), count)
        found = evaluate_in_memory(
            loaded, load_policy(loaded), Cohort(count, seed, scheme), misses, workers, tick
        )
    typer.echo(evaluation_text(found, words))
    raise typer.Exit(1 if found.missed else 0)
