"""The commands of the server and its desk: parse, one call, print, exit code. No logic."""

import getpass
from datetime import UTC, datetime
from pathlib import Path
from typing import Annotated

import typer

from gripcourse.cli import text as cli_text
from gripcourse.cli.help import SpokenCommand
from gripcourse.cli.loudness import confirm
from gripcourse.cli.options import (
    PROCESSORS,
    ByOption,
    CourseOption,
    LanguageOption,
    OutFileOption,
    OutOption,
    WhyOption,
    WorkersOption,
    course_folder,
    words_for,
)
from gripcourse.text.words import message

# Every command imports what it needs itself: the server and the database cost half a second.
# ruff: noqa: PLC0415

app = typer.Typer()

AddressOption = Annotated[
    str,
    typer.Option(
        "--address", help="Address of the server, as browsers reach it; default: the course's."
    ),
]


@app.command(cls=SpokenCommand)
def serve(  # noqa: PLR0913 (one parameter per option)
    *,
    host: Annotated[str, typer.Option("--host", help="Where to listen.")] = "127.0.0.1",
    port: Annotated[int, typer.Option("--port", min=1, max=65535, help="Where to listen.")] = 8321,
    address: AddressOption = "",
    assignments: Annotated[
        Path | None, typer.Option("--assignments", help="Folder that issuing wrote.")
    ] = None,
    graded: Annotated[
        Path | None, typer.Option("--graded", help="Folder that grading writes.")
    ] = None,
    workers: WorkersOption = PROCESSORS,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Serve students' pages and the instructor's desk; prints a link to sign in."""
    try:
        from gripcourse.web.serve import Serving, look_into
        from gripcourse.web.serve import serve as run
    except ModuleNotFoundError as missing:
        raise cli_text.misuse(
            message(
                "The server needs the package {name}; install gripcourse with its extra 'web'.",
                name=str(missing.name),
            )
        ) from missing
    from gripcourse.usecases.serving.living import open_living
    from gripcourse.usecases.serving.sign_in import offer_sign_in

    words = words_for(language)
    living = open_living(course_folder(course))
    context = living.context
    base = (address or context.course.address or f"http://{host}:{port}").rstrip("/")
    serving = Serving(host, port, base, assignments, graded, workers)
    look_into(serving)
    token = offer_sign_in(context, getpass.getuser(), datetime.now(UTC))
    said = message("Serving at {address}. Sign in once, within half an hour:", address=base)
    typer.echo(f"{words.say(said)}\n{base}/desk/sign-in/{token}")
    run(living, serving)


@app.command("sign-in", cls=SpokenCommand)
def sign_in(
    *,
    by: ByOption = None,
    address: AddressOption = "",
    course: CourseOption = None,
    language: LanguageOption = None,  # noqa: ARG001 (every command takes it)
) -> None:
    """Print a link with which an instructor signs in at the desk, once."""
    from gripcourse.usecases.serving.desk import open_books
    from gripcourse.usecases.serving.links import address_of
    from gripcourse.usecases.serving.sign_in import offer_sign_in

    books = open_books(course_folder(course))
    base = address_of(books.address, address)  # before a token is made that nobody would see
    token = offer_sign_in(books, by or getpass.getuser(), datetime.now(UTC))
    typer.echo(f"{base}/desk/sign-in/{token}")


@app.command(cls=SpokenCommand)
def links(  # noqa: PLR0913 (one parameter per option)
    *,
    out: OutFileOption = None,
    address: AddressOption = "",
    days: Annotated[
        int, typer.Option("--days", min=1, max=1000, help="How long the links are good for.")
    ] = 180,
    revoke: Annotated[
        str | None,
        typer.Option("--revoke", metavar="student", help="End this student's earlier links first."),
    ] = None,
    by: ByOption = None,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Write a personal link for every student; whoever has a link is that student."""
    from gripcourse.usecases.serving.desk import open_books
    from gripcourse.usecases.serving.links import make_links, revoke_links, write_links

    words, now = words_for(language), datetime.now(UTC)
    books = open_books(course_folder(course))
    if revoke is not None:
        revoke_links(books, revoke, by or getpass.getuser(), now)
        said = message("No link that {student} had opens anything any more.", student=revoke)
        confirm(words.say(said))
    if out is None and revoke is None:
        raise cli_text.misuse(message("Name the file with --out, or a student with --revoke."))
    if out is not None:
        write_links(make_links(books, address, days, now), out)
        confirm(str(out))


@app.command(cls=SpokenCommand)
def release(
    graded: Annotated[
        Path | None, typer.Argument(metavar="folder", help="Folder that grading wrote.")
    ] = None,
    *,
    withdraw: Annotated[
        bool, typer.Option("--withdraw", help="Let students see no results any more.")
    ] = False,
    by: ByOption = None,
    why: WhyOption = "",
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Show students a copy of their results on their pages; to note that they know it: publish."""
    from gripcourse.usecases.publishing import publish as command
    from gripcourse.usecases.serving.desk import open_context

    words, who, now = words_for(language), by or getpass.getuser(), datetime.now(UTC)
    if withdraw == (graded is not None):
        raise cli_text.misuse(message("Name the folder that grading wrote, or --withdraw."))
    context = open_context(course_folder(course))
    if graded is None:
        command.withdraw(context, who, why, now)
        confirm(words.say(message("Students see no results.")))
    else:
        command.publish(context, graded, who, why, now)
        confirm(words.say(message("Students see the results.")))


@app.command("handed-in", cls=SpokenCommand)
def handed_in(
    *, out: OutOption, course: CourseOption = None, language: LanguageOption = None
) -> None:
    """Write the workbooks that may count into a folder, to be graded."""
    from gripcourse.usecases.serving.desk import open_books
    from gripcourse.usecases.serving.hand_in import collect_hand_ins

    written = collect_hand_ins(open_books(course_folder(course)), out)
    said = message("Files in {folder}: {count}.", folder=str(out), count=len(written))
    confirm(words_for(language).say(said))
