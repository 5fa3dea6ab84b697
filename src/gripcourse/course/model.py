"""A course after loading: frozen values, nothing computed yet.

Values of quantities are kept in the declared unit (as people wrote them); the solver works in SI.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from gripcourse.course.diagram import Diagram
from gripcourse.course.errata import Erratum
from gripcourse.course.kinematics import JointPosition, Kinematics
from gripcourse.course.note import CourseNote
from gripcourse.course.toml_table import Table
from gripcourse.course.view import View
from gripcourse.formula.functions import is_entry
from gripcourse.formula.tree import Formula
from gripcourse.text.words import Texts


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
    """Where a declaration comes from: a work of the course's list, an equation, a note."""

    work: str
    equation: str = ""
    note: Texts | None = None


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
    """An anticipated wrong method: the value it gives, its credit (0…1) and the hint it earns."""

    id: str
    formula: Formula
    credit: float
    hint: Texts


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
class Choice:
    """The rule of a design decision.

    Attributes:
        column: `catalogue.column` of the preferred series; the reference is taken from it.
        also: further series that are accepted, for example the second row of a standard.
        rounding: which entry is the reference for the required value.
        condition: what the chosen value must also satisfy, None for nothing more.
        steps: how many entries of the preferred series above the smallest admissible one are still
            not wasteful; None for no limit.
    """

    column: str
    also: tuple[str, ...]
    rounding: Rounding
    condition: Formula | None
    steps: int | None


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
        source: where it comes from.
        formula: computes a FORMULA or PICK; the condition of a VERDICT; for a CHOICE the value
            that the chosen entry must not be below; None for the others.
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
        must_hold: of a VERDICT, whether a variant in which the answer is no is refused; False for
            the others.
        rubric: id of the rubric of a MANUAL item, empty for the others.
        file: the file that declares it, for messages.
        uses: ids that its formulas use, sorted. Kept, because a course has thousands of
            compositions and each asks for them.
    """

    id: str
    section: str
    kind: Kind
    symbol: Texts
    unit: str
    title: Texts
    explain: Texts | None
    source: Source
    formula: Formula | None
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
    must_hold: bool
    rubric: str
    file: str
    uses: tuple[str, ...] = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        """Find what is used once."""
        found = {name for formula in self.formulas() for name in formula.names}
        object.__setattr__(self, "uses", tuple(sorted(found)))

    @property
    def exact(self) -> bool:
        """Whether its answer is taken as it stands: a size, an entry of a table, yes or no.

        No figure of such an answer is left out, so it differs from the right one or it does not.
        What is interpolated between entries is a computed number like any other.
        """
        if self.kind is Kind.PICK:
            return self.formula is not None and is_entry(self.formula.tree)
        return self.kind in {Kind.CHOICE, Kind.VERDICT}

    def formulas(self) -> Iterator[Formula]:
        """Yield every formula that the declaration holds."""
        for one in (self.formula, self.valid):
            if one is not None:
                yield one
        if self.choice is not None and self.choice.condition is not None:
            yield self.choice.condition
        for slip in self.slips:
            yield slip.formula
        for printed in self.as_printed:
            if printed.formula is not None:
                yield printed.formula


@dataclass(frozen=True, slots=True)
class OptionChoice:
    """One value of an option and the parts that it brings."""

    id: str
    title: Texts
    parts: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Option:
    """Something that a variant chooses, for example the drive; it selects among shared parts."""

    id: str
    title: Texts
    choices: tuple[OptionChoice, ...]


@dataclass(frozen=True, slots=True)
class Part:
    """A file of declarations that many schemes share."""

    id: str
    quantities: Mapping[str, Quantity]
    file: str


@dataclass(frozen=True, slots=True)
class WorkedExample:
    """A calculation published elsewhere, as data.

    Attributes:
        source: where it is printed.
        options: the options it uses.
        given: values of givens and constants, in declared units.
        chosen: design decisions it takes, in declared units, by convention.
        expected: value and tolerated difference of each quantity, in declared units, by convention.
    """

    source: Source
    options: Mapping[str, str]
    given: Mapping[str, float]
    chosen: Mapping[Convention, Mapping[str, float]]
    expected: Mapping[Convention, Mapping[str, tuple[float, float]]]


@dataclass(frozen=True, slots=True)
class Scheme:
    """A kinematic scheme: what it shares, what it declares, what a variant of it chooses.

    Attributes:
        id: name of its folder.
        title: in full.
        task: a sentence for the assignment.
        parts: ids of the parts that every variant has.
        options: what a variant chooses.
        quantities: its own declarations.
        overrides: declarations of parts as it changes them, by part and quantity.
        kinematics: how its links move, its own or that of a part; None where nothing moves.
        example: None where there is none.
        file: the file that declares it, for messages.
    """

    id: str
    title: Texts
    task: Texts
    parts: tuple[str, ...]
    options: tuple[Option, ...]
    quantities: Mapping[str, Quantity]
    overrides: Mapping[str, Mapping[str, Quantity]]
    kinematics: Kinematics | None
    diagram: Diagram | None
    view: View | None
    example: WorkedExample | None
    file: str


@dataclass(frozen=True, slots=True)
class Section:
    """A section of the assignment, in the order in which it is handed out.

    Attributes:
        id: name in declarations.
        title: in full.
        short: what fits a tab of a workbook or a column of a table.
        task: what is to be done in it.
    """

    id: str
    title: Texts
    short: Texts
    task: Texts


@dataclass(frozen=True, slots=True)
class Work:
    """A work that declarations cite.

    Attributes:
        id: short name in declarations.
        title: of a published work the same in every language, which is the work's own.
    """

    id: str
    title: Texts


@dataclass(frozen=True, slots=True)
class Catalogue:
    """A table of standard sizes.

    Attributes:
        id: its name in formulas.
        columns: in SI, one array per column, all of one length; the first is the size itself.
        units: declared unit of each column.
        source: standard and edition, and how the numbers were obtained.
        file: where it was read.
    """

    id: str
    columns: Mapping[str, NDArray[np.float64]]
    units: Mapping[str, str]
    source: Texts
    file: str


@dataclass(frozen=True, slots=True, eq=False)
class Course:
    """Everything that an instructor wrote, loaded.

    Two courses are never the same one, so that what was made of one can be remembered by it.

    Attributes:
        id: short name that goes into signatures.
        title: of the course or the assignment.
        language: default language of students' documents.
        sections: in order.
        works, errata: cited works, and what is wrong in them.
        constants: quantities every scheme knows, for example gravity.
        parts, schemes, catalogues: by id.
        convention: whose version of a formula is the reference.
        positions: of the drive, that schemes may have, by id in order.
        notes: sentences that its documents print.
        root: the folder with `variants`, `templates` and `grader`.
    """

    id: str
    title: Texts
    language: str
    sections: tuple[Section, ...]
    works: Mapping[str, Work]
    errata: Mapping[str, Erratum]
    constants: Mapping[str, Quantity]
    parts: Mapping[str, Part]
    schemes: Mapping[str, Scheme]
    catalogues: Mapping[str, Catalogue]
    convention: Convention
    positions: Mapping[str, JointPosition]
    notes: tuple[CourseNote, ...]
    root: Path

    @property
    def conventions(self) -> tuple[Convention, ...]:
        """Those that differ in this course: without errata nothing is printed otherwise."""
        return tuple(Convention) if self.errata else (Convention.CORRECTED,)
