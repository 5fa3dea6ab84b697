"""The errata of the sources: what is printed, and what is right."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from gripcourse.course.toml_table import Table, read_toml
from gripcourse.errors import Problem
from gripcourse.text.words import Texts


@dataclass(frozen=True, slots=True)
class Erratum:
    """A fault of a source.

    Attributes:
        id: its number in the list, for example `E4`.
        work, equation: where it stands.
        printed, right: what is there, and what should be.
        no_version: why no quantity declares a version as printed; None where one does, or where
            nothing more is to be said than that the course does not compute it.
    """

    id: str
    work: str
    equation: str
    printed: Texts
    right: Texts
    no_version: Texts | None


def read_errata(path: Path, root: Path, problems: list[Problem]) -> Mapping[str, Erratum] | None:
    """Read the list of errata; a course may have none. None where the list cannot be read."""
    if not path.exists():
        return {}
    table = read_toml(path, root, problems)
    if table is None:
        return None
    table.known_keys({"erratum"})
    return {name: _erratum(name, one) for name, one in table.named_tables("erratum").items()}


def _erratum(name: str, table: Table) -> Erratum:
    table.known_keys({"work", "equation", "printed", "right", "no_version"})
    return Erratum(
        name,
        table.text("work"),
        table.text("equation", ""),
        table.texts("printed"),
        table.texts("right"),
        table.texts("no_version") if table.has("no_version") else None,
    )
