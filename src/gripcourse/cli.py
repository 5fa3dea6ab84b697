"""The command line: parse, one call, print, exit code. No logic.

Exit codes: 0 done; 1 done, something needs a person; 2 wrong use or invalid course; 3 our mistake.
"""

import sys
import traceback
from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path
from typing import Annotated

import typer

from gripcourse import cli_draw, cli_mark, cli_text, cli_trace, cli_variants, cli_virtual
from gripcourse.cli_options import (
    DONE,
    NEEDS_PERSON,
    OUR_MISTAKE,
    PROCESSORS,
    WRONG_USE,
    CourseOption,
    DateOption,
    GradebookOption,
    LanguageOption,
    OutOption,
    TableOption,
    WorkersOption,
    chosen_words,
    course_folder,
    day_of,
    document_language,
    gradebook_place,
    main_table,
    words_for,
)
from gripcourse.errors import GripcourseError
from gripcourse.words import Words, message

# Every command imports what it needs itself: numpy, pandas and WeasyPrint cost up to half a second.
# ruff: noqa: PLC0415

app = typer.Typer(
    add_completion=False,
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    help="Course assignments for robot gripper design: issue variants, check, grade, report.",
)
app.add_typer(cli_variants.app, name="variants")
app.add_typer(cli_virtual.app)
app.command()(cli_trace.trace)
app.command()(cli_mark.mark)
app.command()(cli_draw.draw)


@app.command()
def validate(course: CourseOption = None, language: LanguageOption = None) -> None:
    """Check a whole course and list all its problems at once."""
    from gripcourse.commands.validate import all_problems

    words = words_for(language)
    problems = all_problems(course_folder(course))
    if problems:
        raise GripcourseError(problems)
    typer.echo(words.say(message("The course is valid.")))


