"""Virtual students as plain values: how they work, what they did, what the grader is held to."""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum

from gripcourse.grading.model import FlagCode
from gripcourse.simulation.arithmetic import DigitRounding
from gripcourse.slips.model import SlipId


class Conduct(StrEnum):
    """What a student does that somebody should find out."""

    HONEST = "honest"
    SLIP = "slip"
    TWO_SLIPS = "two_slips"
    BARE_UNIT = "bare_unit"  # a number typed in another unit without saying so
    WRONG_UNIT = "wrong_unit"  # a number with a unit that measures something else
    ROUNDED_DOWN = "rounded_down"  # a size below the required one
    BLANKS = "blanks"
    COPIED_ANSWERS = "copied_answers"  # a neighbour's numbers in the student's own workbook
    COPIED_WORKBOOK = "copied_workbook"

    @property
    def copies(self) -> bool:
        """Whether somebody else's work is handed in."""
        return self in {Conduct.COPIED_ANSWERS, Conduct.COPIED_WORKBOOK}


class Carrying(StrEnum):
    """What a student computes the next step with."""

    TYPED = "typed"
    CALCULATOR = "calculator"


class Style(StrEnum):
    """How a number stands in its cell."""

    NUMBER = "number"
    TEXT = "text"
    TEXT_WITH_UNIT = "text_with_unit"
    TEXT_IN_OTHER_UNIT = "text_in_other_unit"


@dataclass(frozen=True, slots=True)
class Behaviour:
    """One student's way of working.

    Attributes:
        conduct: what there is to find out.
        figures: significant figures that are written.
        rounding: what becomes of the others.
        carrying: what the next step is computed with.
        style: how numbers stand in their cells.
        pi: the student's.
        constants: constants of the course as the student takes them, in declared units.
        neighbour: id of the student whose work is copied; empty for nobody.
        seed: of the student's own choices: where the slip is, which answers stay blank.
    """

    conduct: Conduct
    figures: int
    rounding: DigitRounding
    carrying: Carrying
    style: Style
    pi: float
    constants: Mapping[str, float]
    neighbour: str
    seed: int


class ActionKind(StrEnum):
    """What was done for one answer."""

    RIGHT = "right"  # the right method, and nothing wrong before it
    FOLLOWS = "follows"  # the right method at numbers that come from something wrong
    SLIP = "slip"  # a wrong method
    BARE_UNIT = "bare_unit"
    WRONG_UNIT = "wrong_unit"
    ROUNDED_DOWN = "rounded_down"
    BLANK = "blank"
    COPIED = "copied"


@dataclass(frozen=True, slots=True)
class Action:
    """What was done for one answer.

    Attributes:
        quantity: its id.
        done: what was done.
        slip: the candidate that was computed instead of the formula; None for none.
        kind: of that slip.
        twins: ids of the other candidates that give exactly this value with the student's numbers;
            nobody can tell them from the slip.
        value: of what the student wrote, in the declared unit; None for nothing.
        right: that the right method gives with the student's own numbers, likewise.
        typed: what stands in the cell; None for nothing.
    """

    quantity: str
    done: ActionKind
    slip: SlipId | None
    kind: str
    twins: tuple[SlipId, ...]
    value: float | None
    right: float | None
    typed: float | str | None


@dataclass(frozen=True, slots=True)
class SimulatedWork:
    """What one student did: the truth that the grader never sees.

    Attributes:
        student: id.
        owner: id of the student whose workbook is handed in.
        behaviour: how the student works.
        actions: one for each answer, in the order of the assignment.
        tried: places that were tried for slips; each but the last had too small an effect.
        hidden: of these, places where the slip cannot be told from the right value.
    """

    student: str
    owner: str
    behaviour: Behaviour
    actions: tuple[Action, ...]
    tried: int
    hidden: int


@dataclass(frozen=True, slots=True)
class Required:
    """What the grader is held to: shares, 0…1.

    Attributes:
        strategy_earned: of the points that no person gives, for works that compute nothing, on
            average of each strategy.
        charged_once, misnamed, blamed, named: of works of the second generator with one mistake:
            charged once at least so many, at most so many given a wrong name or with another
            quantity blamed, and named at least so many where there is a word for it.
        moved_copy_flagged: of copies whose numbers were moved.
        mixture_flagged: of copies of two neighbours.
    """

    honest_refused: float
    slip_accepted: float
    slip_named: float
    slip_misnamed: float
    copy_flagged: float
    honest_flagged: float
    strategy_earned: float
    charged_once: float = 0.97
    misnamed: float = 0.01
    blamed: float = 0.01
    named: float = 0.9
    moved_copy_flagged: float = 0.9
    mixture_flagged: float = 0.9


@dataclass(frozen=True, slots=True)
class Mix:
    """How often virtual students do what; of weights only the proportions matter.

    Attributes:
        conduct, figures, rounding, carrying, style, pi, language: weights by value.
        constants: of each constant of the course, weights by the value that students take.
        blank: share of the answers that one who leaves blanks leaves blank.
        copied: share of the answers that one who copies takes over.
        apart: a slip is made where it differs from every right value by so many bands.
        tries: places that are tried for it.
        answers: honest ones, before a narrower band than the present one is proposed.
        bands: relative tolerances that an audit may propose, narrowest first.
        wide: share of a value; a step that rounded inputs spread so far is ill-conditioned.
        copying_flags: codes of flags that say that a work is not the student's own.
        required: what the grader is held to.
    """

    conduct: Mapping[Conduct, float]
    figures: Mapping[int, float]
    rounding: Mapping[DigitRounding, float]
    carrying: Mapping[Carrying, float]
    style: Mapping[Style, float]
    pi: Mapping[float, float]
    language: Mapping[str, float]
    constants: Mapping[str, Mapping[float, float]]
    blank: float
    copied: float
    apart: float
    tries: int
    answers: int
    bands: tuple[float, ...]
    wide: float
    copying_flags: frozenset[FlagCode]
    required: Required
