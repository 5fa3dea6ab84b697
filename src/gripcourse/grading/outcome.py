"""What can be found out about an answer, and everything that differs by it: one entry for each.

Nothing else in the program asks which outcome it has before it, only what holds of it; so a new
outcome is one entry here, and an entry that leaves something open cannot be written.
"""

from dataclasses import dataclass
from enum import StrEnum
from typing import Final, Self

from gripcourse.text.words import Message, message


@dataclass(frozen=True, slots=True)
class OutcomeTraits:
    """What holds of an outcome.

    Attributes:
        sign: that prints in grey.
        word: for the verdict.
        meaning: what it says, for the legend of a report.
        style: class of the style sheets.
        waits: whether a person has to decide; the points count neither for nor against the student
            until then.
        by_rubric: whether a person marks it in any case.
        typed: whether the student's cell holds anything.
        missing: whether an answer was asked for and none can be judged; causes pass through it.
        right: whether nothing is wrong with the answer by itself.
        coarse: whether it would be right with more figures.
        equals_reference: whether it was found to be the reference, not only to follow from others.
        follows: whether it follows from the student's own earlier numbers, or from one root.
        mistake: whether something was done wrongly in this very answer.
        named: whether the wrong method is known.
        withheld: whether it would count if what it rests on did.
        calculated: whether it shows that somebody calculated: chance does not lead there.
        said_elsewhere: whether the word, or the list of next steps, says all about it already.
        counted: whether statistics have a column for it, in the order of the outcomes.
    """

    sign: str
    word: Message
    meaning: Message
    style: str
    waits: bool
    by_rubric: bool
    typed: bool
    missing: bool
    right: bool
    coarse: bool
    equals_reference: bool
    follows: bool
    mistake: bool
    named: bool
    withheld: bool
    calculated: bool
    said_elsewhere: bool
    counted: bool


class Outcome(StrEnum):
    """What was found out about one answer; the value is its name in JSON and in the gradebook."""

    traits: OutcomeTraits

    def __new__(cls, name: str, traits: OutcomeTraits) -> Self:
        """Make a member: its name in files, and what holds of it."""
        one = str.__new__(cls, name)
        one._value_ = name
        one.traits = traits
        return one

    CORRECT = (
        "correct",
        OutcomeTraits(
            sign="✓",
            word=message("correct"),
            meaning=message("equals the expected value within its tolerance"),
            style="correct",
            waits=False,
            by_rubric=False,
            typed=True,
            missing=False,
            right=True,
            coarse=False,
            equals_reference=True,
            follows=False,
            mistake=False,
            named=False,
            withheld=False,
            calculated=True,
            said_elsewhere=False,
            counted=True,
        ),
    )
    CARRIED = (
        "carried",
        OutcomeTraits(
            sign="↪",
            word=message("carried forward"),
            meaning=message("follows correctly from your own earlier numbers"),
            style="carried",
            waits=False,
            by_rubric=False,
            typed=True,
            missing=False,
            right=True,
            coarse=False,
            equals_reference=False,
            follows=True,
            mistake=False,
            named=False,
            withheld=False,
            calculated=True,
            said_elsewhere=False,
            counted=True,
        ),
    )
    ROUGH = (
        "rough",
        OutcomeTraits(
            sign="≋",
            word=message("too rough"),
            meaning=message("right, but rounded too far"),
            style="carried",
            waits=False,
            by_rubric=False,
            typed=True,
            missing=False,
            right=True,
            coarse=True,
            equals_reference=False,
            follows=False,
            mistake=False,
            named=False,
            withheld=False,
            calculated=False,
            said_elsewhere=False,
            counted=True,
        ),
    )
    SLIP = (
        "slip",
        OutcomeTraits(
            sign="≈",
            word=message("known slip"),
            meaning=message("the result of a known mistake, named below the answer"),
            style="fault",
            waits=False,
            by_rubric=False,
            typed=True,
            missing=False,
            right=False,
            coarse=False,
            equals_reference=False,
            follows=False,
            mistake=True,
            named=True,
            withheld=False,
            calculated=False,
            said_elsewhere=False,
            counted=True,
        ),
    )
    WRONG = (
        "wrong",
        OutcomeTraits(
            sign="✗",
            word=message("wrong"),
            meaning=message("neither the expected value nor one that follows from your numbers"),
            style="fault",
            waits=False,
            by_rubric=False,
            typed=True,
            missing=False,
            right=False,
            coarse=False,
            equals_reference=False,
            follows=False,
            mistake=True,
            named=False,
            withheld=False,
            calculated=False,
            said_elsewhere=False,
            counted=True,
        ),
    )
    UNSUPPORTED = (
        "unsupported",
        OutcomeTraits(
            sign="○",
            word=message("not supported"),
            meaning=message("fits, but rests on numbers that are neither right nor explained"),
            style="fault",
            waits=False,
            by_rubric=False,
            typed=True,
            missing=False,
            right=False,
            coarse=False,
            equals_reference=False,
            follows=False,
            mistake=False,
            named=False,
            withheld=True,
            calculated=False,
            said_elsewhere=False,
            counted=True,
        ),
    )
    BLANK = (
        "blank",
        OutcomeTraits(
            sign="–",
            word=message("blank"),
            meaning=message("the cell is empty; it was not read as zero"),
            style="fault",
            waits=False,
            by_rubric=False,
            typed=False,
            missing=True,
            right=False,
            coarse=False,
            equals_reference=False,
            follows=False,
            mistake=False,
            named=False,
            withheld=False,
            calculated=False,
            said_elsewhere=True,
            counted=True,
        ),
    )
    UNREADABLE = (
        "unreadable",
        OutcomeTraits(
            sign="?",
            word=message("unreadable"),
            meaning=message("no answer can be read in the cell"),
            style="fault",
            waits=False,
            by_rubric=False,
            typed=True,
            missing=True,
            right=False,
            coarse=False,
            equals_reference=False,
            follows=False,
            mistake=False,
            named=False,
            withheld=False,
            calculated=False,
            said_elsewhere=True,
            counted=True,
        ),
    )
    NOT_JUDGED = (
        "not_judged",
        OutcomeTraits(
            sign="…",
            word=message("not judged"),
            meaning=message("could not be judged automatically; the instructor decides"),
            style="waiting",
            waits=True,
            by_rubric=False,
            typed=True,
            missing=False,
            right=False,
            coarse=False,
            equals_reference=False,
            follows=False,
            mistake=False,
            named=False,
            withheld=False,
            calculated=False,
            said_elsewhere=False,
            counted=True,
        ),
    )
    MANUAL = (
        "manual",
        OutcomeTraits(
            sign="✎",
            word=message("by the instructor"),
            meaning=message("marked or decided by the instructor"),
            style="waiting",
            waits=True,
            by_rubric=True,
            typed=False,
            missing=False,
            right=False,
            coarse=False,
            equals_reference=False,
            follows=False,
            mistake=False,
            named=False,
            withheld=False,
            calculated=False,
            said_elsewhere=True,
            counted=False,
        ),
    )


_NAMED: Final = {one.value: one for one in Outcome}


def outcome_named(name: str) -> Outcome:
    """Return the outcome of a name from a file; `ValueError` for a name that is none."""
    found = _NAMED.get(name)
    if found is None:
        raise ValueError(name)
    return found
