"""Loading the rubrics of a head of course from `grader/rubric/*.toml`."""

import math
import re
from collections import Counter
from pathlib import Path

from gripcourse.course.model import Course
from gripcourse.course.toml_table import Table, read_toml
from gripcourse.errors import Problem
from gripcourse.policy.keys import RUBRIC
from gripcourse.policy.rubric import Level, Rubric, RubricLine
from gripcourse.text.words import message

TABLE_COLUMNS = ("student", "quantity", "points", "credit", "comment", "override")
"""Columns of a table of marks that are no lines: no line may be called so."""

_ID = re.compile(r"[a-z][a-z0-9_]*")
_SAME = 1e-9  # shares that are written with a few decimals add up to 1 but for the last bits


def rubric_folder(root: Path) -> Path:
    """Where a course keeps its rubrics."""
    return root / "grader" / "rubric"


def read_rubrics(course: Course, problems: list[Problem]) -> dict[str, Rubric]:
    """Read all rubrics of a course; what is wrong with them is added to the problems.

    Args:
        course: in whose languages they are written.
        problems: what was found; each with file and key.

    Returns:
        The rubrics by id, the ones with faults included.
    """
    rubrics: dict[str, Rubric] = {}
    for path in sorted(rubric_folder(course.root).glob("*.toml")):
        table = read_toml(path, course.root, problems, RUBRIC, course.languages)
        if table is not None:
            rubrics[path.stem] = _rubric(path.stem, table)
    return rubrics


def _rubric(name: str, table: Table) -> Rubric:
    table.known_keys()
    title = table.texts("title")
    tables = table.tables("line")
    lines = tuple(_line(one) for one in tables)
    if not tables and _is_absent(table):
        table.add(
            "line",
            message("The rubric has no lines."),
            message("Write at least one [[line]] with id, share and text."),
        )
    _check_names(tables, lines)
    total = sum(line.share for line in lines)
    if lines and not math.isnan(total) and not math.isclose(total, 1.0, abs_tol=_SAME):
        table.add(
            "line",
            message("The shares of the lines add up to {sum}, not to 1.", sum=float(total)),
            message("Change a share: together the lines are the whole item."),
        )
    return Rubric(name, title, lines)


def _is_absent(table: Table) -> bool:
    """Tell whether there are no lines at all; a value of another type is its own problem."""
    return table.values.get("line", []) == []


def _line(table: Table) -> RubricLine:
    table.known_keys()
    share = table.number("share")
    if share <= 0 or share > 1:
        table.add(
            "share",
            message("The share is {value}.", value=share),
            message("Write a number above 0, at most 1."),
        )
    levels = tuple(_level(one) for one in table.tables("level"))
    _check_levels(table, levels)
    return RubricLine(table.text("id"), share, table.texts("text"), levels)


def _level(table: Table) -> Level:
    table.known_keys()
    credit = table.number("credit")
    if credit < 0 or credit > 1:
        table.add(
            "credit",
            message("The share is {value}.", value=credit),
            message("Write a number from 0 to 1."),
        )
    return Level(credit, table.texts("text"))


def _check_levels(table: Table, levels: tuple[Level, ...]) -> None:
    credits_given = [level.credit for level in levels]
    if levels and max(credits_given) < 1:
        table.add(
            "level",
            message("No level earns the whole line."),
            message("Add a level with credit 1, or make the share of the line smaller."),
        )
    for credit, count in Counter(credits_given).items():
        if count > 1:
            table.add(
                "level",
                message("Two levels have the credit {credit}.", credit=credit),
                message("Give each level another one."),
            )


def _check_names(tables: tuple[Table, ...], lines: tuple[RubricLine, ...]) -> None:
    seen: set[str] = set()
    for table, line in zip(tables, lines, strict=True):
        if not isinstance(table.values.get("id"), str):
            continue  # that is told already
        if not _ID.fullmatch(line.id):
            table.add(
                "id",
                message("'{id}' is no id.", id=line.id),
                message("Write lower-case Latin letters, digits and underscores, a letter first."),
            )
        elif line.id in TABLE_COLUMNS:
            table.add(
                "id",
                message("'{id}' is a column of the table of marks.", id=line.id),
                message("Give the line another name."),
            )
        elif line.id in seen:
            table.add(
                "id",
                message("Two lines have the id '{id}'.", id=line.id),
                message("Give each line an id of its own."),
            )
        seen.add(line.id)
