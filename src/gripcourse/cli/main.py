"""The command line: parse, one call, print, exit code. No logic.

Exit codes: 0 done; 1 done, something needs a person; 2 wrong use or invalid course; 3 our mistake.
"""

import logging
import sys
import traceback
from collections.abc import Callable, Iterable
from contextlib import suppress
from datetime import datetime
from functools import partial
from pathlib import Path
from time import perf_counter
from typing import Annotated, Final

import typer

from gripcourse.cli import backup as cli_backup
from gripcourse.cli import course as cli_course
from gripcourse.cli import desk as cli_desk
from gripcourse.cli import draw as cli_draw
from gripcourse.cli import export as cli_export
from gripcourse.cli import grade as cli_grade
from gripcourse.cli import key as cli_key
from gripcourse.cli import lti as cli_lti
from gripcourse.cli import mark as cli_mark
from gripcourse.cli import regrade as cli_regrade
from gripcourse.cli import reissue as cli_reissue
from gripcourse.cli import simulation
from gripcourse.cli import text as cli_text
from gripcourse.cli import trace as cli_trace
from gripcourse.cli import variants as cli_variants
from gripcourse.cli import withdraw as cli_withdraw
from gripcourse.cli.foreseen import HANDOUTS, foresee
from gripcourse.cli.help import SpokenCommand, command_group
from gripcourse.cli.issuing import exit_code, issue_with_progress
from gripcourse.cli.loudness import confirm, is_verbose, prepare_streams
from gripcourse.cli.options import (
    DONE,
    OUR_MISTAKE,
    PROCESSORS,
    WRONG_USE,
    CourseOption,
    DateOption,
    LanguageOption,
    LinkDaysOption,
    OutFileOption,
    OutOption,
    TableOption,
    WorkersOption,
    chosen_words,
    course_apart,
    course_folder,
    day_of,
    document_language,
    main_table,
    words_for,
)
from gripcourse.cli.pairs import read_pairs
from gripcourse.cli.problems import said_of
from gripcourse.errors import GripcourseError, memory_problem, system_problem
from gripcourse.machine.ending import end_in_order
from gripcourse.machine.process_wide import DATE_VARIABLE, collect_rarely, strange_date
from gripcourse.text.words import Words, message

# Every command imports what it needs itself: numpy, pandas and WeasyPrint cost up to half a second.
# ruff: noqa: PLC0415

_LONGEST_SETTING: Final = 40  # characters that are shown of it

_log = logging.getLogger(__name__)

app = command_group(
    "Course assignments: issue variants, check, grade, report.",
    is_program=True,
)
for part in (
    cli_grade,
    cli_reissue,
    cli_withdraw,
    cli_mark,
    cli_regrade,
    cli_trace,
    cli_draw,
    cli_course,
    simulation,
    cli_desk,
    cli_backup,
):
    app.add_typer(part.app)
app.add_typer(cli_variants.app, name="variants")
app.add_typer(cli_export.app, name="export")
app.add_typer(simulation.tolerance_app, name="tolerance")
app.add_typer(cli_key.app, name="key")
app.add_typer(cli_lti.app, name="lti")


