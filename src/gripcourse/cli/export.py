"""`gripcourse export`: parse, one call, print, exit code. No logic."""

from collections.abc import Iterable
from pathlib import Path
from typing import Annotated

import typer

from gripcourse.cli.help import SpokenCommand, command_group
from gripcourse.cli.loudness import confirm
from gripcourse.cli.options import (
    DONE,
    NEEDS_PERSON,
    CourseOption,
    GradebookOption,
    LanguageOption,
    OutOption,
    TableOption,
    course_folder,
    document_language,
    gradebook_place,
    main_table,
    words_for,
)
from gripcourse.text.words import Message, Words, counted, message

# Every command imports what it needs itself: the tables cost half a second.
# ruff: noqa: PLC0415

app = command_group("Take grades to a learning platform, a table or people; nothing is sent.")

GradesOption = Annotated[
    Path, typer.Option("--grades", help="What grading wrote; its reports lie beside it.")
]
_GRADES = Path("graded") / "grades.json"


@app.command("moodle", cls=SpokenCommand)
def moodle(
    *,
    worksheet: Annotated[
        Path, typer.Option("--worksheet", help="Grading worksheet, as Moodle exports it.")
    ],
    out: OutOption,
    grades: GradesOption = _GRADES,
    feedback: Annotated[
        Path | None, typer.Option("--feedback", help="Zip to write, with the students' reports.")
    ] = None,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Fill the grades into Moodle's grading worksheet, and pack the reports for Moodle."""
    from gripcourse.exports.platforms.moodle_worksheet import to_choose
    from gripcourse.usecases.publishing.exporting import moodle_files, open_results

    words = words_for(language)
    results = open_results(course_folder(course), grades)
    filled, lacking = moodle_files(results, worksheet, out, feedback)
    said = counted(
        "{count} row of {file} has a grade; Moodle should say that it updated {updates}.",
        "{count} rows of {file} have a grade; Moodle should say that it updated {updates}.",
        filled.filled,
        updates=filled.updates,
        file=str(out),
    )
    confirm(words.say(said))
    choice = to_choose(filled.worksheet)
    if choice is not None:
        confirm(words.say(choice))
    if feedback is not None:
        said = message("Upload the worksheet first, then {file}.", file=str(feedback))
        confirm(words.say(said))
    _leave((*results.notes, *filled.notes, *lacking), words)


@app.command("moodle-xml", cls=SpokenCommand)
def moodle_xml(
    variants: Annotated[
        list[str] | None,
        typer.Argument(metavar="variant", help="Variants of the table; default: all."),
    ] = None,
    *,
    out: OutOption = Path("questions.xml"),
    table: TableOption = None,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Write variants as questions that Moodle imports, for a self-test; with the answers."""
    from gripcourse.course.load import load_course
    from gripcourse.usecases.publishing.exporting import moodle_questions

    loaded = load_course(course_folder(course))
    document = Words(document_language(language, loaded.language))
    place = table or main_table(loaded.root)
    count = moodle_questions(loaded, place, variants or (), out, document)
    said = message("Questions written to {file}: {count}.", count=count, file=str(out))
    confirm(words_for(language).say(said))


@app.command("canvas", cls=SpokenCommand)
def canvas(
    *,
    gradebook: Annotated[Path, typer.Option("--table", help="Gradebook, as Canvas exports it.")],
    out: OutOption,
    assignment: Annotated[
        str, typer.Option("--assignment", help="Its title or number; default: the only one.")
    ] = "",
    grades: GradesOption = _GRADES,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Write the table of points that Canvas imports, made from its own export."""
    from gripcourse.usecases.publishing.exporting import canvas_file, open_results

    words = words_for(language)
    results = open_results(course_folder(course), grades)
    filled = canvas_file(results, gradebook, assignment, out)
    said = counted("{count} row of {file} has points.", "{count} rows of {file} have points.",
                   filled.filled, file=str(out))  # fmt: skip
    confirm(words.say(said))
    _leave((*results.notes, *filled.notes), words)


@app.command("gradescope", cls=SpokenCommand)
def gradescope(
    *,
    out: OutOption = Path("results.json"),
    student: Annotated[
        str, typer.Option("--student", help="Whose; default: the only one that was graded.")
    ] = "",
    published: Annotated[
        bool, typer.Option("--published", help="Students see it at once.")
    ] = False,
    grades: GradesOption = _GRADES,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Write the results of one submission as Gradescope reads them: a test for each section."""
    from gripcourse.usecases.publishing.exporting import gradescope_file, open_results

    words = words_for(language)
    results = open_results(course_folder(course), grades)
    gradescope_file(results, student, out, published=published)
    confirm(str(out))
    _leave((), words)


@app.command("table", cls=SpokenCommand)
def table(
    *,
    out: Annotated[Path, typer.Option("--out", help="A .xlsx file, or a folder for CSV files.")],
    grades: GradesOption = _GRADES,
    gradebook: GradebookOption = None,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Write results by student, section and quantity, and what they say about the assignment."""
    from gripcourse.usecases.publishing.exporting import open_results, table_files

    words = words_for(language)
    root = course_folder(course)
    place, results = gradebook_place(gradebook, root), open_results(root, grades)
    for path in table_files(results, out, place):
        confirm(str(path))
    if results.outdated:
        _leave(results.outdated, words)


@app.command("outbox", cls=SpokenCommand)
def outbox(
    *,
    out: OutOption = Path("outbox"),
    grades: GradesOption = _GRADES,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Write a folder for each student with a text and the report; you send them yourself."""
    from gripcourse.usecases.publishing.exporting import open_results
    from gripcourse.usecases.publishing.outbox import outbox_folders

    words = words_for(language)
    results = open_results(course_folder(course), grades)
    folders, notes = outbox_folders(results, out)
    said = counted("{count} folder is in {folder}; nothing was sent.",
                   "{count} folders are in {folder}; nothing was sent.",
                   len(folders), folder=str(out))  # fmt: skip
    confirm(words.say(said))
    _leave((*results.notes, *notes), words)


def _leave(notes: Iterable[Message], words: Words) -> None:
    """Print what a person should look at, and leave with the exit code for it."""
    said = [words.say(note) for note in notes]
    for line in said:
        typer.echo(line)
    raise typer.Exit(NEEDS_PERSON if said else DONE)
