"""The right values of every issued variant, as tables; and what is alike in them by itself."""

import math
from array import array
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from types import MappingProxyType
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

from gripcourse.course.composition import Composition
from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind
from gripcourse.errors import UsageError
from gripcourse.likeness.cells import Floats, Ints, SparseTable
from gripcourse.machine.shelf import Shelved
from gripcourse.solver.plan import Plan, plan_of
from gripcourse.solver.solve import evaluate
from gripcourse.text.units import factor
from gripcourse.variants.model import Variant

_PROPORTIONAL = 0.995  # correlation of logarithms from which two quantities count as one
_ENOUGH = 8  # different values from which a correlation says something
_DIFFERENT = 1e-6  # of the logarithm
_TOGETHER: Final = 1000  # owners in one table: what lies in memory of them at a time
_TODAY: Final[Mapping[int, Course]] = MappingProxyType({})

KeptTable: TypeAlias = Callable[[int, Callable[[], SparseTable]], SparseTable]
"""Returns one of the tables: what an earlier run kept of it, or what solving comes to."""


def solved_anew(_: int, solve: Callable[[], SparseTable]) -> SparseTable:
    """Solve a table, whatever an earlier run did."""
    return solve()


@dataclass(frozen=True, slots=True)
class IssuedValues:
    """The values of variants, in declared units.

    Attributes:
        owners: of the rows, for example student ids; whoever was issued to twice owns two.
        quantities: ids of the columns: given, computed, chosen and picked ones.
        values: tables, the owners of the first before those of the second: of owners (rows) and
            quantities (columns); none where a variant has no such quantity.
        kind: (owners,); variants of one kind are computed alike.
        families: (kinds, quantities); quantities with the same number are proportional in all
            variants of the kind: who has one of them has the others.
        discrete: (quantities,); whether a value comes from a series or a table.
    """

    owners: tuple[str, ...]
    quantities: tuple[str, ...]
    values: Sequence[SparseTable]
    kind: Ints
    families: Ints
    discrete: NDArray[np.bool_]

    @property
    def columns(self) -> Mapping[str, int]:
        """The column of each quantity."""
        return {name: column for column, name in enumerate(self.quantities)}

    def at(self, owner: Ints, column: Ints) -> Floats:
        """Return the numbers of cells, one after another; NaN for the empty ones."""
        return values_at(self.values, owner, column)

    def dense(self, columns: Sequence[int] | Ints) -> Floats:
        """Return some columns with all their rows: (owners, columns), NaN where there is none."""
        none = np.zeros((0, len(columns)))
        return np.concatenate([none, *(table.dense(columns) for table in self.values)])

    def family(self, owner: Ints, column: Ints) -> Ints:
        """Return the family of each of some quantities, for its owner."""
        return self.families[self.kind[owner], column]


def values_at(tables: Iterable[SparseTable], row: Ints, column: Ints) -> Floats:
    """Return the numbers of cells of tables that stand one below the other; NaN for the empty ones.

    Args:
        tables: with the same columns.
        row: (cells,); among those of all tables.
        column: (cells,).
    """
    found, first = np.full(len(row), np.nan), 0
    for table in tables:
        mine = np.flatnonzero((row >= first) & (row < first + table.rows))
        found[mine] = table.at(row[mine] - first, column[mine])
        first += table.rows
    return found


