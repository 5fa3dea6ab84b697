"""The right values of every issued variant, as one table; and what is alike in them by itself."""

import math
from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gripcourse.course.composition import Composition
from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind
from gripcourse.errors import UsageError
from gripcourse.likeness.cells import Floats, Ints, SparseTable
from gripcourse.solver.plan import Plan, plan_of
from gripcourse.solver.solve import evaluate
from gripcourse.text.units import factor
from gripcourse.variants.model import Variant

_PROPORTIONAL = 0.995  # correlation of logarithms from which two quantities count as one
_ENOUGH = 8  # different values from which a correlation says something
_DIFFERENT = 1e-6  # of the logarithm
_TODAY: Final[Mapping[str, Course]] = MappingProxyType({})


@dataclass(frozen=True, slots=True)
class IssuedValues:
    """The values of variants, in declared units.

    Attributes:
        owners: of the rows, for example student ids.
        quantities: ids of the columns: given, computed, chosen and picked ones.
        values: of owners (rows) and quantities (columns); none where a variant has no such
            quantity.
        kind: (owners,); variants of one kind are computed alike.
        families: (kinds, quantities); quantities with the same number are proportional in all
            variants of the kind: who has one of them has the others.
        discrete: (quantities,); whether a value comes from a series or a table.
    """

    owners: tuple[str, ...]
    quantities: tuple[str, ...]
    values: SparseTable
    kind: Ints
    families: Ints
    discrete: NDArray[np.bool_]

    @property
    def columns(self) -> Mapping[str, int]:
        """The column of each quantity."""
        return {name: column for column, name in enumerate(self.quantities)}

    def family(self, owner: Ints, column: Ints) -> Ints:
        """Return the family of each of some quantities, for its owner."""
        return self.families[self.kind[owner], column]


def issued_values(
    course: Course,
    variants: Sequence[tuple[str, Variant]],
    declared: Mapping[str, Course] = _TODAY,
) -> IssuedValues:
    """Solve all variants at once.

    Args:
        course: that they belong to.
        variants: each with its owner; one that the course can no longer solve has no values.
        declared: by owner, an earlier state of the course that their variant was judged by.
    """
    plans = _grouped(course, variants, declared)
    exact = {
        name: one.exact
        for plan, _ in plans
        for name, one in plan.quantities.items()
        if one.kind in {Kind.GIVEN, Kind.FORMULA, Kind.CHOICE, Kind.PICK}
    }
    columns = {name: column for column, name in enumerate(exact)}
    kind = np.full(len(variants), len(plans), dtype=np.intp)
    # The last one is of what cannot be solved.
    families = np.tile(np.arange(len(columns)), (len(plans) + 1, 1))
    shape, parts = (len(variants), len(columns)), list[SparseTable]()
    for number, (plan, members) in enumerate(plans):
        names = [name for name in plan.quantities if name in columns]
        solved = _solved(plan, [variants[row][1] for row in members], names)
        places = np.array([columns[name] for name in names], dtype=np.int32)
        rows = np.array(members, dtype=np.int32)
        kind[rows] = number
        families[number, places] = places[_families(solved)]
        row, column = np.repeat(rows, len(places)), np.tile(places, len(rows))
        parts.append(SparseTable.of(shape, row, column, solved.ravel()))
    return IssuedValues(
        owners=tuple(owner for owner, _ in variants),
        quantities=tuple(columns),
        values=SparseTable.joined(shape, parts),
        kind=kind,
        families=families,
        discrete=np.array(list(exact.values()), bool),
    )


def _grouped(
    course: Course, variants: Sequence[tuple[str, Variant]], declared: Mapping[str, Course]
) -> list[tuple[Plan, list[int]]]:
    """Group variants that are computed alike."""
    rows = defaultdict[tuple[int, Composition], list[int]](list)
    courses = {id(one): one for one in (course, *declared.values())}
    for row, (owner, variant) in enumerate(variants):
        rows[id(declared.get(owner, course)), variant.composition].append(row)
    plans = []
    for (state, composition), members in rows.items():
        try:
            plans.append((plan_of(courses[state], composition), members))
        except UsageError:  # issued from an earlier version of the course that nobody kept
            continue
    return plans


def _solved(plan: Plan, variants: Sequence[Variant], names: Sequence[str]) -> Floats:
    """Return the values of quantities: (variants, names), in declared units."""
    given = {
        one.id: np.array([variant.given.get(one.id, math.nan) for variant in variants])
        * factor(one.unit)
        for one in plan.givens
    }
    found = evaluate(plan, given).values
    columns = [
        np.broadcast_to(found[name] / factor(plan.quantities[name].unit), len(variants))
        for name in names
    ]
    return np.stack(columns, axis=1)


def _families(values: Floats) -> NDArray[np.intp]:
    """Return for each column the first column that it is proportional to, or a power of."""
    first = np.arange(values.shape[1])
    sizes = np.abs(values)
    usable = np.isfinite(sizes).all(axis=0) & (sizes > 0).all(axis=0)
    logs = np.log(np.where(usable, sizes, 1.0))
    different = (np.diff(np.sort(logs, axis=0), axis=0) > _DIFFERENT).sum(axis=0) + 1
    usable &= different >= _ENOUGH
    if not usable.any():
        return first
    places = np.flatnonzero(usable)
    alike = np.abs(np.atleast_2d(np.corrcoef(logs[:, places], rowvar=False))) >= _PROPORTIONAL
    first[places] = places[np.argmax(alike, axis=1)]
    return first
