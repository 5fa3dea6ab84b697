"""Reports for other programs: everything that was found, in sentences of one language."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, ClassVar

from gripcourse.documents.report.standing import percent_of, standing_of
from gripcourse.exports.files import Fate, FileAccount, graded_account, reason_of
from gripcourse.exports.plain import from_plain, to_plain
from gripcourse.grading.model import (
    Against,
    Decision,
    Finding,
    Flag,
    FlagCode,
    KnownBy,
    Outcome,
    Report,
)
from gripcourse.policy.scales import Scale, certain_grade
from gripcourse.text.words import LANGUAGES, Message, Words
from gripcourse.variants.model import Student


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
        days_late: days begun after the deadline that cost something.
        counts: whether it is the work of the student that counts; null where there are several and
            the policy does not say which.
        percent: score as a percentage of the points that wait for nobody; null where not judged.
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
    days_late: int = 0
    counts: bool | None = True
    percent: float | None = None
    scales: Mapping[str, str] = field(default_factory=dict)

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


def grades_result(
    reports: Sequence[Report],
    words: Words,
    incidents: Sequence[str] = (),
    others: Sequence[FileAccount] = (),
    scales: Sequence[Scale] = (),
    missing: Sequence[Student] = (),
) -> GradesResult:
    """Put the reports of a batch into words for another program.

    Args:
        reports: of the files that were read.
        words: their language.
        incidents: what failed on our side.
        others: files that were found and not looked at.
        scales: of the policy.
        missing: students of whom there is nothing.
    """
    made = tuple(report_result(report, words, scales) for report in reports)
    return replace(around_reports(reports, words, incidents, others, missing), reports=made)


def around_reports(
    reports: Sequence[Report],
    words: Words,
    incidents: Sequence[str] = (),
    others: Sequence[FileAccount] = (),
    missing: Sequence[Student] = (),
) -> GradesResult:
    """Return what a batch came to but for the reports themselves; see `grades_result`."""
    accounts = (*map(graded_account, reports), *others)
    flagged = any(one.needs_person for one in accounts)
    files = tuple(
        FileResult(one.file, one.fate, one.student, one.why, reason_of(one, words))
        for one in accounts
    )
    lacking = tuple(MissingResult(one.id, one.name, one.group, one.email) for one in missing)
    return GradesResult((), flagged, tuple(incidents), files, lacking)


def report_result(report: Report, words: Words, scales: Sequence[Scale] = ()) -> ReportResult:
    """Put a report into words for another program; scales are those of the policy."""
    standing = standing_of(report)
    called = {one.id: certain_grade(one, standing, words) for one in scales}
    return ReportResult(
        file=report.file,
        student=report.student,
        name=report.name,
        variant=report.variant,
        scheme=report.scheme,
        options=dict(report.options),
        judged=report.judged,
        score=_points(report.score) if report.judged else None,
        max_score=_points(report.max_score) if report.judged else None,
        open_points=_points(report.open_points),
        flags=tuple(_flag_result(one, words) for one in report.flags),
        remarks=_said(report.remarks, words),
        causes=tuple(
            CauseResult(one.quantity, one.explains, words.say(one.message)) for one in report.causes
        ),
        findings=tuple(finding_result(one, words) for one in report.findings),
        digest=report.digest,
        known_by=report.known_by,
        earned=_points(report.earned) if report.judged else None,
        days_late=0 if report.timing is None else report.timing.days_late,
        counts=_counts(report),
        percent=percent_of(report) if report.judged else None,
        scales=called if report.judged else {},
    )


def _counts(report: Report) -> bool | None:
    """Tell whether a work counts; None where nobody has decided which of several does."""
    if any(one.code is FlagCode.SEVERAL_FILES for one in report.flags):
        return None
    return report.timing is None or report.timing.counts


def _points(value: float) -> float:
    return round(value, 6)  # what adding up in another order changes is not said


def finite(value: float | None) -> float | None:
    """Return a number that JSON can hold, None for none."""
    return value if value is not None and math.isfinite(value) else None


def _flag_result(flag: Flag, words: Words) -> FlagResult:
    in_languages = {language: Words(language).say(flag.message) for language in LANGUAGES}
    said = words.say(flag.message)
    return FlagResult(flag.code, said, flag.others, flag.rests_on, in_languages)


def finding_result(finding: Finding, words: Words) -> FindingResult:
    """Put a finding into words for another program."""
    return FindingResult(
        quantity=finding.quantity,
        section=finding.section,
        outcome=finding.outcome,
        against=finding.against,
        given=finite(finding.given),
        typed=finding.typed,
        cell=finding.cell,
        reference=finite(finding.reference),
        expected=finite(finding.expected),
        band=finite(finding.band),
        points=_points(finding.points),
        max_points=_points(finding.max_points),
        slip="" if finding.slip is None else str(finding.slip),
        tied=tuple(map(str, finding.tied)),
        roots=finding.roots,
        message=words.say(finding.message),
        remarks=_said(finding.remarks, words),
        decision=finding.decision,
    )


def _said(sentences: Sequence[Message], words: Words) -> tuple[str, ...]:
    return tuple(words.say(one) for one in sentences)
