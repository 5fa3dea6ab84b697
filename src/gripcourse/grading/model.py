"""The result of grading: findings, flags and a report. Plain values, rendered elsewhere."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field, fields
from datetime import datetime
from enum import StrEnum
from operator import attrgetter
from typing import Final

from gripcourse.course.composition import Composition
from gripcourse.grading.flag_code import FlagCode
from gripcourse.grading.known_by import KnownBy
from gripcourse.grading.outcome import Outcome
from gripcourse.slips.model import SlipId
from gripcourse.text.words import Message

__all__ = [
    "Against", "Cause", "Decision", "Finding", "Flag", "FlagCode", "KnownBy", "Outcome",
    "PointSums", "Report", "Timing", "sums_of",
]  # fmt: skip


class Against(StrEnum):
    """What an answer was judged against."""

    REFERENCE = "reference"
    OWN_INPUTS = "own_inputs"
    PRINTED = "printed"  # an erratum of a source, accepted by policy
    ALTERNATIVE = "alternative"  # another honest reading that the quantity declares
    NOTHING = "nothing"


@dataclass(frozen=True, slots=True)
class Decision:
    """What a person decided about an item.

    Attributes:
        automatic: what the program had found by itself.
        credit: share of the item's points that the person gave, 0…1.
        lines: share of its points that each line of the rubric earned; empty without a rubric.
        marker: who decided.
        decided_at: when.
        comment: for the student, in the marker's words; empty for none.
        outdated: whether the file or the automatic results are others than the person saw.
    """

    automatic: Outcome
    credit: float
    lines: Mapping[str, float]
    marker: str
    decided_at: datetime
    comment: str
    outdated: bool


@dataclass(frozen=True, slots=True)
class Finding:
    """The judgement of one quantity.

    Attributes:
        quantity, section: ids.
        outcome: what was found.
        against: what the answer was judged against.
        given: the student's value, in the declared unit; None for none.
        typed: what the cell shows.
        cell: where it stands.
        reference: the reference value, in the declared unit; None where there is none.
        expected: the value at the student's own inputs, in the declared unit; None for none.
        band: how far the answer may be from the expected value, in the declared unit.
        inputs: the student's own numbers and given values that `expected` was computed from, in
            declared units, by id: what the worked line substitutes.
        points, max_points: earned and possible.
        slip: the recognised slip, None for none.
        message: the verdict in a sentence.
        remarks: hints and notes that go with it.
        tied: other slips that explain the answer as well.
        roots: ids of the quantities whose wrong answers explain this one.
        half_unit: half a unit of the last typed digit, in the declared unit.
        low, high: the range of `expected` that the rounding of earlier answers leaves.
        decision: a person's, whose points count; the outcome is MANUAL then. None for none.
    """

    quantity: str
    section: str
    outcome: Outcome
    against: Against
    given: float | None
    typed: str
    cell: str
    reference: float | None
    expected: float | None
    band: float
    inputs: Mapping[str, float]
    points: float
    max_points: float
    slip: SlipId | None
    message: Message
    remarks: tuple[Message, ...]
    tied: tuple[SlipId, ...] = ()
    roots: tuple[str, ...] = ()
    half_unit: float = 0.0
    low: float | None = None
    high: float | None = None
    decision: Decision | None = None

    def __reduce__(self) -> "tuple[type[Finding], tuple[object, ...]]":
        # As messages: half the time that dataclasses take of themselves.
        return Finding, _parts_of(self)

    @property
    def is_open(self) -> bool:
        """Whether a person still has to decide about the item."""
        return self.outcome.traits.waits and self.decision is None


_parts_of: Final = attrgetter(*(one.name for one in fields(Finding)))


@dataclass(frozen=True, slots=True)
class PointSums:
    """Points of findings: earned and possible of what is decided, possible of what is open."""

    score: float
    max_score: float
    open_points: float


def sums_of(findings: Sequence[Finding]) -> PointSums:
    """Add up points; what waits for a person counts neither for nor against the student."""
    closed = [one for one in findings if not one.is_open]
    return PointSums(
        score=sum(one.points for one in closed),
        max_score=sum(one.max_points for one in closed),
        open_points=sum(one.max_points for one in findings if one.is_open),
    )


@dataclass(frozen=True, slots=True)
class Cause:
    """What explains several answers: a wrong answer of the student's, or a number used wrongly.

    Attributes:
        quantity: id of the quantity at the root.
        explains: ids of the answers that follow from it, in order of calculation.
        message: for the student.
    """

    quantity: str
    explains: tuple[str, ...]
    message: Message


@dataclass(frozen=True, slots=True)
class Flag:
    """Something a person should look at before the marks are published.

    Attributes:
        code: why.
        message: the same in a sentence.
        others: other students whom it concerns, by id, the likeliest first.
        rests_on: ids of the quantities that are the evidence, the strongest first.
    """

    code: FlagCode
    message: Message
    others: tuple[str, ...] = ()
    rests_on: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Timing:
    """When a work was handed in, what lateness costs, and whether the work counts.

    Attributes:
        number, of: which of the student's works it is, and how many there are.
        counts: whether it is the one that counts.
        handed_in: None where nobody knows.
        deadline: None for none.
        days_late: days begun after the deadline; 0 within it or its grace.
        deduction: share of the points that is taken off.
        waived: why lateness is not counted, in the words of a person; empty where it is.
        waived_until: until when it is not; None for good, or where it is not waived.
    """

    number: int
    of: int
    counts: bool
    handed_in: datetime | None
    deadline: datetime | None
    days_late: int
    deduction: float
    waived: str
    waived_until: datetime | None = None

    @property
    def is_unknown(self) -> bool:
        """Whether there is a deadline, and nobody knows whether the work came before it."""
        return self.deadline is not None and self.handed_in is None


def after_lateness(points: float, timing: Timing | None) -> float:
    """Return what lateness leaves of points; all of them where no rule says anything."""
    return points if timing is None else points * (1 - timing.deduction)


@dataclass(frozen=True, slots=True)
class Report:
    """The judgement of one submission.

    Attributes:
        file: path as the user gave it.
        student: id; empty where nobody could be told.
        name: as the roster writes it.
        variant, scheme: ids.
        options: what the variant chooses.
        language: of the student's documents.
        score, max_score: in points; what waits for a person counts in neither.
        open_points: points of what waits for a person.
        flags: for the instructor.
        findings: one for each answered or manual quantity, in the order of the assignment.
        remarks: about the workbook as a whole.
        judged: False where the file could not be judged at all; the flags say why.
        digest: SHA-256 of the file's bytes, hexadecimal; empty where it could not be read.
        causes: root causes of several answers, those that explain most first.
        givens: given values as they stand in the workbook, in declared units.
        creator: the author that the workbook names; empty for none.
        known_by: what told whose file it is.
        refusal: code of the reason why the file cannot be read; empty for none.
        timing: attempts and lateness; None where the policy has no rule for them.
        lacks_results: whether answers are formulas whose results the file does not store.
        unverified: whether formulas store results that nobody computed once more.
        unopened: whether LibreOffice was asked for more of the file, and gave it up.
        version: of the student's assignment, that the work was judged by.
        made_for: version that the workbook was made for.
        either_version: whether several versions were tried, of which the best one counts.
        declarations: fingerprint of those that it was judged by; empty for today's.
    """

    file: str
    student: str
    name: str
    variant: str
    scheme: str
    options: Mapping[str, str]
    language: str
    score: float
    max_score: float
    open_points: float
    flags: tuple[Flag, ...]
    findings: Collection[Finding]
    remarks: tuple[Message, ...]
    judged: bool
    digest: str = ""
    causes: tuple[Cause, ...] = ()
    givens: Mapping[str, float] = field(default_factory=dict)
    creator: str = ""
    known_by: KnownBy = KnownBy.NOTHING
    refusal: str = ""
    timing: Timing | None = None
    lacks_results: bool = False
    unverified: bool = False
    unopened: bool = False
    version: int = 1
    made_for: int = 1
    either_version: bool = False
    declarations: str = ""

    @property
    def earned(self) -> float:
        """Points that count, after what lateness takes off."""
        return after_lateness(self.score, self.timing)

    @property
    def is_cut(self) -> bool:
        """Whether lateness takes points off."""
        return self.earned < self.score

    @property
    def composition(self) -> Composition:
        """What was computed: the scheme with the options of the variant."""
        return Composition.of(self.scheme, self.options)
