"""Names by which cells are found again, wherever a student's work moves them.

Every answer is the cell named `answer.<id of the quantity>`, every given value `given.<id>`, and a
hidden sheet carries `meta.<field>`; the same fields stand in custom properties of the document.
"""

from collections.abc import Mapping
from typing import Final

ANSWER: Final = "answer"
GIVEN: Final = "given"
META: Final = "meta"
SI: Final = "si"
"""In the instructor's key only: the value of a quantity in SI."""

AUTHOR: Final = "gripcourse"
"""The author that an issued workbook names, until a person's program writes another."""

HIDDEN_SHEET: Final = "_gripcourse"
PROPERTY: Final = "gripcourse"
"""Custom properties of the document are named `gripcourse.<field>`."""

STUDENT: Final = "student"
VARIANT: Final = "variant"
SCHEME: Final = "scheme"
OPTIONS: Final = "options"
SIGNATURE: Final = "signature"
FIELDS: Final = (STUDENT, VARIANT, SCHEME, OPTIONS, SIGNATURE)


def cell_name(role: str, identifier: str) -> str:
    """Return the name of a cell, for example `answer.mass`."""
    return f"{role}.{identifier}"


def options_text(options: Mapping[str, str]) -> str:
    """Write what a variant chooses as one line of text: `drive=electric; mounting=wall`."""
    return "; ".join(f"{option}={choice}" for option, choice in sorted(options.items()))


def read_options(text: str) -> dict[str, str]:
    """Read what `options_text` wrote; parts without a sign of equality are left out."""
    pairs = (part.partition("=") for part in text.split(";"))
    return {option.strip(): choice.strip() for option, equals, choice in pairs if equals}
