"""The keys of `variants/equilibrium/*.toml`."""

from typing import Final

from gripcourse.course.shape import Shape, by_name, flag, other, strings, table, tables, text

_BETWEEN: Final = other(
    "Two bodies, or a body and `ground`; the force acts on the first, its opposite on the second.",
    {"type": "array", "items": {"type": "string"}, "minItems": 2, "maxItems": 2},
    required=True,
)
_AT: Final = text("A point.", required=True)
_DIRECTION: Final = text(
    "Formula: angle from the x axis of the positive force on the first body.", required=True
)
_COUNT: Final = text("Formula: how many supports there are.", required=True)
_PITCH: Final = text("Formula: their distance from each other.", required=True)
JOINTS: Final = {
    "pin": {"at": _AT},
    "weld": {"at": _AT},
    "slider": {
        "at": _AT,
        "along": text("Formula: angle of the guide from the x axis.", required=True),
    },
    "force": {"at": _AT, "direction": _DIRECTION},
    "slot": {
        "at": _AT,
        "direction": _DIRECTION,
        "friction_angle": text(
            "Formula: the force is turned by this angle from the normal, counterclockwise where it"
            " is positive."
        ),
    },
    "contact": {
        "at": _AT,
        "direction": _DIRECTION,
        "friction_angle": text("Formula: as of a slot; friction is at its limit then."),
        "friction": text(
            "Formula: coefficient; the tangential force is found then, and must not exceed it."
        ),
    },
    "mesh": {
        "at": _AT,
        "direction": text("Formula: angle of the tangential force.", required=True),
        "pressure_angle": text(
            "Formula: the force is turned by this angle from the tangent, counterclockwise where"
            " it is positive.",
            required=True,
        ),
    },
    "link": {"at": _AT, "to": text("A point: its other end.", required=True)},
    "couple": {},
    "row": {"at": _AT, "direction": _DIRECTION, "count": _COUNT, "pitch": _PITCH},
    "grid": {
        "at": _AT,
        "count": _COUNT,
        "pitch": _PITCH,
        "rows": text("Formula: how many there are across.", required=True),
        "row_pitch": text("Formula: their distance across.", required=True),
    },
}
POINTS: Final = {
    "place": {
        "x": text("Formula: a length.", required=True),
        "y": text("Formula: a length.", required=True),
    },
    "circles": {
        "around": other(
            "Two points: the centres.",
            {"type": "array", "items": {"type": "string"}, "minItems": 2, "maxItems": 2},
            required=True,
        ),
        "radii": other(
            "Two formulas: the distances from them.",
            {"type": "array", "items": {"type": "string"}, "minItems": 2, "maxItems": 2},
            required=True,
        ),
        "side": text("Of the way from the first centre to the second.", "left", "right",
                     required=True),
    },
}  # fmt: skip
_FORMULA: Final = text("A formula.", required=True)
_WHERE: Final = text("Only at this position; left out: at each.")
EQUILIBRIUM: Final = Shape(
    {
        "schemes": strings("The schemes it is about; left out: all that have all its names."),
        "options": by_name("Only with these choices.", text("A choice.", required=True)),
        "position": by_name(
            "Positions of the course in which it stands, each with formulas of the same names.",
            by_name("A position.", _FORMULA),
        ),
        "let": by_name("Names for parts of the formulas, in any order.", _FORMULA),
        "point": by_name(
            "Points of the plane; `NAME_x` and `NAME_y` are names for the formulas.",
            table("A point.", Shape(
                {"kind": text("How it is found; left out: by its coordinates.", *POINTS)},
                by="kind", kinds=POINTS,
            )),
        ),
        "bodies": strings("The rigid bodies; `ground` is none of them."),
        "joint": by_name(
            "What bodies do to each other, unknown; `NAME_x`, `NAME_force` and so on are names for"
            " claims.",
            table("A joint.", Shape(
                {
                    "kind": text("What it can carry.", *JOINTS, required=True),
                    "between": _BETWEEN,
                },
                by="kind", kinds=JOINTS,
            )),
        ),
        "load": by_name(
            "Forces and moments that are known.",
            table("A load.", {
                "on": text("The body on which it acts.", required=True),
                "from": text("The body from which it comes and on which its opposite acts."),
                "at": text("A point; with `force`."),
                "force": text("Formula: a force."),
                "direction": text("Formula: angle of the force from the x axis."),
                "moment": text("Formula: a moment, counterclockwise."),
            }),
        ),
        "relation": by_name(
            "Further linear equations between reactions, for example friction across the plane.",
            table("A sum.", {
                "of": by_name("Formula of the factor by reaction.", _FORMULA, required=True),
                "gives": text("Formula: what they add up to.", required=True),
            }),
        ),
        "claim": tables("Quantities that must be what equilibrium gives.", {
            "quantity": text("Formula of what the course computes.", required=True),
            "is": text("Formula of reactions that must give the same.", required=True),
            "at": _WHERE,
            "largest": flag("It is the largest of all positions."),
        }),
        "condition": tables("Comparisons that must hold.", {
            "that": text("A comparison of reactions and quantities.", required=True),
            "at": _WHERE,
        }),
    }
)  # fmt: skip
