"""Reading the folder of a scheme: `scheme.toml` and `worked_example.toml`."""

from collections.abc import Mapping, Sequence
from pathlib import Path

from gripcourse.course.declare import declare, source
from gripcourse.course.kinematics import read_kinematics
from gripcourse.course.model import (
    Convention,
    Option,
    Quantity,
    Scheme,
    WorkedExample,
)
from gripcourse.course.options import scheme_options
from gripcourse.course.toml_table import Table, did_you_mean, read_toml
from gripcourse.course.view import View
from gripcourse.course.view_read import read_view
from gripcourse.errors import Problem
from gripcourse.words import message


def read_scheme(
    folder: Path,
    root: Path,
    raw_parts: Mapping[str, Mapping[str, Table]],
    shared: Mapping[str, Option],
    drawings: Mapping[str, View | None],
    problems: list[Problem],
) -> Scheme | None:
    """Read a scheme; None where its file cannot be read at all, or names an unknown option."""
    table = read_toml(folder / "scheme.toml", root, problems)
    if table is None:
        return None
    table.known_keys(
        {"id", "parts", "options", "title", "task", "option", "quantity", "override", "kinematics"}
    )
    identifier = table.text("id")
    if identifier != folder.name:
        table.add(
            "id",
            message("The id '{id}' differs from the name of the folder.", id=identifier),
            message("Give both the same name."),
        )
    all_options = scheme_options(table, shared)
    options = all_options or ()
    part_ids = [*table.strings("parts")]
    part_ids += [part for option in options for choice in option.choices for part in choice.parts]
    motion = table.table("kinematics")
    scheme = Scheme(
        id=folder.name,
        title=table.texts("title"),
        task=table.texts("task"),
        parts=table.strings("parts"),
        options=options,
        quantities={
            name: declare(name, one) for name, one in table.named_tables("quantity").items()
        },
        overrides=_overrides(table, part_ids, raw_parts, complete=all_options is not None),
        kinematics=None if motion is None else read_kinematics(motion),
        view=_view(folder / "drawing.toml", root, drawings, problems),
        example=_example(folder / "worked_example.toml", root, problems),
        file=table.file,
    )
    return None if all_options is None else scheme


def _view(
    path: Path, root: Path, drawings: Mapping[str, View | None], problems: list[Problem]
) -> View | None:
    """Read the general view of a scheme; a scheme may do without."""
    if not path.exists():
        return None
    table = read_toml(path, root, problems)
    return None if table is None else read_view(table, drawings)


def _overrides(
    table: Table,
    part_ids: Sequence[str],
    raw_parts: Mapping[str, Mapping[str, Table]],
    *,
    complete: bool,
) -> dict[str, Quantity]:
    """Declare again what the scheme changes: its keys over the keys of the shared declaration.

    Unless the parts are complete, because an option could not be read, nothing is called unknown.
    """
    declared: dict[str, Quantity] = {}
    for name, changes in table.named_tables("override").items():
        parts = dict.fromkeys(part_ids)  # several choices may bring the same part
        shared = [raw_parts[part][name] for part in parts if name in raw_parts.get(part, {})]
        if len(shared) == 1:
            declared[name] = _override(name, shared[0], changes)
        elif shared:
            table.add(
                f"override.{name}",
                message("More than one part declares '{name}'.", name=name),
                message("Change it in the parts: a scheme changes what one part declares."),
            )
        elif complete and all(part in raw_parts for part in part_ids):  # else that is reported
            table.add(
                f"override.{name}",
                message("No part of the scheme declares '{name}'.", name=name),
                did_you_mean(name, {one for part in part_ids for one in raw_parts[part]}),
            )
    return declared


def _override(name: str, shared: Table, changes: Table) -> Quantity:
    """Declare a quantity with changes; the faults of the shared declaration are not repeated."""
    merged = Table({**shared.values, **changes.values}, changes.file, changes.key, [])
    declared = declare(name, merged)
    repeated = Table(shared.values, changes.file, changes.key, [])
    declare(name, repeated)
    changes.problems.extend(one for one in merged.problems if one not in repeated.problems)
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
