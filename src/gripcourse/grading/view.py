"""What a judge of one answer looks at, and what it concludes."""

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gripcourse.course.model import Quantity
from gripcourse.course.policy import Policy
from gripcourse.formula.evaluate import evaluate as evaluate_formula
from gripcourse.formula.tree import Formula
from gripcourse.grading.model import Against, Outcome
from gripcourse.grading.own import Own
from gripcourse.solver.plan import Plan
from gripcourse.submission.model import Answer
from gripcourse.units import factor
from gripcourse.words import Message


@dataclass(frozen=True, slots=True)
class Judgement:
    """The conclusion about one answer.

    Attributes:
        outcome, against: what was found, and by which comparison.
        expected: the value at the student's own inputs, in the declared unit.
        band: how far from it the answer may be.
        credit: share of the points, 0…1.
        slip: id of a recognised slip.
        message, remarks: for the student.
    """

    outcome: Outcome
    against: Against
    expected: float | None
    band: float
    credit: float
    slip: str
    message: Message
    remarks: tuple[Message, ...]


@dataclass(frozen=True, slots=True)
class View:
    """One answer with everything that it can be judged by.

    Attributes:
        value: the answer, in the declared unit.
        reference_values: of every quantity, SI.
        own: the calculation at the student's own numbers.
    """

    plan: Plan
    policy: Policy
    quantity: Quantity
    answer: Answer
    value: float
    reference_values: Mapping[str, float]
    own: Own

    @property
    def reference(self) -> float:
        """The reference value, in the declared unit; NaN where there is none."""
        return self.reference_values.get(self.quantity.id, math.nan) / factor(self.quantity.unit)

    @property
    def has_reference(self) -> bool:
        """Whether the reference solution has a value of this quantity."""
        return math.isfinite(self.reference)

    @property
    def expected(self) -> float:
        """The value at the student's own inputs, in the declared unit; NaN where there is none."""
        if self.quantity.id in self.own.bridged:
            return math.nan
        computed = self.own.evaluation.computed[self.quantity.id]
        return float(computed) / factor(self.quantity.unit)

    def both(self, formula: Formula) -> tuple[float, float]:
        """Evaluate a formula at the reference's and the student's inputs, in the declared unit."""
        return (
            self._evaluate(formula, {k: np.asarray(v) for k, v in self.reference_values.items()}),
            self._evaluate(formula, self.own.evaluation.values),
        )

    def _evaluate(self, formula: Formula, values: Mapping[str, NDArray[np.float64]]) -> float:
        unit = self.quantity.unit
        return float(evaluate_formula(formula, unit, values, self.plan.columns)) / factor(unit)
