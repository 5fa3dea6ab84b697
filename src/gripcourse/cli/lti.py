"""The commands on learning platforms: parse, one call, print, exit code. No logic."""

import getpass
from collections.abc import Iterator
from contextlib import contextmanager
from datetime import UTC, datetime
from typing import Annotated

import typer

from gripcourse.access.lti.user_rule import UserRule
from gripcourse.cli import text as cli_text
from gripcourse.cli.desk import AddressOption
from gripcourse.cli.help import SpokenCommand, command_group
from gripcourse.cli.loudness import confirm
from gripcourse.cli.options import (
    DONE,
    NEEDS_PERSON,
    ByOption,
    CourseOption,
    LanguageOption,
    OutOption,
    course_folder,
    words_for,
)
from gripcourse.errors import Problem, UsageError
from gripcourse.text.words import message

# Every command imports what it needs itself: the database and signatures cost half a second.
# ruff: noqa: PLC0415

app = command_group("Learning platforms by LTI 1.3: Moodle, Canvas and others.")

PlatformOption = Annotated[
    str, typer.Option("--platform", help="Name of the platform, where there are several.")
]


@contextmanager
def _needs_library() -> Iterator[None]:
    try:
        yield
    except ModuleNotFoundError as missing:
        raise cli_text.misuse(
            message("Learning platforms need the package {name}.", name=str(missing.name)),
            message("Install gripcourse with its extra 'lti'."),
        ) from missing


