"""Commands that measure the grader: virtual students and tolerances; and the demonstration."""

from pathlib import Path
from time import perf_counter
from typing import Annotated

import typer

from gripcourse.cli import grading_text, simulation_text
from gripcourse.cli import text as cli_text
from gripcourse.cli.costs_text import paying_text
from gripcourse.cli.foreign_text import markdown_table
from gripcourse.cli.help import SpokenCommand, command_group
from gripcourse.cli.loudness import confirm
from gripcourse.cli.options import (
    NEEDS_PERSON,
    PROCESSORS,
    CountOption,
    CourseOption,
    LanguageOption,
    OutFileOption,
    OutOption,
    SchemeOption,
    SeedOption,
    TableOption,
    WorkersOption,
    course_folder,
    main_table,
    say_limits,
    words_for,
)
from gripcourse.cli.table_layout import table_text
from gripcourse.text.words import message

# Every command imports what it needs itself, as in `cli`.
# ruff: noqa: PLC0415

app = typer.Typer()
tolerance_app = command_group("Derive the tolerances of answers.")


@app.command(cls=SpokenCommand)
def simulate(  # noqa: PLR0913 (one parameter per option)
    *,
    count: CountOption = 1000,
    seed: SeedOption = 1,
    scheme: SchemeOption = None,
    out: OutOption = Path("cohort"),
    workers: WorkersOption = PROCESSORS,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Write the workbooks of virtual students, and beside them what each of them did."""
    from gripcourse.course.load import load_course
    from gripcourse.policy.load import load_policy
    from gripcourse.usecases.measuring import virtual as command

    words = words_for(language)
    loaded = load_course(course_folder(course))
    policy = load_policy(loaded)
    cohort = command.Cohort(count, seed, scheme)
    started = perf_counter()
    with cli_text.progress(words) as step:
        tick = step(words.say(message("Filling in")), count)
        written = command.simulate(loaded, policy, cohort, out, workers, tick)
    confirm(simulation_text.simulated_text(written, out, perf_counter() - started, words))


@app.command(cls=SpokenCommand)
def evaluate(  # noqa: PLR0913 (one parameter per option)
    folder: Annotated[
        Path | None, typer.Argument(metavar="folder", help="Folder of a simulated cohort.")
    ] = None,
    *,
    in_memory: Annotated[
        bool, typer.Option("--in-memory", help="Judge a new cohort without writing workbooks.")
    ] = False,
    count: CountOption = 1000,
    seed: SeedOption = 1,
    scheme: SchemeOption = None,
    misses: Annotated[
        Path | None, typer.Option("--misses", help="With --in-memory: CSV file of every miss.")
    ] = None,
    markdown: Annotated[
        bool, typer.Option("--markdown", help="Print the tables for a Markdown file.")
    ] = False,
    workers: WorkersOption = PROCESSORS,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Compare what the grader says of virtual students with what they did."""
    from gripcourse.course.load import load_course
    from gripcourse.policy.load import load_policy
    from gripcourse.usecases.measuring import virtual as command

    if in_memory == (folder is not None):
        raise cli_text.misuse(message("Name the folder of a cohort, or --in-memory."))
    words = words_for(language)
    loaded = load_course(course_folder(course))
    policy = load_policy(loaded)
    cohort = command.Cohort(count, seed, scheme)
    with cli_text.progress(words) as step:
        works = command.works_in_memory(cohort) if folder is None else None
        tick = step(words.say(message("Grading")), works)
        if folder is None:
            found = command.evaluate_in_memory(loaded, policy, cohort, misses, workers, tick)
        else:
            found = command.evaluate_folder(loaded, policy, folder, workers, tick)
    layout = markdown_table if markdown else table_text
    typer.echo(simulation_text.evaluation_text(found, policy, words, layout))
    if found.missed:
        raise typer.Exit(NEEDS_PERSON)


@tolerance_app.command("audit", cls=SpokenCommand)
def tolerance_audit(  # noqa: PLR0913 (one parameter per option)
    *,
    apply: Annotated[
        bool, typer.Option("--apply", help="Write what is proposed into the policy.")
    ] = False,
    count: Annotated[
        int, typer.Option("--count", min=0, max=100_000, help="Variants drawn besides the table's.")
    ] = 2000,
    seed: SeedOption = 1,
    out: OutFileOption = None,
    table: TableOption = None,
    workers: WorkersOption = PROCESSORS,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Derive tolerances from honest students who round, cut off and shorten constants."""
    from gripcourse.course.load import load_course
    from gripcourse.machine.files import expect_file
    from gripcourse.policy.load import load_policy
    from gripcourse.usecases.measuring import tolerance as command

    words = words_for(language)
    if out is not None:
        expect_file(out)
    loaded = load_course(course_folder(course))
    policy = load_policy(loaded)
    sample = command.ToleranceSample(table or main_table(loaded.root), count, seed)
    variants = command.variants_of(loaded, sample)
    with cli_text.progress(words) as step:
        tick = step(words.say(message("Answering")), len(variants))
        found = command.audit(loaded, policy, variants, workers, tick)
    if out is not None:
        command.write_audit(found, out)
    typer.echo(simulation_text.audit_text(found, policy, words))
    paying = command.paying(loaded, policy, sample)
    if costs := paying_text(paying, words):
        typer.echo(f"\n{costs}")
    if apply:
        changed = command.apply(found, loaded, policy)
        said = message("Tolerances written into the policy: {count}.", count=changed)
        confirm(words.say(said))
    elif found.refuses or paying.problems:
        raise typer.Exit(NEEDS_PERSON)


@app.command(cls=SpokenCommand)
def demo(
    *,
    out: OutOption = Path("out"),
    workers: WorkersOption = PROCESSORS,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Try everything once: issue to a roster, let scripted students answer, grade, report."""
    from gripcourse.cli.demo.run import run_demo

    words = words_for(language)
    say_limits(words)
    with cli_text.progress(words) as step:
        done = run_demo(course_folder(course), out, words, workers, step)
    confirm(grading_text.demo_text(done, words))
