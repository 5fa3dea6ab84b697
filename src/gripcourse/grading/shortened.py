"""Constants as people shorten them: 10 for 9.81 on the right formula is coarse, and no slip."""

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass
from itertools import combinations, product
from types import MappingProxyType
from typing import Final, TypeAlias, cast

from gripcourse.course.quantity import Kind
from gripcourse.formula.tree import Formula, Name, walk
from gripcourse.grading.comparison import Comparison, Judgement, conclude
from gripcourse.grading.judge_rough import is_rounded_from
from gripcourse.grading.model import Against, Outcome
from gripcourse.slips.rewrite import number, renamed
from gripcourse.solver.plan import Plan
from gripcourse.text.words import Message, Texts, message

EXACTLY: Final[Mapping[str, float]] = MappingProxyType({})
"""No constant shortened."""

Meets: TypeAlias = Callable[[Comparison, float], bool]
"""Tells whether an answer is a result in the declared unit."""

_MOST: Final = 2  # constants that one person shortens


@dataclass(frozen=True, slots=True)
class Shortened:
    """A formula with one constant as people shorten it; its value in SI."""

    name: str
    value: float
    formula: Formula


def with_shortened(
    formula: Formula, habits: Mapping[str, tuple[float, ...]]
) -> Iterator[Shortened]:
    """Yield a formula with the constants that it uses as people shorten them, one at a time."""
    for name, values in habits.items():
        if name in formula.names or any(part == Name(name) for part in walk(formula.tree)):
            for value in values:
                tree = renamed(formula.tree, {name: number(value)})
                yield Shortened(name, value, Formula("", tree, formula.units))


def shortenings(
    plan: Plan, names: Collection[str], habits: Mapping[str, tuple[float, ...]]
) -> Iterator[Mapping[str, float]]:
    """Yield what people shorten the constants of some formulas to, SI: one of them, or two.

    Args:
        plan: that the formulas are of.
        names: ids of the quantities.
        habits: values of the constants that people shorten.
    """
    used = [one for one in habits if any(one in _names_in(plan, name) for name in names)]
    for most in range(1, _MOST + 1):
        for some in combinations(used, most):
            for values in product(*(habits[one] for one in some)):
                yield dict(zip(some, values, strict=True))


def with_constants(plan: Plan, name: str, constants: Mapping[str, float]) -> Formula | None:
    """Return the formula of a quantity with shortened constants, those that it uses.

    Args:
        plan: that the quantity belongs to.
        name: id of the quantity.
        constants: what they were shortened to, SI, by name.

    Returns:
        The formula itself where it uses none of them; None where there is none.
    """
    formula = plan.reference_formula(name)
    used = constants.keys() & _names_in(plan, name) if constants else ()
    if formula is None or not used:
        return formula
    made = cast("dict[object, Formula]", plan.made.setdefault("shortened", {}))
    key = (name, *((one, constants[one]) for one in sorted(used)))
    if key not in made:
        tree = renamed(formula.tree, {one: number(constants[one]) for one in used})
        made[key] = Formula("", tree, formula.units)
    return made[key]


def uses_constant(plan: Plan, name: str, constants: Collection[str]) -> bool:
    """Tell whether the formula of a quantity uses one of some constants."""
    return not _names_in(plan, name).isdisjoint(constants)


def _names_in(plan: Plan, name: str) -> frozenset[str]:
    """Return all names in the formula of a quantity, `pi` too."""
    made = cast("dict[str, frozenset[str]]", plan.made.setdefault("names", {}))
    if name not in made:
        formula = plan.reference_formula(name)
        parts = () if formula is None else walk(formula.tree)
        made[name] = frozenset(one.id for one in parts if isinstance(one, Name))
    return made[name]


def shortened_in(
    comparison: Comparison, meets: Meets = Comparison.meets_as_typed
) -> tuple[Shortened, Against] | None:
    """Return the shortened constant that a number was computed with, and from whose numbers.

    Args:
        comparison: of the number.
        meets: tells whether it is a result: by itself as exactly as it was typed, for the band is
            wide enough for other mistakes.
    """
    formula = comparison.plan.reference_formula(comparison.quantity.id)
    if formula is None or comparison.quantity.kind is not Kind.FORMULA or not comparison.value:
        return None
    for one in with_shortened(formula, comparison.policy.habits):
        exact = comparison.at_reference(one.formula)
        if meets(comparison, comparison.at_own(one.formula).nearest(comparison.value)):
            return one, Against.OWN_INPUTS
        if meets(comparison, exact):
            return one, Against.REFERENCE
    return None


def judge_shortened(comparison: Comparison) -> Judgement | None:
    """Conclude that a number is right but for a constant that was shortened too far.

    It may have been rounded too far besides.
    """
    found = shortened_in(comparison) or shortened_in(comparison, is_rounded_from)
    if found is None:
        return None
    one, against = found
    said = said_too_coarse(comparison.plan, one.name, one.value)
    return conclude(comparison, Outcome.ROUGH, against, comparison.policy.rough_credit, said)


def said_too_coarse(plan: Plan, name: str, value: float) -> Message:
    """Say that a constant was shortened too far."""
    return message(
        "Right, but with {value} for {title}, which is too coarse here.",
        value=value,
        title=title_of_constant(plan, name),
    )


def title_of_constant(plan: Plan, name: str) -> Texts | str:
    """Return what a constant is called."""
    return plan.quantities[name].short_title if name != "pi" else "π"
