"""A quantity after loading: the one declaration of what is computed, chosen or given.

Values are kept in the declared unit (as people wrote them); the solver works in SI.
"""

from collections.abc import Iterator
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Final

from gripcourse.course.multiples import Multiples
from gripcourse.course.toml_table import Table
from gripcourse.formula.functions import is_entry
from gripcourse.formula.tree import Formula
from gripcourse.text.words import Texts

_RULE: Final = ": "  # behind it a title says how a size is chosen


class Kind(StrEnum):
    """What a quantity is to the student."""

    GIVEN = "given"  # a number of the student's variant
    CONSTANT = "constant"  # a number of the course
    FORMULA = "formula"  # computed
    CHOICE = "choice"  # decided by the student inside a rule; the decision is used downstream
    PICK = "pick"  # read from a table by an earlier answer
    VERDICT = "verdict"  # yes or no on a condition
    MANUAL = "manual"  # marked by a person from a rubric

    @property
    def answered(self) -> bool:
        """Whether the student fills a cell of the workbook with it."""
        return self in {Kind.FORMULA, Kind.CHOICE, Kind.PICK, Kind.VERDICT}


class Convention(StrEnum):
    """Whose version of a formula is the reference."""

    CORRECTED = "corrected"
    AS_PRINTED = "as_printed"  # as the sources print it, errata included


class Rounding(StrEnum):
    """Which entry of a series is the reference for a required value."""

    UP = "up"
    NEAREST = "nearest"


@dataclass(frozen=True, slots=True)
class Source:
    """Where a declaration comes from.

    Attributes:
        work: id of the course's list.
        equation: number of the equation, or the paragraph.
        note: what the source says, or how it was obtained.
        mark: how far the source was read; for whoever teaches, never on what is issued.
    """

    work: str
    equation: str = ""
    note: Texts | None = None
    mark: Texts | None = None

    def told(self, language: str) -> str:
        """Return note and mark in a language, as the reference tells them; empty for neither."""
        said = (one.of(language) for one in (self.note, self.mark) if one is not None)
        return "; ".join(filter(None, said))


@dataclass(frozen=True, slots=True)
class Tolerance:
    """A band round an expected value: the wider of a relative and an absolute part.

    Attributes:
        relative: fraction of the expected value.
        absolute: in the quantity's unit; the floor near zero.
    """

    relative: float
    absolute: float


@dataclass(frozen=True, slots=True)
class Slip:
    """An anticipated wrong method: the value it gives, its credit (0…1) and the hint it earns.

    Attributes:
        seldom: whether its value is right, or nearly so, in many variants; it is named where it can
            be told, and no variant is refused for it.
    """

    id: str
    formula: Formula
    credit: float
    hint: Texts
    seldom: bool = False


@dataclass(frozen=True, slots=True)
class AsPrinted:
    """A version of a quantity that a source prints and that is not right.

    Attributes:
        erratum: its number in the list of errata, for example `E4`.
        formula: what the source computes; None where only the rounding differs.
        rounding: how the source rounds a choice; None where the formula differs.
        note: what is wrong with it, for the remark and the reference documentation.
    """

    erratum: str
    formula: Formula | None
    rounding: Rounding | None
    note: Texts


@dataclass(frozen=True, slots=True)
class Alternative:
    """Another honest reading of a quantity: it earns full credit, with a remark.

    Attributes:
        id: its name, unique among those of the quantity.
        formula: what that reading computes; of a CHOICE the value that the entry must not be below.
        remark: for the student: how it was read, and how the sheet means it.
    """

    id: str
    formula: Formula
    remark: Texts


@dataclass(frozen=True, slots=True)
class Choice:
    """The rule of a design decision.

    Attributes:
        column: `catalogue.column` of the preferred series; the reference is taken from it.
        also: further series that are accepted, for example the second row of a standard.
        rounding: which entry is the reference for the required value.
        condition: what the chosen value must also satisfy, None for nothing more.
        steps: how many entries of the preferred series above the smallest admissible one are still
            not wasteful; None for no limit.
        step_up: whether the reference is the smallest size that satisfies the condition too; else
            the condition only checks the size that the rounding takes.
        multiples: what the series is, where it is no catalogue of the author's.
    """

    column: str
    also: tuple[str, ...]
    rounding: Rounding
    condition: Formula | None
    steps: int | None
    step_up: bool = False
    multiples: Multiples | None = None


