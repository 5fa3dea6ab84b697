"""The keys of the files in `variants`: the course, parts, schemes, examples, errata, atlases."""

from typing import Final

from gripcourse.course import former
from gripcourse.course.diagram_keys import DIAGRAM, SHARED_DIAGRAM
from gripcourse.course.equations import EQUATIONS
from gripcourse.course.kinematics import KINEMATICS, POSITION
from gripcourse.course.note import NOTE
from gripcourse.course.quantity import Convention
from gripcourse.course.quantity_keys import CONSTANT, OVERRIDES, QUANTITIES, SOURCE
from gripcourse.course.shape import (
    Shape,
    by_name,
    flag,
    number,
    other,
    strings,
    table,
    tables,
    text,
    texts,
)
from gripcourse.text.words import LANGUAGES

__all__ = [
    "ATLAS",
    "COURSE",
    "DIAGRAM",
    "EXAMPLE",
    "OPTION",
    "PART",
    "PUBLISHED_CASES",
    "SCHEME",
    "SHARED_DIAGRAM",
]

_VALUE: Final = {
    "type": "array",
    "items": {"type": "number"},
    "minItems": 2,
    "maxItems": 2,
}
_VALUES: Final = by_name("Values by id, in declared units.", number("A value.", required=True))
_EXPECTED: Final = by_name(
    "By id: a value and the difference that the printed digits leave open.",
    other(
        "Value and tolerated difference: [3900, 0.5]; of a verdict [1, 0] for yes, [0, 0] for no.",
        _VALUE,
    ),
)
_CHOICES: Final = by_name("Choice of each option, by id.", text("A choice.", required=True))

