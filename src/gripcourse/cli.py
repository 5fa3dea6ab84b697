"""The command line: parse, one call, print, exit code. No logic.

Exit codes: 0 done; 1 done, something needs a person; 2 wrong use or invalid course; 3 our mistake.
"""

import os
import sys
import traceback
from collections.abc import Callable
from datetime import date, datetime
from pathlib import Path
from typing import Annotated

import typer

from gripcourse import cli_text
from gripcourse.errors import GripcourseError
from gripcourse.words import LANGUAGES, Words, message

# Every command imports what it needs itself: numpy, pandas and WeasyPrint cost up to half a second.
# ruff: noqa: PLC0415

DONE, NEEDS_PERSON, WRONG_USE, OUR_MISTAKE = 0, 1, 2, 3

app = typer.Typer(
    add_completion=False,
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    help="Course assignments for robot gripper design: issue variants, check, grade, report.",
)
variants_app = typer.Typer(no_args_is_help=True, help="Variant tables: draw or import.")
app.add_typer(variants_app, name="variants")

CourseOption = Annotated[
    Path | None,
    typer.Option(
        "--course",
        help="Folder of the course; default: this folder if it is one, else the one shipped.",
    ),
]
LanguageOption = Annotated[
    str | None, typer.Option("--language", help="en, ru or uk; default: the course's language.")
]
TableOption = Annotated[
    Path | None, typer.Option("--table", help="Variant table; default: the course's main table.")
]
OutOption = Annotated[Path, typer.Option("--out", help="Where to write.")]
DateOption = Annotated[
    datetime | None, typer.Option("--date", formats=["%Y-%m-%d"], help="Day to print; today.")
]
WorkersOption = Annotated[
    int, typer.Option("--workers", min=1, help="How many processes.", show_default="processors")
]
PROCESSORS = os.cpu_count() or 1


@app.command()
def validate(course: CourseOption = None, language: LanguageOption = None) -> None:
    """Check a whole course and list all its problems at once."""
    from gripcourse.commands.validate import all_problems

    words = _words(language)
    problems = all_problems(_root(course))
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

    loaded = load_course(_root(course))
    wanted = cli_text.chosen_convention(convention)
    if (variant is None) == (scheme is None):
        raise cli_text.misuse(message("Name a variant of the table, or a scheme with --scheme."))
    if variant is not None:
        if settings or options:
            raise cli_text.misuse(message("--set and --option go with --scheme."))
        from gripcourse.variants.table import read_table

        variants = read_table(table or _main_table(loaded.root), loaded)
        solved = command.solve_from_table(loaded, variants, variant, wanted)
    else:
        solved = command.solve_scheme(loaded, str(scheme), settings or (), options or (), wanted)
    words = Words(_document_language(language, loaded.language))
    if pdf:
        typer.echo(str(command.write_solution(solved, out, words)))
    if xlsx:
        typer.echo(str(command.write_key(solved, out, words)))
    if json:
        typer.echo(command.solution_json(solved))
    if not (pdf or xlsx or json):
        typer.echo(cli_text.solution_table(solved, words))


