"""Reports for other programs: everything that was found, in sentences of one language."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, ClassVar

from gripcourse.exports.files import Fate
from gripcourse.exports.plain import from_plain, to_plain
from gripcourse.grading.model import Against, Decision, KnownBy, Outcome


@dataclass(frozen=True, slots=True)
class FindingResult:
    """The judgement of one quantity; values are in its declared unit, null where there is none.

    Attributes:
        quantity, section: ids.
        outcome: what was found.
        against: what the answer was judged against.
        given: the student's value.
        typed: what the cell shows.
        cell: where it stands.
        reference: the reference value.
        expected: the value at the student's own inputs.
        band: how far the answer may be from the expected value.
        points, max_points: earned and possible.
        slip: id of the recognised slip, empty for none.
        tied: ids of other slips that explain the answer as well.
        roots: ids of the quantities whose wrong answers explain this one.
        message: the verdict in a sentence.
        remarks: hints and notes that go with it.
        decision: of a person; null for none.
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
    band: float | None
    points: float
    max_points: float
    slip: str
    tied: tuple[str, ...]
    roots: tuple[str, ...]
    message: str
    remarks: tuple[str, ...]
    decision: Decision | None = None

    @property
    def is_open(self) -> bool:
        """Whether a person still has to decide about the item."""
        return self.outcome.traits.waits and self.decision is None


@dataclass(frozen=True, slots=True)
class CauseResult:
    """What explains several answers.

    Attributes:
        quantity: id of the quantity at the root.
        explains: ids of the answers that follow from it, in order of calculation.
        message: for the student.
    """

    quantity: str
    explains: tuple[str, ...]
    message: str


@dataclass(frozen=True, slots=True)
class FlagResult:
    """Something a person should look at before the marks are published.

    Attributes:
        code: the same in every language.
        message: a sentence.
        others: ids of other students whom it concerns, the likeliest first.
        rests_on: ids of the quantities that are the evidence, the strongest first.
        in_languages: the same sentence in every language, by its code.
    """

    code: str
    message: str
    others: tuple[str, ...] = ()
    rests_on: tuple[str, ...] = ()
    in_languages: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class ReportResult:
    """The judgement of one submission.

    Attributes:
        file: its name as it was given.
        student: id; empty where nobody could be told.
        name: as the roster writes it.
        variant, scheme: ids.
        options: what the variant chooses.
        judged: false where the file could not be judged at all; the flags say why.
        score, max_score: in points, without what waits for a person; null where not judged. All
            points are to six decimals.
        open_points: points of what waits for a person.
        flags: for the instructor.
        remarks: about the workbook as a whole, for the student.
        causes: what explains several answers, those that explain most first.
        findings: one for each answered or manual quantity, in the order of the assignment.
        digest: SHA-256 of the file's bytes, hexadecimal; empty where it could not be read.
        known_by: what told whose file it is: `person`, `signature`, `platform`, `file_name` or
            nothing.
        earned: what is left of the score after lateness; null where not judged or not known.
        days_late: days begun after the deadline that cost something; null where there is a deadline
            and nobody knows when the work was handed in, so that nothing is taken off.
        counts: whether it is the work of the student that counts; null where there are several and
            the policy does not say which.
        percent: score as a percentage of the points that wait for nobody; null where not judged.
        earned_percent: the same of what is left after lateness; null where not judged or not known.
        scales: by the id of each scale of the policy, what the earned points are called, in the
            language of the sentences; empty where points that wait for a person decide.
    """

    SCHEMA: ClassVar[str] = "gripcourse/report/1"

    file: str
    student: str
    name: str
    variant: str
    scheme: str
    options: Mapping[str, str]
    judged: bool
    score: float | None
    max_score: float | None
    open_points: float
    flags: tuple[FlagResult, ...]
    remarks: tuple[str, ...]
    causes: tuple[CauseResult, ...]
    findings: tuple[FindingResult, ...]
    digest: str = ""
    known_by: KnownBy = KnownBy.NOTHING
    earned: float | None = None
    days_late: int | None = 0
    counts: bool | None = True
    percent: float | None = None
    scales: Mapping[str, str] = field(default_factory=dict)
    earned_percent: float | None = None

    @property
    def points_that_count(self) -> float | None:
        """What is left after lateness; the score where the batch does not say it."""
        return self.score if self.earned is None else self.earned

    @property
    def points_lost(self) -> float:
        """Points that lateness took off."""
        return (self.score or 0.0) - (self.points_that_count or 0.0)

    def to_dict(self) -> dict[str, Any]:
        """Return the plain form, for JSON."""
        return dict(to_plain(self))

    @classmethod
    def from_dict(cls, plain: Mapping[str, Any]) -> "ReportResult":
        """Read the plain form; see `exports.plain.from_plain`."""
        return from_plain(cls, plain)


@dataclass(frozen=True, slots=True)
class FileResult:
    """What became of a file that was found.

    Attributes:
        file: its name as it was found.
        fate: `graded`, `refused`, `to_a_person` or `not_looked_at`.
        student: id; empty where nobody can be told.
        why: code of the reason why it was not graded; empty for none.
        message: the reason in a sentence.
    """

    file: str
    fate: Fate
    student: str
    why: str
    message: str


@dataclass(frozen=True, slots=True)
class MissingResult:
    """A student of the register of whom a batch has no work.

    Attributes:
        student: id.
        name, group, email: as the register has them; empty where it does not.
    """

    student: str
    name: str
    group: str
    email: str


@dataclass(frozen=True, slots=True)
class GradesResult:
    """What a batch came to.

    Attributes:
        reports: one per file, in order.
        needs_person: whether something waits for a person: a flag of any report, or a file that was
            not looked at and may be somebody's work.
        incidents: what failed on our side, each with its trace.
        files: every file that was found, also those that were not looked at.
        missing: who has handed in nothing, by id.
    """

    SCHEMA: ClassVar[str] = "gripcourse/grades/1"

    reports: tuple[ReportResult, ...]
    needs_person: bool
    incidents: tuple[str, ...] = ()
    files: tuple[FileResult, ...] = ()
    missing: tuple[MissingResult, ...] = ()

    def to_dict(self) -> dict[str, Any]:
        """Return the plain form, for JSON."""
        return dict(to_plain(self))

    @classmethod
    def from_dict(cls, plain: Mapping[str, Any]) -> "GradesResult":
        """Read the plain form; see `exports.plain.from_plain`."""
        return from_plain(cls, plain)
