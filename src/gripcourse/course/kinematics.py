"""The position kinematics of a scheme, as its author declares it.

Coordinates are formulas of the drive's coordinate, of quantities and of earlier coordinates. They
serve the proof that a scheme's ratio of efforts is right (virtual work) and its drawing. The
positions at which the drive may stand are the course's (`[position]` in `course.toml`).
"""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from typing import Final

from gripcourse.course import former
from gripcourse.course.shape import Shape, by_name, number, other, table, text, texts
from gripcourse.course.toml_table import Table
from gripcourse.course.unit_words import unit_remedy
from gripcourse.course.written_formula import written_formula
from gripcourse.formula.parse import parse
from gripcourse.formula.tree import Formula
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.units import known as known_unit
from gripcourse.text.words import Texts, message

_ONE: Final = Formula("1", parse("1"), {})
_PAIR: Final = {"type": "array", "items": {"type": "string"}, "minItems": 2, "maxItems": 2}


class Direction(StrEnum):
    """How the output's coordinate changes while the drive's grows."""

    GROWS = "grows"
    FALLS = "falls"


class PositionLine(StrEnum):
    """How a diagram shows a position."""

    NONE = "none"
    THICK = "thick"
    THIN = "thin"


POSITION: Final = Shape(
    {
        "title": texts("In words.", required=True),
        "line": text("How diagrams show it; the first where nothing is written.", *PositionLine),
    }
)
KINEMATICS: Final = Shape(
    {
        "drive": text("Name of the drive's coordinate in the formulas.", required=True),
        "unit": text("Its unit.", required=True),
        "coordinate": by_name(
            "Lengths and angles that depend on it, in order of calculation.",
            table(
                "A coordinate.",
                {
                    "unit": text("Its unit.", required=True),
                    "formula": text("What computes it.", required=True),
                },
            ),
        ),
        "at": by_name(
            "The drive's coordinate at each position of the course that the scheme has.",
            text("A formula.", required=True),
            required=True,
        ),
        "output": text("The coordinate that the drive moves against the load; with `ratio`."),
        "outputs": text("Formula: how many outputs the drive moves alike; 1 where not written."),
        "direction": text("Of the output while the drive's coordinate grows.", *Direction),
        "ratio": by_name(
            "The quantity that is the ratio of efforts, by position.",
            text("Id of a quantity.", required=True),
        ),
        "state": by_name(
            "By position: which coordinate gives each quantity that describes it.",
            by_name("Coordinate by quantity.", text("A coordinate.", required=True)),
        ),
        "lossless": by_name(
            "Quantities to be set so that the ratio holds no friction.",
            number("A value.", required=True),
        ),
        "point": by_name("Joints, by name.", other("Names of two coordinates.", _PAIR)),
    },
    former=former.KINEMATICS,
)


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
    table.known_keys()
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
        at={position: written_formula(at, position) for position in at.values},
        output=_output(table),
        outputs=written_formula(table, "outputs") if table.has("outputs") else _ONE,
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
    table.known_keys()
    return Coordinate(name, _unit(table), written_formula(table, "formula"))


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
    table.known_keys()
    written = table.text("line", PositionLine.NONE)
    if written not in list(PositionLine):
        what = message("'{word}' means nothing here.", word=written)
        table.add("line", what, did_you_mean(written, list(PositionLine)))
        written = PositionLine.NONE
    return JointPosition(name, table.texts("title"), PositionLine(written))


def _output(table: Table) -> str:
    """Read the output; a ratio of efforts has one."""
    if table.has("ratio") and not table.has("output"):
        table.add(
            "output",
            message("This key is missing."),
            message("Write '{name}': {wanted}.", name="output", wanted=message("a text in quotes")),
        )
    return table.text("output", "")


def _direction(table: Table) -> Direction:
    written = table.text("direction", Direction.GROWS)
    if written in list(Direction):
        return Direction(written)
    what = message("'{word}' means nothing here.", word=written)
    table.add("direction", what, did_you_mean(written, list(Direction)))
    return Direction.GROWS


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
        unit_remedy(unit),
    )
    return ""
