"""The command `trace`: whose variant do these numbers come from?"""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gripcourse.cli import text as cli_text
from gripcourse.cli.help import SpokenCommand
from gripcourse.cli.options import (
    CourseOption,
    LanguageOption,
    TableOption,
    course_folder,
    main_table,
    words_for,
)
from gripcourse.cli.pairs import read_pairs
from gripcourse.cli.table_layout import table_text
from gripcourse.text.words import Words, message

if TYPE_CHECKING:
    from collections.abc import Mapping

    from gripcourse.course.quantity import Quantity
    from gripcourse.likeness.trace import Match
    from gripcourse.usecases.issuing.trace import Traced

# The command imports what it needs itself: numpy and the course cost up to half a second.
# ruff: noqa: PLC0415

SHOWN = 10  # variants
_MANY = 1e6  # odds to one; more says nothing more


app = typer.Typer()


@app.command(cls=SpokenCommand)
def trace(
    numbers: Annotated[
        list[str] | None,
        typer.Argument(metavar="number", help="Numbers as typed: 1843 22,6 '0,37 kN'."),
    ] = None,
    *,
    quantities: Annotated[
        list[str] | None,
        typer.Option(
            "--quantity",
            metavar="name=value",
            help="A number whose meaning is known: mass=60.",
        ),
    ] = None,
    table: TableOption = None,
    issued: Annotated[
        Path | None,
        typer.Option(
            "--issued", help="Course folder whose register is searched; default: the course's own."
        ),
    ] = None,
    course: CourseOption = None,
    language: LanguageOption = None,
) -> None:
    """Rank the variants and students that numbers may come from, with the odds; no verdict."""
    from gripcourse.course.load import load_course
    from gripcourse.issuing.store import read_register
    from gripcourse.usecases.issuing import trace as command

    if table is not None and issued is not None:
        raise cli_text.misuse(message("--table and --issued exclude each other."))
    shape = message("Write it as in mass=60 or force=2,26 kN.")
    named = read_pairs("--quantity", quantities or (), shape)
    words = words_for(language)
    loaded = load_course(course_folder(course))
    root = issued or loaded.root
    if table is None and (issued is not None or read_register(root, loaded.id).entries):
        sought = command.in_register(root, loaded)
    else:
        sought = command.in_table(table or main_table(loaded.root), loaded)
    traced = command.trace(numbers or (), named, loaded, sought)
    typer.echo(trace_text(traced, words))


def trace_text(traced: "Traced", words: Words) -> str:
    """Return the likeliest variants with what each number would be there."""
    if not traced.origins:
        return words.say(message("None of the variants has any of these numbers."))
    rows = []
    for origin in traced.origins[:SHOWN]:
        variant = traced.variants[origin.owner]
        students = ", ".join(traced.students.get(origin.owner, ()))
        named = " ".join(filter(None, (origin.owner, students)))
        found = "; ".join(
            _meaning(one, traced.declared[origin.owner], words) for one in origin.matches
        )
        rows.append((_odds(origin.odds, words), named, variant.scheme, found))
    heads = (message("odds"), message("variant"), message("scheme"), message("what it would be"))
    lines = [table_text([words.say(head) for head in heads], rows, right={0})]
    if traced.origins[0].odds < 1:
        lines.append(words.say(message("No variant explains the numbers better than chance.")))
    lines += map(words.say, traced.notes)
    return "\n".join(lines)


def _meaning(match: "Match", declared: "Mapping[str, Quantity]", words: Words) -> str:
    if not match.quantity:
        return f"{match.text} = —"
    from gripcourse.text.units import unit_text

    quantity = declared[match.quantity]
    value = words.number(match.value)
    unit = unit_text(quantity.unit, words.language)
    symbol = quantity.symbol.of(words.language)
    return " ".join(filter(None, (match.text, "=", symbol, f"({match.quantity})", value, unit)))


def _odds(odds: float, words: Words) -> str:
    if odds >= _MANY:
        return f"> {words.number(_MANY)} : 1"
    return f"{words.number(odds, 2)} : 1" if odds >= 1 else f"1 : {words.number(1 / odds, 2)}"
