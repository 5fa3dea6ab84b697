"""The keys of `diagram.toml`: those of each element follow from the vocabulary."""

from collections.abc import Mapping
from typing import Final

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
    Sort.WORD: "How it looks; the first word where nothing is written.",
    Sort.QUANTITY: "Id of the quantity whose symbol is written beside it.",
}


def _key(role: Role) -> Key:
    meaning, required = _MEANINGS[role.sort], role.default is None
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
    "kind": text("Which symbol it is.", *VOCABULARY, required=True),
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
        kind: {name: _key(role) for name, role in word.roles.items()}
        for kind, word in VOCABULARY.items()
    },
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
