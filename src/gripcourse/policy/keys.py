"""The keys of the files in `grader`: the policy, the generic slips, the rubrics."""

from typing import Final

from gripcourse.course.quantity import Kind
from gripcourse.course.quantity_keys import TOLERANCE
from gripcourse.course.shape import (
    Key,
    KeySort,
    Shape,
    by_name,
    number,
    other,
    strings,
    table,
    tables,
    text,
    texts,
)
from gripcourse.policy.lenient import LEAST_CALCULATED, LEAST_FIGURES, WIDEST_RELATIVE
from gripcourse.policy.model import Reveal, Tells
from gripcourse.policy.slips import SlipKind
from gripcourse.policy.time_rules import Counts

_SHARE: Final = {"type": "number", "minimum": 0, "maximum": 1}
_PAIRS: Final = {
    "type": "array",
    "items": {"type": "array", "items": {"type": "string"}, "minItems": 2, "maxItems": 2},
}
_WEIGHT: Final = number("A weight.", high=1000, required=True)

POLICY: Final = Shape(
    {
        "points": table(
            "Points of the assignment.",
            {
                "total": number("Of the whole assignment.", 0.001, 100_000, required=True),
                "section": by_name(
                    "Of each section; they add up to the total.",
                    number("Points.", required=True),
                    required=True,
                ),
                "quantity": by_name(
                    "Of main results, whatever else their section asks for, by id.",
                    number("Points.", 0, 100_000, required=True),
                ),
            },
            required=True,
        ),
        "weight": table(
            "Weights of quantities inside their sections.",
            {
                "kind": table(
                    "By kind.",
                    {one: _WEIGHT for one in Kind if one.answered or one is Kind.MANUAL},
                ),
                "quantity": by_name("Where it is not the kind's, by id.", _WEIGHT),
            },
            required=True,
        ),
        "tolerance": table(
            "How far an answer may differ: the wider part counts. The relative one is at most "
            f"{WIDEST_RELATIVE}.",
            {
                **TOLERANCE,
                "floor": by_name(
                    "Absolute part by declared unit.", number("In that unit.", required=True)
                ),
            },
            required=True,
        ),
        "quantity_tolerance": by_name(
            "Tolerances of single quantities, by id.", table("A tolerance.", TOLERANCE)
        ),
        "credit": table(
            "Shares of the points.",
            {
                "carried": number("Of what follows from the student's own numbers.", 0, 1,
                                  required=True),
                "printed": other(
                    "Of an answer as a source prints it; false refuses it.",
                    {"anyOf": [_SHARE, {"const": False}]},
                    required=True,
                ),
                "wrong_unit": number("Of the right number with a unit that does not fit.", 0, 1,
                                     required=True),
                "rough": number("Of the right number, rounded until it leaves its band.", 0, 1),
                "calculated": number("Of a work's computed answers: so many must be right or "
                                     "follow, for what rests on the others to count; "
                                     f"{LEAST_CALCULATED} or more.", 0, 1),
            },
            required=True,
        ),
        "rounding": table(
            "How people round.",
            {
                "last_digit": number("Units of the last typed digit: 0.5 or 1.", 0, 10,
                                     required=True),
                "figures": number("A typed number counts as written with so many; "
                                  f"{LEAST_FIGURES} or more.", 1, 15, required=True),
                "habits": by_name(
                    "Shortened constants, by id or `pi`.",
                    other("Values.", {"type": "array", "items": {"type": "number"}}),
                ),
                "widest": number("Bands that an answer from rounded numbers may spread.", 0, 10_000,
                                 required=True),
            },
            required=True,
        ),
        "figures": table(
            "Significant figures of answers, judged apart from the value.",
            {
                "least": number("At least so many; 0 for no bound."),
                "most": number("At most so many; 0 for no bound."),
                "credit": number("Share that an answer outside keeps.", 0, 1),
            },
        ),
        "likeness": table(
            "When another student's numbers are told to the instructor.",
            {
                "odds": number("Of copying against chance; 0 looks for nothing.", required=True),
                "answers": number("Telling numbers that it rests on, at least."),
                "same_creator": number("Students who share an author's name, at most."),
            },
        ),
        "check": table(
            "What a student's self-check tells before the deadline.",
            {
                "tells": text("The most that is told.", *Tells, required=True),
                "times": number("How often each student is told more than the reading."),
            },
        ),
        "report": table(
            "What a student's report shows.",
            {"reveal": text("Of the reference solution.", *Reveal, required=True)},
            required=True,
        ),
        "late": table(
            "What lateness costs.",
            {
                "per_day": number("Share of the points that each day begun takes off.", 0, 1,
                                  required=True),
                "most": number("Share that lateness takes off at most.", 0, 1),
                "grace": number("Hours after the deadline that cost nothing.", 0, 10_000),
                "zone": text("Time zone of the course, such as Europe/Kyiv."),
            },
        ),
        "attempts": table(
            "Which of several works of a student counts.",
            {
                "counts": text("Of those that may count.", *Counts, required=True),
                "most": number("How many may; 0 for any number.", 0, 1000),
            },
        ),
        "scale": tables(
            "What shares of the points are called.",
            {
                "id": text("Unique name; its column in the table of grades.", required=True),
                "title": texts("For documents.", required=True),
                "step": tables(
                    "Its steps; none for the plain percentage.",
                    {
                        "from": number("Percentage of the points that it begins at.", 0, 100,
                                       required=True),
                        "text": texts("What it is called.", required=True),
                    },
                ),
            },
        ),
        "variants": table(
            "When variants may be handed out side by side.",
            {
                "shared_points": number("Share of the points with another's answers.", 0, 1,
                                        required=True),
                "shared_section_points": number("The same in one section.", 0, 1, required=True),
                "slip_bands": number("Bands that the result of a slip lies off.", 0, 1000,
                                     required=True),
                "keep_apart": strings("Kinds of slips that refuse a variant.",
                                      "declared", *SlipKind),
                "step_margin": number("Share that an answer may move before a size changes.", 0, 1,
                                      required=True),
                "steps_ratio": number("Quantities of the longest assignment over the shortest.", 1,
                                      1000, required=True),
                "weak_item": number("Share of pairs in which a quantity is equal.", 0, 1,
                                    required=True),
                "same_size": number("Share of a scheme's variants with one and the same size.",
                                    0, 1, required=True),
                "same_end": number("Share of them in which the same of two values is the greater.",
                                   0, 1, required=True),
                "verdict_no": Key(KeySort.PAIR, "Least and greatest share of 'no' to a verdict.",
                                  required=True),
            },
            required=True,
        ),
    }
)  # fmt: skip
SLIPS: Final = Shape(
    {
        "naming": table(
            "When a slip is named.",
            {
                "unexplained": number("How common a wrong answer is that nothing explains.",
                                      required=True),
                "declared": number("How common each declared slip is.", required=True),
                "certain": number("A slip is named from this probability on.", required=True),
                "tie": number("Of two with one result both are named: neither is so much likelier.",
                              required=True),
                "spread": number("Wrong answers scatter by e to this power.", required=True),
            },
            required=True,
        ),
        "kind": by_name(
            "Kinds of wrong methods that people use with any formula.",
            table(
                "A kind.",
                {
                    "prior": number("How common it is.", required=True),
                    "credit": number("Share of the points that it earns.", 0, 1, required=True),
                    "names": strings("Quantities that it concerns."),
                    "pairs": other("Pairs of endings of names.", _PAIRS),
                    "units": strings("Units that it is tried with."),
                    "title": texts("Its name.", required=True),
                    "hint": texts("What the student reads.", required=True),
                },
            ),
        ),
    }
)  # fmt: skip
RUBRIC: Final = Shape(
    {
        "title": texts("Of the rubric.", required=True),
        "line": tables(
            "The criteria.",
            {
                "id": text("Unique name.", required=True),
                "share": number("Of the points of the item.", required=True),
                "text": texts("What is asked.", required=True),
                "level": tables(
                    "Steps, where not every share makes sense.",
                    {
                        "credit": number("Share of the line.", required=True),
                        "text": texts("What earns it.", required=True),
                    },
                ),
            },
        ),
    }
)
