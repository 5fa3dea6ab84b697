"""`gripcourse mark`: parse, one call, print, exit code. No logic."""

import getpass
from datetime import UTC, datetime
from functools import partial
from pathlib import Path
from typing import Annotated

import typer

from gripcourse.cli import grading_text
from gripcourse.cli import text as cli_text
from gripcourse.cli.help import SpokenCommand
from gripcourse.cli.loudness import confirm
from gripcourse.cli.options import (
    DONE,
    NEEDS_PERSON,
    CourseOption,
    GradebookOption,
    LanguageOption,
    course_folder,
    decimal_number,
    gradebook_place,
    words_for,
)
from gripcourse.cli.pairs import read_lines
from gripcourse.machine.former_file import keeping_former
from gripcourse.text.words import message

# Every command imports what it needs itself: numpy, pandas and the database cost half a second.
# ruff: noqa: PLC0415


app = typer.Typer()


@app.command(cls=SpokenCommand)
def mark(  # noqa: PLR0913 (one parameter per option)
    student: Annotated[str | None, typer.Argument(metavar="student", help="Whose item.")] = None,
    quantity: Annotated[
        str | None, typer.Argument(metavar="item", help="Which item; see --list.")
    ] = None,
    *,
    lines: Annotated[
        list[str] | None,
        typer.Option("--line", metavar="id=share", help="What a line of the rubric earns, 0 to 1."),
    ] = None,
    points: Annotated[
        float | None,
        typer.Option(
            parser=decimal_number, help="Points of the item, instead of what its lines add up to."
        ),
    ] = None,
    credit: Annotated[
        float | None,
        typer.Option(
            parser=decimal_number, help="Share of the points, 0 to 1, where there is no rubric."
        ),
    ] = None,
    comment: Annotated[str, typer.Option(help="For the student.")] = "",
    by: Annotated[
        str | None, typer.Option("--by", help="Who marks; default: the user of this machine.")
    ] = None,
    override: Annotated[
        bool, typer.Option("--override", help="Overrule the automatic result; needs a comment.")
    ] = False,
    withdraw: Annotated[
        bool, typer.Option("--withdraw", help="Withdraw the marks of this item.")
    ] = False,
    show: Annotated[bool, typer.Option("--list", help="Show what waits for a person.")] = False,
    table: Annotated[
        Path | None,
        typer.Option("--table", help="Table of marks, csv, xlsx, ods or xls, instead of one."),
    ] = None,
    out: Annotated[
        Path | None,
        typer.Option(
            "--out", help="With --list: a table to fill in, .xlsx or .csv, for --table later."
        ),
    ] = None,
    gradebook: GradebookOption = None,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Mark what a person judges; kept for good, and part of every report from the next grading."""
    from gripcourse.gradebook.enter import Draft
    from gripcourse.usecases.marks import mark as command
    from gripcourse.usecases.marks.counting import counting_instead
    from gripcourse.usecases.marks.opening import open_grading

    words = words_for(language)
    root = course_folder(course)
    place = gradebook_place(gradebook, root)
    one = student is not None and quantity is not None
    if [show, table is not None, one].count(True) != 1 or (student is not None and not one):
        raise cli_text.misuse(
            message("Name a student and an item, or a file with --table, or ask with --list.")
        )
    if out is not None and not show:
        raise cli_text.misuse(message("--out goes with --list."))
    if show:
        context = open_grading(root)
        waits = command.what_waits(place, context.joins)
        if out is not None:
            write = partial(command.write_waiting, waits, context, place, out)
            _, kept = keeping_former(out, write)
            typer.echo(str(out))
            if kept is not None:
                confirm(words.say(cli_text.kept_former(out, kept)))
        else:
            instead = counting_instead(place, {one.student for one in waits}, context)
            typer.echo(grading_text.waiting_text(waits, instead, context, words))
        raise typer.Exit(NEEDS_PERSON if waits else DONE)
    context, marker, now = open_grading(root), by or getpass.getuser(), datetime.now(UTC)
    if table is not None:
        done = command.enter_table(table, context, place, marker, now)
    else:
        draft = Draft(
            student=str(student),
            quantity=str(quantity),
            lines=read_lines(lines or ()),
            points=points,
            credit=credit,
            comment=comment,
            override=override,
            withdraw=withdraw,
        )
        done = command.enter_mark(draft, context, place, marker, now)
    confirm(grading_text.marking_text(done, context, words))
