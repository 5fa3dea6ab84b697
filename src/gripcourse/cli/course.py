"""Commands on a course as a whole, and on the machine: parse, one call, print. No logic."""

from pathlib import Path
from typing import Annotated, Final

import typer

from gripcourse.cli import text as cli_text
from gripcourse.cli.help import SpokenCommand
from gripcourse.cli.loudness import confirm
from gripcourse.cli.options import (
    DONE,
    NEEDS_PERSON,
    PROCESSORS,
    WRONG_USE,
    CourseOption,
    LanguageOption,
    OutOption,
    SchemeOption,
    course_folder,
    document_language,
    main_table,
    words_for,
)
from gripcourse.errors import GripcourseError
from gripcourse.text.shown import first_of, one_line
from gripcourse.text.words import LANGUAGES, Message, Words, message

# Every command imports what it needs itself, as in `cli`.
# ruff: noqa: PLC0415

_NAMED: Final = 20  # files that were not copied

app = typer.Typer()


@app.command(cls=SpokenCommand)
def validate(
    *,
    prove: Annotated[
        bool, typer.Option("--prove", help="Prove the formulas too; takes minutes.")
    ] = False,
    count: Annotated[
        int,
        typer.Option(
            "--count", min=1, max=1000, help="Variants to prove with, for each choice of options."
        ),
    ] = 4,
    scheme: SchemeOption = None,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Check a whole course and list all its problems at once."""
    from gripcourse.cli.problems import said_of
    from gripcourse.usecases.authoring.validate import scheme_notes, scheme_problems, validated

    words, root = words_for(language), course_folder(course)
    if scheme is not None:
        problems = scheme_problems(root, scheme)
        notes = [] if problems else scheme_notes(root, scheme)
    else:
        found = validated(root, thorough=prove, processes=PROCESSORS)
        problems, notes = found.problems, list(found.notes)
        if problems and not found.computed:
            late = message("What depends on the following is checked once that is corrected:")
            typer.echo(words.say(late), err=True)
    if problems:
        raise GripcourseError(problems)
    confirm(
        words.say(
            message("The course is valid.")
            if scheme is None
            else message("The scheme {scheme} is valid.", scheme=scheme)
        )
    )
    if notes:
        confirm(words.say(message("Notes, though nothing is wrong:")))
        for said in said_of(notes, words):
            confirm(said)
    if prove:
        _prove(root, count, scheme, words)


def _prove(root: Path, count: int, scheme: str | None, words: Words) -> None:
    """Print a line for each proof as soon as it ended, and what they come to."""
    from gripcourse.cli.proof_text import open_text, result_line, summary_text
    from gripcourse.course.load import load_course
    from gripcourse.policy.load import load_policy
    from gripcourse.proofs.model import Verdict
    from gripcourse.proofs.prove import prove

    loaded = load_course(root)
    results = []
    for result in prove(loaded, load_policy(loaded), count=count, scheme=scheme):
        typer.echo(result_line(result, words))
        results.append(result)
    if said := open_text(results, words):
        typer.echo(said)
    typer.echo(summary_text(results, words))
    failed = [
        one for result in results if result.verdict is Verdict.FAILS for one in result.problems
    ]
    if failed:
        raise GripcourseError(failed)
    is_open = any(one.verdict is Verdict.OPEN for one in results)
    raise typer.Exit(NEEDS_PERSON if is_open else DONE)


@app.command(cls=SpokenCommand)
def init(
    folder: Annotated[Path, typer.Argument(metavar="folder", help="New folder of the course.")],
    *,
    source: Annotated[
        Path | None,
        typer.Option(
            "--from", help="Course to copy, without its students; default: the one shipped."
        ),
    ] = None,
    empty: Annotated[
        bool, typer.Option("--empty", help="A small course to begin with, of any subject.")
    ] = False,
    templates: Annotated[
        bool,
        typer.Option("--templates", help="Copy the program's templates too, to change the look."),
    ] = False,
    language: LanguageOption = None,
) -> None:
    """Make a course of your own, with a key of its own: a copy of another, or a small one."""
    import secrets

    from gripcourse.usecases.authoring.init import empty_course, init_course

    words = words_for(language)
    if empty and source is not None:
        raise cli_text.misuse(message("--from and --empty exclude each other."))
    if empty:
        if templates:
            raise cli_text.misuse(message("--templates and --empty exclude each other."))
        empty_course(folder, secrets.token_bytes(32), words)
        left: tuple[str, ...] = ()
    else:
        left = init_course(folder, secrets.token_bytes(32), words, source, with_templates=templates)
    confirm(words.say(message("The course is in {folder}.", folder=str(folder))))
    if left:
        said = message(
            "Not copied, as it belongs to the other term or to no course: {names}.",
            names=first_of([one_line(name) for name in left], _NAMED),
        )
        confirm(words.say(said))
    if source is not None and main_table(folder).is_file():
        confirm(words.say(_drawn_for_others(folder, source)))


def _drawn_for_others(folder: Path, source: Path) -> Message:
    """Say that a copied table holds what the students of another term may know."""
    return message(
        "Its variants are those of {source}. Draw others before you issue them: gripcourse variants"
        " draw --course {folder} --count 30 --seed 1 --out {table} --apart-from {other}",
        source=str(source),
        folder=str(folder),
        table=str(main_table(folder)),
        other=str(main_table(source)),
    )


@app.command(cls=SpokenCommand)
def renew(
    *,
    apply: Annotated[
        bool, typer.Option("--apply", help="Rewrite them, with a copy of each file beside it.")
    ] = False,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Show which names in a course of an earlier version have changed; rewrite them if asked."""
    from gripcourse.usecases.authoring.renew import renewals, write_renewals

    words, root = words_for(language), course_folder(course)
    found = renewals(root)
    for file in found.files:
        for one in file.renamings:
            now = one.former.now or words.say(message("no longer needed"))
            typer.echo(f"{file.file}: {one.was} → {now}")
    for name in found.by_hand:
        said = message(
            "{file}: this cannot be written word by word; rename by hand what `gripcourse validate`"
            " names.",
            file=name,
        )
        typer.echo(words.say(said), err=True)
    if not found.files:
        if not found.by_hand:
            confirm(words.say(message("No name in the course has changed.")))
    elif apply:
        for path in write_renewals(root, found.files):
            confirm(words.say(message("Kept as it was: {file}", file=str(path))))
        confirm(words.say(message("What is left to do, `gripcourse validate` tells.")))
    else:
        confirm(words.say(message("Nothing was changed. With --apply it is.")))


@app.command(cls=SpokenCommand)
def doctor(language: LanguageOption = None) -> None:
    """Check this machine and say how to get what it lacks."""
    from gripcourse.machine.doctor import checks

    words = words_for(language)
    found = checks(Path.cwd())
    typer.echo(cli_text.doctor_text(found, words))
    raise typer.Exit(WRONG_USE if any(one.required and not one.ok for one in found) else DONE)


@app.command(cls=SpokenCommand)
def atlas(
    name: Annotated[
        str, typer.Argument(metavar="atlas", help="A file of variants/atlas, without .toml.")
    ],
    *,
    out: OutOption = Path("atlas"),
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Reproduce the figures and cases of a source from the course's own formulas."""
    from gripcourse.course.load import load_course
    from gripcourse.usecases.authoring.atlas import draw_atlas

    loaded = load_course(course_folder(course))
    words = Words(document_language(language, loaded.language))
    for path in draw_atlas(loaded, name, out, words):
        confirm(str(path))


@app.command(cls=SpokenCommand)
def schema(*, out: OutOption = Path("schema")) -> None:
    """Write the keys of a course's files and of results: JSON Schema, and a page to read."""
    from gripcourse.api.schema import schemas
    from gripcourse.usecases.authoring.schema import write_schemas

    for path in write_schemas(out, schemas()):
        typer.echo(str(path))


@app.command(cls=SpokenCommand)
def reference(
    *,
    out: OutOption = Path("reference"),
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Write the formula reference: a page for each scheme, made from the declarations alone."""
    from gripcourse.course.load import load_course
    from gripcourse.usecases.authoring.reference import write_reference

    words = Words(document_language(language, LANGUAGES[0]))
    for path in write_reference(load_course(course_folder(course)), out, words):
        confirm(str(path))
