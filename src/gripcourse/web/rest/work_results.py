"""What the server tells programs of grading, flags and regrading; see `results`."""

from dataclasses import dataclass
from datetime import datetime
from typing import ClassVar

from gripcourse.access.desk.model import GradedBatch
from gripcourse.gradebook.regrade import Shift
from gripcourse.usecases.grading.progress import BatchProgress
from gripcourse.usecases.marks.kept_policies import PolicyChange


@dataclass(frozen=True, slots=True)
class FacilityResult:
    """How much of its points a part of the assignment earned.

    Attributes:
        id: of the section or the quantity.
        title: what it is.
        share: mean over the works, 0 to 1.
        works: in which it was asked and is decided.
    """

    id: str
    title: str
    share: float
    works: int


@dataclass(frozen=True, slots=True)
class FiguresResult:
    """What the works of the group that count came to, with the marks of persons.

    Attributes:
        works: how many have points.
        scores: how many of them earned a tenth of the points each after lateness, the lowest first.
        mean, median: of the shares after lateness, 0 to 1; null where there is no work.
        sections: in the order of the course; before lateness.
        items: the hardest first; before lateness.
    """

    SCHEMA: ClassVar[str] = "gripcourse/figures/1"

    works: int
    scores: tuple[int, ...]
    mean: float | None
    median: float | None
    sections: tuple[FacilityResult, ...]
    items: tuple[FacilityResult, ...]


@dataclass(frozen=True, slots=True)
class EvidenceResult:
    """A number that a likeness rests on, as both typed it.

    Attributes:
        quantity: id.
        title: what it is.
        here, there: what was typed in either work; empty for nothing.
        right_here, right_there: what would have been right in either variant.
    """

    quantity: str
    title: str
    here: str
    there: str
    right_here: str
    right_there: str


@dataclass(frozen=True, slots=True)
class OtherWorkResult:
    """A work that a flag lays beside the flagged one.

    Attributes:
        student: id.
        name: empty where the register has the student no longer.
        numbers: that the flag rests on.
    """

    student: str
    name: str
    numbers: tuple[EvidenceResult, ...]


@dataclass(frozen=True, slots=True)
class FlagWithEvidenceResult:
    """Something a person should look at before results are published.

    Attributes:
        code: the same in every language.
        message: a sentence.
        beside: other works that it concerns.
    """

    code: str
    message: str
    beside: tuple[OtherWorkResult, ...]


@dataclass(frozen=True, slots=True)
class StudentFlagsResult:
    """The flags of a student, with their evidence.

    Attributes:
        flags: in the order of the works.
    """

    SCHEMA: ClassVar[str] = "gripcourse/student_flags/1"

    flags: tuple[FlagWithEvidenceResult, ...]


@dataclass(frozen=True, slots=True)
class FlaggedWorkResult:
    """A work that somebody should look at.

    Attributes:
        student: id; empty where nobody can be told.
        name: empty where the register has no such student.
        file: its name.
        codes: of the flags.
        messages: the flags in sentences, in the same order.
    """

    student: str
    name: str
    file: str
    codes: tuple[str, ...]
    messages: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class FlagsResult:
    """What the last batch flagged; flags are questions, not verdicts.

    Attributes:
        at: when files were graded last; null for never.
        works: that are flagged.
    """

    SCHEMA: ClassVar[str] = "gripcourse/flags/1"

    at: datetime | None
    works: tuple[FlaggedWorkResult, ...]


@dataclass(frozen=True, slots=True)
class GradingResult:
    """The batch that is being graded, and those before.

    Attributes:
        runs: whether one is at work.
        silent: whether nothing was heard of it for minutes: it may be begun again.
        failed: whether the one that was begun here last did not come to its end.
        progress: how far it is; null where none has begun, or it is about to begin or to end.
        last: when files were graded last; null for never.
        waiting: workbooks that a batch would grade.
        batches: oldest first.
    """

    SCHEMA: ClassVar[str] = "gripcourse/grading/1"

    runs: bool
    silent: bool
    failed: bool
    progress: BatchProgress | None
    last: datetime | None
    waiting: int
    batches: tuple[GradedBatch, ...]


@dataclass(frozen=True, slots=True)
class ChangedItemResult:
    """What a regrade changes about an item; null where it is not asked for.

    Attributes:
        item: id of the quantity.
        before, after: points.
    """

    item: str
    before: float | None
    after: float | None


@dataclass(frozen=True, slots=True)
class ChangedWorkResult:
    """What a regrade comes to for a work that would get other results.

    Attributes:
        student: id.
        digest: SHA-256 of the file, hexadecimal.
        direction: whether the share of all points grows or falls.
        told: whether the student was told the result.
        before, after: points, with the marks of persons.
        items: those whose result is another.
    """

    student: str
    digest: str
    direction: Shift
    told: bool
    before: float
    after: float
    items: tuple[ChangedItemResult, ...]


@dataclass(frozen=True, slots=True)
class RegradingResult:
    """What today's course and policy would change; nothing counts yet.

    Attributes:
        seen: of what would change; goes back to apply it.
        raised, lowered, unchanged: how many works.
        works: that would get other results.
        failed: files that could not be graded.
        missing: students with a work that was graded and is not here.
        policies: that works were graded by, each with what differs today.
    """

    SCHEMA: ClassVar[str] = "gripcourse/regrading/1"

    seen: str
    raised: int
    lowered: int
    unchanged: int
    works: tuple[ChangedWorkResult, ...]
    failed: tuple[str, ...]
    missing: tuple[str, ...]
    policies: tuple[PolicyChange, ...]


@dataclass(frozen=True, slots=True)
class RegradeResult:
    """A regrade that was applied, or one that takes another back.

    Attributes:
        number: counts all from 1.
        undoes: number of the one that it takes back; null for one that was applied.
        by: who did it.
        why: the reason.
        at: when.
    """

    SCHEMA: ClassVar[str] = "gripcourse/regrade/1"

    number: int
    undoes: int | None
    by: str
    why: str
    at: datetime


@dataclass(frozen=True, slots=True)
class RegradesResult:
    """The regrades that stand.

    Attributes:
        regrades: oldest first.
    """

    SCHEMA: ClassVar[str] = "gripcourse/regrades/1"

    regrades: tuple[RegradeResult, ...]
