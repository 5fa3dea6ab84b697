"""The catalogues that a scheme reads, with all their rows."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

from gripcourse.course.columns_read import columns_of_formula
from gripcourse.course.model import Catalogue
from gripcourse.course.quantity import Quantity
from gripcourse.documents.reference.entry import link_to
from gripcourse.documents.reference.model import Link
from gripcourse.documents.reference.occurrence import Content
from gripcourse.text.units import factor, unit_text
from gripcourse.text.words import Words

_FIGURES: Final = 9  # SI and back costs the last digits of a float


@dataclass(frozen=True, slots=True)
class ReferenceTable:
    """A catalogue, ready to print.

    Attributes:
        id: its name in declarations.
        source: with the mark of how its numbers were obtained.
        headings: name and unit of each column.
        rows: numbers as text.
        users: quantities that read it.
    """

    id: str
    source: str
    headings: tuple[tuple[str, str], ...]
    rows: tuple[tuple[str, ...], ...]
    users: tuple[Link, ...]


def tables_of(content: Content, words: Words) -> tuple[ReferenceTable, ...]:
    """Return the catalogues that some declaration of a scheme reads."""
    users: dict[str, list[Link]] = {}
    for one in content.occurrences:
        for name in dict.fromkeys(_catalogues(one.quantity)):
            users.setdefault(name, []).append(link_to(one, content, words.language))
    return tuple(
        _table(catalogue, tuple(users[name]), words)
        for name, catalogue in sorted(content.course.catalogues.items())
        if name in users
    )


def _catalogues(quantity: Quantity) -> Iterator[str]:
    columns = [column for formula in quantity.formulas() for column in columns_of_formula(formula)]
    if quantity.choice is not None:
        columns += [quantity.choice.column, *quantity.choice.also]
    if quantity.read_from:
        columns.append(quantity.read_from)
    yield from (column.partition(".")[0] for column in columns)


def _table(catalogue: Catalogue, users: tuple[Link, ...], words: Words) -> ReferenceTable:
    columns = [
        [
            words.number(float(value) / factor(catalogue.units[name]), _FIGURES)
            for value in catalogue.columns[name]
        ]
        for name in catalogue.units
    ]
    headings = tuple(
        (name, unit_text(unit, words.language)) for name, unit in catalogue.units.items()
    )
    rows = tuple(zip(*columns, strict=True))
    return ReferenceTable(catalogue.id, catalogue.source.of(words.language), headings, rows, users)
