"""The appendix of an assignment: the series, tables and formulas that a student needs at hand."""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from math import isclose

from gripcourse.course.quantity import Kind, Quantity
from gripcourse.documents.report.worked import entering_units, worked_line
from gripcourse.formula.boxes import Applied, Box, boxes
from gripcourse.solver.asked import cited_works
from gripcourse.solver.needed_tables import NeededTable, needed_tables, tables_by_taker
from gripcourse.solver.plan import Plan
from gripcourse.text.units import unit_text
from gripcourse.text.words import Message, Words, message

_FIGURES = 12  # sizes are printed as they are declared, never rounded
_WIDE = 8  # columns, from which on a table takes the width of the page
_BESIDE = 2  # formulas that find room beside a small table
_FEW, _LONG = 4, 6  # so few columns of so many rows are printed as lines across the page
_LINE = 125  # characters that find room in such a line, a space behind each number
_RUN = 40  # sizes that stand equally far apart, from which on only the ends of the run are printed
_SAME = 1e-9  # share by which equal steps may differ as they are computed
_BEGINNING = 3  # sizes that show how such a run goes on


@dataclass(frozen=True, slots=True)
class AppendixTable:
    """A series or a table, ready to print.

    Attributes:
        number: as the questions cite it.
        title: with the standard.
        takers: symbols of the answers that are found with it.
        unit: of a series.
        sizes: of a series; empty for a table.
        headings: name and unit of each column of a table.
        rows: numbers of a table as text.
        wide: whether it takes the width of the page.
        strips: where its columns are printed as lines: the rows that stand side by side.
    """

    number: int
    title: str
    takers: tuple[str, ...]
    unit: str
    sizes: tuple[str, ...]
    headings: tuple[tuple[str, str], ...]
    rows: tuple[tuple[str, ...], ...]
    wide: bool
    strips: tuple[tuple[tuple[str, ...], ...], ...]


@dataclass(frozen=True, slots=True)
class AppendixFormula:
    """A formula of a work that students do not have, and the units of its bare numbers.

    It begins with the symbol of what it gives, which the questions name.
    """

    line: Box
    units: tuple[tuple[str, str], ...]


@dataclass(frozen=True, slots=True)
class QuotedWork:
    """A work that students do not have, with the formulas that are cited from it.

    Attributes:
        number: as the questions cite it; None of a work whose equations have no numbers.
        title: of the work.
        formulas: in the order of the questions.
    """

    number: int | None
    title: str
    formulas: tuple[AppendixFormula, ...]


@dataclass(frozen=True, slots=True)
class Appendix:
    """What goes with an assignment: its series, its tables, and formulas of works not at hand."""

    series: tuple[AppendixTable, ...]
    tables: tuple[AppendixTable, ...]
    works: tuple[QuotedWork, ...]

    @property
    def any(self) -> bool:
        """Whether there is anything to print."""
        return bool(self.series or self.tables or self.works)

    @property
    def has_directions(self) -> bool:
        """Whether a formula takes a direction, whose arguments tools give in either order."""
        lines = (one.line for work in self.works for one in work.formulas)
        called = (one for line in lines for one in boxes(line) if isinstance(one, Applied))
        return any(one.word == "atan2" for one in called)

    @property
    def beside(self) -> int:
        """The number of the small table that few formulas stand beside; 0 where they follow."""
        return self._small[-1] if self._small and 0 < self._quoted <= _BESIDE else 0

    @property
    def around(self) -> int:
        """The number of the only small table, which many formulas go round; 0 where they follow."""
        return self._small[0] if len(self._small) == 1 and self._quoted > _BESIDE else 0

    @property
    def _small(self) -> list[int]:
        return [one.number for one in self.tables if not one.wide]

    @property
    def _quoted(self) -> int:
        return sum(len(one.formulas) for one in self.works)


def appendix_of(plan: Plan, words: Words) -> Appendix:
    """Return the appendix of a plan's assignment."""
    found = [(one.is_series, _table(one, words)) for one in needed_tables(plan)]
    return Appendix(
        series=tuple(one for is_series, one in found if is_series),
        tables=tuple(one for is_series, one in found if not is_series),
        works=tuple(_works(plan, words)),
    )


def cited_tables(plan: Plan) -> dict[str, Message]:
    """Return by id what a question says of where in the appendix its answer is taken from."""
    return {
        name: message("app. {numbers}", numbers=", ".join(str(one.number) for one in tables))
        for name, tables in tables_by_taker(needed_tables(plan)).items()
    }


def _table(one: NeededTable, words: Words) -> AppendixTable:
    catalogue, language = one.catalogue, words.language
    title = catalogue.source if catalogue.title is None else catalogue.title
    written = tuple(tuple(words.number(size, _FIGURES) for size in row) for row in one.rows)
    units = tuple(unit_text(catalogue.units[name], language) for name in one.columns)
    across = len(one.columns) <= _FEW and len(one.rows) > _LONG
    taken = (q.symbol.of(language) for q in one.takers if q.kind is not Kind.VERDICT)
    return AppendixTable(
        number=one.number,
        title=title.of(language),
        takers=tuple(dict.fromkeys(symbol for symbol in taken if symbol)),
        unit=units[0],
        sizes=_sizes(one, written) if one.is_series else (),
        headings=tuple(
            (catalogue.headings[name].of(language) if name in catalogue.headings else "", unit)
            for name, unit in zip(one.columns, units, strict=True)
        ),
        rows=() if one.is_series else written,
        wide=len(one.columns) > _WIDE or across,
        strips=_strips(written) if across and not one.is_series else (),
    )


def _sizes(one: NeededTable, written: tuple[tuple[str, ...], ...]) -> tuple[str, ...]:
    """Return the sizes of a series, of a long run such as all whole numbers only its ends."""
    sizes = [size for (size,) in one.rows]
    texts = [text for (text,) in written]
    steps = [after - before for before, after in pairwise(sizes)]
    printed: list[str] = []
    at = 0
    while at < len(sizes):
        end = at + 1
        while end < len(sizes) and isclose(steps[end - 1], steps[at], rel_tol=_SAME):
            end += 1
        shown = _BEGINNING if end - at >= _RUN else end - at
        printed += texts[at : at + shown]
        printed += ["…", texts[end - 1]] if shown < end - at else []
        at = end
    return tuple(printed)


def _strips(rows: tuple[tuple[str, ...], ...]) -> tuple[tuple[tuple[str, ...], ...], ...]:
    """Divide rows that are printed side by side, about evenly, into as many lines as they need."""
    width = sum(1 + max(map(len, row)) for row in rows)
    count = -(-width // _LINE)
    long = -(-len(rows) // count)
    return tuple(rows[at : at + long] for at in range(0, len(rows), long))


def _works(plan: Plan, words: Words) -> Iterator[QuotedWork]:
    numbers = {work.id: number for number, work in enumerate(cited_works(plan), start=1)}
    for work in plan.course.works.values():
        if work.at_hand:
            continue
        cited = (q for q in plan.answered if q.source.work == work.id and q.kind is Kind.FORMULA)
        formulas = tuple(one for q in cited if (one := _formula(q, plan, words)) is not None)
        if formulas:
            yield QuotedWork(numbers.get(work.id), work.title.of(words.language), formulas)


def _formula(quantity: Quantity, plan: Plan, words: Words) -> AppendixFormula | None:
    line = worked_line(quantity, {}, None, plan, words)
    if line is None:
        return None
    return AppendixFormula(line, entering_units(quantity, plan, words))
