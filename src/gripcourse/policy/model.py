"""The policy of a head of course: points, bands, credits and what a report reveals.

It lives beside the course, below grading, because the assignment sheet prints points and bands too.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum

from gripcourse.course.quantity import Tolerance
from gripcourse.policy.rubric import Rubric
from gripcourse.policy.scales import Scale
from gripcourse.policy.slips import SlipPolicy
from gripcourse.policy.time_rules import AttemptRule, LateRule


class Reveal(StrEnum):
    """What a student's report shows of the reference solution."""

    NOTHING = "nothing"
    REFERENCE = "reference"


@dataclass(frozen=True, slots=True)
class VariantRules:
    """When variants may be handed out side by side.

    Attributes:
        shared_points: most that one student may get with another's answers, as a share of the
            points of the computed quantities.
        shared_section_points: the same inside one section, as a share of that section's.
        slip_bands: how many bands a slip's result must lie from the right one.
        keep_apart: kinds of slips that a variant is refused for; others are only counted.
        step_margin: by which share of itself a computed answer may move before a size that is taken
            for it from a series changes.
        steps_ratio: how many times as many quantities as the shortest assignment the longest may
            ask for.
        weak_item: a computed quantity that is equal in a larger share of the pairs of variants
            of a scheme is named as weak.
        same_size: a size that is one and the same in a larger share of the variants of a scheme is
            named.
        same_end: where a formula takes the greater or the lesser of two values, and it is the same
            one in a larger share of the variants of a scheme, this is named.
        verdict_no: a verdict that may come out either way is named where the share of "no" in the
            variants of a scheme is less than the first or greater than the second.
    """

    shared_points: float
    shared_section_points: float
    slip_bands: float
    keep_apart: tuple[str, ...]
    step_margin: float
    steps_ratio: float
    weak_item: float
    same_size: float
    same_end: float
    verdict_no: tuple[float, float]


@dataclass(frozen=True, slots=True)
class FigureRule:
    """How many significant figures a computed answer should have; judged apart from its value.

    Attributes:
        least, most: figures; 0 for no bound.
        credit: share of the points that an answer outside the bounds keeps.
    """

    least: int
    most: int
    credit: float


@dataclass(frozen=True, slots=True)
class LikenessRule:
    """When it is told that a submission holds another student's numbers; never a verdict.

    Attributes:
        odds: of copying against chance, all comparisons counted, from which on; 0 for never.
        answers: telling numbers that it must rest on, at least.
        same_creator: students who share an author's name, at most; of more, nothing is told.
    """

    odds: float
    answers: int
    same_creator: int


class Tells(StrEnum):
    """What a self-check tells before the deadline, each with all before it."""

    READING = "reading"  # how each answer was read, its unit and magnitude
    SECTIONS = "sections"  # whether the numbers of a section fit each other, all of them or not
    ANSWERS = "answers"  # whether each answer fits those before it


@dataclass(frozen=True, slots=True)
class CheckRule:
    """How much a student may learn from self-checks.

    Attributes:
        tells: the most that is told.
        times: how often each student may be told more than the reading; who asks again learns the
            reading alone.
    """

    tells: Tells
    times: int


@dataclass(frozen=True, slots=True)
class Policy:
    """How answers become points.

    Attributes:
        total: points of the whole assignment.
        section_points: points of each section; they add up to `total`.
        main_points: points of main results, whatever else their section asks for.
        weights: weight of a quantity inside its section, where it is not the kind's default.
        kind_weights: default weight by kind.
        tolerance: default band.
        floors: absolute part of the default band by unit, in that unit.
        tolerances: bands of single quantities that override their declarations.
        carried_credit: share of the points for what follows from the student's own numbers.
        printed_credit: share for an answer as a source prints it; None refuses it.
        wrong_unit_credit: share for the right number with a unit that does not fit it.
        rough_credit: share for the right number, rounded so far that it leaves its band.
        calculated_share: of a work's computed answers that are right, follow or are unexplained,
            the share that must not be unexplained for what follows from those to count.
        last_digit: how much further from zero than typed a number in a calculator may be, in units
            of the last typed digit: 0.5 where people round, 1 where they cut off as well.
        figures: significant figures that a typed number counts as written with, at least.
        habits: values in SI that people shorten constants to, by the constant's id, or `pi`.
        widest: how far what follows from rounded numbers may spread to either side, in bands.
        reveal: what a report shows.
        slips: how slips are named.
        variants: when variants may be handed out side by side.
        figure_rule: how many figures answers should be typed with.
        likeness: when copying is suspected.
        check: what a self-check tells.
        rubrics: by which a person marks manual items, by id.
        scales: what shares of the points are called, in the order of the documents.
        late: what lateness costs; None for nothing.
        attempts: which of several works counts; None where each is reported for itself.
    """

    total: float
    section_points: Mapping[str, float]
    main_points: Mapping[str, float]
    weights: Mapping[str, float]
    kind_weights: Mapping[str, float]
    tolerance: Tolerance
    floors: Mapping[str, float]
    tolerances: Mapping[str, Tolerance]
    carried_credit: float
    printed_credit: float | None
    wrong_unit_credit: float
    rough_credit: float
    calculated_share: float
    last_digit: float
    figures: int
    habits: Mapping[str, tuple[float, ...]]
    widest: float
    reveal: Reveal
    slips: SlipPolicy
    variants: VariantRules
    figure_rule: FigureRule
    likeness: LikenessRule
    check: CheckRule
    rubrics: Mapping[str, Rubric]
    scales: tuple[Scale, ...] = ()
    late: LateRule | None = None
    attempts: AttemptRule | None = None
