"""The errata of the sources: what is printed, and what is right."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from gripcourse.course.shape import Shape, by_name, table, text, texts
from gripcourse.course.toml_table import Table, read_toml
from gripcourse.errors import Problem
from gripcourse.text.words import Texts

ERRATA: Final = Shape(
    {
        "erratum": by_name(
            "Faults of sources, by id.",
            table(
                "A fault.",
                {
                    "work": text("Id of the work.", required=True),
                    "equation": text("Where it stands."),
                    "printed": texts("What is printed.", required=True),
                    "right": texts("What is right.", required=True),
                    "no_version": texts("Why no quantity declares a version as printed."),
                },
            ),
        )
    }
)


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


def read_errata(
    path: Path, root: Path, problems: list[Problem], languages: Sequence[str]
) -> Mapping[str, Erratum] | None:
    """Read the list of errata; a course may have none. None where the list cannot be read."""
    if not path.exists():
        return {}
    table = read_toml(path, root, problems, ERRATA, languages)
    if table is None:
        return None
    table.known_keys()
    return {name: _erratum(name, one) for name, one in table.named_tables("erratum").items()}


def _erratum(name: str, table: Table) -> Erratum:
    table.known_keys()
    return Erratum(
        name,
        table.text("work"),
        table.text("equation", ""),
        table.texts("printed"),
        table.texts("right"),
        table.texts("no_version") if table.has("no_version") else None,
    )