@app.command()
def solve(  # noqa: PLR0913 (one parameter per option)
    variant: Annotated[str | None, typer.Argument(help="Variant of the table.")] = None,
    *,
    scheme: Annotated[str | None, typer.Option(help="Scheme to solve without a table.")] = None,
    settings: Annotated[
        list[str] | None, typer.Option("--set", help="name=value, in the declared unit.")
    ] = None,
    options: Annotated[
        list[str] | None, typer.Option("--option", help="name=choice, for example drive=hydraulic.")
    ] = None,
    convention: Annotated[
        str | None, typer.Option(help="corrected, or guide: as the source prints it.")
    ] = None,
    json: Annotated[bool, typer.Option("--json", help="Print the values as JSON.")] = False,
    pdf: Annotated[bool, typer.Option("--pdf", help="Write the worked solution.")] = False,
    xlsx: Annotated[bool, typer.Option("--xlsx", help="Write the key workbook.")] = False,
    out: Annotated[Path | None, typer.Option("--out", help="File to write.")] = None,
    table: TableOption = None,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Solve a variant of the table, or a scheme with values set by hand."""
    from gripcourse.commands import solve as command
    from gripcourse.course.load import load_course

    loaded = load_course(course_folder(course))
    wanted = cli_text.chosen_convention(convention)
    if (variant is None) == (scheme is None):
        raise cli_text.misuse(message("Name a variant of the table, or a scheme with --scheme."))
    if variant is not None:
        if settings or options:
            raise cli_text.misuse(message("--set and --option go with --scheme."))
        from gripcourse.variants.table import read_table

        variants = read_table(table or main_table(loaded.root), loaded)
        solved = command.solve_from_table(loaded, variants, variant, wanted)
    else:
        solved = command.solve_scheme(loaded, str(scheme), settings or (), options or (), wanted)
    words = Words(document_language(language, loaded.language))
    if pdf:
        typer.echo(str(command.write_solution(solved, out, words)))
    if xlsx:
        typer.echo(str(command.write_key(solved, out, words)))
    if json:
        typer.echo(command.solution_json(solved))
    if not (pdf or xlsx or json):
        typer.echo(cli_text.solution_table(solved, words))


@app.command()
def issue(  # noqa: PLR0913 (one parameter per option)
    *,
    roster: Annotated[Path, typer.Option(help="CSV of students.")],
    out: OutOption,
    table: TableOption = None,
    deadline: Annotated[
        datetime | None, typer.Option(formats=["%Y-%m-%d"], help="Last day for handing in.")
    ] = None,
    on: DateOption = None,
    workers: WorkersOption = PROCESSORS,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Issue an assignment to everybody on the roster: a sheet and an answer workbook each."""
    from gripcourse.commands.issue import Order, issue_order
    from gripcourse.course.load import load_course
    from gripcourse.course.policy_load import load_policy

    words = words_for(language)
    loaded = load_course(course_folder(course))
    order = Order(
        roster=roster,
        table=table or main_table(loaded.root),
        out=out,
        today=day_of(on),
        deadline=deadline.date() if deadline else None,
    )
    with cli_text.progress() as step:
        tick = step(words.say(message("Issuing")), None)
        issuing = issue_order(loaded, load_policy(loaded), order, workers, lambda _: tick())
    typer.echo(cli_text.issuing_text(issuing, out, words))
    raise typer.Exit(NEEDS_PERSON if any(one.faults for one in issuing.handouts) else DONE)


@app.command()
def grade(  # noqa: PLR0913 (one parameter per option)
    paths: Annotated[list[Path], typer.Argument(help="Workbooks, or folders with workbooks.")],
    *,
    out: OutOption,
    json: Annotated[bool, typer.Option("--json", help="Print the findings as JSON.")] = False,
    on: DateOption = None,
    workers: WorkersOption = PROCESSORS,
    gradebook: GradebookOption = None,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Grade workbooks against the issued values; write reports, a cohort summary and grades."""
    from gripcourse.commands import grade as command
    from gripcourse.commands.desk import open_desk
    from gripcourse.commands.gradebook import check_gradebook, keep

    words = words_for(language)
    files = command.find_files(paths)
    desk = open_desk(course_folder(course))
    place = gradebook_place(gradebook, desk.course.root)
    check_gradebook(place)
    with cli_text.progress() as step:
        tick = step(words.say(message("Grading")), len(files))
        graded = command.grade(files, desk, workers, lambda _: tick())
        graded = keep(graded, desk, place, datetime.now(UTC))
        tick = step(words.say(message("Writing reports")), len(files))
        outcome = command.write_results(graded, desk, out, day_of(on), workers, lambda _: tick())
    if json:
        typer.echo(command.json_text(outcome.reports, words))
    else:
        typer.echo(cli_text.grading_text(outcome, out, words))
    raise typer.Exit(NEEDS_PERSON if outcome.needs_person else DONE)


@app.command()
def check(
    file: Annotated[Path, typer.Argument(help="Your answer workbook.")],
    *,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Show how a workbook is read and whether its numbers fit each other; never the answers."""
    from gripcourse.commands.check import check_file
    from gripcourse.course.load import load_course
    from gripcourse.course.policy_load import load_policy

    loaded = load_course(course_folder(course))
    checked = check_file(file, loaded, load_policy(loaded))
    words = Words(document_language(language, loaded.language))
    typer.echo(cli_text.check_text(checked, words))


@app.command()
def atlas(
    name: Annotated[str, typer.Argument(help="Atlas of the course, for example lever-arms.")],
    *,
    out: OutOption = Path("atlas"),
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Reproduce the figures and cases of a source from the course's own formulas."""
    from gripcourse.commands.atlas import draw_atlas
    from gripcourse.course.load import load_course

    loaded = load_course(course_folder(course))
    words = Words(document_language(language, loaded.language))
    for path in draw_atlas(loaded, name, out, words):
        typer.echo(str(path))


@app.command()
def reference(
    *,
    out: OutOption = Path("reference"),
    course: CourseOption = None,
    language: Annotated[str, typer.Option("--language", help="en, ru or uk.")] = "en",
) -> None:
    """Write the formula reference: a page for each scheme, made from the declarations alone."""
    from gripcourse.commands.reference import write_reference
    from gripcourse.course.load import load_course

    words = words_for(language)
    for path in write_reference(load_course(course_folder(course)), out, words):
        typer.echo(str(path))


@app.command()
def init(
    folder: Annotated[Path, typer.Argument(help="New folder of the course.")],
    *,
    language: LanguageOption = None,
) -> None:
    """Make a course of your own: a copy of the reference course with a key of its own."""
    import secrets

    from gripcourse.init import init_course

    words = words_for(language)
    init_course(folder, secrets.token_bytes(32), words)
    typer.echo(words.say(message("The course is in {folder}.", folder=str(folder))))


@app.command()
def doctor(language: LanguageOption = None) -> None:
    """Check this machine and say how to mend what it lacks."""
    from gripcourse.doctor import checks

    words = words_for(language)
    found = checks(Path.cwd())
    typer.echo(cli_text.doctor_text(found, words))
    raise typer.Exit(WRONG_USE if any(one.required and not one.ok for one in found) else DONE)


@app.command()
def demo(
    *,
    out: OutOption = Path("out"),
    workers: WorkersOption = PROCESSORS,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Run the whole main job: issue to a roster, let scripted students answer, grade, report."""
    from gripcourse.commands.demo import run_demo

    words = words_for(language)
    with cli_text.progress() as step:
        done = run_demo(course_folder(course), out, words, workers, step)
    typer.echo(cli_text.demo_text(done, words))


def main() -> None:
    """Run the command line; every failure is a sentence and an exit code, never a traceback."""
    _guard(app)


def _guard(run: Callable[[], object]) -> None:
    try:
        run()
    except GripcourseError as error:
        words = chosen_words()
        for problem in error.problems:
            typer.echo(problem.say(words), err=True)
        sys.exit(WRONG_USE)
    except OSError as error:
        place = f"{error.filename}: " if error.filename else ""
        typer.echo(f"{place}{error.strerror or error}", err=True)
        sys.exit(WRONG_USE)
    except Exception:  # noqa: BLE001 (the last place that can say it kindly)
        log = cli_text.write_incident(traceback.format_exc())
        said = message("This is our mistake, not yours. The details are in {file}.", file=str(log))
        typer.echo(chosen_words().say(said), err=True)
        sys.exit(OUR_MISTAKE)
