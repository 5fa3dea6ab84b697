"""The position kinematics of a scheme, as its author declares it.

Coordinates are formulas of the drive's coordinate, of quantities and of earlier coordinates. They
serve the proof that a scheme's force ratio is right (virtual work) and its drawing.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

from gripcourse.course.shape import Shape, by_name, number, other, table, text
from gripcourse.course.toml_table import Table
from gripcourse.course.unit_words import unit_remedy
from gripcourse.formula.parse import FormulaFault, caret, parse
from gripcourse.formula.tree import Formula
from gripcourse.text.units import known as known_unit
from gripcourse.text.words import message

POSITIONS = ("open", "at_max", "at_min")
_PAIR: Final = {"type": "array", "items": {"type": "string"}, "minItems": 2, "maxItems": 2}
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
        "at": table(
            "The drive's coordinate at each position.",
            {one: text("A formula.", required=True) for one in POSITIONS},
            required=True,
        ),
        "jaw": text("The coordinate that falls while a jaw closes.", required=True),
        "jaws": text("Formula: how many jaws the drive moves.", required=True),
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
    }
)


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
            shaft, growing while the jaws close.
        unit: its declared unit.
        coordinates: in the order in which they are computed.
        at: the drive's coordinate at each position: open, at_max and at_min (largest and smallest
            object held).
        jaw: id of the coordinate that falls while a jaw closes.
        jaws: how many jaws the drive moves.
        ratio: id of the quantity that is the drive's effort over the grip force of one jaw, for
            each position at which the scheme declares one.
        state: for each such position, the quantities that describe it and the coordinates that
            give them at any position of the drive.
        lossless: quantities to be set so that the ratio holds no friction, in declared units.
        points: joints, by name, as pairs of coordinates (x along the gripper's axis).
        file: the file that declares it, for messages.
    """

    drive: str
    unit: str
    coordinates: tuple[Coordinate, ...]
    at: Mapping[str, Formula]
    jaw: str
    jaws: Formula
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
    at.known_keys()
    return Kinematics(
        drive=table.text("drive"),
        unit=_unit(table),
        coordinates=tuple(
            _coordinate(name, one) for name, one in table.named_tables("coordinate").items()
        ),
        at={position: _formula(at, position) for position in POSITIONS},
        jaw=table.text("jaw"),
        jaws=_formula(table, "jaws"),
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
    return Coordinate(name, _unit(table), _formula(table, "formula"))


def _formula(table: Table, name: str) -> Formula:
    text = table.text(name)
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
        unit_remedy(unit),
    )
    return ""
