"""`gripcourse reissue`: parse, one call, print, exit code. No logic."""

import getpass
from datetime import datetime
from typing import TYPE_CHECKING, Annotated

import typer

from gripcourse.cli import text as cli_text
from gripcourse.cli.help import SpokenCommand
from gripcourse.cli.loudness import confirm
from gripcourse.cli.options import (
    DONE,
    NEEDS_PERSON,
    PROCESSORS,
    ByOption,
    CourseOption,
    DateOption,
    LanguageOption,
    LinkDaysOption,
    OutOption,
    TableOption,
    WhyOption,
    WorkersOption,
    course_apart,
    day_of,
    main_table,
    say_limits,
    words_for,
)
from gripcourse.text.words import message

if TYPE_CHECKING:
    from collections.abc import Callable

# Every command imports what it needs itself: numpy, pandas and the database cost half a second.
# ruff: noqa: PLC0415

app = typer.Typer()


@app.command(cls=SpokenCommand)
def reissue(  # noqa: PLR0913 (one parameter per option)
    students: Annotated[
        list[str], typer.Argument(metavar="student", help="To whom; ids of the register.")
    ],
    *,
    out: OutOption,
    why: WhyOption = "",
    variant: Annotated[
        str, typer.Option("--variant", help="Another variant; default: the student's own row.")
    ] = "",
    table: TableOption = None,
    deadline: Annotated[
        datetime | None,
        typer.Option(formats=["%Y-%m-%d"], help="Last day for handing in; default: as it was."),
    ] = None,
    link_days: LinkDaysOption = 0,
    by: ByOption = None,
    on: DateOption = None,
    workers: WorkersOption = PROCESSORS,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Issue a new version of assignments; what was handed out stays, and works on it count."""
    from gripcourse.course.load import load_course
    from gripcourse.issuing.reissue import Correction
    from gripcourse.policy.load import load_policy
    from gripcourse.usecases.issuing.reissue import CorrectedOrder, reissue_order

    words = words_for(language)
    loaded = load_course(course_apart(course, out))
    order = CorrectedOrder(
        correction=Correction(tuple(students), variant, why, by or getpass.getuser()),
        table=table or main_table(loaded.root),
        out=out,
        today=day_of(on),
        deadline=deadline.date() if deadline else None,
        link_days=link_days,
    )
    say_limits(words)
    with cli_text.progress(words) as step:
        ticks: list[Callable[[], None]] = []
        issuing = reissue_order(
            loaded,
            load_policy(loaded),
            order,
            workers,
            lambda _: ticks[0](),
            on_counted=lambda total: ticks.append(step(words.say(message("Issuing")), total)),
        )
    confirm(cli_text.issuing_text(issuing, out, words))
    unissued = cli_text.unissued_text(issuing, words)
    if unissued:
        typer.echo(unissued)
    raise typer.Exit(NEEDS_PERSON if unissued else DONE)
