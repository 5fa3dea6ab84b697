"""The command that grades a batch: parse, one call, print, exit code. No logic."""

import getpass
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gripcourse.cli import grading_text
from gripcourse.cli import text as cli_text
from gripcourse.cli.help import SpokenCommand
from gripcourse.cli.loudness import confirm, is_quiet
from gripcourse.cli.options import (
    DONE,
    NEEDS_PERSON,
    PROCESSORS,
    AfreshOption,
    ClusterOption,
    CourseOption,
    DateOption,
    EitherVersionOption,
    GradebookOption,
    LanguageOption,
    OutOption,
    RecalculateOption,
    WhoseOption,
    WorkersOption,
    course_folder,
    day_of,
    gradebook_place,
    say_limits,
    words_for,
)
from gripcourse.cli.regrade import ByOption
from gripcourse.text.words import Words, message

if TYPE_CHECKING:
    from gripcourse.usecases.grade import GradingOutcome

# Every command imports what it needs itself: numpy, pandas and WeasyPrint cost up to half a second.
# ruff: noqa: PLC0415

app = typer.Typer()


@app.command(cls=SpokenCommand)
def grade(  # noqa: PLR0913 (one parameter per option)
    paths: Annotated[
        list[Path],
        typer.Argument(metavar="file", help="Workbooks, or folders or zips with workbooks."),
    ],
    *,
    out: OutOption,
    json: Annotated[bool, typer.Option("--json", help="Print the findings as JSON.")] = False,
    whose: WhoseOption = None,
    handed_in: Annotated[
        list[str] | None,
        typer.Option(
            "--handed-in",
            metavar="file=time",
            help="When a file was handed in, or all of them; default: the file's own time.",
        ),
    ] = None,
    pattern: Annotated[
        str | None,
        typer.Option(
            "--pattern", metavar="pattern", help="Where your own paths say whose a file is."
        ),
    ] = None,
    either_version: EitherVersionOption = None,
    recalculate: RecalculateOption = False,
    afresh: AfreshOption = False,
    grades_only: Annotated[
        bool,
        typer.Option("--grades-only", help="Print no reports: grades and findings alone."),
    ] = False,
    by: ByOption = None,
    why: Annotated[str, typer.Option("--why", help="Why, in a few words; it is kept.")] = "",
    on: DateOption = None,
    workers: WorkersOption = PROCESSORS,
    cluster: ClusterOption = None,
    gradebook: GradebookOption = None,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Grade workbooks against the issued values; write reports, a cohort summary and grades."""
    from gripcourse.gradebook.journal import Signed
    from gripcourse.grading.path_pattern import path_pattern
    from gripcourse.jobs.cluster import open_workers
    from gripcourse.machine.files import make_private_folder
    from gripcourse.policy.time_rules import zone_of
    from gripcourse.usecases import grade as command
    from gripcourse.usecases.begin_grading import note_batch
    from gripcourse.usecases.collect import collect
    from gripcourse.usecases.gradebook import (
        check_gradebook,
        course_deadlines,
        keep,
        with_kept_versions,
    )
    from gripcourse.usecases.handed_in import handed_in_times
    from gripcourse.usecases.opening import open_grading, recalculating
    from gripcourse.usecases.progress import progress_noted
    from gripcourse.usecases.student_reports import student_pdf
    from gripcourse.usecases.unchanged import open_earlier, versions_of
    from gripcourse.usecases.whose import read_whose

    words = words_for(language)
    found = collect(paths)
    files = found.files
    root = course_folder(course)
    versions = versions_of(root)
    context = open_grading(root)
    decided = read_whose(whose or (), files, context.register)
    context = replace(
        context,
        whose=decided,
        pattern=None if pattern is None else path_pattern(pattern, context.register),
        either_version=either_version,
    )
    if recalculate:
        context = recalculating(context, workers)
    times = handed_in_times(handed_in or (), files, zone_of(context.policy.late))
    place = gradebook_place(gradebook, context.course.root)
    check_gradebook(place)
    context = with_kept_versions(context, place)
    # Read again where they are needed; what is wrong there is said before anything is graded.
    course_deadlines(context)
    # Before anything is kept: a folder that cannot be written must not cost an attempt.
    make_private_folder(out)
    stated = None if on is None else day_of(on)
    earlier = open_earlier(out, context, versions, workers=workers, day=stated, afresh=afresh)
    say_limits(words)
    with (
        open_workers(workers, cluster) as (hands, pool),
        cli_text.progress() as shown,
        progress_noted(out, shown) as step,
    ):
        tick = step(words.say(message("Grading")), len(files))
        graded = command.grade(files, context, hands, lambda _: tick(), earlier, pool)
        signed = Signed(by or getpass.getuser(), datetime.now(UTC), why)
        graded = keep(graded, context, place, signed.done_at, times)
        note_batch(place, context.course.id, len(graded), signed)
        if not grades_only:
            tick = step(words.say(message("Writing reports")), len(files))
        outcome = command.write_results(
            graded,
            context,
            out,
            day_of(on),
            hands,
            lambda _: tick(),
            passed_over=found.passed_over,
            lay_out=None if grades_only else student_pdf,
            earlier=earlier,
            pool=pool,
        )
    if json:
        result = command.batch_result(
            outcome.reports, words, found.passed_over, scales=context.policy.scales
        )
        typer.echo(cli_text.json_text(result.to_dict()))
    else:
        _say(outcome, out, words)
    raise typer.Exit(NEEDS_PERSON if outcome.needs_person else DONE)


def _say(outcome: "GradingOutcome", out: Path, words: Words) -> None:
    """Say all, or where nobody wants to hear it no more than what went wrong or waits."""
    confirm(grading_text.grading_text(outcome, out, words))
    if is_quiet() and outcome.needs_person:
        typer.echo(grading_text.problems_text(outcome, out, words), err=True)
