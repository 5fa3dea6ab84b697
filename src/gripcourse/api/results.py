"""What the calls of the library return, in sentences of one language; see also `exports`."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from gripcourse.course.quantity import Convention, Kind
from gripcourse.errors import NextStep
from gripcourse.exports.plain import from_plain, to_plain
from gripcourse.grading.self_check import SectionState, State

if TYPE_CHECKING:
    import pandas as pd


@dataclass(frozen=True, slots=True)
class SourceResult:
    """Where a declaration comes from.

    Attributes:
        work: id of the work in the course's list.
        equation: its number there; empty for none.
        note: what else is to be said.
    """

    work: str
    equation: str
    note: str


@dataclass(frozen=True, slots=True)
class ValueResult:
    """A quantity of a solved variant.

    Attributes:
        symbol: as formulas write it.
        title: what it is.
        unit: the declared unit; empty for a plain number.
        value: in the declared unit; null where it has none.
        kind: what kind of quantity it is.
        section: id of its section.
        source: where its formula comes from.
    """

    symbol: str
    title: str
    unit: str
    value: float | None
    kind: Kind
    section: str
    source: SourceResult


@dataclass(frozen=True, slots=True)
class SolutionResult:
    """A solved variant.

    Attributes:
        scheme: id.
        variant: id in the table; empty for a scheme with values of one's own.
        options: what is chosen.
        convention: errata corrected, or as the source prints them.
        values: of every quantity that is computed, by id, in order of calculation.
        assumed: ids of computed quantities whose values were given instead.
    """

    SCHEMA: ClassVar[str] = "gripcourse/solution/1"

    scheme: str
    variant: str
    options: Mapping[str, str]
    convention: Convention
    values: Mapping[str, ValueResult]
    assumed: tuple[str, ...] = ()

    def to_dict(self) -> dict[str, Any]:
        """Return the plain form, for JSON."""
        return dict(to_plain(self))

    @classmethod
    def from_dict(cls, plain: Mapping[str, Any]) -> "SolutionResult":
        """Read the plain form; see `exports.plain.from_plain`."""
        return from_plain(cls, plain)

    def table(self) -> "pd.DataFrame":
        """Return the values as a table: id, symbol, title, unit, value, kind, section, source."""
        import pandas as pd  # noqa: PLC0415 (400 ms)

        rows = [
            (
                name, one.symbol, one.title, one.unit, one.value, one.kind.value, one.section,
                " ".join(part for part in (one.source.work, one.source.equation) if part),
            )
            for name, one in self.values.items()
        ]  # fmt: skip
        heads = ["id", "symbol", "title", "unit", "value", "kind", "section", "source"]
        return pd.DataFrame(rows, columns=heads).astype({"value": "float64"})


@dataclass(frozen=True, slots=True)
class ProblemResult:
    """One thing that somebody has to correct.

    Attributes:
        file: where it is; empty for nowhere in a file.
        key: where in the file.
        what: what is wrong.
        remedy: how to correct it.
        excerpt: lines to show below, for example a formula with a caret.
        parameter: name of the parameter that a call cannot use; empty for none.
        step: what of this program mends it; null for nothing.
    """

    file: str
    key: str
    what: str
    remedy: str
    excerpt: str = ""
    parameter: str = ""
    step: NextStep | None = None


@dataclass(frozen=True, slots=True)
class ProblemsResult:
    """Every problem of a course.

    Attributes:
        problems: none where the course is valid.
        notes: what its author should know though nothing is wrong with it: what nothing uses, and
            what nothing proves; none while there are problems.
    """

    SCHEMA: ClassVar[str] = "gripcourse/problems/1"

    problems: tuple[ProblemResult, ...]
    notes: tuple[ProblemResult, ...] = ()

    @property
    def valid(self) -> bool:
        """Whether there is none."""
        return not self.problems

    def to_dict(self) -> dict[str, Any]:
        """Return the plain form, for JSON."""
        return dict(to_plain(self))

    @classmethod
    def from_dict(cls, plain: Mapping[str, Any]) -> "ProblemsResult":
        """Read the plain form; see `exports.plain.from_plain`."""
        return from_plain(cls, plain)


@dataclass(frozen=True, slots=True)
class VariantResult:
    """The numbers of one individual assignment.

    Attributes:
        id: as the table writes it.
        scheme: id.
        options: what it chooses.
        given: given values by id, in declared units.
    """

    id: str
    scheme: str
    options: Mapping[str, str]
    given: Mapping[str, float]


@dataclass(frozen=True, slots=True)
class DrawingTallyResult:
    """How drawing went for one scheme.

    Attributes:
        scheme: id.
        tried: candidates judged.
        sound: candidates that can be solved.
    """

    scheme: str
    tried: int
    sound: int


@dataclass(frozen=True, slots=True)
class VariantsResult:
    """Variants of a table.

    Attributes:
        variants: in the order of the table.
        tallies: how they were found; none where they were read.
    """

    SCHEMA: ClassVar[str] = "gripcourse/variants/1"

    variants: tuple[VariantResult, ...]
    tallies: tuple[DrawingTallyResult, ...] = ()

    def to_dict(self) -> dict[str, Any]:
        """Return the plain form, for JSON."""
        return dict(to_plain(self))

    @classmethod
    def from_dict(cls, plain: Mapping[str, Any]) -> "VariantsResult":
        """Read the plain form; see `exports.plain.from_plain`."""
        return from_plain(cls, plain)


@dataclass(frozen=True, slots=True)
class HandoutResult:
    """What became of one student's documents.

    Attributes:
        student: id.
        files: paths of what was written.
        faults: what could not be written, each in a sentence.
    """

    student: str
    files: tuple[str, ...]
    faults: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class IssueResult:
    """What was issued.

    Attributes:
        handouts: one per student, in the order of the roster.
        notes: for the instructor.
    """

    SCHEMA: ClassVar[str] = "gripcourse/issue/1"

    handouts: tuple[HandoutResult, ...]
    notes: tuple[str, ...]

    def to_dict(self) -> dict[str, Any]:
        """Return the plain form, for JSON."""
        return dict(to_plain(self))

    @classmethod
    def from_dict(cls, plain: Mapping[str, Any]) -> "IssueResult":
        """Read the plain form; see `exports.plain.from_plain`."""
        return from_plain(cls, plain)


@dataclass(frozen=True, slots=True)
class CheckedAnswerResult:
    """What a student learns about one answer before the deadline; never the reference.

    Attributes:
        quantity: id.
        symbol, title, unit: as the workbook shows them.
        state: what is known about it.
        value: as it was read, in the declared unit; null for none.
        typed: what the cell shows.
        cell: where it stands.
        message: the state in a sentence.
        remarks: on how it was read.
        verdict: whether it is a yes or a no; `value` is 1 or 0 then.
    """

    quantity: str
    symbol: str
    title: str
    unit: str
    state: State
    value: float | None
    typed: str
    cell: str
    message: str
    remarks: tuple[str, ...]
    verdict: bool = False


@dataclass(frozen=True, slots=True)
class CheckedSectionResult:
    """What is said about the numbers of a section, all together.

    Attributes:
        section, title: id and name.
        state: what is known about it.
        message: the state in a sentence.
    """

    section: str
    title: str
    state: SectionState
    message: str


@dataclass(frozen=True, slots=True)
class CheckResult:
    """What is said about a workbook before the deadline.

    Attributes:
        refusal: why the file cannot be used, in a sentence; empty where it can.
        answers: in the order of the assignment.
        remarks: about the workbook as a whole.
        sections: whether numbers fit each other; none where only the reading is told.
        left: how often that will be told again; null where nobody counts.
    """

    SCHEMA: ClassVar[str] = "gripcourse/check/1"

    refusal: str
    answers: tuple[CheckedAnswerResult, ...]
    remarks: tuple[str, ...]
    sections: tuple[CheckedSectionResult, ...] = ()
    left: int | None = None

    def to_dict(self) -> dict[str, Any]:
        """Return the plain form, for JSON."""
        return dict(to_plain(self))

    @classmethod
    def from_dict(cls, plain: Mapping[str, Any]) -> "CheckResult":
        """Read the plain form; see `exports.plain.from_plain`."""
        return from_plain(cls, plain)
