"""Scales: how a share of the points is called, in marks, letters or words."""

import re
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Final

from gripcourse.course.toml_table import Table
from gripcourse.text.amounts import percent_text
from gripcourse.text.words import Texts, Words, message

# A share on the edge of a step is inside, whatever the last bit says.
_SLACK: Final = 1e-9
_ID: Final = re.compile(r"[a-z][a-z0-9_]*")
# Columns of the table of grades: a scale has a column there, too.
_COLUMNS: Final = frozenset(
    (
        *("student", "name", "group", "variant", "score", "max_score", "percent", "open_points"),
        *("slips", "flags", "file", "attempt", "counts", "handed_in", "days_late"),
        *("earned", "earned_percent"),
    )
)


@dataclass(frozen=True, slots=True)
class ScaleStep:
    """A step of a scale: from which percentage of the points on, and what it is called."""

    start: float
    text: Texts


@dataclass(frozen=True, slots=True)
class Scale:
    """A scale of a course.

    Attributes:
        id: its column in the table of grades.
        title: for documents.
        steps: the highest first; none for the plain percentage.
    """

    id: str
    title: Texts
    steps: tuple[ScaleStep, ...]


@dataclass(frozen=True, slots=True)
class CountedPoints:
    """Points of which some may still wait for a person.

    Attributes:
        earned: so far, after what lateness costs.
        possible: all points, with those that wait.
        waiting: points that wait, as far as the student may still earn them.
    """

    earned: float
    possible: float
    waiting: float


def grade_text(scale: Scale, standing: CountedPoints, words: Words) -> str:
    """Call points by a scale: one step; where what waits decides, from the lowest to the highest.

    Returns:
        `B`, `D…B`, or nothing where there are no points at all.
    """
    lowest, highest = _between(scale, standing, words)
    return lowest if lowest == highest else f"{lowest}…{highest}"


def certain_grade(scale: Scale, standing: CountedPoints, words: Words) -> str:
    """Call points by a scale; nothing where points that wait for a person decide."""
    lowest, highest = _between(scale, standing, words)
    return lowest if lowest == highest else ""


def _between(scale: Scale, standing: CountedPoints, words: Words) -> tuple[str, str]:
    if not standing.possible:
        return "", ""
    return (
        _called(scale, standing.earned / standing.possible, words),
        _called(scale, (standing.earned + standing.waiting) / standing.possible, words),
    )


def _called(scale: Scale, share: float, words: Words) -> str:
    if not scale.steps:
        return percent_text(share, words)
    percent = 100 * share + _SLACK
    reached = next((one for one in scale.steps if percent >= one.start), scale.steps[-1])
    return reached.text.of(words.language)


def read_scales(table: Table, sections: Mapping[str, float]) -> tuple[Scale, ...]:
    """Read the scales of a policy, with all their faults; a policy may have none.

    Args:
        table: the policy.
        sections: of the course; their ids are columns of the table of grades.
    """
    tables = table.tables("scale")
    scales = tuple(_scale(one) for one in tables)
    counts = Counter(one.id for one in scales)
    for inner, scale in zip(tables, scales, strict=True):
        if not _ID.fullmatch(scale.id):
            inner.add(
                "id",
                message("'{id}' is no id.", id=scale.id),
                message("Write lower-case Latin letters, digits and underscores, a letter first."),
            )
        elif scale.id in _COLUMNS or scale.id in sections:
            inner.add(
                "id",
                message("'{id}' is a column of the table of grades.", id=scale.id),
                message("Give the scale another name."),
            )
        elif counts[scale.id] > 1:
            inner.add(
                "id",
                message("Two scales have the id '{id}'.", id=scale.id),
                message("Give each scale an id of its own."),
            )
    return scales


def _scale(table: Table) -> Scale:
    table.known_keys()
    steps = [_step(one) for one in table.tables("step")]
    _check_steps(table, steps)
    ordered = sorted(steps, key=lambda one: -one.start)
    return Scale(table.text("id"), table.texts("title"), tuple(ordered))


def _step(table: Table) -> ScaleStep:
    table.known_keys()
    return ScaleStep(table.number("from"), table.texts("text"))


def _check_steps(table: Table, steps: Sequence[ScaleStep]) -> None:
    starts = Counter(one.start for one in steps)
    for start, count in starts.items():
        if count > 1:
            table.add(
                "step",
                message("Two steps begin at {percent} percent.", percent=start),
                message("Let each step begin at another percentage."),
            )
    if steps and min(starts) > 0:
        table.add(
            "step",
            message("Below {percent} percent the scale has no step.", percent=min(starts)),
            message("Let the lowest step begin at 0."),
        )