@app.command("card", cls=SpokenCommand)
def card(
    *,
    address: AddressOption = "",
    canvas: Annotated[
        bool, typer.Option("--canvas", help="Print the JSON that Canvas takes.")
    ] = False,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Print what the administrator of a platform types in for this course."""
    from gripcourse.course.load import load_course
    from gripcourse.usecases.serving.links import address_of

    with _needs_library():
        from gripcourse.access.lti.usual import canvas_configuration, tool_addresses

    words, loaded = words_for(language), load_course(course_folder(course))
    made = tool_addresses(address_of(loaded.address, address))
    if canvas:
        title = loaded.title.of(words.language)
        typer.echo(cli_text.json_text(canvas_configuration(title, made)))
        return
    lines = (
        message("Tool URL: {address}", address=made.opens),
        message("Login initiation URL: {address}", address=made.login),
        message("Redirection URI: {address}", address=made.launch),
        message("Public keyset URL: {address}", address=made.keys),
        message("Launch container: a new window"),
    )
    typer.echo("\n".join(words.say(one) for one in lines))


@app.command("register", cls=SpokenCommand)
def register(  # noqa: PLR0913 (one parameter per option)
    name: Annotated[str, typer.Argument(metavar="name", help="What it is called here.")],
    *,
    client_id: Annotated[str, typer.Option("--client-id", help="Our client ID on the platform.")],
    deployments: Annotated[
        list[str],
        typer.Option("--deployment", metavar="id", help="ID of our deployment on the platform."),
    ],
    moodle: Annotated[
        str, typer.Option("--moodle", metavar="address", help="It is a Moodle at this address.")
    ] = "",
    canvas: Annotated[
        str,
        typer.Option(
            "--canvas", metavar="address", help="It is Canvas, with this school's address."
        ),
    ] = "",
    endpoints: Annotated[
        tuple[str, str, str, str] | None,
        typer.Option(
            "--endpoints",
            metavar="issuer authorization token keys",
            help="Another platform: its issuer, and where it is asked.",
        ),
    ] = None,
    contexts: Annotated[
        list[str] | None,
        typer.Option("--context", metavar="id", help="A course of the platform that is let in."),
    ] = None,
    known_by: Annotated[
        list[UserRule] | None,
        typer.Option(
            "--known-by",
            metavar="sourcedid|email",
            help="What identifies a student: the office's number (default), the mail address.",
        ),
    ] = None,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Declare a platform whose people are let in; the first one makes our key."""
    with _needs_library():
        from gripcourse.access.lti import usual
        from gripcourse.usecases.serving.lti import register_platform

    if sum(map(bool, (moodle, canvas, endpoints))) != 1:
        raise cli_text.misuse(message("Name one of --moodle, --canvas and --endpoints."))
    if moodle or canvas:
        places = usual.moodle(moodle) if moodle else usual.canvas(canvas)
    else:
        issuer, authorization, token, keys = endpoints or ("", "", "", "")
        places = usual.Endpoints(issuer, authorization, token, keys, ())
    admission = usual.Admission(
        client_id,
        tuple(deployments),
        tuple(contexts or ()),
        tuple(known_by or (UserRule.SOURCEDID,)),
    )
    platform = usual.platform_of(name, places, admission)
    made = register_platform(course_folder(course), platform)
    words = words_for(language)
    said = message(
        "Declared in {file}; our key is {key}.", file=str(made.declared), key=str(made.key)
    )
    confirm(words.say(said))
    if not contexts:
        said = message("No course of the platform is let in yet: name it at 'contexts' there.")
        confirm(words.say(said))


@app.command("rotate", cls=SpokenCommand)
def rotate(*, course: CourseOption = None, language: LanguageOption = None) -> None:
    """Sign with a new key from now on; the former ones are still published for a while."""
    with _needs_library():
        from gripcourse.access.lti.tool_key import make_tool_key

    said = message(
        "A new key signs from now on: {place}.", place=str(make_tool_key(course_folder(course)))
    )
    confirm(words_for(language).say(said))


@app.command("unknown", cls=SpokenCommand)
def unknown(*, course: CourseOption = None, language: LanguageOption = None) -> None:
    """List who came from a platform and could not be matched to a student of the roster."""
    with _needs_library():
        from gripcourse.usecases.serving.desk import open_context
        from gripcourse.usecases.serving.lti import platform_names, store_of, why_not_told

    words = words_for(language)
    context = open_context(course_folder(course))
    names = platform_names(context.course.root)
    strangers = store_of(context).strangers()
    for one in strangers:
        platform = names.get((one.issuer, one.client), one.issuer)
        said = message(
            "{platform}: user {user} ({name}, {email}, {number}): {why}",
            platform=platform,
            user=one.user,
            name=one.name or "–",
            email=one.email or "–",
            number=one.sourcedid or "–",
            why=why_not_told(one),
        )
        typer.echo(words.say(said))
    if not strangers:
        confirm(words.say(message("Everybody who came is known.")))
    raise typer.Exit(NEEDS_PERSON if strangers else DONE)


@app.command("bind", cls=SpokenCommand)
def bind(
    user: Annotated[str, typer.Argument(metavar="user", help="Number of the platform's user.")],
    student: Annotated[
        str, typer.Argument(metavar="student", help="Student of the roster; none for nobody.")
    ] = "",
    *,
    platform: PlatformOption = "",
    by: ByOption = None,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Say which student a platform's user is; without a student: nobody."""
    with _needs_library():
        from gripcourse.usecases.serving import lti as command
        from gripcourse.usecases.serving.desk import open_context

    root = course_folder(course)
    context, chosen = open_context(root), command.chosen_platform(root, platform)
    command.bind(context, chosen, user, student, by or getpass.getuser(), datetime.now(UTC))
    said = message("{user} is {student} from now on.", user=user, student=student)
    if not student:
        said = message("{user} is nobody of the list from now on.", user=user)
    confirm(words_for(language).say(said))


@app.command("send-grades", cls=SpokenCommand)
def send_grades(
    *,
    platform: PlatformOption = "",
    line_item: Annotated[
        str, typer.Option("--line-item", help="Address of the column, where there are several.")
    ] = "",
    by: ByOption = None,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Send published results to the platform's gradebook: what is new or changed."""
    with _needs_library():
        from gripcourse.access.lti.given_access import Access
        from gripcourse.access.lti.tool_key import read_tool_keys
        from gripcourse.access.lti.web_client import make_client
        from gripcourse.usecases.publishing import lti_grades as command
        from gripcourse.usecases.serving.desk import open_context
        from gripcourse.usecases.serving.lti import chosen_platform

    words, root = words_for(language), course_folder(course)
    context, chosen = open_context(root), chosen_platform(root, platform)
    wanted, fates = command.ScoreOrder(line_item, by or getpass.getuser()), []
    with _platform_answers(), make_client() as client:
        access = Access(client, chosen, read_tool_keys(root), lambda: datetime.now(UTC))
        for one in command.send_grades(context, access, wanted):
            fates.append(one.fate)
            if one.why is not None:
                said = message("{student}: not sent. {why}", student=one.student, why=one.why)
                typer.echo(words.say(said), err=True)
    if command.ScoreFate.NOT_TRIED in fates:
        said = message(
            "The platform stopped answering; not tried: {count}. What was sent is kept: call this"
            " again later.",
            count=fates.count(command.ScoreFate.NOT_TRIED),
        )
        typer.echo(words.say(said), err=True)
    said = message(
        "Sent: {sent}; unchanged: {unchanged}; without a result: {none}; not seen on the platform:"
        " {unseen}; failed: {failed}.",
        sent=fates.count(command.ScoreFate.SENT),
        unchanged=fates.count(command.ScoreFate.UNCHANGED),
        none=fates.count(command.ScoreFate.NO_RESULT),
        unseen=fates.count(command.ScoreFate.NOT_SEEN),
        failed=sum(one in command.NOT_SENT for one in fates),
    )
    confirm(words.say(said))
    raise typer.Exit(NEEDS_PERSON if command.NOT_SENT.intersection(fates) else DONE)


@app.command("roster", cls=SpokenCommand)
def roster(
    *,
    out: OutOption,
    platform: PlatformOption = "",
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Write the students of the platform's course as a roster."""
    with _needs_library():
        from gripcourse.access.lti.given_access import Access
        from gripcourse.access.lti.tool_key import read_tool_keys
        from gripcourse.access.lti.web_client import make_client
        from gripcourse.usecases.serving import lti_roster as command
        from gripcourse.usecases.serving.desk import open_context
        from gripcourse.usecases.serving.lti import chosen_platform

    root = course_folder(course)
    context, chosen = open_context(root), chosen_platform(root, platform)
    with _platform_answers(), make_client() as client:
        access = Access(client, chosen, read_tool_keys(root), lambda: datetime.now(UTC))
        people = command.fetch_roster(context, access)
    command.write_roster(people, out)
    said = message("Students in {file}: {count}.", file=str(out), count=len(people))
    confirm(words_for(language).say(said))


@contextmanager
def _platform_answers() -> Iterator[None]:
    from gripcourse.access.lti.refused import PlatformFailedError

    try:
        yield
    except PlatformFailedError as fault:
        remedy = message("Check what is declared in {file}, or try again later.", file="lti.toml")
        raise UsageError([Problem("", "", fault.said, remedy)]) from fault