@dataclass(frozen=True, slots=True)
class _Kinds:
    """What all owners have in common: the plans of their variants, and the columns of the tables.

    Attributes:
        owners: of the variants.
        plans: different ones.
        kind: (owners,); the plan of each, one more than there are for what cannot be solved.
        exact: by quantity, in the order of the columns, whether a value is exact.
    """

    owners: tuple[str, ...]
    plans: tuple[Plan, ...]
    kind: Ints
    exact: Mapping[str, bool]

    def table(self, variants: Sequence[tuple[str, Variant]], begin: int, end: int) -> SparseTable:
        """Solve the variants of some owners: (owners, quantities)."""
        shape, parts = (end - begin, len(self.exact)), list[SparseTable]()
        for number, plan in enumerate(self.plans):
            rows = np.flatnonzero(self.kind[begin:end] == number).astype(np.int32)
            if len(rows):
                places = self.columns(plan)
                names = [name for name in plan.quantities if name in self.exact]
                solved = _solved(plan, [variants[begin + row][1] for row in rows.tolist()], names)
                row, column = np.repeat(rows, len(places)), np.tile(places, len(rows))
                parts.append(SparseTable.of(shape, row, column, solved.ravel()))
        return SparseTable.joined(shape, parts)

    def columns(self, plan: Plan) -> NDArray[np.int32]:
        """Return the columns of the quantities of a plan."""
        columns = {name: column for column, name in enumerate(self.exact)}
        found = [columns[name] for name in plan.quantities if name in columns]
        return np.array(found, dtype=np.int32)

    def families(self, tables: Sequence[SparseTable]) -> Ints:
        """Return the family of each quantity: (kinds, quantities).

        Of a kind with very many variants some are asked: what is proportional in them is so in all.
        """
        # The last one is of what cannot be solved.
        families = np.tile(np.arange(len(self.exact)), (len(self.plans) + 1, 1))
        for number, plan in enumerate(self.plans):
            places = self.columns(plan)
            rows = np.flatnonzero(self.kind == number)[:_TOGETHER]
            values = values_at(tables, np.repeat(rows, len(places)), np.tile(places, len(rows)))
            families[number, places] = places[_families(values.reshape(len(rows), len(places)))]
        return families


def issued_values(
    course: Course,
    variants: Sequence[tuple[str, Variant]],
    declared: Mapping[int, Course] = _TODAY,
    kept: KeptTable = solved_anew,
) -> IssuedValues:
    """Solve all variants, as many at a time as there is room for.

    Args:
        course: that they belong to.
        variants: each with its owner; one that the course can no longer solve has no values.
        declared: by place among these, an earlier state of the course that computes a variant.
        kept: returns what an earlier run solved.
    """
    kinds = _kinds(course, variants, declared)
    tables = Shelved(_tables(kinds, variants, kept))
    return IssuedValues(
        owners=kinds.owners,
        quantities=tuple(kinds.exact),
        values=tables,
        kind=kinds.kind,
        families=kinds.families(tables),
        discrete=np.array(list(kinds.exact.values()), bool),
    )


def solved_ahead(
    course: Course,
    variants: Sequence[tuple[str, Variant]],
    declared: Mapping[int, Course],
    kept: KeptTable,
) -> Iterator[None]:
    """Solve variants before anybody asks for them, some at each step, so that they are kept.

    Args:
        course: that they belong to.
        variants: each with its owner, as `issued_values` will be asked for them.
        declared: likewise.
        kept: keeps what they come to.
    """
    for _ in _tables(_kinds(course, variants, declared), variants, kept):
        yield


def _tables(
    kinds: _Kinds, variants: Sequence[tuple[str, Variant]], kept: KeptTable
) -> Iterator[SparseTable]:
    """Yield the tables of `IssuedValues`, each solved when its turn comes."""
    count = len(kinds.owners)
    for number, begin in enumerate(range(0, count, _TOGETHER)):
        end = min(begin + _TOGETHER, count)
        yield kept(number, partial(kinds.table, variants, begin, end))


def _kinds(
    course: Course, variants: Iterable[tuple[str, Variant]], declared: Mapping[int, Course]
) -> _Kinds:
    """Group variants that are computed alike."""
    courses = {id(one): one for one in (course, *declared.values())}
    owners, kind, known = list[str](), array("i"), dict[tuple[int, Composition], int]()
    for row, (owner, variant) in enumerate(variants):
        key = id(declared.get(row, course)), variant.composition
        owners.append(owner)
        kind.append(known.setdefault(key, len(known)))
    plans, numbers = list[Plan](), list[int]()
    for state, composition in known:
        try:
            plans.append(plan_of(courses[state], composition))
        except UsageError:  # issued from an earlier version of the course that nobody kept
            numbers.append(-1)
        else:
            numbers.append(len(plans) - 1)
    exact = {
        name: one.exact
        for plan in plans
        for name, one in plan.quantities.items()
        if one.kind in {Kind.GIVEN, Kind.FORMULA, Kind.CHOICE, Kind.PICK}
    }
    place = np.where(np.array(numbers, np.int32) < 0, len(plans), numbers).astype(np.int32)
    of_owner = place[np.frombuffer(kind, np.int32)] if owners else np.zeros(0, np.int32)
    return _Kinds(tuple(owners), tuple(plans), of_owner, exact)


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
