"""The position kinematics of a scheme, as its author declares it.

Coordinates are formulas of the drive's coordinate, of quantities and of earlier coordinates. They
serve the proof that a scheme's ratio of efforts is right (virtual work) and its drawing. The
positions at which the drive may stand are the course's (`[position]` in `course.toml`).
"""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from typing import Final

from gripcourse.course.toml_table import Table
from gripcourse.formula.parse import FormulaFault, caret, parse
from gripcourse.formula.tree import Formula
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.units import known as known_unit
from gripcourse.text.words import Texts, message

KINEMATICS_KEYS: Final = (
    "drive",
    "unit",
    "coordinate",
    "at",
    "output",
    "outputs",
    "direction",
    "ratio",
    "state",
    "lossless",
    "point",
)
COORDINATE_KEYS: Final = ("unit", "formula")
POSITION_KEYS: Final = ("title", "line")


class Direction(StrEnum):
    """How the output's coordinate changes while the drive's grows."""

    GROWS = "grows"
    FALLS = "falls"


class PositionLine(StrEnum):
    """How a diagram shows a position."""

    NONE = "none"
    THICK = "thick"
    THIN = "thin"


@dataclass(frozen=True, slots=True)
class JointPosition:
    """A position of the drive that schemes of a course have: its title, and how it is drawn."""

    id: str
    title: Texts
    line: PositionLine


@dataclass(frozen=True, slots=True)
class Coordinate:
    """A length or an angle that depends on the drive's coordinate."""

    id: str
    unit: str
    formula: Formula


@dataclass(frozen=True, slots=True)
class Kinematics:
    """How the links of a scheme move.

    Attributes:
        drive: name of the drive's coordinate in the formulas: the path of a rod or the angle of a
            shaft, growing while it works.
        unit: its declared unit.
        coordinates: in the order in which they are computed.
        at: the drive's coordinate at each position that the scheme has, one at least.
        output: id of the coordinate that the drive moves against the load; empty where the scheme
            declares no ratio.
        outputs: how many outputs the drive moves alike.
        direction: of the output while the drive's coordinate grows.
        ratio: id of the quantity that is the drive's effort over the effort at one output, for
            each position at which the scheme declares one.
        state: for each such position, the quantities that describe it and the coordinates that
            give them at any position of the drive.
        lossless: quantities to be set so that the ratio holds no friction, in declared units.
        points: joints, by name, as pairs of coordinates (x along the axis).
        file: the file that declares it, for messages.
    """

    drive: str
    unit: str
    coordinates: tuple[Coordinate, ...]
    at: Mapping[str, Formula]
    output: str
    outputs: Formula
    direction: Direction
    ratio: Mapping[str, str]
    state: Mapping[str, Mapping[str, str]]
    lossless: Mapping[str, float]
    points: Mapping[str, tuple[str, str]]
    file: str


def read_kinematics(table: Table) -> Kinematics:
    """Read the `[kinematics]` table of a scheme or of a part."""
    table.known_keys(KINEMATICS_KEYS)
    states = table.named_tables("state")
    ratio = table.table("ratio")
    points = table.table("point")
    at = table.required_table("at")
    if table.has("at") and not at.values:
        table.add("at", message("The kinematics has no position."), message("Name one at least."))
    return Kinematics(
        drive=table.text("drive"),
        unit=_unit(table),
        coordinates=tuple(
            _coordinate(name, one) for name, one in table.named_tables("coordinate").items()
        ),
        at={position: _formula(at, position) for position in at.values},
        output=table.text("output", None if table.has("ratio") else ""),
        outputs=_formula(table, "outputs", "1"),
        direction=_direction(table),
        ratio={name: ratio.text(name) for name in ratio.values} if ratio else {},
        state={
            position: {name: one.text(name) for name in one.values}
            for position, one in states.items()
        },
        lossless=table.numbers("lossless", {}),
        points={name: _point(points, name) for name in points.values} if points else {},
        file=table.file,
    )


def _coordinate(name: str, table: Table) -> Coordinate:
    table.known_keys(COORDINATE_KEYS)
    return Coordinate(name, _unit(table), _formula(table, "formula"))


def read_positions(table: Table) -> Mapping[str, JointPosition]:
    """Read the `[position]` tables of a course; a course whose schemes do not move has none."""
    found = {name: _position(name, one) for name, one in table.named_tables("position").items()}
    thick = [name for name, one in found.items() if one.line is PositionLine.THICK]
    for name in thick[1:]:
        table.add(
            f"position.{name}.line",
            message("Two positions are drawn in thick lines: {names}.", names=", ".join(thick)),
            message("Leave one of them: 'thin' or 'none' for the other."),
        )
    return found


def _position(name: str, table: Table) -> JointPosition:
    table.known_keys(POSITION_KEYS)
    written = table.text("line", PositionLine.NONE)
    if written not in list(PositionLine):
        what = message("'{word}' means nothing here.", word=written)
        table.add("line", what, did_you_mean(written, list(PositionLine)))
        written = PositionLine.NONE
    return JointPosition(name, table.texts("title"), PositionLine(written))


def _direction(table: Table) -> Direction:
    written = table.text("direction", Direction.GROWS)
    if written in list(Direction):
        return Direction(written)
    what = message("'{word}' means nothing here.", word=written)
    table.add("direction", what, did_you_mean(written, list(Direction)))
    return Direction.GROWS


def _formula(table: Table, name: str, default: str | None = None) -> Formula:
    text = table.text(name, default)
    try:
        return Formula(text, parse(text), {})
    except FormulaFault as fault:
        table.add(name, fault.what, message("Mend the formula."), caret(text, fault.span))
        return Formula("0", parse("0"), {})


def _point(points: Table, name: str) -> tuple[str, str]:
    match points.values[name]:
        case [str() as along, str() as across]:
            return (along, across)
    points.add(
        name,
        message("The value has the wrong type."),
        message("Write the names of two coordinates: ['pin_x', 'pin_y']."),
    )
    return ("", "")


def _unit(table: Table) -> str:
    unit = table.text("unit")
    if known_unit(unit):
        return unit
    table.add(
        "unit",
        message("The unit '{unit}' is not known.", unit=unit),
        message("Write it as in units.csv of the package, for example 'N*m'."),
    )
    return ""
