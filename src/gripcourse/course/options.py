"""Options: what a variant chooses. Shared ones stand in a file each, for many schemes."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path

from gripcourse.course.keys import OPTION
from gripcourse.course.model import Option, OptionChoice, Scheme
from gripcourse.course.option_rule import OptionRule
from gripcourse.course.toml_table import Table, read_toml
from gripcourse.errors import Problem
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import message

_ONE_AND_ANOTHER = 2


def read_options(
    folder: Path, root: Path, problems: list[Problem], languages: Sequence[str]
) -> dict[str, Option]:
    """Read the shared options of a course, by the names of their files."""
    found = (
        (path.stem, read_toml(path, root, problems, OPTION, languages))
        for path in sorted(folder.glob("*.toml"))
    )
    return {name: read_option(table) for name, table in found if table is not None}


def scheme_options(table: Table, shared: Mapping[str, Option]) -> tuple[Option, ...] | None:
    """Return the options of a scheme: shared ones by name, then its own; None if one is missing.

    One without choices is as good as missing: no variant could have it, and all that its parts
    declare would be called unknown.
    """
    named = table.strings("options")
    unknown = [name for name in named if name not in shared]
    for name in unknown:
        table.add(
            "options",
            message("There is no shared option '{name}'.", name=name),
            did_you_mean(name, shared),
        )
    own = tuple(read_option(option) for option in table.tables("option"))
    found = (*(shared[name] for name in named if name in shared), *own)
    return found if not unknown and all(one.choices for one in found) else None


def spare_options(
    options: Mapping[str, Option], schemes: Iterable[Scheme], folder: str
) -> Iterator[Problem]:
    """Yield the shared options that no scheme lists: no variant would ever have one.

    Args:
        options: the shared ones, by the names of their files.
        schemes: all of the course.
        folder: of the shared options, in the course.
    """
    listed = [option for scheme in schemes for option in scheme.options]
    for name, option in options.items():
        if not any(option is one for one in listed):
            yield Problem(
                f"{folder}/{name}.toml",
                "",
                message("No scheme lists this option."),
                message("Name it in the options of a scheme, or remove the file."),
            )


def read_option(table: Table) -> Option:
    """Read one option with its choices."""
    table.known_keys()
    choices = tuple(_choice(choice) for choice in table.tables("choice"))
    if not choices and table.values.get("choice", []) == []:
        table.add(
            "choice",
            message("The option has no choices."),
            message("Write at least one [[choice]] with id and title."),
        )
    ids = [choice.id for choice in choices]
    for name in dict.fromkeys(one for one in ids if one and ids.count(one) > 1):
        table.add(
            "choice",
            message("Two choices have the id '{id}'.", id=name),
            message("Give each choice an id of its own."),
        )
    return Option(table.text("id"), table.texts("title"), choices, read_rules(table, "rule"))


def read_rules(table: Table, name: str) -> tuple[OptionRule, ...]:
    """Read the rules among options that a table holds under a key."""
    return tuple(_rule(one) for one in table.tables(name))


def _rule(table: Table) -> OptionRule:
    table.known_keys()
    when, requires = (_choices_by_option(table, name) for name in ("when", "requires"))
    same = table.strings("same")
    if not requires and len(same) < _ONE_AND_ANOTHER:
        table.add(
            "",
            message("The rule asks for nothing."),
            message('Write requires = {{ option = ["choice"] }}, or same = ["one", "other"].'),
        )
    return OptionRule(when, requires, same, table.texts("note"), table.file, table.key)


def _choices_by_option(table: Table, name: str) -> dict[str, tuple[str, ...]]:
    inside = table.table(name)
    return {} if inside is None else {option: inside.strings(option) for option in inside.values}


def _choice(table: Table) -> OptionChoice:
    table.known_keys()
    return OptionChoice(table.text("id"), table.texts("title"), table.strings("parts"))
