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
    """Return the catalogues that the answers of a plan are found with: series, then tables."""
    takers: dict[str, dict[str, Quantity]] = {}
    for quantity in plan.answered:
        for column in columns_read(quantity, plan.reference_formula(quantity.id)):
            name = column.partition(".")[0]
            takers.setdefault(name, {})[quantity.id] = quantity
    shown = {name: shown_columns(plan.course.catalogues[name]) for name in takers}
    ordered = sorted(takers, key=lambda name: len(shown[name]) > 1)
    return tuple(
        NeededTable(number, plan.course.catalogues[name], shown[name], tuple(takers[name].values()))
        for number, name in enumerate(ordered, start=1)
    )


def tables_by_taker(tables: tuple[NeededTable, ...]) -> Mapping[str, tuple[NeededTable, ...]]:
    """Return for each quantity, by id, the tables that it is found with."""
    found: dict[str, tuple[NeededTable, ...]] = {}
    for table in tables:
        for quantity in table.takers:
            found[quantity.id] = (*found.get(quantity.id, ()), table)
    return found