@dataclass(frozen=True, slots=True)
class Quantity:
    """The one declaration of a quantity.

    Attributes:
        id: its name in formulas, workbooks and outputs.
        section: id of the section it belongs to.
        kind: what it is to the student.
        symbol: as written in formulas, `D_тр` meaning a subscript; per language.
        unit: declared unit in the spelling of `units`; empty for a plain number.
        title: its name in words.
        explain: a sentence on how to think about it, None where there is nothing to add.
        decides: what decides the answer where title and symbol leave it open, for the sheet and
            the workbook: position, convention, sign, rule; None where nothing is left open.
        note_decides: whether the note of the source says it, or a part of it.
        formula_decides: whether its formula is no task but a convention, as of an overall size,
            and stands beside it.
        one_end: why the formula always takes the same where it takes the greater or lesser of two
            values; None where either occurs.
        source: where it comes from.
        formula: computes a FORMULA or PICK; the condition of a VERDICT; for a CHOICE the value
            that the chosen entry must not be below; None for the others.
        route: what gives the same value by another way, from other answers; None for none. Who
            has a wrong number on one way may have gone the other.
        read_from: `catalogue.column` that students may read it from, where its formula reads no
            table; empty for none.
        choice: the rule of a CHOICE, None for the others.
        value: of a CONSTANT, in `unit`; None for the others.
        valid: guard: only a student's value that satisfies it is carried on; None for no guard.
        tolerance: None where the policy's default applies.
        default: of a GIVEN, what an example takes that states no other, in `unit`; None for none.
        range: of a GIVEN, what variants draw it from, as written; None where spaces must say it.
        bounds: lowest and highest value that is physically thinkable, in `unit`.
        integer: whether only whole numbers make sense.
        slips: anticipated wrong methods.
        as_printed: errata of the sources.
        alternatives: other honest readings.
        must_hold: of a VERDICT, whether a variant in which the answer is no is refused; False for
            the others.
        rubric: id of the rubric of a MANUAL item, empty for the others.
        file: the file that declares it, for messages.
        uses: ids that its formulas use, sorted. Kept, because a course has thousands of
            compositions and each asks for them.
        short_title: the title for the middle of a sentence, without a rule behind a colon.
    """

    id: str
    section: str
    kind: Kind
    symbol: Texts
    unit: str
    title: Texts
    explain: Texts | None
    decides: Texts | None
    note_decides: bool
    formula_decides: bool
    one_end: Texts | None
    source: Source
    formula: Formula | None
    route: Formula | None
    read_from: str
    choice: Choice | None
    value: float | None
    valid: Formula | None
    tolerance: Tolerance | None
    default: float | None
    range: Table | None
    bounds: tuple[float, float]
    integer: bool
    slips: tuple[Slip, ...]
    as_printed: tuple[AsPrinted, ...]
    alternatives: tuple[Alternative, ...]
    must_hold: bool
    rubric: str
    file: str
    uses: tuple[str, ...] = field(init=False, repr=False, compare=False)
    short_title: Texts = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        """Find what is used once."""
        found = {name for formula in self.formulas() for name in formula.names}
        object.__setattr__(self, "uses", tuple(sorted(found)))
        object.__setattr__(self, "short_title", _before_colon(self.title))

    @property
    def exact(self) -> bool:
        """Whether its answer is taken as it stands: a size, an entry of a table, yes or no.

        No figure of such an answer is left out, so it differs from the right one or it does not.
        What is interpolated between entries is a computed number like any other.
        """
        if self.kind is Kind.PICK:
            return self.formula is not None and is_entry(self.formula.tree)
        return self.kind in {Kind.CHOICE, Kind.VERDICT}

    @property
    def steps_up(self) -> bool:
        """Whether a larger size is taken where the first does not satisfy its condition."""
        choice = self.choice
        return choice is not None and choice.step_up and choice.condition is not None

    def formulas(self) -> Iterator[Formula]:
        """Yield every formula that the declaration holds."""
        for one in (self.formula, self.route, self.valid):
            if one is not None:
                yield one
        if self.choice is not None and self.choice.condition is not None:
            yield self.choice.condition
        for slip in self.slips:
            yield slip.formula
        for printed in self.as_printed:
            if printed.formula is not None:
                yield printed.formula
        for other in self.alternatives:
            yield other.formula


def _before_colon(title: Texts) -> Texts:
    """Return what comes before the colon in each language; `title` itself where there is none."""
    if not any(_RULE in text for text in title.by_language.values()):
        return title
    texts = {key: text.partition(_RULE)[0] for key, text in title.by_language.items()}
    return Texts(texts)
