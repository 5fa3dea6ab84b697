"""The keys of `variants/proofs.toml`."""

from typing import Final

from gripcourse.course.shape import Shape, by_name, number, strings, tables, text

_FORMULA: Final = text("A formula.", required=True)
_TOLERANCE: Final = number("Relative.", 0.0, 1.0)
_KINDS: Final = {
    "identity": {
        "left": text("A formula.", required=True),
        "right": text("A formula that must give the same.", required=True),
        "tolerance": _TOLERANCE,
    },
    "inequality": {"condition": text("A comparison that must hold.", required=True)},
    "virtual_work": {
        "ratio": text("The declared effort of the input over the output's.", required=True),
        "parameter": text("Name of what moves, in both paths.", required=True),
        "unit": text("Unit of the parameter.", required=True),
        "at": text("Formula: where the ratio is declared.", required=True),
        "input": text("Path of the input, a formula of the parameter.", required=True),
        "output": text("Path of the output, a formula of the parameter.", required=True),
        "step": number("Of the numerical derivative, in the unit.", 0.0),
        "tolerance": _TOLERANCE,
    },
    "travel": {
        "quantity": text("A declared path, as a formula.", required=True),
        "coordinate": text("A coordinate of [kinematics].", required=True),
        "start": text("A position of [kinematics].", required=True),
        "end": text("A position of [kinematics].", required=True),
        "tolerance": _TOLERANCE,
    },
}
PROOFS: Final = Shape(
    {
        "proof": tables(
            "What must be so whatever the numbers are, told without the formulas it proves.",
            Shape(
                {
                    "id": text("Unique name.", required=True),
                    "kind": text("How it is proved.", *_KINDS, required=True),
                    "schemes": strings(
                        "The schemes that it is about; left out: all that have all its names."
                    ),
                    "options": by_name(
                        "Only with these choices.", text("A choice.", required=True)
                    ),
                    "set": by_name(
                        "Numbers that variants are given instead of their own, declared units.",
                        number("A value.", required=True),
                    ),
                    "let": by_name("Names for parts of the formulas, in order.", _FORMULA),
                },
                by="kind",
                kinds=_KINDS,
            ),
        ),
        "unshown": tables(
            "Flipped operators that no number can show.",
            {
                "quantity": text("Id of the quantity.", required=True),
                "operator": text("The operator.", required=True),
                "reason": text("Why nothing can show it.", required=True),
            },
        ),
    }
)
