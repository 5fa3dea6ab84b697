"""The keys of `grader/virtual.toml`."""

from dataclasses import MISSING, fields
from typing import Final

from gripcourse.course.shape import Key, Shape, by_name, number, other, strings, table
from gripcourse.simulation.arithmetic import DigitRounding
from gripcourse.simulation.model import Carrying, Conduct, Required, Style
from gripcourse.text.words import LANGUAGES

_WEIGHT: Final = number("A weight.", required=True)


def _weights(meaning: str, *names: str) -> Key:
    """Make a key that holds weights by name: of these names, of any where none is named."""
    if not names:
        return by_name(meaning, _WEIGHT, required=True)
    each = number("A weight; absent is never.")
    return table(meaning, dict.fromkeys(names, each), required=True)


MIX: Final = Shape(
    {
        "conduct": _weights("What students do.", *Conduct),
        "figures": _weights("Significant figures that a student writes."),
        "rounding": _weights("How they round.", *DigitRounding),
        "carrying": _weights("What the next step is computed with.", *Carrying),
        "style": _weights("How a number stands in its cell.", *Style),
        "pi": _weights("Values of π that they take."),
        "language": _weights("Their languages.", *LANGUAGES),
        "constant": by_name(
            "Constants of the course as they take them, by id.",
            _weights("Values in the declared unit."),
            required=True,
        ),
        "share": table(
            "Shares of a student's answers.",
            {
                "blank": number("That one who leaves blanks leaves.", 0, 1, required=True),
                "copied": number("That one who copies takes over.", 0, 1, required=True),
            },
            required=True,
        ),
        "slip": table(
            "How wrong methods are made.",
            {
                "apart": number("Bands that its result lies off.", 0, 1000, required=True),
                "tries": number("Places that are tried for it.", required=True),
            },
            required=True,
        ),
        "tolerance": table(
            "What an audit of tolerances may propose.",
            {
                "answers": number("Honest ones before a narrower band.", required=True),
                "bands": other(
                    "Relative bands, the narrowest first.",
                    {"type": "array", "items": {"type": "number", "exclusiveMinimum": 0}},
                    required=True,
                ),
                "wide": number("Share of a value that is listed as spread far.", 0, 1,
                               required=True),
            },
            required=True,
        ),
        "flags": table(
            "Flags that count.",
            {"copying": strings("Those that say that a work is not the student's own.")},
            required=True,
        ),
        "required": table(
            "What the grader is held to.",
            {
                one.name: number("A share.", 0, 1, required=one.default is MISSING)
                for one in fields(Required)
            },
            required=True,
        ),
    }
)  # fmt: skip
