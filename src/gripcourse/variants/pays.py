"""What a mistake costs over a table of variants, and which rules of a policy let guesses pay."""

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind, Quantity
from gripcourse.errors import Problem
from gripcourse.policy.bands import FLOOR_SHARE, tolerance_of
from gripcourse.policy.load import policy_path
from gripcourse.policy.model import Policy
from gripcourse.policy.points import points_of
from gripcourse.solver.plan import depends_on_given, plan_of
from gripcourse.solver.solve import solve_variant
from gripcourse.text.amounts import amount_texts
from gripcourse.text.words import message
from gripcourse.variants.model import Variant

MOST_APART = 1.5
"""How many times as much the same mistake may cost in another variant."""
_NOTABLE = 0.03  # of all points: what costs less makes no difference to a mark
_SAME_POINTS = 0.02  # of all points: what an answer may earn that is the same in all variants
_EMPTY = '""'  # as a policy writes the unit of a plain number
_LEAST_VARIANTS = 3  # of a scheme: fewer are the same by chance


@dataclass(frozen=True, slots=True)
class MistakeCost:
    """What a mistake in one quantity costs.

    Attributes:
        quantity, section: ids.
        least, most: points, over the variants.
        variants: how many ask for it.
        is_main: whether the policy declares its points.
    """

    quantity: str
    section: str
    least: float
    most: float
    variants: int
    is_main: bool

    @property
    def apart(self) -> float:
        """How many times the least the most is."""
        return self.most / self.least if self.least else np.inf


@dataclass(frozen=True, slots=True)
class _IssuedAnswer:
    """What a variant of a table has for an answer, in the declared unit, and what it earns."""

    quantity: Quantity
    variant: str
    scheme: str
    value: float
    points: float
    is_from_given: bool


def mistake_costs(
    course: Course, policy: Policy, variants: Sequence[Variant]
) -> tuple[MistakeCost, ...]:
    """Return what a mistake in each answer costs over a table, what costs most first."""
    points: dict[str, list[float]] = defaultdict(list)
    sections: dict[str, str] = {}
    for variant in variants:
        plan = plan_of(course, variant.composition)
        worth = points_of(plan, policy)
        for one in plan.answered:
            points[one.id].append(worth[one.id])
            sections[one.id] = one.section
    costs = [
        MistakeCost(name, sections[name], min(all_), max(all_), len(all_), _is_main(name, policy))
        for name, all_ in points.items()
    ]
    return tuple(sorted(costs, key=lambda one: (-one.most, one.quantity)))


def uneven_costs(costs: Sequence[MistakeCost], policy: Policy) -> tuple[MistakeCost, ...]:
    """Return what costs much more in some variants than in others, of what matters to a mark."""
    notable = _NOTABLE * policy.total
    return tuple(one for one in costs if one.apart > MOST_APART and one.most >= notable)


def _is_main(name: str, policy: Policy) -> bool:
    return name in policy.main_points


def paying_rules(
    course: Course, policy: Policy, variants: Sequence[Variant], table: str
) -> Iterator[Problem]:
    """Name what in a policy would let a work earn that computes little.

    Args:
        course: whose policy it is.
        policy: how answers become points.
        variants: that are issued.
        table: their file, as a person would look for it.
    """
    file = str(policy_path(course.root).relative_to(course.root))
    yield from _without_main_results(file, policy, mistake_costs(course, policy, variants))
    issued = _issued(course, policy, variants)
    yield from _too_wide(file, policy, issued, table)
    yield from _same_for_all(file, policy, issued, table)


def _without_main_results(
    file: str, policy: Policy, costs: Sequence[MistakeCost]
) -> Iterator[Problem]:
    """Name the sections where the same mistake costs much more in some variants than in others."""
    with_main = {one.section for one in costs if one.is_main}
    all_uneven = uneven_costs(costs, policy)
    for section in dict.fromkeys(one.section for one in costs):
        uneven = [one for one in all_uneven if one.section == section]
        if section in with_main or not uneven or not policy.section_points[section]:
            continue
        worst = uneven[0]
        what = message(
            "No main result of the section '{section}' has points of its own: a mistake in "
            "'{quantity}' costs between {least} and {most} points.",
            section=section,
            quantity=worst.quantity,
            least=round(worst.least, 2),
            most=round(worst.most, 2),
        )
        remedy = message("Write the points of its main results, so that they cost alike.")
        yield Problem(file, "points.quantity", what, remedy)