@app.command(cls=SpokenCommand)
def solve(  # noqa: PLR0913 (one parameter per option)
    variant: Annotated[
        str | None, typer.Argument(metavar="variant", help="Variant of the table.")
    ] = None,
    *,
    scheme: Annotated[str | None, typer.Option(help="Scheme to solve without a table.")] = None,
    settings: Annotated[
        list[str] | None,
        typer.Option("--set", metavar="name=value", help="A given number, in the declared unit."),
    ] = None,
    options: Annotated[
        list[str] | None,
        typer.Option(
            "--option", metavar="name=choice", help="What is chosen, for example material=steel."
        ),
    ] = None,
    convention: Annotated[
        str | None,
        typer.Option(
            metavar="corrected|as_printed", help="Errata corrected, or as the sources print it."
        ),
    ] = None,
    json: Annotated[bool, typer.Option("--json", help="Print the values as JSON.")] = False,
    pdf: Annotated[bool, typer.Option("--pdf", help="Write the worked solution.")] = False,
    xlsx: Annotated[bool, typer.Option("--xlsx", help="Write the key workbook.")] = False,
    out: OutFileOption = None,
    table: TableOption = None,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Solve a variant of the table, or a scheme with values set by hand."""
    from gripcourse.course.load import load_course
    from gripcourse.usecases.solving import solve as command

    root = course_folder(course)
    wanted = cli_text.chosen_convention(convention)
    if (variant is None) == (scheme is None):
        raise cli_text.misuse(message("Name a variant of the table, or a scheme with --scheme."))
    if variant is not None:
        if settings or options:
            raise cli_text.misuse(message("--set and --option go with --scheme."))
        from gripcourse.variants.kept_table import load_with_table

        loaded, variants = load_with_table(root, table or main_table(root))
        solved = command.solve_from_table(loaded, variants, variant, wanted)
    else:
        loaded = load_course(root)
        shape = message("Write name=value.")
        given = dict(read_pairs("--set", settings or (), shape))
        chosen = dict(read_pairs("--option", options or (), shape))
        solved = command.solve_scheme(loaded, str(scheme), given, chosen, wanted)
    if pdf and xlsx and out is not None:
        raise cli_text.misuse(
            message("--out names one file for two documents."),
            message("Ask for one of them, or leave --out out."),
        )
    words = Words(document_language(language, loaded.language))
    if pdf:
        confirm(str(command.write_solution(solved, out, words)))
    if xlsx:
        confirm(str(command.write_key(solved, out, words)))
    if json:
        from gripcourse.api.make_results import solution_result

        typer.echo(cli_text.json_text(solution_result(solved, words).to_dict()))
    if not (pdf or xlsx or json):
        from gripcourse.cli.solution_text import solution_table

        typer.echo(solution_table(solved, words))


@app.command(cls=SpokenCommand)
def issue(  # noqa: PLR0913 (one parameter per option)
    *,
    roster: Annotated[Path, typer.Option(help="Table of the students, csv, xlsx, ods or xls.")],
    out: OutOption,
    table: TableOption = None,
    deadline: Annotated[
        datetime | None, typer.Option(formats=["%Y-%m-%d"], help="Last day for handing in.")
    ] = None,
    printed: Annotated[
        Path | None,
        typer.Option("--print", help="File for a printer: a list and all sheets, on both sides."),
    ] = None,
    link_days: LinkDaysOption = 0,
    on: DateOption = None,
    workers: WorkersOption = PROCESSORS,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Issue an assignment to everybody on the roster: a sheet and an answer workbook each."""
    foresee(HANDOUTS, workers)

    from gripcourse.course.load import load_course
    from gripcourse.machine.files import expect_file
    from gripcourse.policy.load import load_policy
    from gripcourse.usecases.issuing.issue import Order, issue_order

    words = words_for(language)
    if printed is not None:
        expect_file(printed)  # else everybody would be issued something before it is refused
    loaded = load_course(course_apart(course, out))
    order = Order(
        roster=roster,
        table=table or main_table(loaded.root),
        out=out,
        today=day_of(on),
        deadline=deadline.date() if deadline else None,
        link_days=link_days,
    )
    issue_all = partial(issue_order, loaded, load_policy(loaded), order, workers)
    issuing = issue_with_progress(issue_all, out, words)
    if printed is not None:
        from gripcourse.usecases.issuing.printing import print_sheets

        print_sheets(issuing.handouts, loaded, out, printed, order.today)
        confirm(str(printed))
    raise typer.Exit(exit_code(issuing))


@app.command(cls=SpokenCommand)
def check(
    file: Annotated[Path, typer.Argument(metavar="file", help="Your answer workbook.")],
    *,
    ledger: Annotated[
        Path | None, typer.Option("--ledger", help="Server: file that counts who asked how often.")
    ] = None,
    who: Annotated[str, typer.Option("--who", help="Server: id of who is signed in.")] = "",
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Show how a workbook is read, and by policy whether its numbers fit; never the answers."""
    from functools import partial

    from gripcourse.course.load import load_course
    from gripcourse.gradebook.checks import CheckLedger
    from gripcourse.machine.office import office_command
    from gripcourse.policy.load import load_policy
    from gripcourse.submission.apart import start_reader
    from gripcourse.submission.with_office import read_with_office
    from gripcourse.usecases.grading.check import check_file

    if (ledger is None) != (not who):
        raise cli_text.misuse(message("Name both --ledger and --who, or neither."))
    counted = None if ledger is None else CheckLedger(ledger, who)
    start_reader()
    loaded = load_course(course_folder(course))
    read = partial(read_with_office, office=office_command(), language=loaded.language)
    checked = check_file(file, loaded, load_policy(loaded), read, counted)
    words = Words(document_language(language, loaded.language))
    typer.echo(cli_text.check_text(checked, words))


def main() -> None:
    """Run the command line; every failure is a sentence and an exit code, never a traceback."""
    # Not standalone: what the parser refuses comes here, like all other refusals.
    end_in_order()
    is_heard = prepare_streams()
    collect_rarely()
    started = perf_counter()
    code = _guard(_run if is_heard else cli_text.refuse_closed_output)
    _log.info("exit code %d after %.1f s", code, perf_counter() - started)
    sys.exit(code)


def _run() -> int | None:
    if (written := strange_date()) is not None:
        said = message(
            "{variable} is '{written}', which is no number of seconds: it is left out of account.",
            variable=DATE_VARIABLE,
            written=written[:_LONGEST_SETTING],
        )
        typer.echo(chosen_words().say(said), err=True)
    code: int | None = app(prog_name="gripcourse", standalone_mode=False)
    return code


def _guard(run: Callable[[], int | None]) -> int:
    try:
        return run() or DONE
    except GripcourseError as error:
        return _refused(said_of(error.problems, chosen_words()))
    except OSError as error:
        return _refused([system_problem(error).say(chosen_words())])
    except MemoryError:
        pass  # what the failure holds is let go first: a sentence takes memory, too
    except Exception as error:  # noqa: BLE001 (the last place that can say it kindly)
        from gripcourse.machine.jobs.room import is_lack_of_room

        if not is_lack_of_room(error):
            return _our_mistake()
    return _refused([_said_of_memory()])


def _our_mistake() -> int:
    trace = traceback.format_exc()
    log = cli_text.write_incident(trace)
    said = message("This is our mistake, not yours. The details are in {file}.", file=str(log))
    if log is None:
        said = message("This is our mistake, not yours. The details stand above.")
    lines = [trace] if is_verbose() or log is None else []
    _complain([*lines, chosen_words().say(said)])
    return OUR_MISTAKE


def _said_of_memory() -> str:
    try:
        return memory_problem().say(chosen_words())
    except MemoryError:  # not even for the sentences of another language
        return memory_problem().say(Words("en"))


def _refused(lines: Iterable[str]) -> int:
    _complain(lines)
    return WRONG_USE


def _complain(lines: Iterable[str]) -> None:
    """Write to the error stream; where nothing can be written to it either, the code says it."""
    with suppress(OSError):
        for line in lines:
            typer.echo(line, err=True)
