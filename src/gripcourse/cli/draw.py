"""The command that draws: parse, one call, print."""

from pathlib import Path
from typing import Annotated

import typer

from gripcourse.cli.help import SpokenCommand
from gripcourse.cli.loudness import confirm
from gripcourse.cli.options import (
    CourseOption,
    LanguageOption,
    OutOption,
    TableOption,
    course_folder,
    document_language,
    main_table,
)
from gripcourse.text.words import Words

# The command imports what it needs itself: numpy and ezdxf cost half a second.
# ruff: noqa: PLC0415


app = typer.Typer()


@app.command(cls=SpokenCommand)
def draw(
    variant: Annotated[str, typer.Argument(metavar="variant", help="Variant of the table.")],
    *,
    student: Annotated[str, typer.Option("--student-name", help="For the title block.")] = "",
    out: OutOption = Path("drawings"),
    table: TableOption = None,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Draw the general view of a variant, as DXF for a CAD program and as SVG."""
    from gripcourse.usecases.solving.draw import write_general_view
    from gripcourse.usecases.solving.solve import solve_from_table
    from gripcourse.variants.kept_table import load_with_table

    root = course_folder(course)
    loaded, variants = load_with_table(root, table or main_table(root))
    solved = solve_from_table(loaded, variants, variant, None)
    words = Words(document_language(language, loaded.language))
    for path in write_general_view(solved, out, student, words):
        confirm(str(path))