def _too_wide(
    file: str, policy: Policy, issued: Mapping[str, Sequence[_IssuedAnswer]], table: str
) -> Iterator[Problem]:
    """Name absolute tolerances that are wide beside what is issued.

    A floor by unit is cut where a value cannot be zero; of others that come near zero the usual
    value counts, because a relative band is empty there.
    """
    for answers in issued.values():
        quantity = answers[0].quantity
        absolute = tolerance_of(quantity, policy).absolute
        sizes = np.abs([one.value for one in answers if one.value])
        own = policy.tolerances.get(quantity.id) or quantity.tolerance
        low, high = quantity.bounds
        is_own = own is not None and own.absolute > 0
        spans_zero = low <= 0 <= high
        if not sizes.size or not (is_own or spans_zero):
            continue
        size = float(np.median(sizes)) if spans_zero else float(sizes.min())
        if absolute <= FLOOR_SHARE * size:
            continue
        floor = f"tolerance.floor.{quantity.unit or _EMPTY}"
        key = f"quantity_tolerance.{quantity.id}" if is_own else floor
        smallest = min((one for one in answers if one.value), key=lambda one: abs(one.value))
        said = (
            message("the usual size of '{quantity}' in {table}", quantity=quantity.id, table=table)
            if spans_zero
            else message("which '{quantity}' has in variant {variant} of {table}",
                         quantity=quantity.id, variant=smallest.variant, table=table)
        )  # fmt: skip
        what = message(
            "The absolute tolerance {absolute} is {share} % of {size}, {which}: a guess may meet"
            " it.",
            absolute=absolute,
            share=round(100 * absolute / size, 1),
            size=amount_texts(size, quantity.unit),
            which=said,
        )
        remedy = message("Write at most {absolute}.", absolute=_no_more_than(FLOOR_SHARE * size))
        yield Problem(file, key, what, remedy)


def _same_for_all(
    file: str, policy: Policy, issued: Mapping[str, Sequence[_IssuedAnswer]], table: str
) -> Iterator[Problem]:
    """Name answers that earn much though all variants of a scheme have the same one.

    One that depends on nothing issued is left out: it earns only in a work that calculates.
    """
    for name, answers in issued.items():
        for scheme in dict.fromkeys(one.scheme for one in answers):
            own = [one for one in answers if one.scheme == scheme]
            values, points = [one.value for one in own], min(one.points for one in own)
            within = tolerance_of(own[0].quantity, policy).relative * max(map(abs, values))
            if (
                len(own) < _LEAST_VARIANTS
                or max(values) - min(values) > within
                or points <= _SAME_POINTS * policy.total
                or not own[0].is_from_given
            ):
                continue
            what = message(
                "'{quantity}' is the same in all {count} variants of the scheme '{scheme}' in"
                " {table}, and earns {points} points: a neighbour's number earns them too.",
                quantity=name,
                count=len(own),
                scheme=scheme,
                table=table,
                points=round(points, 2),
            )
            remedy = message("Write a smaller weight, or draw the variants from wider ranges.")
            yield Problem(file, f"weight.quantity.{name}", what, remedy)


def _no_more_than(number: float) -> float:
    """Round a positive number down to one figure."""
    step = 10.0 ** np.floor(np.log10(number))
    return float(f"{np.floor(number / step) * step:.1g}")


def _issued(
    course: Course, policy: Policy, variants: Sequence[Variant]
) -> Mapping[str, Sequence[_IssuedAnswer]]:
    """Return the computed answers of the variants, by quantity."""
    found: dict[str, list[_IssuedAnswer]] = defaultdict(list)
    for variant in variants:
        plan = plan_of(course, variant.composition)
        values, points = solve_variant(plan, variant.given), points_of(plan, policy)
        for one in plan.answered:
            if one.kind is Kind.FORMULA and np.isfinite(values[one.id]):
                is_from_given = depends_on_given(plan, one.id)
                found[one.id].append(
                    _IssuedAnswer(
                        one,
                        variant.id,
                        variant.scheme,
                        values[one.id],
                        points[one.id],
                        is_from_given,
                    )
                )
    return found
