"""Rubrics: by which lines a person marks an item that no formula can judge."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Final

from gripcourse.text.words import Texts

MOST_TOGETHER: Final = 4
"""Texts of a line in one heading; of more there are too many sets to know them all again."""


@dataclass(frozen=True, slots=True)
class Level:
    """A step on which a line may stand, where not every share of it makes sense.

    Attributes:
        credit: share of the line's points that it earns, 0…1.
        text: when it is given.
    """

    credit: float
    text: Texts


@dataclass(frozen=True, slots=True)
class RubricLine:
    """One thing that a person looks at.

    Attributes:
        id: what it is called on the command line and in tables of marks.
        share: of the item's points, 0…1.
        text: what is asked for.
        levels: the only credits that may be given; empty where any from 0 to 1 may.
    """

    id: str
    share: float
    text: Texts
    levels: tuple[Level, ...]


@dataclass(frozen=True, slots=True)
class Rubric:
    """The lines of one kind of item; their shares add up to 1.

    Attributes:
        id: name of its file, by which a manual quantity names it.
        title: what is marked.
        lines: in the order in which they are looked at.
    """

    id: str
    title: Texts
    lines: tuple[RubricLine, ...]

    @property
    def by_id(self) -> Mapping[str, RubricLine]:
        """Return the lines by id."""
        return {line.id: line for line in self.lines}

    def credit(self, credits_by_line: Mapping[str, float]) -> float:
        """Return the share of the item's points that its lines earn together, 0…1.

        Args:
            credits_by_line: share of its own points that each line earns, 0…1, for all lines.

        Raises:
            KeyError: a line has no credit.
        """
        return sum(line.share * credits_by_line[line.id] for line in self.lines)


def lines_of(rubrics: Iterable[Rubric]) -> dict[str, list[Texts]]:
    """Return the ids of all lines of rubrics, each with the texts that it has in them."""
    found: dict[str, list[Texts]] = {}
    for rubric in rubrics:
        for line in rubric.lines:
            found.setdefault(line.id, []).append(line.text)
    return found


def column_heading(texts: Iterable[str]) -> str:
    """Return the heading of one column for a line that rubrics word otherwise, each its own way."""
    return " / ".join(sorted(set(texts)))