COURSE: Final = Shape(
    {
        "id": text("Short name; it goes into signatures.", required=True),
        "language": text("Of students' documents, where the roster says no other.", *LANGUAGES,
                         required=True),
        "languages": strings(
            "That the course is written in; all three where not written. What is missing in the "
            "others is shown in the course's own."
        ),
        "address": text("Of its page in the web: where the code on an assignment leads to."),
        "convention": text("Whose version of a formula is the reference.", *Convention),
        "title": texts("Of the course or the assignment.", required=True),
        "section": tables(
            "The sections of the assignment, in order.",
            {
                "id": text("Name in declarations.", required=True),
                "title": texts("In full.", required=True),
                "short": texts("What fits a tab of a workbook.", required=True),
                "task": texts("What is to be done in it.", required=True),
                "detail": tables(
                    "Further sentences of the task, for variants that have something.",
                    {
                        "quantities": strings("It is printed for variants with one of these."),
                        "text": texts("The sentence.", required=True),
                    },
                ),
            },
        ),
        "work": by_name(
            "Works that declarations cite, by id.",
            table(
                "A work.",
                {
                    "title": texts("As it is cited.", required=True),
                    "equations": EQUATIONS,
                    "at_hand": flag(
                        "Whether students have it; if not, the formulas that are cited from it are "
                        "printed with their assignments. True where not written."
                    ),
                },
            ),
        ),
        "constant": by_name("Numbers of the course, by id.", table("A constant.", CONSTANT)),
        "position": by_name(
            "Where the drive may stand, by id, in order.", table("A position.", POSITION)
        ),
        "note": tables("Sentences of the course's own that its documents print.", NOTE),
    }
)  # fmt: skip
PART: Final = Shape(
    {
        "quantity": QUANTITIES,
        "override": OVERRIDES,
        "kinematics": table("How the links move.", KINEMATICS),
    }
)
_SEVERAL_CHOICES: Final = strings("Ids of choices.")
OPTION_RULE: Final = Shape(
    {
        "when": by_name(
            "Choices by option: the rule counts where each option has one of its own.",
            _SEVERAL_CHOICES,
            required=True,
        ),
        "requires": by_name(
            "Choices by option: then each of these options has one of its own.", _SEVERAL_CHOICES
        ),
        "same": strings("Ids of givens that are then one number, drawn for the first of them."),
        "note": texts("Why: it is told to whoever breaks the rule.", required=True),
    }
)
OPTION: Final = Shape(
    {
        "id": text("Name of the option in variants.", required=True),
        "title": texts("In words.", required=True),
        "choice": tables(
            "What may be chosen.",
            {
                "id": text("Name of the choice in variants.", required=True),
                "title": texts("In words.", required=True),
                "parts": strings("Ids of the parts that it brings."),
            },
        ),
        "rule": tables(
            "What its choices ask of other options, in the schemes that have these.", OPTION_RULE
        ),
    }
)
SCHEME: Final = Shape(
    {
        "id": text("The name of the folder.", required=True),
        "parts": strings("Ids of the parts that every variant has."),
        "options": strings("Ids of shared options: the files in `variants/options`."),
        "title": texts("In full.", required=True),
        "task": texts("A sentence for the assignment.", required=True),
        "option": tables("Options of this scheme alone.", OPTION),
        "option_rule": tables("Rules among the options of this scheme.", OPTION_RULE),
        "quantity": QUANTITIES,
        "override": OVERRIDES,
        "kinematics": table("How the links move.", KINEMATICS),
    }
)
EXAMPLE: Final = Shape(
    {
        "source": table("Where the calculation is published.", SOURCE, required=True),
        "options": _CHOICES,
        "given": by_name(
            "Givens and constants that differ from their defaults, in declared units.",
            number("A value.", required=True),
        ),
        **{
            str(convention): table(
                "What comes out in this convention.", {"chosen": _VALUES, "expected": _EXPECTED}
            )
            for convention in Convention
        },
    },
    former=former.EXAMPLE,
)
PUBLISHED_CASES: Final = Shape(
    {
        "case": tables(
            "Calculations printed elsewhere, or made by another method.",
            {
                "id": text("Unique name.", required=True),
                "scheme": text("The scheme that it solves.", required=True),
                "source": table("Where its numbers are printed.", SOURCE, required=True),
                "options": _CHOICES,
                "given": _VALUES,
                "chosen": _VALUES,
                "expected": _EXPECTED,
            },
        )
    }
)
_NUMBER: Final = number("As the source numbers it.", required=True)
_ATLAS_SIZE: Final = {
    "symbol": text("In the heading of its column.", required=True),
    "unit": text("Its unit.", required=True),
}
ATLAS: Final = Shape(
    {
        "scheme": text("The scheme whose formulas are used.", required=True),
        "work": text("Id of the work.", required=True),
        "title": texts("Of the atlas.", required=True),
        "size": by_name("What every row computes, by id, in order.", table("A size.", _ATLAS_SIZE)),
        "input": by_name(
            "What the examples of rows know besides quantities, by id.",
            table("An input.", _ATLAS_SIZE),
        ),
        "figure": tables(
            "Figures of curves.",
            {
                "number": _NUMBER,
                "title": texts("Under the figure.", required=True),
                "against": text("The given along the axis.", required=True),
                "from": number("Where the axis begins, in declared units.", required=True),
                "to": number("Where the axis ends.", required=True),
                "ordinate": texts("What all lines show, beside the other axis."),
                "curves": tables(
                    "The lines of the figure.",
                    {
                        "number": _NUMBER,
                        "quantity": text("What is drawn.", required=True),
                        "at": by_name("Values of givens.", number("A value.", required=True),
                                      required=True),
                    },
                ),
            },
        ),
        "row": tables(
            "Rows of a table of cases.",
            Shape({
                "number": _NUMBER,
                "title": texts("What is measured.", required=True),
                "size": by_name("Formula of each size, by id.", text("A formula.", required=True),
                                required=True),
                "example": by_name("Values by name.", number("A value.", required=True),
                                   required=True),
            }, former=former.ATLAS_ROW),
        ),
    }
)  # fmt: skip
