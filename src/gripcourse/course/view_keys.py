"""The keys of `drawing.toml`: those of each shape follow from the list of shapes."""

from collections.abc import Mapping
from typing import Final

from gripcourse.course import former
from gripcourse.course.shape import (
    Key,
    Shape,
    by_name,
    flag,
    number,
    other,
    strings,
    tables,
    text,
    texts,
)
from gripcourse.course.view import HATCHES, LINES, SHAPES, Face, Need, Side

_FORMULA: Final = {"anyOf": [{"type": "string"}, {"const": 0}]}
_TWO: Final = {"type": "array", "items": _FORMULA, "minItems": 2, "maxItems": 2}
_NEEDS: Final[Mapping[Need, Key]] = {
    Need.POINT: other("A point: two formulas or zeros.", _TWO, required=True),
    Need.POINTS: other(
        "Two points or more.", {"type": "array", "items": _TWO, "minItems": 2}, required=True
    ),
    Need.RANGE: other("From and to: two formulas or zeros.", _TWO, required=True),
    Need.LENGTH: other("Formula of a length.", _FORMULA, required=True),
    Need.ANGLES: other("From and to, degrees, counter-clockwise.", _TWO, required=True),
}
_POINT: Final = _NEEDS[Need.POINT]
_FACE: Final = text("The side that shows it.", *Face)
_MEASURE: Final = other(
    "A formula; of several, the first whose names are known.",
    {"anyOf": [{"type": "string"}, {"type": "array", "items": {"type": "string"}}]},
)
_DEPTH: Final = other(
    "Where it lies: from and to, lengths from the plane of the main view, counted on both sides of"
    " it: [0, half the thickness] of a plate in the middle; absent: all through.",
    _TWO,
)
_REPEAT: Final = Shape(
    {
        "count": text("Formula: how often.", required=True),
        "step": other("From one to the next: two formulas or zeros.", _TWO),
        "about": other("The centre of a ring, instead of `step`.", _TWO),
    }
)
SHAPE: Final = Shape(
    {
        "kind": text("Which figure it is.", *SHAPES, required=True),
        "line": text("How its edge is drawn.", *LINES),
        "hatch": text("Which way a cut face is hatched, and how closely.", *HATCHES),
        "hidden_edges": flag("Whether what other parts cover is shown by dashed lines."),
        "face": _FACE,
        "repeat": tables("Again and again, in a row or round a point.", _REPEAT),
        "body": flag("Whether it is solid: absent is true for what has an inside."),
        "void": flag("Whether it is cut out of the solid shapes of its part at the same depth."),
        "whole": flag("Whether a section leaves it whole: teeth, and a shaft along its axis."),
        "depth": _DEPTH,
    },
    by="kind",
    kinds={
        kind: {name: _NEEDS[need] for name, need in needs.items()} for kind, needs in SHAPES.items()
    },
)
_PART: Final = Shape(
    {
        "id": text("Its name in the declarations.", required=True),
        "title": texts("In the parts list."),
        "nameless": flag("Whether it has no position in the parts list, and no title."),
        "mirror": flag("Whether it stands on both sides of the axis."),
        "count": text("Formula: how many there are."),
        "sizes": strings("Quantities that the parts list shows."),
        "material": texts("In the parts list; absent: that of the view."),
        "mark": other("Where the leader of its position ends; needed where it has a title.", _TWO),
        "moves": flag("Whether the other position of the view shows it too."),
        "meets": strings("Parts that it may overlap: a pin in its hole, teeth in mesh."),
        "touches": strings("Parts that it may press into by 0.2 mm: what it holds."),
        "enters": text("Formula: how much deeper than that it may."),
        "body": flag("Whether its figures are solid: absent is true for those with an inside."),
        "depth": _DEPTH,
        "density": number("kg/m³ of what its outline holds; absent: that of the view."),
        "piece_of": text("The part that it is one piece with; absent: a piece of its own."),
        "positions": strings("Positions of the kinematics in which it is there; absent: all."),
        "placed_at": text("The position whose coordinates place it in all of them."),
        "shape": tables("Its figures, the later over the earlier.", SHAPE),
    },
    former=former.VIEW_PART,
)
_DIMENSION: Final = Shape(
    {
        "quantity": text("What it shows.", required=True),
        "from": _POINT,
        "to": _POINT,
        "side": text("The side of the view that it stands on.", *Side, required=True),
        "face": _FACE,
        "sign": text("Before the number, for example ⌀."),
        "at_other": flag("Whether it is measured in the other position."),
    }
)
_LABEL: Final = Shape(
    {
        "text": texts("Words on a leader line, with places in braces.", required=True),
        "values": by_name("Quantity or measure in each place.", text("A name.", required=True)),
        "at": _POINT,
        "face": _FACE,
    }
)
_DETAIL: Final = Shape(
    {
        "at": _POINT,
        "reach": _NEEDS[Need.LENGTH],
        "section": flag("Whether it is cut across the axis there; absent: shown as it is seen."),
    }
)
_GRADE: Final = Shape(
    {
        "yield": number("Yield stress, MPa.", required=True),
        "elastic_modulus": number("Elastic modulus, MPa; for parts that name theirs."),
        "density": number("kg/m³.", required=True),
        "material": texts("In the parts list.", required=True),
    }
)
_REQUIREMENT: Final = Shape({"text": texts("A sentence.", required=True)})
SHARED_VIEW: Final = Shape(
    {
        "length": by_name("Lengths of the drawing, by name.", _MEASURE),
        "angle": by_name("Angles of the drawing, by name.", _MEASURE),
        "count": by_name("Numbers of the drawing, by name.", _MEASURE),
        "part": tables("Parts, the later over the earlier.", _PART),
        "dimension": tables("Dimensions.", _DIMENSION),
        "label": tables("Words on leader lines.", _LABEL),
        "detail": tables("Places shown again at a larger scale, where there is room.", _DETAIL),
        "grade": tables("Materials by their strength.", _GRADE),
        "requirement": tables("Technical requirements, beside the drawing.", _REQUIREMENT),
    }
)
VIEW: Final = Shape(
    {
        "behind": strings("Files in `variants/drawing` that lie behind this one."),
        "before": strings("Files in `variants/drawing` that lie before this one."),
        "position": text("Of the kinematics, in which it is drawn."),
        "upright": flag("Whether the axis stands upright."),
        "bodies": flag("Whether its parts are bodies that must not go through one another."),
        "other": text("Position that moving parts are shown in by thin lines too."),
        "density": number("Of what its bodies are made of, kg/m³; absent: the mass is not told."),
        "material": texts("Of parts that name none, in the parts list; absent: it has none."),
        "strength": by_name(
            "Yield stresses that a part needs, by its id: the greatest that a variant has chooses"
            " its material among the grades.",
            _MEASURE,
        ),
        "elastic_modulus": by_name(
            "Elastic modulus that a part was calculated with, by its id: only the grades nearest"
            " to it are chosen from.",
            _MEASURE,
        ),
        "around": text("Formula: how many of what is mirrored stand round the axis; absent: two."),
        "characteristics": strings("Quantities that stand beside the drawing."),
        **SHARED_VIEW.keys,
    },
    former=former.VIEW,
)
