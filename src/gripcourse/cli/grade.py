"""The command that grades a batch: parse, one call, print, exit code. No logic."""

import getpass
from dataclasses import dataclass
from datetime import UTC, date, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gripcourse.cli import grading_text
from gripcourse.cli import text as cli_text
from gripcourse.cli.foreseen import GRADING, REPORTS, foresee
from gripcourse.cli.help import SpokenCommand
from gripcourse.cli.loudness import confirm, is_quiet
from gripcourse.cli.options import (
    DONE,
    NEEDS_PERSON,
    PROCESSORS,
    AfreshOption,
    ByOption,
    ClusterOption,
    CourseOption,
    DateOption,
    EitherVersionOption,
    GradebookOption,
    LanguageOption,
    OutOption,
    PatternOption,
    RecalculateOption,
    WhoseOption,
    WhyOption,
    WorkersOption,
    course_apart,
    day_of,
    gradebook_place,
    say_limits,
    words_for,
)
from gripcourse.text.words import Words, message
from gripcourse.usecases.marks.batch_wish import BatchWish

if TYPE_CHECKING:
    from collections.abc import Sequence

    from gripcourse.batch.context import GradingContext
    from gripcourse.batch.graded import Graded
    from gripcourse.batch.read_ahead import WorksAhead
    from gripcourse.usecases.grading.as_before import Beginning, SaidAtEnd
    from gripcourse.usecases.grading.grade import GradingOutcome
    from gripcourse.usecases.grading.unchanged import Earlier

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
            help="When a file was handed in, or all of them, or a grading worksheet of Moodle; "
            "default: the file's own time.",
        ),
    ] = None,
    pattern: PatternOption = None,
    either_version: EitherVersionOption = None,
    recalculate: RecalculateOption = False,
    afresh: AfreshOption = False,
    grades_only: Annotated[
        bool,
        typer.Option("--grades-only", help="Print no reports: grades and findings alone."),
    ] = False,
    by: ByOption = None,
    why: WhyOption = "",
    on: DateOption = None,
    workers: WorkersOption = PROCESSORS,
    cluster: ClusterOption = None,
    gradebook: GradebookOption = None,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Grade workbooks against the issued values; write reports, a cohort summary and grades."""
    from gripcourse.usecases.grading.versions import EARLIER

    modules = GRADING if grades_only else (*GRADING, *REPORTS)
    # Whether nothing can be as an earlier run left it: workers will be needed.
    is_new = json or afresh or not (out / EARLIER).exists()
    if is_new:
        foresee(modules, workers, cluster)

    from gripcourse.batch.read_ahead import reading_ahead
    from gripcourse.machine.office import office_command, office_identity
    from gripcourse.usecases.grading.as_before import GradingAsked, beginning
    from gripcourse.usecases.grading.collect import collect
    from gripcourse.usecases.grading.note_batch import note_batch

    words = words_for(language)
    found = collect(paths)
    root = course_apart(course, out)
    wish = BatchWish(
        whose=tuple(whose or ()),
        handed_in=tuple(handed_in or ()),
        pattern=pattern,
        either_version=either_version,
        recalculate=recalculate,
    )
    order = _Order(
        wish=wish,
        grades_only=grades_only,
        day=None if on is None else day_of(on),
    )
    manner = _Manner(workers, cluster, afresh, json, by or getpass.getuser(), why, words)
    options = (
        *(order, wish.tables_said(), str(out)),
        *(words.language, bool(workers), office_identity(office_command())),
    )
    with reading_ahead(found.files, workers if is_new and cluster is None else 0) as ahead:
        begun = beginning(GradingAsked(root, gradebook_place(gradebook, root), out, found, options))
        said = None if json or afresh else begun.said_before()
        if said is None:
            # Where they were not foreseen before, nothing where they were.
            foresee(modules, workers, cluster)
            needs_person = _grade_anew(begun, order, manner, ahead)
        else:
            now, files = datetime.now(UTC), len(found.files)
            note_batch(begun.asked.place, said.course, files, manner.by, why, now)
            _say(said)
            needs_person = said.needs_person
    raise typer.Exit(NEEDS_PERSON if needs_person else DONE)


@dataclass(frozen=True, slots=True)
class _Order:
    """What decides over what is graded and printed, as it was typed."""

    wish: BatchWish
    grades_only: bool
    day: date | None


@dataclass(frozen=True, slots=True)
class _Manner:
    """How it is done, by whom and why, and how it is said; results do not depend on it."""

    workers: int
    cluster: str | None
    afresh: bool
    json: bool
    by: str
    why: str
    words: Words


@dataclass(frozen=True, slots=True)
class _Graded:
    """A batch that was graded and written.

    Attributes:
        graded: what each file came to.
        context: what it was graded with.
        outcome: what was written.
        earlier: what an earlier run left; None where nobody can tell what results are made from.
        hands: how many processes graded it.
        now: when.
    """

    graded: "Sequence[Graded]"
    context: "GradingContext"
    outcome: "GradingOutcome"
    earlier: "Earlier | None"
    hands: int
    now: datetime


def _grade_anew(begun: "Beginning", order: _Order, manner: _Manner, ahead: "WorksAhead") -> bool:
    """Grade what an earlier run did not, and say all; tell whether something needs a person."""
    from gripcourse.usecases.grading import grade as command
    from gripcourse.usecases.grading.batch_tables import batch_result

    done, asked, words = _written(begun, order, manner, ahead), begun.asked, manner.words
    outcome, context = done.outcome, done.context
    if manner.json:
        result = batch_result(outcome.reports, words, context, asked.found.passed_over)
        typer.echo(cli_text.json_text(result.to_dict()))
        return outcome.needs_person
    # Once: to lay out the table of a large batch takes seconds.
    text = grading_text.batch_text(outcome, asked.out, words)
    _say(_said(text, outcome, context.course.id, asked.out, words))
    if done.earlier is not None and command.is_settled(done.graded, context, asked.out, done.hands):
        next_time = command.taken_over_next_time(outcome)
        again = _said(text, next_time, context.course.id, asked.out, words)
        begun.keep(again, (one.report.digest for one in done.graded), done.now)
    return outcome.needs_person


def _written(begun: "Beginning", order: _Order, manner: _Manner, ahead: "WorksAhead") -> _Graded:
    """Grade a batch, keep it and write its results."""
    from gripcourse.batch.comparing import comparing_apart
    from gripcourse.machine.files import make_private_folder
    from gripcourse.machine.jobs.cluster import open_workers
    from gripcourse.usecases.grading import grade as command
    from gripcourse.usecases.grading.note_batch import note_batch
    from gripcourse.usecases.grading.progress import progress_noted
    from gripcourse.usecases.grading.student_reports import student_pdf
    from gripcourse.usecases.grading.unchanged import open_earlier
    from gripcourse.usecases.marks.gradebook import keep
    from gripcourse.usecases.marks.opening import as_wished, open_grading

    asked, words = begun.asked, manner.words
    files, out, place = asked.found.files, asked.out, asked.place
    course = open_grading(asked.root)
    context, times = as_wished(order.wish, files, course, place, manner.workers)
    # Before anything is kept: a folder that cannot be written must not cost an attempt.
    make_private_folder(out)
    earlier = open_earlier(
        out, context, begun.versions, workers=manner.workers, day=order.day, afresh=manner.afresh
    )
    say_limits(words)
    with (
        open_workers(manner.workers, manner.cluster) as (hands, pool),
        cli_text.progress(words) as shown,
        progress_noted(out, shown) as step,
    ):
        tick = step(words.say(message("Grading")), len(files))
        read = ahead.ended()
        with comparing_apart(context, None if earlier is None else earlier.reports) as comparing:
            graded = command.grade(
                files, context, hands, lambda _: tick(), earlier, pool,
                ahead=read, comparing=comparing,
            )  # fmt: skip
            now = datetime.now(UTC)
            graded = comparing.entered(keep(graded, context, place, now, times))
        note_batch(place, context.course.id, len(graded), manner.by, manner.why, now)
        if not order.grades_only:
            tick = step(words.say(message("Writing reports")), len(files))
        outcome = command.write_results(
            graded,
            context,
            out,
            order.day or day_of(None),
            hands,
            lambda _: tick(),
            passed_over=asked.found.passed_over,
            lay_out=None if order.grades_only else student_pdf,
            earlier=earlier,
            pool=pool,
        )
    return _Graded(graded, context, outcome, earlier, hands, now)


def _said(
    text: str, outcome: "GradingOutcome", course: str, out: Path, words: Words
) -> "SaidAtEnd":
    from gripcourse.usecases.grading.as_before import SaidAtEnd

    return SaidAtEnd(
        course=course,
        whole=grading_text.with_taken_over(text, outcome, words),
        problems=grading_text.problems_text(outcome, out, words),
        needs_person=outcome.needs_person,
    )


def _say(said: "SaidAtEnd") -> None:
    """Say all, or where nobody wants to hear it no more than what went wrong or waits."""
    confirm(said.whole)
    if is_quiet() and said.needs_person:
        typer.echo(said.problems, err=True)
