"""Wrong methods as they come out for somebody who works in millimetres, newtons and megapascals.

A formula computes in SI. Where a root is forgotten, the result measures something else than it
should, and the number depends on the units of the work: 3600 square millimetres are written down as
3600 mm, not as the 3.6 mm that 0.0036 square metres would be.
"""

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from functools import lru_cache
from typing import Final

from gripcourse.formula.dimension import measured_by
from gripcourse.formula.fault import FormulaFault
from gripcourse.formula.functions import FUNCTIONS
from gripcourse.formula.rules import ColumnDimensions
from gripcourse.formula.tree import Call, Name, Node, walk
from gripcourse.slips.rewrite import everywhere, scaled
from gripcourse.slips.surroundings import Rewritten, Surroundings
from gripcourse.text.units import PLAIN, Dimension, dimension, factor, unit_names

# The mass that one newton accelerates by one millimetre a second each second is a tonne.
_SIZES: Final[Mapping[str, float]] = {"length": 1e-3, "mass": 1e3}
_COMPOUNDS: Final = ("N/mm", "N*mm/s", "t/mm**3")
_SAME: Final = 1e-9  # relative: what floating point leaves of equal sizes


def in_practical_units(around: Surroundings, made: Iterable[Rewritten]) -> Iterator[Rewritten]:
    """Yield those of the rewritten formulas that give another number in practical units."""
    if around.formula.units:
        return  # an empirical formula states its units
    asked = dimension(around.quantity.unit)
    for one in made:
        found = _dimension_of(around, one.tree)
        if found is None:
            tree = _computed_practically(around, one.tree)
        else:
            tree = _times(one.tree, practical_ratio(asked, found))
        if tree != one.tree:
            yield replace(one, detail=f"{one.detail},mm", tree=tree, practical=True)


def _computed_practically(around: Surroundings, tree: Node) -> Node:
    """Return a sum of unlike things with every number in practical units, as 50² − 20 in mm.

    What a table says is taken in practical units too; its rows are found as they are printed.
    """
    columns = _columns_of(around, tree)

    def practical(node: Node) -> Node:
        match node:
            case Name(name) if name in around.quantities:
                return _in_practical(node, dimension(around.quantities[name].unit))
            case Call(function, (at,), str(column)):
                given = FUNCTIONS[function].rule(node, (None,), columns[column]) or PLAIN
                size, value = columns[column]
                wanted = size if given == value else value
                row = _times(at, practical_ratio(wanted, PLAIN))
                return _in_practical(replace(node, arguments=(row,)), given)
        return node

    asked = practical_ratio(dimension(around.quantity.unit), PLAIN)
    return _times(everywhere(tree, practical), asked)


def _in_practical(node: Node, measured: Dimension) -> Node:
    return _times(node, 1 / practical_ratio(measured, PLAIN))


def _times(node: Node, ratio: float) -> Node:
    return node if ratio == 1.0 else scaled(node, ratio)


def _columns_of(around: Surroundings, tree: Node) -> Mapping[str, ColumnDimensions]:
    """Return what the columns that a formula reads measure."""
    found: dict[str, ColumnDimensions] = {}
    for node in walk(tree):
        if isinstance(node, Call) and node.column is not None:
            catalogue, _, name = node.column.partition(".")
            units = around.catalogues[catalogue].units
            found[node.column] = (dimension(next(iter(units.values()))), dimension(units[name]))
    return found


def practical_ratio(asked: Dimension, found: Dimension) -> float:
    """Return how many times as large the SI value is that a practical number is taken for.

    Args:
        asked: what the quantity measures, in whose unit the number is written down.
        found: what the wrong formula gives.
    """
    ratio = 1.0
    for base, exponent in (asked / found).exponents:
        ratio *= _SIZES.get(base, 1.0) ** float(exponent)
    return ratio


@lru_cache(maxsize=1024)
def practical_unit(unit: str) -> str | None:
    """Return the practical unit of what is declared in a unit: `mm/s**2` for `m/s**2`.

    None where it has the size of the SI unit, as the newton, or no name that people know.
    """
    measured = dimension(unit)
    size = practical_ratio(measured, PLAIN)
    if size == 1.0:
        return None
    spelled = (unit, *unit_names(), *_COMPOUNDS, *_of_length_and_time(measured))
    return next(
        (
            one
            for one in spelled
            if dimension(one) == measured and math.isclose(factor(one), size, rel_tol=_SAME)
        ),
        None,
    )


def _of_length_and_time(measured: Dimension) -> Iterator[str]:
    """Yield a power of a millimetre, over a power of a second if there is one."""
    powers = dict(measured.exponents)
    lengths, seconds = powers.pop("length", Fraction(0)), -powers.pop("time", Fraction(0))
    if powers or lengths < 1 or seconds < 0:
        return
    above = "mm" if lengths == 1 else f"mm**{lengths}"
    yield above + ("" if not seconds else "/s" if seconds == 1 else f"/s**{seconds}")


def _dimension_of(around: Surroundings, tree: Node) -> Dimension | None:
    """Return what a wrong formula measures; None for nothing, or for a sum of unlike things."""
    known = {name: dimension(one.unit) for name, one in around.quantities.items()}
    try:
        return measured_by(tree, known, _columns_of(around, tree))
    except FormulaFault:
        return None
