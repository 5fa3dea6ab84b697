"""Variants of one scheme computed together, whatever their options: what compositions share, once.

A composition is a choice of shared declarations. A table of ten thousand variants has thousands of
compositions, but each of a few hundred declarations is computed only once, for all variants that
have it.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TypeAlias, TypeVar

import numpy as np
from numpy.typing import NDArray

from gripcourse.course.compose import compose
from gripcourse.course.composition import Composition
from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind, Quantity
from gripcourse.course.step_up import inputs_of, step_ups
from gripcourse.formula.evaluate import finite
from gripcourse.solver.order import in_order_of_need
from gripcourse.solver.plan import Plan, plan_of
from gripcourse.solver.sizes import compute
from gripcourse.solver.solve import Evaluation

Array = NDArray[np.float64]
Rows = NDArray[np.intp]
Number = TypeVar("Number", bound=np.generic)
Key: TypeAlias = int | tuple[int, ...]
"""What tells a declaration from all others: itself, and what else its value is computed by."""


@dataclass(frozen=True, slots=True, eq=False)
class Member:
    """A declaration of a family.

    Attributes:
        quantity: what is declared.
        inputs: ids that its reference is computed from directly.
        places: the variants of the family that have it, ascending, shape (k,); None for all.
        numbers: the compositions that have it.
        plan: of one of these compositions.
    """

    quantity: Quantity
    inputs: tuple[str, ...]
    places: Rows | None
    numbers: tuple[int, ...]
    plan: Plan

    @property
    def at(self) -> Rows | slice:
        """What picks the variants that have it from an array of all."""
        return slice(None) if self.places is None else self.places

    def of(self, values: NDArray[Number]) -> NDArray[Number]:
        """Take from values of all variants, shape (n,), those of the ones that have it."""
        return values[self.at]


@dataclass(frozen=True, slots=True, eq=False)
class Family:
    """Variants of one scheme.

    Attributes:
        compositions: that they have, each once.
        numbers: the composition of each variant, shape (n,).
        members: all declarations, inputs before what needs them.
    """

    compositions: tuple[Composition, ...]
    numbers: Rows
    members: tuple[Member, ...]

    @property
    def scheme(self) -> str:
        """Id of the scheme."""
        return self.compositions[0].scheme

    @property
    def size(self) -> int:
        """How many variants there are."""
        return len(self.numbers)

    @property
    def course(self) -> Course:
        """Whose variants they are."""
        return self.members[0].plan.course

    @property
    def answered(self) -> Iterator[Member]:
        """The declarations that a student answers."""
        return (one for one in self.members if one.quantity.kind.answered)

    @property
    def givens(self) -> Iterator[Member]:
        """The declarations of given numbers."""
        return (one for one in self.members if one.quantity.kind is Kind.GIVEN)

    def restricted(self, places: Rows) -> "Family":
        """Return the family of some of the variants, at these ascending places."""
        now = np.full(self.size, -1, dtype=np.intp)
        now[places] = np.arange(len(places))
        members = []
        for one in self.members:
            own = None if one.places is None else now[one.places]
            members.append(replace(one, places=None if own is None else own[own >= 0]))
        return replace(self, numbers=self.numbers[places], members=tuple(members))

    def plan(self, place: int) -> Plan:
        """Return the plan of a variant."""
        return plan_of(self.course, self.compositions[self.numbers[place]])


def families_of(
    course: Course, compositions: Sequence[Composition]
) -> Iterator[tuple[Rows, Family]]:
    """Put variants into families, scheme by scheme.

    Args:
        course: what is declared.
        compositions: of each variant.

    Yields:
        Positions of variants in the sequence, ascending, and their family.
    """
    by_scheme: dict[str, list[int]] = {}
    for row, composition in enumerate(compositions):
        by_scheme.setdefault(composition.scheme, []).append(row)
    for rows in by_scheme.values():
        yield from _families(course, compositions, np.array(rows, dtype=np.intp))


def family_of(plan: Plan, size: int) -> Family:
    """Make a family of variants of a single composition.

    Args:
        plan: that they share.
        size: how many there are.
    """
    members = (
        Member(quantity, plan.inputs.get(id_, ()), None, (0,), plan)
        for id_, quantity in plan.quantities.items()
    )
    return Family((plan.composition,), np.zeros(size, dtype=np.intp), tuple(members))


def evaluate_family(family: Family, known: Mapping[str, Array]) -> Evaluation:
    """Compute every quantity of a family; see `solve.evaluate`.

    Args:
        family: what is computed.
        known: SI values by id, shape (n,); NaN where not supplied, infinite
            where supplied but no number.

    Returns:
        Values and computed values of shape (n,), NaN for variants that do not have the quantity.
    """
    values: dict[str, Array] = {}
    computed: dict[str, Array] = {}
    for member in family.members:
        if member.quantity.kind is Kind.MANUAL:
            continue
        id_ = member.quantity.id
        inputs = {name: member.of(values[name]) for name in member.inputs}
        result = compute(member.plan, member.quantity, inputs)
        _put(computed, member, result, family.size)
        if id_ in known:
            own = member.of(known[id_])
            result = np.where(np.isnan(own), result, finite(own))
        _put(values, member, result, family.size)
    return Evaluation(values, computed)


def _put(table: dict[str, Array], member: Member, result: Array, size: int) -> None:
    id_ = member.quantity.id
    if member.places is None:
        table[id_] = np.broadcast_to(result, (size,))
        return
    if id_ not in table:
        table[id_] = np.full(size, np.nan)
    table[id_][member.places] = result


def _families(
    course: Course, compositions: Sequence[Composition], rows: Rows
) -> Iterator[tuple[Rows, Family]]:
    numbered: dict[Composition, int] = {}
    numbers = np.array(
        [numbered.setdefault(compositions[row], len(numbered)) for row in rows], dtype=np.intp
    )
    family = _family(course, tuple(numbered), numbers)
    if family is not None:
        yield rows, family
        return
    # What one composition computes first another computes last: they are no family.
    first = numbers < max(len(numbered) // 2, 1)
    for half in (rows[first], rows[~first]):
        yield from _families(course, compositions, half)


def _family(course: Course, compositions: tuple[Composition, ...], numbers: Rows) -> Family | None:
    """Make a family; None where its compositions have no order of calculation in common."""
    having: dict[Key, tuple[Quantity, list[int]]] = {}
    before: dict[Key, set[Key]] = {}
    inputs: dict[Key, tuple[str, ...]] = {}
    for number, composition in enumerate(compositions):
        declared = compose(course, course.schemes[composition.scheme], composition.options)
        ups = step_ups(declared, course.convention)
        keys: dict[str, Key] = {name: id(one) for name, one in declared.items()}
        for name, up in ups.items():  # what is computed from the size decides about it too
            keys[name] = (id(declared[name]), *(id(declared[one]) for one in up.between))
        for name, one in declared.items():
            key = keys[name]
            if key not in having:
                having[key] = (one, [])
                before[key] = set()
                inputs[key] = inputs_of(one, course.convention, ups)
            having[key][1].append(number)
            before[key].update(keys[name] for name in inputs[key])
    order = in_order_of_need(before)
    if len(order) < len(before):
        return None
    members = []
    for key in order:
        quantity, found = having[key]
        is_all = len(found) == len(compositions)
        places = None if is_all else np.flatnonzero(np.isin(numbers, found))
        plan = plan_of(course, compositions[found[0]])
        members.append(Member(quantity, inputs[key], places, tuple(found), plan))
    return Family(compositions, numbers, tuple(members))
