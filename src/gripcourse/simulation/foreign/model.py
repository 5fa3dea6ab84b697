"""Students of the second generator as plain values."""

import ast
import math
from collections.abc import Mapping
from dataclasses import dataclass

from gripcourse.grading.model import Report
from gripcourse.simulation.foreign.kinds import ROUGH_GRAVITY, Doing, ForeignMistake, Writing
from gripcourse.slips.model import SlipId


@dataclass(frozen=True, slots=True)
class Habits:
    """How a student computes and writes.

    Attributes:
        writing: how numbers are written down.
        keeps: whether the next step is computed with what the calculator holds.
        pi, gravity: as the student takes them, gravity in m/s².
        as_text: whether answers are typed as text.
        seed: of what is random.
    """

    writing: Writing
    keeps: bool
    pi: float
    gravity: float
    as_text: bool
    seed: int

    @property
    def coarse(self) -> bool:
        """Whether right numbers may leave their bands: they are rounded far, or g is 10."""
        return self.writing.coarse or self.gravity == ROUGH_GRAVITY


@dataclass(frozen=True, slots=True)
class Done:
    """One mistake.

    Attributes:
        kind: what it is.
        root: the quantity that it is made at.
        tree: what is computed there instead; None where the formula is right.
        number: what is used or typed there instead, in the declared unit; NaN where none is.
    """

    kind: ForeignMistake
    root: str
    tree: ast.expr | None = None
    number: float = math.nan


@dataclass(frozen=True, slots=True)
class Calculated:
    """What a student computed.

    Attributes:
        held: what the student went on with, in practical units, by id.
        found: what each formula came to before it was written, in declared units.
        texts: what was written, in declared units; not what has no value.
    """

    held: Mapping[str, float]
    found: Mapping[str, float]
    texts: Mapping[str, str]

    def typed(self, name: str) -> float:
        """Return a written number; NaN where there is none."""
        return float(self.texts.get(name, "nan"))


@dataclass(frozen=True, slots=True)
class ForeignWork:
    """What a student handed in, and what was done: the truth that the grader never sees.

    Attributes:
        student, owner: ids of the student, and of the one whose workbook it is.
        doing: what the student does altogether.
        habits: of the student.
        done: the mistake; None for none.
        reaches: answers that the mistake itself is in: where it was made, or where a misread or
            miscopied number was used directly.
        shown: answers in which it shows first where what it reaches is blank.
        decisions: sizes and verdicts, of which another one may be as right.
        calculated: the numbers.
        cells: what stands in them, by id; blank answers are not there.
        sources: students whose numbers were taken over.
    """

    student: str
    owner: str
    doing: Doing
    habits: Habits
    done: Done | None
    reaches: frozenset[str]
    shown: frozenset[str]
    decisions: frozenset[str]
    calculated: Calculated
    cells: Mapping[str, float | str]
    sources: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class JudgedForeign:
    """What a student of the second generator did, and what the grader says.

    Attributes:
        work: what was done.
        report: what the grader says.
        twins: of the names that it gives, those that come to the very number of the mistake.
        incident: trace of a failure of ours; empty for none.
    """

    work: ForeignWork
    report: Report
    twins: frozenset[tuple[str, SlipId]]
    incident: str = ""
