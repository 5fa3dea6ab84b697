"""The commands on tables of variants: parse, one call, print, exit code. No logic."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gripcourse.cli import text as cli_text
from gripcourse.cli.help import SpokenCommand, command_group
from gripcourse.cli.loudness import confirm
from gripcourse.cli.options import (
    DONE,
    NEEDS_PERSON,
    PROCESSORS,
    CountOption,
    CourseOption,
    DateOption,
    LanguageOption,
    OutOption,
    OutTableOption,
    SchemeOption,
    SeedOption,
    TableOption,
    WorkersOption,
    course_folder,
    day_of,
    document_language,
    main_table,
    words_for,
)
from gripcourse.machine.former_file import keeping_former
from gripcourse.text.words import Words, message

if TYPE_CHECKING:
    from gripcourse.variants.draw import Drawn

# Every command imports what it needs itself: numpy, pandas and WeasyPrint cost up to half a second.
# ruff: noqa: PLC0415

app = command_group("Variant tables: draw, fill in, import, audit.")


@app.command("draw", cls=SpokenCommand)
def draw(  # noqa: PLR0913 (one parameter per option)
    *,
    count: CountOption,
    seed: SeedOption,
    scheme: SchemeOption = None,
    freely: Annotated[
        bool, typer.Option("--freely", help="Do not keep the variants apart from each other.")
    ] = False,
    apart_from: Annotated[
        list[Path] | None,
        typer.Option(
            "--apart-from",
            help="A table to keep apart from, as of last year; as often as there are tables.",
        ),
    ] = None,
    out: OutTableOption = Path("variants.csv"),
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Draw variants that can be solved and are far enough apart from the course's spaces."""
    from gripcourse.course.load import load_course
    from gripcourse.usecases.solving.variants import draw_table

    if freely and apart_from:
        raise cli_text.misuse(message("--freely and --apart-from exclude each other."))
    words = words_for(language)
    loaded = load_course(course_folder(course))

    def make() -> "Drawn":
        return draw_table(
            loaded, count, seed, scheme, out, freely=freely, apart_from=apart_from or ()
        )

    drawn, kept = keeping_former(out, make)
    confirm(cli_text.drawn_text(drawn, out, words))
    _tell_former(out, kept, words)


@app.command("import", cls=SpokenCommand)
def import_(
    source: Annotated[
        Path, typer.Argument(metavar="table", help="An instructor's own table, xlsx or csv.")
    ],
    *,
    out: OutTableOption = Path("variants.csv"),
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Check an instructor's own table and write it in the form that the other commands read."""
    from gripcourse.course.load import load_course
    from gripcourse.usecases.solving.variants import import_table

    words = words_for(language)
    loaded = load_course(course_folder(course))
    table, kept = keeping_former(out, lambda: import_table(loaded, source, out))
    for note in table.notes:
        confirm(words.say(note))
    confirm(words.say(cli_text.written_variants(len(table.variants), out)))
    _tell_former(out, kept, words)


@app.command("template", cls=SpokenCommand)
def template(
    *,
    scheme: SchemeOption = None,
    rows: Annotated[
        int, typer.Option("--rows", min=1, max=1000, help="How many rows for each scheme.")
    ] = 30,
    out: OutTableOption = Path("variants.xlsx"),
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Write a table for an instructor to fill in, with the worked example in every row."""
    from gripcourse.course.load import load_course
    from gripcourse.usecases.solving.variants import write_template

    words = words_for(language)
    loaded = load_course(course_folder(course))
    variants, kept = keeping_former(out, lambda: write_template(loaded, scheme, rows, out))
    confirm(words.say(cli_text.written_variants(len(variants), out)))
    _tell_former(out, kept, words)


@app.command("audit", cls=SpokenCommand)
def audit(  # noqa: PLR0913 (one parameter per option)
    *,
    table: TableOption = None,
    drawn: Annotated[
        int | None,
        typer.Option("--drawn", min=1, help="Audit so many freely drawn variants, and no table."),
    ] = None,
    seed: Annotated[
        int, typer.Option("--seed", min=0, help="The same seed draws the same variants.")
    ] = 1,
    scheme: SchemeOption = None,
    out: OutOption = Path("audit"),
    on: DateOption = None,
    workers: WorkersOption = PROCESSORS,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Check that a table's variants are far from slips, fair and apart; write a certificate."""
    from gripcourse.course.load import load_course
    from gripcourse.usecases.solving.audit import audit_drawn, audit_table

    if table is not None and drawn is not None:
        raise cli_text.misuse(message("A table and --drawn were named: one of them is audited."))
    loaded = load_course(course_folder(course))
    document = Words(document_language(language, loaded.language))
    audited = (
        audit_table(loaded, table or main_table(loaded.root), out, document, day_of(on), workers)
        if drawn is None
        else audit_drawn(loaded, drawn, seed, scheme, out, document, day_of(on), workers)
    )
    confirm(cli_text.audit_text(audited, words_for(language)))
    raise typer.Exit(DONE if audited.audit.passed else NEEDS_PERSON)


def _tell_former(out: Path, kept: Path | None, words: Words) -> None:
    """Say where the table is whose place another one took."""
    if kept is not None:
        confirm(words.say(cli_text.kept_former(out, kept)))
