"""The atlas of a source: its figures and its table of cases, from the course's own formulas."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache, partial

import numpy as np
from numpy.typing import NDArray

from gripcourse.course.atlas import Atlas, AtlasFigure, AtlasRow, AtlasSize
from gripcourse.course.model import Course
from gripcourse.documents.pdf import Chart, Document, render_pdf
from gripcourse.documents.report.charts import ChartLine, line_plot
from gripcourse.formula.boxes import Box
from gripcourse.formula.evaluate import evaluate as evaluate_formula
from gripcourse.formula.tree import Formula
from gripcourse.formula.typeset import equation, symbol_box, typeset
from gripcourse.solver.plan import Plan, default_options, make_plan
from gripcourse.solver.solve import evaluate, to_si
from gripcourse.text.amounts import amount_text
from gripcourse.text.units import factor, unit_text
from gripcourse.text.words import Words

TEMPLATE = "atlas.html.j2"
STYLES = ("page.css", "formula.css", "atlas.css")

_POINTS = 61


@dataclass(frozen=True, slots=True)
class Plate:
    """A figure ready to print: number, title, and what draws its plot as SVG text, once."""

    number: int
    title: str
    svg: Callable[[], str]


@dataclass(frozen=True, slots=True)
class AtlasCase:
    """A row of the table: number, title, its formulas, and an example.

    Attributes:
        known: symbols of what the formulas take, as declared, and its values in the example.
        found: the same of what they give.
    """

    number: int
    title: str
    formulas: tuple[Box, ...]
    known: tuple[tuple[str, str], ...]
    found: tuple[tuple[str, str], ...]


def plates(atlas: Atlas, course: Course, words: Words) -> tuple[Plate, ...]:
    """Compute every figure of an atlas; it is drawn where it is shown."""
    scheme = course.schemes[atlas.scheme]
    plan = make_plan(course, atlas.scheme, default_options(scheme))
    given = scheme.example.given if scheme.example is not None else {}
    known = {name: value for name, value in given.items() if name in plan.quantities}
    return tuple(
        Plate(one.number, one.title.of(words.language), _plot(one, plan, known, words))
        for one in atlas.figures
    )


def curve_values(
    figure: AtlasFigure, plan: Plan, known: Mapping[str, float]
) -> tuple[NDArray[np.float64], dict[int, NDArray[np.float64]]]:
    """Compute the curves of a figure.

    Args:
        figure: what is drawn against what.
        plan: of the atlas's scheme.
        known: given values that the figure leaves open, in declared units.

    Returns:
        The abscissae, and the ordinates by the curve's number, in declared units; NaN where an
        ordinate is not positive.
    """
    along = np.linspace(figure.low, figure.high, _POINTS)
    curves: dict[int, NDArray[np.float64]] = {}
    for curve in figure.curves:
        fixed: dict[str, NDArray[np.float64] | float] = dict(to_si(plan, {**known, **curve.at}))
        fixed[figure.against] = along * factor(plan.quantities[figure.against].unit)
        computed = evaluate(plan, fixed).computed[curve.quantity]
        values = np.broadcast_to(
            computed / factor(plan.quantities[curve.quantity].unit), along.shape
        )
        curves[curve.number] = np.where(values > 0, values, np.nan)
    return along, curves


def case_values(row: AtlasRow, atlas: Atlas, plan: Plan) -> dict[str, float]:
    """Compute the sizes of a row's example, in SI."""
    known = {
        name: np.asarray(value * factor(_unit(name, atlas, plan)))
        for name, value in row.example.items()
    }
    for name, formula in row.sizes.items():
        known[name] = evaluate_formula(formula, atlas.sizes[name].unit, known, {})
    return {name: float(known[name]) for name in row.sizes}


def atlas_pdf(atlas: Atlas, drawn: tuple[Plate, ...], course: Course, words: Words) -> bytes:
    """Make the atlas as a PDF file: its figures and its table of cases."""
    content = atlas_values(atlas, drawn, course, words)
    return render_pdf(Document(TEMPLATE, STYLES, content), course.root / "templates", words)