@variants_app.command("draw")
def variants_draw(
    *,
    count: Annotated[int, typer.Option(min=1, max=100_000, help="How many variants.")],
    seed: Annotated[int, typer.Option(min=0, help="The same seed gives the same table.")],
    scheme: Annotated[str | None, typer.Option(help="Only this scheme.")] = None,
    out: Annotated[Path, typer.Option("--out", help="CSV file to write.")] = Path("variants.csv"),
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Draw feasible variants from the course's spaces into a table."""
    from gripcourse.commands.variants import draw_table
    from gripcourse.course.load import load_course

    words = _words(language)
    drawn = draw_table(load_course(_root(course)), count, seed, scheme, out)
    typer.echo(cli_text.drawn_text(drawn, out, words))


@variants_app.command("import")
def variants_import(
    source: Annotated[Path, typer.Argument(help="An instructor's own table, xlsx or csv.")],
    *,
    out: Annotated[Path, typer.Option("--out", help="CSV file to write.")] = Path("variants.csv"),
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Check an instructor's own table and write it in the form that the other commands read."""
    from gripcourse.commands.variants import import_table
    from gripcourse.course.load import load_course

    words = _words(language)
    count = import_table(load_course(_root(course)), source, out)
    said = message("{count} variants were written to {file}.", count=count, file=str(out))
    typer.echo(words.say(said))


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

    words = _words(language)
    loaded = load_course(_root(course))
    order = Order(
        roster=roster,
        table=table or _main_table(loaded.root),
        out=out,
        today=_day(on),
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
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Grade workbooks against the issued values; write reports, a cohort summary and grades."""
    from gripcourse.assignment.register import read_register, register_path
    from gripcourse.cohort.one import Desk
    from gripcourse.commands import grade as command
    from gripcourse.course.load import load_course
    from gripcourse.course.policy_load import load_policy

    words = _words(language)
    files = command.find_files(paths)
    loaded = load_course(_root(course))
    register = read_register(register_path(loaded.root), loaded.id).by_student()
    desk = Desk(loaded, load_policy(loaded), register)
    with cli_text.progress() as step:
        tick = step(words.say(message("Grading")), len(files))
        graded = command.grade(files, desk, workers, lambda _: tick())
        tick = step(words.say(message("Writing reports")), len(files))
        outcome = command.write_results(graded, desk, out, _day(on), workers, lambda _: tick())
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

    loaded = load_course(_root(course))
    checked = check_file(file, loaded, load_policy(loaded))
    words = Words(_document_language(language, loaded.language))
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

    loaded = load_course(_root(course))
    words = Words(_document_language(language, loaded.language))
    for path in draw_atlas(loaded, name, out, words):
        typer.echo(str(path))


@app.command()
def reference(
    *,
    out: OutOption = Path("reference"),
    course: CourseOption = None,
    language: LanguageOption = "en",
) -> None:
    """Write the formula reference: a page for each scheme, made from the declarations alone."""
    from gripcourse.commands.reference import write_reference
    from gripcourse.course.load import load_course

    words = Words(_known(language or LANGUAGES[0]))
    for path in write_reference(load_course(_root(course)), out, words):
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

    words = _words(language)
    init_course(folder, secrets.token_bytes(32), words)
    typer.echo(words.say(message("The course is in {folder}.", folder=str(folder))))


@app.command()
def doctor(language: LanguageOption = None) -> None:
    """Check this machine and say how to mend what it lacks."""
    from gripcourse.doctor import checks

    words = _words(language)
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

    words = _words(language)
    with cli_text.progress() as step:
        done = run_demo(_root(course), out, words, workers, step)
    typer.echo(cli_text.demo_text(done, words))


def main() -> None:
    """Run the command line; every failure is a sentence and an exit code, never a traceback."""
    _guard(app)


def _guard(run: Callable[[], object]) -> None:
    try:
        run()
    except GripcourseError as error:
        words = _words(None)
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
        typer.echo(_words(None).say(said), err=True)
        sys.exit(OUR_MISTAKE)


def _root(course: Path | None) -> Path:
    from gripcourse.resources import course_root, is_course

    here = Path.cwd()
    return course_root(course or (here if is_course(here) else None))


def _main_table(root: Path) -> Path:
    return root / "variants" / "tables" / "main.csv"


def _day(chosen: datetime | None) -> date:
    return chosen.date() if chosen else datetime.now().astimezone().date()


def _words(language: str | None) -> Words:
    """Return the language that the command line speaks: chosen, else the system's, else English."""
    if language is not None:
        return Words(_known(language))
    system = os.environ.get("LC_ALL") or os.environ.get("LC_MESSAGES") or os.environ.get("LANG", "")
    return Words(system[:2] if system[:2] in LANGUAGES else LANGUAGES[0])


def _document_language(chosen: str | None, course: str) -> str:
    return _known(chosen) if chosen is not None else course


def _known(language: str) -> str:
    if language not in LANGUAGES:
        raise cli_text.misuse(
            message("There is no language '{language}': en, ru or uk.", language=language)
        )
    return language
