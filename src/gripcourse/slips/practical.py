"""Wrong methods as they come out for somebody who works in millimetres, newtons and megapascals.

A formula computes in SI. Where a root is forgotten, the result measures something else than it
should, and the number depends on the units of the work: 3600 square millimetres are written down as
3600 mm, not as the 3.6 mm that 0.0036 square metres would be.
"""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from typing import Final

from gripcourse.formula.dimension import measured_by
from gripcourse.formula.fault import FormulaFault
from gripcourse.formula.tree import Call, Name, Node, names, walk
from gripcourse.slips.rewrite import renamed, scaled
from gripcourse.slips.surroundings import Rewritten, Surroundings
from gripcourse.text.units import PLAIN, Dimension, dimension

# The mass that one newton accelerates by one millimetre a second each second is a tonne.
_SIZES: Final[Mapping[str, float]] = {"length": 1e-3, "mass": 1e3}


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
            ratio = practical_ratio(asked, found)
            tree = one.tree if ratio == 1.0 else scaled(one.tree, ratio)
        if tree != one.tree:
            yield replace(one, detail=f"{one.detail},mm", tree=tree)


def _computed_practically(around: Surroundings, tree: Node) -> Node:
    """Return a sum of unlike things with every number in practical units, as 50² − 20 in mm.

    It stays as it is where it reads a table, whose entries have units of their own.
    """
    if any(isinstance(node, Call) and node.column is not None for node in walk(tree)):
        return tree
    sizes = {
        name: practical_ratio(dimension(around.quantities[name].unit), PLAIN)
        for name in names(tree)
    }
    inside = {name: scaled(Name(name), 1 / size) for name, size in sizes.items() if size != 1.0}
    asked = practical_ratio(dimension(around.quantity.unit), PLAIN)
    return scaled(renamed(tree, dict(inside)), asked) if inside or asked != 1.0 else tree


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


def _dimension_of(around: Surroundings, tree: Node) -> Dimension | None:
    """Return what a wrong formula measures; None for nothing, or for a sum of unlike things."""
    known = {name: dimension(one.unit) for name, one in around.quantities.items()}
    try:
        return measured_by(tree, known, {})
    except FormulaFault:
        return None
