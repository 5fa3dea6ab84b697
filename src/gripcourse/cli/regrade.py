"""`gripcourse regrade`, `undo`, `publish`, `waive`, `history`: parse, one call, print."""

import getpass
from contextlib import suppress
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gripcourse.cli import regrade_text
from gripcourse.cli import text as cli_text
from gripcourse.cli.foreseen import GRADING, foresee
from gripcourse.cli.help import SpokenCommand
from gripcourse.cli.loudness import confirm
from gripcourse.cli.options import (
    DONE,
    NEEDS_PERSON,
    PROCESSORS,
    AllowLowerOption,
    ByOption,
    CourseOption,
    EitherVersionOption,
    GradebookOption,
    LanguageOption,
    PatternOption,
    WhoseOption,
    WhyOption,
    WorkersOption,
    course_folder,
    gradebook_place,
    say_limits,
    words_for,
)
from gripcourse.errors import CourseError
from gripcourse.text.words import message

if TYPE_CHECKING:
    from gripcourse.batch.context import GradingContext

# Every command imports what it needs itself: numpy, pandas and the database cost half a second.
# ruff: noqa: PLC0415

app = typer.Typer()


@app.command(cls=SpokenCommand)
def regrade(  # noqa: PLR0913 (one parameter per option)
    paths: Annotated[
        list[Path], typer.Argument(metavar="file", help="Workbooks, or folders with workbooks.")
    ],
    *,
    only: Annotated[
        str | None,
        typer.Option("--only", metavar="raised|lowered|unchanged", help="Show only such works."),
    ] = None,
    apply: Annotated[
        bool, typer.Option("--apply", help="Let the new results count; needs a reason.")
    ] = False,
    why: WhyOption = "",
    allow_lower: AllowLowerOption = False,
    by: ByOption = None,
    whose: WhoseOption = None,
    pattern: PatternOption = None,
    either_version: EitherVersionOption = None,
    workers: WorkersOption = PROCESSORS,
    gradebook: GradebookOption = None,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Show what today's course and policy would change about graded works; apply it if asked."""
    from gripcourse.batch.read_ahead import reading_ahead
    from gripcourse.gradebook.journal import Signed
    from gripcourse.usecases.grading.collect import collect
    from gripcourse.usecases.grading.unchanged import open_earlier
    from gripcourse.usecases.grading.versions import EARLIER, versions_of
    from gripcourse.usecases.marks import regrade as command
    from gripcourse.usecases.marks.batch_wish import BatchWish
    from gripcourse.usecases.marks.opening import open_grading

    words = words_for(language)
    direction = regrade_text.chosen_direction(only)
    if apply and not why.strip():
        raise cli_text.misuse(
            message("A regrade needs a reason."),
            message("Say why: whoever asks in a year reads it."),
        )
    foresee(GRADING, workers)
    files = collect(paths).files
    root = course_folder(course)
    # Who has looked before mostly looks at the same again.
    is_new = not (root / "private" / EARLIER).exists()
    wish = BatchWish(tuple(whose or ()), pattern=pattern, either_version=either_version)
    with reading_ahead(files, workers if is_new else 0) as ahead:
        versions = versions_of(root)
        context = open_grading(root)
        place, now = gradebook_place(gradebook, context.course.root), datetime.now(UTC)
        context = command.as_decided(context, files, place, wish)
        earlier = None
        # Whoever may not write there looks, too, but pays for every look.
        with suppress(OSError):
            earlier = open_earlier(root / "private", context, versions, workers=workers)
        say_limits(words)
        read = ahead.ended()
        with cli_text.progress(words) as step:
            tick = step(words.say(message("Grading")), len(files))
            kept = None if earlier is None else earlier.reports
            found = command.regrade(
                files, context, place, workers, now, lambda _: tick(), kept=kept, ahead=read
            )
    if found.incidents:
        cli_text.write_incident("\n".join(found.incidents))
    typer.echo(regrade_text.regrade_text(found, direction, context, words))
    if apply:
        signed = Signed(by or getpass.getuser(), now, why)
        done = command.apply_regrade(found, place, signed, allow_lower=allow_lower)
        confirm(regrade_text.applied_text(done, words))
    waits = found.lost or found.strangers or found.failed or (found.to_apply and not apply)
    raise typer.Exit(NEEDS_PERSON if waits else DONE)


@app.command(cls=SpokenCommand)
def undo(
    *,
    why: WhyOption = "",
    allow_lower: AllowLowerOption = False,
    by: ByOption = None,
    gradebook: GradebookOption = None,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Take the last regrade back; it stays on record."""
    from gripcourse.gradebook.journal import Signed
    from gripcourse.usecases.marks.opening import register_of
    from gripcourse.usecases.marks.regrade import undo_regrade

    words = words_for(language)
    root = course_folder(course)
    place, joins = gradebook_place(gradebook, root), register_of(root).joins
    signed = Signed(by or getpass.getuser(), datetime.now(UTC), why)
    done = undo_regrade(place, signed, joins, allow_lower=allow_lower)
    confirm(regrade_text.undone_text(done, words))


@app.command(cls=SpokenCommand)
def publish(
    students: Annotated[
        list[str] | None, typer.Argument(metavar="student", help="Only these; default: everybody.")
    ] = None,
    *,
    by: ByOption = None,
    gradebook: GradebookOption = None,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Note that results are known, so that only a regrade changes them; to show them: release."""
    from gripcourse.gradebook.journal import Signed
    from gripcourse.usecases.marks import regrade as command
    from gripcourse.usecases.marks.opening import register_of

    words = words_for(language)
    root = course_folder(course)
    place, joins = gradebook_place(gradebook, root), register_of(root).joins
    signed = Signed(by or getpass.getuser(), datetime.now(UTC))
    told = command.publish(place, students or (), signed, joins)
    confirm(regrade_text.published_text(told, words))


@app.command(cls=SpokenCommand)
def waive(  # noqa: PLR0913 (one parameter per option)
    student: Annotated[str, typer.Argument(metavar="student", help="Whose lateness.")],
    *,
    until: Annotated[
        str | None,
        typer.Option(
            "--until",
            metavar="time",
            help="Until when it costs nothing; default: for good.",
        ),
    ] = None,
    withdraw: Annotated[
        bool, typer.Option("--withdraw", help="Withdraw the student's waivers.")
    ] = False,
    why: WhyOption = "",
    by: ByOption = None,
    gradebook: GradebookOption = None,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Let a student's lateness cost nothing, at all or until a moment; the reason is kept."""
    from gripcourse.gradebook.deadlines import doubt_about, last_moment_of
    from gripcourse.gradebook.timing import Waiver
    from gripcourse.policy.time_rules import zone_of
    from gripcourse.usecases.marks.opening import open_grading, register_of
    from gripcourse.usecases.marks.waive import waive as enter

    words, root = words_for(language), course_folder(course)
    # The zone stands in the policy, which needs a course without problems; the rest needs none.
    moment = None
    if until is not None:
        zone = zone_of(open_grading(root).policy.late)
        moment = last_moment_of(until, zone)
        if moment is None:
            raise cli_text.misuse(
                message("'{text}' is no day.", text=until),
                message("Write 2026-12-01, or 2026-12-01 18:00."),
            )
        if (doubt := doubt_about(until, zone)) is not None:
            raise cli_text.misuse(*doubt)
    place, now = gradebook_place(gradebook, root), datetime.now(UTC)
    wanted = Waiver(student, 0, moment, withdraw, by or getpass.getuser(), now, why)
    register = register_of(root)
    enter(wanted, place, register.by_student(), register.joins)
    confirm(words.say(message("Kept. Grade again to renew the reports.")))


@app.command(cls=SpokenCommand)
def history(
    student: Annotated[str, typer.Argument(metavar="student", help="Whose grade.")],
    *,
    gradebook: GradebookOption = None,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Show everything that happened to a student's grade: when, by whom, and why."""
    from gripcourse.usecases.marks.called import item_with_id
    from gripcourse.usecases.marks.history import history as ask
    from gripcourse.usecases.marks.history import what_counts
    from gripcourse.usecases.marks.opening import register_of

    words, root = words_for(language), course_folder(course)
    context = _sound(root)

    def called(quantity: str) -> str:
        return (
            quantity
            if context is None
            else item_with_id(student, quantity, context, words.language)
        )

    place = gradebook_place(gradebook, root)
    register = register_of(root)
    known, withdrawals = register.by_student(), register.withdrawals
    events = ask(place, student, known, called, withdrawals, register.course_id, root=root)
    typer.echo(regrade_text.history_text(events, words))
    counts = None if context is None else what_counts(place, student, context)
    if counts is not None:
        typer.echo(words.say(counts))
    if context is None:
        said = message("The course has problems: quantities are called by their ids.")
        typer.echo(words.say(said), err=True)


def _sound(root: Path) -> "GradingContext | None":
    """Open a course for what people call its quantities; None while it has problems."""
    from gripcourse.usecases.marks.opening import open_grading

    try:
        return open_grading(root)
    except CourseError:
        return None
