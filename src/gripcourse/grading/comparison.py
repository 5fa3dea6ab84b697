"""What a judge of one answer looks at, and what it concludes."""

import math
from collections.abc import Mapping
from copy import copy
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from gripcourse.course.quantity import Kind, Quantity
from gripcourse.formula.evaluate import evaluate_number, evaluate_sound
from gripcourse.formula.tree import Formula
from gripcourse.grading.follow_through import FollowThrough, range_of
from gripcourse.grading.manner import UNKNOWN, Manner
from gripcourse.grading.model import Against, Outcome
from gripcourse.grading.rounding import met_as_typed
from gripcourse.policy.bands import BandRule, band_rules, within
from gripcourse.policy.model import Policy
from gripcourse.slips.model import SlipId
from gripcourse.solver.plan import Plan
from gripcourse.submission.model import Answer
from gripcourse.text.units import factor
from gripcourse.text.words import Message

_OF_FLOATING_POINT = 1e-12  # relative: what a difference or a cosine leaves of nothing


@dataclass(frozen=True, slots=True)
class Judgement:
    """The conclusion about one answer.

    Attributes:
        outcome, against: what was found, and by which comparison.
        expected: the value at the student's own inputs, in the declared unit.
        band: how far from it the answer may be.
        credit: share of the points, 0…1.
        slip: the recognised slip; None for none.
        tied: other slips that explain the answer as well.
        roots: ids of the quantities whose wrong answers this one follows from.
        message, remarks: for the student.
        alone: how densely numbers lie at a wrong answer if nothing else is wrong but it: what all
            wrong methods and chance make of it; NaN where nobody asked.
        elsewhere: id of another answer that has the same number, where nothing else explains it.
        mistyped: whether it has the digits of the right number, where nothing else explains it.
        held: whether it is what the student's calculator held, perhaps rounded too far.
    """

    outcome: Outcome
    against: Against
    expected: float | None
    band: float
    credit: float
    slip: SlipId | None
    tied: tuple[SlipId, ...]
    roots: tuple[str, ...]
    message: Message
    remarks: tuple[Message, ...]
    alone: float = math.nan
    elsewhere: str = ""
    mistyped: bool = False
    held: bool = False


@dataclass(frozen=True, slots=True)
class ExpectedRange:
    """A value and how far rounded inputs may move it; all NaN where there is none."""

    value: float
    low: float
    high: float

    def nearest(self, value: float) -> float:
        """Return the point of the range that is nearest to a value; NaN where there is no range."""
        if math.isnan(self.low) or math.isnan(self.high):
            return math.nan  # `min` and `max` would give the value back, which then fits itself
        return min(max(value, self.low), self.high)

    def moved(self, by: float) -> "ExpectedRange":
        """Return the range moved as a whole."""
        return ExpectedRange(self.value + by, self.low + by, self.high + by)


NOWHERE = ExpectedRange(math.nan, math.nan, math.nan)


