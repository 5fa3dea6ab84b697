"""The numbered equations of a work: which of them a course has to account for.

A work lists its equations (`1–56, T1–T11`). Each is cited by a declaration or an erratum, or the
course says why it is not; a citation of a number that the work does not have is a slip of the pen.
"""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Final

from gripcourse.course.shape import Key, by_name, table, text, texts
from gripcourse.course.toml_table import Table
from gripcourse.text.words import Texts

EQUATIONS: Final[Key] = table(
    "The equations of the work that the course accounts for.",
    {
        "numbers": text("Their numbers, like 1–56, T1–T11.", required=True),
        "not_used": by_name(
            "By number: why no declaration cites the equation.", texts("The reason.")
        ),
    },
)
_NUMBER: Final = re.compile(
    r"(?P<kind>[^\W\d]*)(?P<low>\d+)(?:[–-](?P<again>[^\W\d]*)(?P<high>\d+))?"
)


@dataclass(frozen=True, slots=True)
class Equations:
    """The equations of a work.

    Attributes:
        numbers: in the order of the work.
        not_used: why no declaration cites one, by its number.
    """

    numbers: tuple[str, ...] = ()
    not_used: Mapping[str, Texts] = field(default_factory=dict)


def equations_in(citation: str) -> Iterator[str]:
    """Yield the numbers of a citation like `5, 24–27, T7`; other words are none."""
    for written in citation.split(","):
        found = _NUMBER.fullmatch(written.strip())
        if found is None:
            continue
        low, high = int(found["low"]), int(found["high"] or found["low"])
        yield from (f"{found['kind']}{number}" for number in range(low, high + 1))


def read_equations(table: Table | None) -> Equations:
    """Read the equations of a work; a work without a list has none to account for."""
    if table is None:
        return Equations()
    table.known_keys()
    reasons = table.table("not_used")
    if reasons is None:
        return Equations(tuple(equations_in(table.text("numbers"))))
    return Equations(
        tuple(equations_in(table.text("numbers"))),
        {number: reasons.texts(number) for number in reasons.values},
    )
