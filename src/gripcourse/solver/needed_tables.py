"""The series and tables that a student needs at hand for an assignment, numbered."""

from collections.abc import Mapping
from dataclasses import dataclass

from gripcourse.course.columns_read import columns_read, shown_columns
from gripcourse.course.model import Catalogue
from gripcourse.course.quantity import Quantity
from gripcourse.solver.plan import Plan
from gripcourse.text.units import factor

# Declared units to SI and back cost the last digits of a float; no size has so many.
_FIGURES = 12
_MANY_COLUMNS, _MANY_ROWS = 8, 6  # of a small table, at most


@dataclass(frozen=True, slots=True)
class NeededTable:
    """A catalogue that answers are taken from.

    Attributes:
        number: from one, as the question cites it.
        catalogue: itself.
        columns: names of those that students see, the sizes first.
        takers: the quantities that are found with it, in order of calculation.
    """

    number: int
    catalogue: Catalogue
    columns: tuple[str, ...]
    takers: tuple[Quantity, ...]

    @property
    def is_series(self) -> bool:
        """Whether it is a mere row of sizes."""
        return len(self.columns) == 1

    @property
    def rows(self) -> tuple[tuple[float, ...], ...]:
        """The numbers in declared units, exactly as they are declared."""
        units, columns = self.catalogue.units, self.catalogue.columns
        written = [
            [float(f"{value / factor(units[name]):.{_FIGURES}g}") for value in columns[name]]
            for name in self.columns
        ]
        return tuple(zip(*written, strict=True))


def needed_tables(plan: Plan) -> tuple[NeededTable, ...]:
    """Return the catalogues that answers are found with: series, small tables, large ones."""
    takers: dict[str, dict[str, Quantity]] = {}
    for quantity in plan.answered:
        for column in columns_read(quantity, plan.reference_formula(quantity.id)):
            name = column.partition(".")[0]
            takers.setdefault(name, {})[quantity.id] = quantity
    shown = {name: shown_columns(plan.course.catalogues[name]) for name in takers}
    sizes = {name: _size(plan.course.catalogues[name], shown[name]) for name in takers}
    ordered = sorted(takers, key=sizes.__getitem__)
    return tuple(
        NeededTable(number, plan.course.catalogues[name], shown[name], tuple(takers[name].values()))
        for number, name in enumerate(ordered, start=1)
    )


def _size(catalogue: Catalogue, columns: tuple[str, ...]) -> int:
    """Tell series, small tables and large ones apart: small ones find room beside each other."""
    if len(columns) == 1:
        return 0
    rows = len(catalogue.columns[columns[0]])
    return 2 if len(columns) > _MANY_COLUMNS or rows > _MANY_ROWS else 1


def tables_by_taker(tables: tuple[NeededTable, ...]) -> Mapping[str, tuple[NeededTable, ...]]:
    """Return for each quantity, by id, the tables that it is found with."""
    found: dict[str, tuple[NeededTable, ...]] = {}
    for table in tables:
        for quantity in table.takers:
            found[quantity.id] = (*found.get(quantity.id, ()), table)
    return found
