"""The keys of `diagram.toml`: those of each element follow from the vocabulary."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Final

from gripcourse.course import former
from gripcourse.course.diagram_words import MIRRORS, VOCABULARY, Role, Sort
from gripcourse.course.shape import Key, Shape, by_name, flag, number, other, strings, tables, text

_POINT: Final = {"type": "array", "items": {"type": "string"}, "minItems": 2, "maxItems": 2}
_SIZE: Final = {"type": ["string", "number"]}
_MEANINGS: Final[Mapping[Sort, str]] = {
    Sort.POINT: "Name of a point.",
    Sort.POINTS: "Names of two points or more, in order.",
    Sort.LENGTH: "Formula of a length, drawn to scale.",
    Sort.ANGLE: "Formula of an angle, counter-clockwise from the axis.",
    Sort.NUMBER: "A number, or its formula; of millimetres on paper, or a count.",
    Sort.WORD: "How it looks.",
    Sort.QUANTITY: "Id of the quantity whose symbol is written beside it.",
}
# What the sort of a role does not say: by the element, or by the name of the role in any.
_OWN: Final[Mapping[str, str]] = {
    "gear.mesh": "Angle at which another gear or a rack meshes: so that teeth stand in gaps there.",
    "gear.has": "What it has at `mesh`: of two gears one has a gap, the other a tooth.",
    "gear.start": "Angle at which a sector begins.",
    "gear.sweep": "Angle that a sector extends over.",
    "link.corner": "Whether a link of three points and more is marked as rigid.",
    "ground.side": "Of the way through the points: which side is hatched.",
    "rack.side": "Of the way through the points: which side the teeth stand on.",
    "contact.holds": "Name of the point in the middle of what it presses on.",
    "contact.surface": "Of its face; a convex or concave one takes a `radius`.",
    "contact.angle": "Half the angle of a vee; not written: one face.",
    "contact.mouth": "Opening of a vee.",
    "contact.smallest": "Least diameter of what it presses on.",
    "contact.largest": "Greatest diameter of what it presses on.",
    "cylinder.base": "Whether it is fastened or hangs on a joint.",
    "cylinder.rod": "Which side of the piston is under pressure.",
    "floating_cylinder.rod": "Which side of the piston is under pressure.",
    "force.shift": "Millimetres on paper by which it stands to the left of its point.",
    "force.most": "How long it may be at most, to scale: the room that it has.",
    "force.end": "Which end of the arrow stands at the point.",
    "moment.start": "Angle at which the arrow begins.",
    "moment.sweep": "Angle that the arrow extends over; negative: clockwise.",
    "length.shift": "Millimetres on paper from the points to the dimension line, to the left.",
    "length.past": "Name of a point that the dimension line lies beyond, too.",
    "length.along": "Whether it is measured along the line of its points or along an axis.",
    "angle.start": "Where the angle begins.",
    "angle.sweep": "How large it is; negative: clockwise.",
    "end_view.count": "How many of the mechanism stand round the axis.",
    "repeat": "How often it is drawn along the picture.",
    "pitch": "How far these stand apart: formula of a length, to scale.",
    "rows": "How often it is drawn across the picture.",
    "row_pitch": "How far these stand apart: formula of a length, to scale.",
}


def _meaning(kind: str, name: str, role: Role) -> str:
    said = _OWN.get(f"{kind}.{name}") or _OWN.get(name) or _MEANINGS[role.sort]
    left_out = role.words[0] if role.words else role.default
    return f"{said} `{left_out}` where not written." if left_out else said


def _key(kind: str, name: str, role: Role) -> Key:
    meaning, required = _meaning(kind, name, role), role.default is None
    match role.sort:
        case Sort.POINTS:
            return strings(meaning)
        case Sort.WORD:
            return text(meaning, *role.words)
        case Sort.POINT | Sort.QUANTITY:
            return text(meaning, required=required)
        case _:
            return other(meaning, _SIZE, required=required)


_COMMON: Final = {
    "kind": replace(
        text("Which symbol it is.", *VOCABULARY, required=True), former=former.ELEMENT_KINDS
    ),
    "positions": strings(
        "Of the drive, at which it is drawn; not written: those that the course shows."
    ),
    "mirror": text("On one side of the axis, on both, or on the other only.", *MIRRORS),
    "options": by_name(
        "It is drawn only with these choices, by option.", strings("Ids of choices.")
    ),
}
ELEMENT: Final = Shape(
    _COMMON,
    by="kind",
    kinds={
        kind: {name: _key(kind, name, role) for name, role in word.roles.items()}
        for kind, word in VOCABULARY.items()
    },
    former_kinds=former.ELEMENTS,
)
SHARED_DIAGRAM: Final = Shape({"element": tables("The symbols, in order of drawing.", ELEMENT)})
DIAGRAM: Final = Shape(
    {
        "axis": text("The coordinate that runs along the axis.", "x", "y"),
        "symmetric": flag("Whether elements that say nothing are drawn on both sides of the axis."),
        "shared": strings("Files in `variants/diagram` with elements that several diagrams share."),
        "point": by_name(
            "Points that the kinematics does not have, by name.",
            other("Two formulas: along the axis, across it.", _POINT),
        ),
        "nominal": by_name(
            "The mechanism as assignments show it, the same for all variants: values of "
            "quantities, where they are not those of the worked example.",
            number("In the declared unit."),
        ),
        **SHARED_DIAGRAM.keys,
    }
)
