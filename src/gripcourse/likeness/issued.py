"""The right values of every issued variant, as one table; and what is alike in them by itself."""

import math
from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gripcourse.course.composition import Composition
from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind
from gripcourse.errors import UsageError
from gripcourse.likeness.matches import Floats
from gripcourse.solver.plan import Plan, plan_of
from gripcourse.solver.solve import evaluate
from gripcourse.text.units import factor
from gripcourse.variants.model import Variant

_PROPORTIONAL = 0.995  # correlation of logarithms from which two quantities count as one
_ENOUGH = 8  # different values from which a correlation says something
_DIFFERENT = 1e-6  # of the logarithm


@dataclass(frozen=True, slots=True)
class IssuedValues:
    """The values of variants, in declared units.

    Attributes:
        owners: of the rows, for example student ids.
        quantities: ids of the columns: given, computed, chosen and picked ones.
        values: (owners, quantities); NaN where a variant has no such quantity.
        families: (owners, quantities); quantities of a variant with the same number are
            proportional in all variants of its kind: who has one of them has the others.
        discrete: (quantities,); whether a value comes from a series or a table.
    """

    owners: tuple[str, ...]
    quantities: tuple[str, ...]
    values: Floats
    families: NDArray[np.intp]
    discrete: NDArray[np.bool_]

    @property
    def columns(self) -> Mapping[str, int]:
        """The column of each quantity."""
        return {name: column for column, name in enumerate(self.quantities)}


def issued_values(course: Course, variants: Sequence[tuple[str, Variant]]) -> IssuedValues:
    """Solve all variants at once.

    Args:
        course: that they belong to.
        variants: each with its owner; one that the course can no longer solve has no values.
    """
    plans = _grouped(course, variants)
    exact = {
        name: one.exact
        for plan, _ in plans
        for name, one in plan.quantities.items()
        if one.kind in {Kind.GIVEN, Kind.FORMULA, Kind.CHOICE, Kind.PICK}
    }
    columns = {name: column for column, name in enumerate(exact)}
    values = np.full((len(variants), len(columns)), math.nan)
    families = np.tile(np.arange(len(columns)), (len(variants), 1))
    for plan, rows in plans:
        names = [name for name in plan.quantities if name in columns]
        solved = _solved(plan, [variants[row][1] for row in rows], names)
        places = np.array([columns[name] for name in names], dtype=np.intp)
        cells = np.ix_(np.array(rows, dtype=np.intp), places)
        values[cells] = solved
        families[cells] = places[_families(solved)]
    return IssuedValues(
        owners=tuple(owner for owner, _ in variants),
        quantities=tuple(columns),
        values=values,
        families=families,
        discrete=np.array(list(exact.values()), bool),
    )


def _grouped(
    course: Course, variants: Sequence[tuple[str, Variant]]
) -> list[tuple[Plan, list[int]]]:
    """Group variants that are computed alike."""
    rows = defaultdict[Composition, list[int]](list)
    for row, (_, variant) in enumerate(variants):
        rows[variant.composition].append(row)
    plans = []
    for composition, members in rows.items():
        try:
            plans.append((plan_of(course, composition), members))
        except UsageError:  # issued from an earlier version of the course
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
