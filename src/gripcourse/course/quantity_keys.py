"""The keys of a quantity's declaration."""

from collections.abc import Mapping
from typing import Final

from gripcourse.course.quantity import Kind, Rounding
from gripcourse.course.shape import (
    Key,
    KeySort,
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

_NUMBERS: Final = {"type": "array", "items": {"type": "number"}}
_PAIRS: Final = {
    "type": "array",
    "items": {"type": "array", "items": {"type": "number"}, "minItems": 2, "maxItems": 2},
}

SOURCE: Final = Shape(
    {
        "work": text("Id of a work that `course.toml` lists.", required=True),
        "equation": text("Number of the equation, or the paragraph."),
        "note": texts("What the source says about it, or how it was obtained."),
        "mark": texts("How far the source was read: for the reference, never on what is issued."),
    }
)
WIDEST_TOLERANCE: Final = 0.5
TOLERANCE: Final = {
    "relative": number("Share of the expected value: 0.01 is one per cent.", 0, WIDEST_TOLERANCE),
    "absolute": number("In the unit of the quantity; it counts near zero.", 0),
}
RANGE_WAYS: Final = {
    "low": number("Lowest value; with `catalogue` the lowest size."),
    "high": number("Highest value; with `catalogue` the highest size."),
    "step": number("From one value to the next; `low` and `high` are values too."),
    "values": other("All values, instead of low, high and step.", _NUMBERS),
    "catalogue": text("`catalogue.column` whose sizes are the values."),
    "follows": text("Another given that decides the value."),
    "pairs": other("With `follows`: value of the other given and value of this one.", _PAIRS),
}
RANGE: Final = Shape(
    {
        **RANGE_WAYS,
        "when": tables(
            "What replaces the range with a choice of an option; the first that fits counts.",
            {
                "option": text("Id of an option.", required=True),
                "choice": text("Id of its choice.", required=True),
                **RANGE_WAYS,
            },
        ),
    }
)
_ROUNDING: Final = text("Which entry of the series is the reference: `up` (default) or `nearest`.",
                        *Rounding)  # fmt: skip
_SLIP: Final = Shape(
    {
        "id": text("Its name, unique among the slips of the quantity.", required=True),
        "formula": text("What the wrong method computes.", required=True),
        "credit": number("Share of the points that it earns.", required=True),
        "hint": texts("What the student reads.", required=True),
        "seldom": flag(
            "Whether its value is nearly right in many variants: none is refused for it."
        ),
        "evaluated_in": by_name(
            "Of a method by which a number measures something else, an area for a length: the unit "
            "in which each name enters; it names all of them.",
            text("A unit.", required=True),
        ),
    }
)
_AS_PRINTED: Final = Shape(
    {
        "erratum": text("Id of the erratum in `errata.toml`.", required=True),
        "formula": text("The formula as it is printed."),
        "rounding": _ROUNDING,
        "note": texts("What is wrong with it, for the remark.", required=True),
    }
)
_ALTERNATIVE: Final = Shape(
    {
        "id": text("Its name, unique among those of the quantity.", required=True),
        "formula": text(
            "What that reading computes; of a choice what the entry must not be below.",
            required=True,
        ),
        "remark": texts("What the student reads beside the full points.", required=True),
    }
)

_COMMON: Final = {
    "section": text("Id of the section of the assignment.", required=True),
    "kind": text("What the quantity is to the student.", required=True),
    "symbol": texts(
        "As in formulas; `_` begins an index: `F_1`, `τ_-1`. Empty for what a person marks.",
        required=True,
    ),
    "unit": text("Declared unit (see Units below); empty for a plain number.", required=True),
    "title": texts("Its name in words.", required=True),
    "explain": texts("A sentence on how to think about it."),
    "decides": texts(
        "What decides the answer where its name leaves it open: position, convention, sign, rule. "
        "Printed beside it on the sheet and in the workbook."
    ),
    "note_decides": flag("Whether the note of the source is printed there too."),
    "formula_decides": flag(
        "Whether the formula itself is printed there: it is a convention and no task, as that of "
        "an overall size."
    ),
    "one_end": texts(
        "Why the formula always takes the same where it takes the greater or lesser of two values: "
        "with numbers. The audit does not complain then, unless it is not so."
    ),
    "source": table("Where it comes from.", SOURCE, required=True),
}
_BOUNDED: Final = {
    "bounds": Key(
        KeySort.PAIR, "Lowest and highest value that is physically thinkable.", required=True
    ),
    "integer": flag("Whether only whole numbers make sense."),
}
_JUDGED: Final = {
    "valid": text("A condition that the bounds do not imply; else the value is not carried on."),
    "tolerance": table(
        "How far an answer may differ, where not as the policy says.", Shape(TOLERANCE)
    ),
    "slip": tables("Anticipated wrong methods.", _SLIP),
    "as_printed": tables("Versions that a source prints and that are not right.", _AS_PRINTED),
    "alternative": tables(
        "Other honest readings: full credit, a remark, carried on.", _ALTERNATIVE
    ),
    "evaluated_in": by_name(
        "Of an empirical formula: the unit in which each name enters; it names all of them."
        " Its slips and other versions are computed in the same units.",
        text("A unit.", required=True),
    ),
}
_COMPUTED: Final = {"formula": text("What computes it.", required=True)}
_BY_ROUTE: Final = {
    "route": text(
        "Another way to the same value, from other answers: F/P for η/i. What follows by it from "
        "the student's own numbers counts as what follows by the formula."
    )
}
_READ: Final = {
    "read_from": text(
        "`catalogue.column` that students may read it from, where its formula reads no table: the "
        "table goes with the assignment."
    )
}
_GIVEN: Final = {
    "default": number("What it is where an example or a calculation by hand states no other."),
    "range": table("What variants draw it from; the space of a scheme may replace it.", RANGE),
}
_CHOICE: Final = {
    "series": text("`catalogue.column` of the preferred series; or write `multiple_of`."),
    "multiple_of": number(
        "Instead of a series: sizes are the whole multiples of this number between the bounds, in "
        "the unit of the quantity. 1 for whole numbers, 10 for what is rounded to tens."
    ),
    "also": strings("Further series that are accepted."),
    "at_least": text("Formula of the value that the entry must not be below.", required=True),
    "condition": text(
        "What the chosen value must also satisfy: a check. The reference stays the first size of "
        "`at_least`; variants in which that one fails are refused."
    ),
    "step_up": flag(
        "Whether the reference is the smallest size not below `at_least` for which the condition "
        "holds, and what is computed from it on the way there; refused where no size will do."
    ),
    "at_most_steps": number("How many entries above the smallest admissible are not wasteful."),
    "rounding": _ROUNDING,
}
_PLAIN: Final = {**_COMMON, "unit": text("Empty, or left out.")}

KEYS: Final[Mapping[str, Mapping[str, Key]]] = {
    Kind.GIVEN: _COMMON | _BOUNDED | _GIVEN,
    Kind.FORMULA: _COMMON | _BOUNDED | _JUDGED | _COMPUTED | _BY_ROUTE | _READ,
    Kind.CHOICE: _COMMON | _BOUNDED | _JUDGED | _CHOICE,
    Kind.PICK: _COMMON | _BOUNDED | _JUDGED | _COMPUTED,
    Kind.VERDICT: _PLAIN
    | {
        "condition": text("Yes where it holds.", required=True),
        "must_hold": flag("Whether variants are issued only where it is yes; true unless said."),
    },
    Kind.MANUAL: _PLAIN | {"rubric": text("Id of a rubric in `grader/rubric`.", required=True)},
}
QUANTITY: Final = Shape(
    {"kind": text("What the quantity is to the student.", *KEYS, required=True)},
    by="kind",
    kinds=KEYS,
)
CONSTANT: Final = Shape(
    {name: key for name, key in _COMMON.items() if name not in {"section", "kind"}}
    | _BOUNDED
    | {"value": number("In its unit.", required=True)}
)
QUANTITIES: Final = by_name("Declarations of quantities, by id.", table("A quantity.", QUANTITY))
_ANY: Final = {name: key for keys in KEYS.values() for name, key in keys.items()}
OVERRIDE: Final = Shape(
    {name: Key(key.sort, key.meaning, inside=key.inside, words=key.words, form=key.form)
     for name, key in _ANY.items()}
    | {"parts": strings("The parts that the change holds in; absent is all.")}
)  # fmt: skip
OVERRIDES: Final = by_name(
    "Single keys that change in a quantity of another part, by its id.",
    table("What changes.", OVERRIDE),
)
