"""Reading the folder of a scheme: `scheme.toml` and `worked_example.toml`."""

from collections.abc import Mapping
from pathlib import Path

from gripcourse.course.declare import declare, source
from gripcourse.course.model import (
    Convention,
    Option,
    OptionChoice,
    Quantity,
    Scheme,
    WorkedExample,
)
from gripcourse.course.toml_table import Table, did_you_mean, read_toml
from gripcourse.errors import Problem
from gripcourse.words import message


def read_scheme(
    folder: Path,
    root: Path,
    raw_parts: Mapping[str, Mapping[str, Table]],
    problems: list[Problem],
) -> Scheme | None:
    """Read a scheme; None where its file cannot be read at all."""
    table = read_toml(folder / "scheme.toml", root, problems)
    if table is None:
        return None
    table.known_keys({"id", "parts", "title", "task", "option", "quantity", "override"})
    identifier = table.text("id")
    if identifier != folder.name:
        table.add(
            "id",
            message("The id '{id}' differs from the name of the folder.", id=identifier),
            message("Give both the same name."),
        )
    options = tuple(_option(option) for option in table.tables("option"))
    part_ids = [*table.strings("parts")]
    part_ids += [part for option in options for choice in option.choices for part in choice.parts]
    own = {name: declare(name, one) for name, one in table.named_tables("quantity").items()}
    return Scheme(
        id=folder.name,
        title=table.texts("title"),
        task=table.texts("task"),
        parts=table.strings("parts"),
        options=options,
        quantities={name: quantity for name, quantity in own.items() if quantity is not None},
        overrides=_overrides(table, {part: raw_parts.get(part, {}) for part in part_ids}),
        example=_example(folder / "worked_example.toml", root, problems),
        file=table.file,
    )


def _option(table: Table) -> Option:
    table.known_keys({"id", "title", "choice"})
    choices = tuple(
        OptionChoice(choice.text("id"), choice.texts("title"), choice.strings("parts"))
        for choice in table.tables("choice")
    )
    if not choices:
        table.add("choice", message("This key is missing."), message("Write the choices."))
    return Option(table.text("id"), table.texts("title"), choices)


def _overrides(table: Table, parts: Mapping[str, Mapping[str, Table]]) -> dict[str, Quantity]:
    """Declare again what the scheme changes: its keys over the keys of the shared declaration."""
    declared: dict[str, Quantity] = {}
    for name, changes in table.named_tables("override").items():
        shared = next((part[name] for part in parts.values() if name in part), None)
        if shared is None:
            table.add(
                f"override.{name}",
                message("No part of the scheme declares '{name}'.", name=name),
                did_you_mean(name, {known for part in parts.values() for known in part}),
            )
            continue
        merged = {**shared.values, **changes.values}
        quantity = declare(name, Table(merged, changes.file, changes.key, table.problems))
        if quantity is not None:
            declared[name] = quantity
    return declared


def _example(path: Path, root: Path, problems: list[Problem]) -> WorkedExample | None:
    table = read_toml(path, root, problems)
    if table is None:
        return None
    table.known_keys({"source", "options", "given", *Convention})
    options = table.table("options")
    return WorkedExample(
        source=source(table.required_table("source")),
        options={name: options.text(name) for name in options.values} if options else {},
        given=table.numbers("given"),
        chosen={one: _convention_table(table, one).numbers("chosen", {}) for one in Convention},
        expected={one: _expected(_convention_table(table, one)) for one in Convention},
    )


def _convention_table(table: Table, convention: Convention) -> Table:
    """Return the table of a convention; an example may leave the guide's out."""
    found = table.table(convention)
    return found or Table({}, table.file, convention, table.problems)


def _expected(table: Table) -> dict[str, tuple[float, float]]:
    table.known_keys({"chosen", "expected"})
    values = table.table("expected")
    if values is None:
        return {}
    expected: dict[str, tuple[float, float]] = {}
    for name, value in values.values.items():
        match value:
            case [int() | float() as number, int() | float() as difference] if difference >= 0:
                expected[name] = (float(number), float(difference))
            case _:
                values.add(
                    name,
                    message("The value has the wrong type."),
                    message("Write the value and its tolerated difference: [3900, 0.5]."),
                )
    return expected
