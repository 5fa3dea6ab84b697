"""`gripcourse withdraw`: parse, one call, print, exit code. No logic."""

import getpass
from datetime import UTC, datetime
from typing import Annotated

import typer

from gripcourse.cli.help import SpokenCommand
from gripcourse.cli.loudness import confirm
from gripcourse.cli.options import (
    DONE,
    NEEDS_PERSON,
    ByOption,
    CourseOption,
    GradebookOption,
    LanguageOption,
    WhyOption,
    course_folder,
    gradebook_place,
    words_for,
)

# Every command imports what it needs itself: numpy, pandas and the database cost half a second.
# ruff: noqa: PLC0415

app = typer.Typer()


@app.command(cls=SpokenCommand)
def withdraw(  # noqa: PLR0913 (one parameter per option)
    student: Annotated[str, typer.Argument(metavar="student", help="Whose entry of the register.")],
    *,
    same_as: Annotated[
        str,
        typer.Option(
            "--same-as",
            metavar="student",
            help="Who that is: the entry that the person keeps; default: who left the course.",
        ),
    ] = "",
    undo: Annotated[bool, typer.Option("--undo", help="Take the last one back.")] = False,
    why: WhyOption = "",
    by: ByOption = None,
    gradebook: GradebookOption = None,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Take somebody out of the course, or join two entries of one person; nothing is removed."""
    from gripcourse.issuing.withdrawal import Withdrawal
    from gripcourse.usecases.marks.withdraw import withdraw as enter

    words, root = words_for(language), course_folder(course)
    now = datetime.now(UTC)
    wanted = Withdrawal(student, same_as, undo, why, by or getpass.getuser(), now)
    done = enter(wanted, root, gradebook_place(gradebook, root))
    for said in done.notes:
        confirm(words.say(said))
    raise typer.Exit(NEEDS_PERSON if done.disputed or done.told_twice else DONE)
