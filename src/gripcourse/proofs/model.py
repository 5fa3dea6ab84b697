"""What is proved of a course, and what came out."""

from dataclasses import dataclass
from enum import StrEnum

from gripcourse.errors import Problem
from gripcourse.text.words import Message


class ProofKind(StrEnum):
    """What a proof compares a course with."""

    EXAMPLE = "example"  # the printed numbers of a worked example
    PUBLISHED_CASE = "published_case"  # the printed numbers of another calculation
    VIRTUAL_WORK = "virtual_work"  # a force ratio against the motion of the links
    MOTION = "motion"  # what describes a position against the coordinates there
    TRAVEL = "travel"  # a path against the coordinates at its ends
    INTERFERENCE = "interference"  # the bodies of the general view against one another
    IDENTITY = "identity"  # two formulas of the author's that must agree
    INEQUALITY = "inequality"  # a condition of the author's that must hold
    EQUILIBRIUM = "equilibrium"  # forces against the sums over free bodies
    OPERATORS = "operators"  # one operator flipped must break one of the above
    WRONG_METHODS = "wrong_methods"  # every slip and erratum shows, and is named
    PRINTED_LINES = "printed_lines"  # the printed substitution reads back to the result
    WORKBOOKS = "workbooks"  # LibreOffice recalculates the key workbooks


class Verdict(StrEnum):
    """How a proof ended."""

    HOLDS = "holds"
    FAILS = "fails"
    OPEN = "open"  # could not be tried here, or does not apply to the numbers that there are


@dataclass(frozen=True, slots=True)
class Proof:
    """One statement about a course.

    Attributes:
        kind: what the course is compared with.
        name: short, for a line of output: a scheme's id, or an id that the author gave.
        file, key: where it is declared, for messages.
    """

    kind: ProofKind
    name: str
    file: str
    key: str


@dataclass(frozen=True, slots=True)
class ProofResult:
    """How one proof ended.

    Attributes:
        proof: what was to be proved.
        verdict: whether it holds.
        compared: how many numbers or formulas were compared.
        problems: what is wrong where it fails, one for each place that somebody has to correct.
        note: what else there is to say, for example why it was not tried; None for nothing.
    """

    proof: Proof
    verdict: Verdict
    compared: int
    problems: tuple[Problem, ...] = ()
    note: Message | None = None


def concluded(
    proof: Proof, compared: int, problems: tuple[Problem, ...], note: Message | None = None
) -> ProofResult:
    """Conclude a proof that was tried: it holds where it found no problem."""
    verdict = Verdict.FAILS if problems else Verdict.HOLDS
    return ProofResult(proof, verdict, compared, problems, note)


def short_name(file: str) -> str:
    """Return the name of a file of declarations: `sections/pin`, `schemes/screw`."""
    return file.removeprefix("variants/").removesuffix(".toml").removesuffix("/scheme")