@dataclass(frozen=True, slots=True)
class Comparison:
    """One answer with everything that it can be judged by.

    Attributes:
        value: the answer, in the declared unit.
        reference_values: of every quantity, SI.
        follow_through: the calculation at the student's own numbers.
        reference: the reference value, in the declared unit; NaN where there is none.
        follows: what follows from the student's own inputs, in the declared unit.
        manner: how the student writes numbers, as far as that is known.
        bands, widest: how far an answer may be from a value, and how wide a range counts.
    """

    plan: Plan
    policy: Policy
    quantity: Quantity
    answer: Answer
    value: float
    reference_values: Mapping[str, float]
    follow_through: FollowThrough
    manner: Manner = UNKNOWN

    reference: float = field(init=False)
    follows: ExpectedRange = field(init=False)
    bands: BandRule = field(init=False)
    widest: BandRule = field(init=False)

    def __post_init__(self) -> None:
        """Find once what every judge asks for."""
        name, put = self.quantity.id, object.__setattr__
        bands, widest = band_rules(self.quantity, self.policy)
        put(self, "bands", bands)
        put(self, "widest", widest)
        scale = factor(self.quantity.unit)
        put(self, "reference", self.reference_values.get(name, math.nan) / scale)
        put(self, "follows", NOWHERE if name in self.follow_through.bridged else self._following())

    def _following(self) -> ExpectedRange:
        name, own = self.quantity.id, self.follow_through
        return self._range(own.numbers.computed[name], own.ranges[name])

    @property
    def has_reference(self) -> bool:
        """Whether the reference solution has a value of this quantity."""
        return math.isfinite(self.reference)

    @property
    def expected(self) -> float:
        """The value at the student's own inputs, in the declared unit; NaN where there is none."""
        return self.follows.value

    def at_reference(self, formula: Formula) -> float:
        """Evaluate a formula at the reference's inputs, in the declared unit."""
        return self._number(formula, self.reference_values) / factor(self.quantity.unit)

    def number_at_own(self, formula: Formula) -> float:
        """Evaluate a formula at the student's inputs, in the declared unit, without its range."""
        return self._number(formula, self.follow_through.numbers.values) / factor(
            self.quantity.unit
        )

    def at_own(self, formula: Formula) -> ExpectedRange:
        """Evaluate a formula at the student's inputs, in the declared unit."""
        value = self._number(formula, self.follow_through.numbers.values)
        return self._range(value, self._ends(formula, self.follow_through.moved.values))

    def near_own(self, formula: Formula, furthest: float) -> ExpectedRange:
        """Do the same; the range is only looked at where it may come so near to the answer."""
        value = self._number(formula, self.follow_through.numbers.values)
        declared = value / factor(self.quantity.unit)
        if not abs(self.value - declared) <= self.widest_round(declared) + furthest:
            return ExpectedRange(declared, declared, declared)
        return self._range(value, self._ends(formula, self.follow_through.moved.values))

    def following(self, name: str, value: float) -> ExpectedRange:
        """Return what follows here if another quantity is exactly a value (declared units)."""
        formula = self.plan.reference_formula(self.quantity.id)
        if formula is None:
            return NOWHERE
        exact = value * factor(self.plan.quantities[name].unit)
        if not math.isfinite(exact):
            exact = math.nan
        own = self.follow_through
        result = self._number(formula, {**own.numbers.values, name: exact})
        moved = {**own.moved.values, name: np.asarray(exact)}
        return self._range(result, self._ends(formula, moved))

    def in_manner(self, manner: Manner) -> "Comparison":
        """Return the same for a student of whom it is known how numbers are written."""
        other = copy(self)  # nothing that is computed at the beginning depends on it
        object.__setattr__(other, "manner", manner)
        return other

    def fits(self, expected: float) -> bool:
        """Tell whether the answer lies in the band round an expected value.

        The cosine of 90° comes out as 6e-17: who writes 0 for it is right.
        """
        return within(self.value, expected, self.band_round(expected)) or (
            self.value == 0 and abs(expected) <= _OF_FLOATING_POINT * abs(self.reference)
        )

    def meets_as_typed(self, result: float) -> bool:
        """Tell whether the answer is a result, in the declared unit, as exactly as it was typed."""
        return met_as_typed(self.answer, self.value, result, self.policy)

    def band_round(self, expected: float) -> float:
        """Return the half width of the band round an expected value, in the declared unit."""
        return self.bands.round(expected)

    def widest_round(self, value: float) -> float:
        """Return how far what is lost on the way may move a value, in the declared unit."""
        if self.quantity.kind is Kind.VERDICT:
            return 1.0  # at the edge a last digit decides between yes and no
        return self.policy.widest * self.widest.round(value)

    @property
    def own_inputs(self) -> frozenset[str]:
        """The quantities whose values at the student's numbers are not those of the reference."""
        return self.follow_through.own

    @property
    def has_right_inputs(self) -> bool:
        """Whether all that it is computed from lies in its band round the reference."""
        return all(
            self._is_right(name)
            for name in self.plan.inputs[self.quantity.id]
            if name in self.follow_through.own
        )

    def _is_right(self, name: str) -> bool:
        quantity = self.plan.quantities[name]
        scale = factor(quantity.unit)
        own = self.follow_through.numbers.values[name] / scale
        expected = self.reference_values.get(name, math.nan) / scale
        return within(own, expected, band_rules(quantity, self.policy)[0].round(expected))

    def _range(self, value: float, ends: tuple[float, float]) -> ExpectedRange:
        """Convert SI to the declared unit; a range wider than the policy allows is cut."""
        size = factor(self.quantity.unit)
        value, low, high = value / size, ends[0] / size, ends[1] / size
        most = self.widest_round(value)
        return ExpectedRange(value, max(low, value - most), min(high, value + most))

    def _number(self, formula: Formula, values: Mapping[str, float]) -> float:
        return evaluate_number(formula, self.quantity.unit, values, self.plan.columns)

    def _ends(
        self, formula: Formula, values: Mapping[str, NDArray[np.float64]]
    ) -> tuple[float, float]:
        return range_of(evaluate_sound(formula, self.quantity.unit, values, self.plan.columns))


def conclude(  # noqa: PLR0913 (the parts of a conclusion)
    comparison: Comparison,
    outcome: Outcome,
    against: Against,
    credit: float,
    said: Message,
    *,
    reach: float = 0.0,
    slip: SlipId | None = None,
    remarks: tuple[Message, ...] = (),
) -> Judgement:
    """Conclude about an answer, as yet without a root; `reach` is its band."""
    expected = comparison.expected
    return Judgement(
        outcome=outcome,
        against=against,
        expected=expected if math.isfinite(expected) else None,
        band=reach,
        credit=credit,
        slip=slip,
        tied=(),
        roots=(),
        message=said,
        remarks=remarks,
    )
