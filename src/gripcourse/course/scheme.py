"""Reading the folder of a scheme: `scheme.toml`, `worked_example.toml` and `diagram.toml`."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from gripcourse.course.declare import declare, source
from gripcourse.course.diagram import Element, read_diagram
from gripcourse.course.keys import EXAMPLE, SCHEME
from gripcourse.course.kinematics import Kinematics, read_kinematics
from gripcourse.course.model import Option, Scheme, WorkedExample
from gripcourse.course.options import read_rules, scheme_options
from gripcourse.course.override import RawPart, read_optional_overrides, read_overrides
from gripcourse.course.quantity import Convention
from gripcourse.course.toml_table import Table, read_toml
from gripcourse.course.view import View
from gripcourse.course.view_keys import VIEW
from gripcourse.course.view_read import read_view
from gripcourse.errors import Problem
from gripcourse.text.words import message


@dataclass(frozen=True, slots=True)
class Shared:
    """What schemes take from files that they share, by the names of the files.

    Attributes:
        parts: declarations of quantities, as they are written.
        options: with their choices.
        drawings, symbols: parts of general views and of diagrams; None for what cannot be read.
        languages: that texts are written in.
    """

    parts: Mapping[str, RawPart]
    options: Mapping[str, Option]
    drawings: Mapping[str, View | None]
    symbols: Mapping[str, tuple[Element, ...] | None]
    languages: Sequence[str]


def read_scheme(folder: Path, root: Path, shared: Shared, problems: list[Problem]) -> Scheme | None:
    """Read a scheme; None where its file cannot be read at all, or names an unknown option."""
    table = read_toml(folder / "scheme.toml", root, problems, SCHEME, shared.languages)
    if table is None:
        return None
    table.known_keys()
    identifier = table.text("id")
    if identifier != folder.name:
        table.add(
            "id",
            message("The id '{id}' differs from the name of the folder.", id=identifier),
            message("Give both the same name."),
        )
    all_options = scheme_options(table, shared.options)
    options = all_options or ()
    optional = [part for option in options for choice in option.choices for part in choice.parts]
    part_ids = [*table.strings("parts"), *optional]
    scheme = Scheme(
        id=folder.name,
        title=table.texts("title"),
        task=table.texts("task"),
        parts=table.strings("parts"),
        options=options,
        own_rules=read_rules(table, "option_rule"),
        quantities={
            one.id: one
            for one in (declare(*each) for each in table.named_tables("quantity").items())
        },
        overrides=read_overrides(table, part_ids, shared.parts, complete=all_options is not None),
        optional_overrides=read_optional_overrides(table, optional, shared.parts),
        kinematics=_motion(table, optional, shared.parts),
        diagram=read_diagram(folder, root, shared.symbols, problems),
        view=_view(folder / "drawing.toml", root, shared, problems),
        example=_example(folder / "worked_example.toml", root, shared.languages, problems),
        file=table.file,
    )
    return None if all_options is None else scheme


def _view(path: Path, root: Path, shared: Shared, problems: list[Problem]) -> View | None:
    """Read the general view of a scheme; a scheme may do without."""
    if not path.exists():
        return None
    table = read_toml(path, root, problems, VIEW, shared.languages)
    return None if table is None else read_view(table, shared.drawings)


def _motion(
    table: Table, optional: Sequence[str], raw_parts: Mapping[str, RawPart]
) -> Kinematics | None:
    """Read how the links move: the scheme says so itself, or one of its fixed parts does."""
    own = table.table("kinematics")
    fixed = [raw_parts[part] for part in table.strings("parts") if part in raw_parts]
    found = [part.kinematics for part in fixed if part.kinematics is not None]
    if own is not None:
        found.append(read_kinematics(own))
    for _ in found[1:]:
        table.add(
            "kinematics",
            message("'{name}' is declared more than once.", name="kinematics"),
            message("It stands in {file} too: keep one.", file=found[0].file),
        )
    for part in dict.fromkeys(optional):
        if part in raw_parts and raw_parts[part].kinematics is not None:
            table.add(
                "options",
                message(
                    "An option brings the part '{part}', which says how links move.", part=part
                ),
                message("Name it in 'parts': only a fixed part may hold kinematics."),
            )
    return found[0] if found else None


def _example(
    path: Path, root: Path, languages: Sequence[str], problems: list[Problem]
) -> WorkedExample | None:
    """Read the worked example of a scheme; a scheme may do without."""
    if not path.exists():
        return None
    table = read_toml(path, root, problems, EXAMPLE, languages)
    if table is None:
        return None
    table.known_keys()
    options = table.table("options")
    return WorkedExample(
        source=source(table.required_table("source")),
        options={name: options.text(name) for name in options.values} if options else {},
        given=table.numbers("given", {}),
        chosen={one: _convention_table(table, one).numbers("chosen", {}) for one in Convention},
        expected={one: _expected(_convention_table(table, one)) for one in Convention},
    )


def _convention_table(table: Table, convention: Convention) -> Table:
    """Return the table of a convention; an example may leave one out."""
    found = table.table(convention)
    return found or replace(table, values={}, key=convention, shape=None)


def _expected(table: Table) -> dict[str, tuple[float, float]]:
    table.known_keys()
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