def atlas_values(
    atlas: Atlas, drawn: tuple[Plate, ...], course: Course, words: Words
) -> dict[str, object]:
    """Return what the template needs; see `atlas_pdf`."""
    scheme = course.schemes[atlas.scheme]
    plan = make_plan(course, atlas.scheme, default_options(scheme))
    return {
        "course": course.title.of(words.language),
        "title": atlas.title.of(words.language),
        "work": course.works[atlas.work].title.of(words.language),
        "plates": [(one.number, one.title, Chart(one.svg)) for one in drawn],
        "cases": list(_cases(atlas, plan, words)),
    }


def _plot(
    figure: AtlasFigure, plan: Plan, known: Mapping[str, float], words: Words
) -> Callable[[], str]:
    along, curves = curve_values(figure, plan, known)
    lines = [
        ChartLine(str(one.number), _label(one.quantity, one.at, plan, words), curves[one.number])
        for one in figure.curves
    ]
    against = plan.quantities[figure.against]
    label = f"{against.title.of(words.language)}, {unit_text(against.unit, words.language)}"
    units = dict.fromkeys(plan.quantities[one.quantity].unit for one in figure.curves)
    ordinate = "; ".join(unit_text(unit, words.language) for unit in units)
    if figure.ordinate is not None:
        ordinate = f"{figure.ordinate.of(words.language)}, {ordinate}"
    return cache(partial(line_plot, along, lines, label, ordinate, words))


def _label(quantity: str, at: Mapping[str, float], plan: Plan, words: Words) -> str:
    symbol = plan.quantities[quantity].symbol.of(words.language).removesuffix("max")
    fixed = "; ".join(
        f"{_held(plan.quantities[name].symbol.of(words.language))} = "
        f"{amount_text(value, plan.quantities[name].unit, words)}"
        for name, value in at.items()
    )
    return f"{symbol.removesuffix('_')} ({fixed})"


def _held(symbol: str) -> str:
    """Write a symbol without the end of the range that the source's figures do not name."""
    return symbol.replace("_max", "")


def _cases(atlas: Atlas, plan: Plan, words: Words) -> Iterator[AtlasCase]:
    for row in atlas.rows:
        values = case_values(row, atlas, plan)
        yield AtlasCase(
            row.number,
            row.title.of(words.language),
            tuple(
                _equation(atlas.sizes[name].symbol, formula, atlas, plan, words)
                for name, formula in row.sizes.items()
            ),
            tuple(_known(row, atlas, plan, words)),
            tuple(_sized(atlas.sizes[name], value, words) for name, value in values.items()),
        )


def _known(row: AtlasRow, atlas: Atlas, plan: Plan, words: Words) -> Iterator[tuple[str, str]]:
    taken = {name for formula in row.sizes.values() for name in formula.names}
    for name, value in row.example.items():
        if name in taken:
            own = atlas.inputs.get(name)
            symbol = plan.quantities[name].symbol.of(words.language) if own is None else own.symbol
            yield symbol, amount_text(value, _unit(name, atlas, plan), words)


def _sized(size: AtlasSize, value: float, words: Words) -> tuple[str, str]:
    return size.symbol, amount_text(value / factor(size.unit), size.unit, words)


def _equation(symbol: str, formula: Formula, atlas: Atlas, plan: Plan, words: Words) -> Box:
    names = {
        name: symbol_box(one.symbol.of(words.language)) for name, one in plan.quantities.items()
    }
    own = {**atlas.sizes, **atlas.inputs}
    names |= {name: symbol_box(one.symbol) for name, one in own.items()}
    return equation((symbol_box(symbol), typeset(formula.tree, names, words.language)))


def _unit(name: str, atlas: Atlas, plan: Plan) -> str:
    own = atlas.inputs.get(name)
    return plan.quantities[name].unit if own is None else own.unit
