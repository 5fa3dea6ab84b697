"""Ways through steps that were left blank: what people do there, and would have been let do.

A constant is shortened, figures are lost, or a step is read as its declaration or a source allows.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import product
from typing import Final

from gripcourse.course.quantity import Quantity
from gripcourse.formula.tree import Formula
from gripcourse.grading.rounding import endings
from gripcourse.grading.shortened import EXACTLY, shortenings
from gripcourse.policy.model import Policy
from gripcourse.solver.plan import Plan

_MORE: Final = 1  # figure than the policy asks for: what still more leave moves hardly anything
_LESS: Final = 1  # figure is too coarse; what still fewer leave is no calculation


@dataclass(frozen=True, slots=True)
class BlankWay:
    """How the steps before an answer may have been computed that were left blank.

    Attributes:
        constants: what constants were shortened to, SI, by name.
        formulas: other readings, in the place of the declared formulas, by id of the step.
        figures: how many were kept of each step; 0 for all.
        cut: whether the others were cut off, not rounded.
        coarse: whether fewer were kept than the policy asks for.
    """

    constants: Mapping[str, float] = field(default_factory=dict)
    formulas: Mapping[str, Formula] = field(default_factory=dict)
    figures: int = 0
    cut: bool = False
    coarse: bool = False


def ways_through(plan: Plan, policy: Policy, steps: Sequence[Quantity]) -> Iterator[BlankWay]:
    """Yield the ways through some steps.

    Args:
        plan: that they belong to.
        policy: what it thinks of.
        steps: the blank ones, and last the answer that they lead to.
    """
    constants = shortenings(plan, [one.id for one in steps], policy.habits)
    kept = [(0, False), *product((policy.figures, policy.figures + _MORE), endings(policy))]
    for formulas, (figures, cut) in product(_readings(policy, steps[:-1]), kept):
        yield BlankWay(formulas=formulas, figures=figures, cut=cut)
    for shortened, (figures, cut) in product((EXACTLY, *constants), kept):
        if shortened or figures:
            yield BlankWay(shortened, figures=figures, cut=cut)
    if policy.figures > _LESS:
        yield BlankWay(figures=policy.figures - _LESS, coarse=True)


def _readings(policy: Policy, blank: Sequence[Quantity]) -> Iterator[Mapping[str, Formula]]:
    """Yield one step after the other by its other route or reading, then all as printed."""
    printed: dict[str, Formula] = {}
    for step in blank:
        if step.route is not None:
            yield {step.id: step.route}
        for alternative in step.alternatives:
            yield {step.id: alternative.formula}
        for one in step.as_printed if policy.printed_credit is not None else ():
            if one.formula is not None:
                yield {step.id: one.formula}
                printed[step.id] = one.formula
    if len(printed) > 1:
        yield printed
