"""One thing that is taken for another: a mass for a weight, a ring for a circle, another row.

Generators as in `generic`: from a formula's surroundings to rewritten trees.
"""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from fnmatch import fnmatchcase
from typing import Final

from gripcourse.course.quantity import Quantity
from gripcourse.formula.dimension import measured_by
from gripcourse.formula.fault import FormulaFault
from gripcourse.formula.tree import Call, Name, Node, Number, Operation
from gripcourse.policy.slips import GenericSlip, SlipKind
from gripcourse.slips.ends import other_ends
from gripcourse.slips.rewrite import number, renamed, rewritings
from gripcourse.slips.surroundings import Place, Rewritten, Surroundings
from gripcourse.text.units import dimension, factor

_SQUARED: Final = 2.0
_READ: Final = frozenset({"lookup", "interpolate"})


def is_behind(one: Quantity, kinds: Mapping[SlipKind, GenericSlip]) -> bool:
    """Tell whether a quantity matters to a formula that only uses what is computed from it."""
    twice = kinds.get(SlipKind.COUNTED_TWICE)
    is_factor = twice is not None and _concerns(twice, one.id)
    return is_factor or (SlipKind.MASS_FOR_WEIGHT in kinds and _is_mass(one))


def _concerns(slip: GenericSlip, name: str) -> bool:
    return any(fnmatchcase(name, pattern) for pattern in slip.names)


def _is_mass(one: Quantity) -> bool:
    return dimension(one.unit) == dimension("kg")


def mass_for_weight(around: Surroundings) -> Iterator[Rewritten]:
    """Leave a mass as it is where the formula accelerates it, or uses a force that comes of it."""

    def change(node: Node) -> Iterator[tuple[Node, tuple[str, Mapping[str, Place]]]]:
        match node:
            case Operation("*", left, right):
                for mass, other in ((left, right), (right, left)):
                    if _is_mass_of(around, mass) and _measures(around, other, "m/s**2"):
                        yield mass, _mass_at(around, mass, node)
            case Name(name):
                for mass in _mass_behind(around, name):
                    yield mass, _mass_at(around, mass, node)

    for tree, (detail, places) in rewritings(around.formula.tree, change):
        yield Rewritten(detail, tree, places)


def _is_mass_of(around: Surroundings, node: Node) -> bool:
    one = around.quantities.get(node.id) if isinstance(node, Name) else None
    return one is not None and _is_mass(one)


def _mass_at(around: Surroundings, mass: Node, place: Node) -> tuple[str, Mapping[str, Place]]:
    """Return the detail and the places of a mass that stands somewhere else."""
    name = mass.id if isinstance(mass, Name) else ""
    return f"{name},{place.span[0]}", {"quantity": around.quantities[name]}


def _measures(around: Surroundings, node: Node, unit: str) -> bool:
    known = {name: dimension(one.unit) for name, one in around.quantities.items()}
    try:
        return measured_by(node, known, {}) == dimension(unit)
    except FormulaFault:
        return False


def _mass_behind(around: Surroundings, name: str) -> Iterator[Name]:
    """Yield the mass that a force is computed from, where it is one."""
    one = around.quantities.get(name)
    if one is None or one.formula is None or dimension(one.unit) != dimension("N"):
        return
    masses = [Name(used) for used in one.formula.names if _is_mass_of(around, Name(used))]
    if len(masses) == 1:
        yield masses[0]


def ring_for_circle(around: Surroundings) -> Iterator[Rewritten]:
    """Subtract an inner diameter where the whole circle counts."""

    def change(node: Node) -> Iterator[tuple[Node, tuple[str, Mapping[str, Place]]]]:
        match node:
            case Operation("**", Name(outer), Number(power)) if power == _SQUARED:
                for inner in other_ends(outer, around.slip):
                    is_inner = any(outer.endswith(pair[0]) for pair in around.slip.pairs)
                    if is_inner and inner in around.quantities and inner not in used:
                        ring = Operation("-", node, Operation("**", Name(inner), number(_SQUARED)))
                        places = {"other": around.quantities[inner]}
                        yield ring, (f"{outer},{node.span[0]}", places)

    used = set(around.formula.names)
    for tree, (detail, places) in rewritings(around.formula.tree, change):
        yield Rewritten(detail, tree, places)


def counted_twice(around: Surroundings) -> Iterator[Rewritten]:
    """Count a factor once more, that of the formula or that of a number which it uses."""
    tree, names = around.formula.tree, around.formula.names
    for name in names:
        if _concerns(around.slip, name):
            squared = Operation("**", Name(name), number(_SQUARED))
            places: Mapping[str, Place] = {"quantity": around.quantities[name]}
            yield Rewritten(name, renamed(tree, {name: squared}), places)
    for name in names:
        inner = around.quantities[name].formula
        known = () if inner is None else (one for one in inner.names if one in around.quantities)
        for counted in known:
            if _concerns(around.slip, counted) and counted not in names:
                again = renamed(tree, {name: Operation("*", Name(counted), Name(name))})
                places = {"quantity": around.quantities[counted]}
                yield Rewritten(f"{counted},{name}", again, places)


def other_row(around: Surroundings) -> Iterator[Rewritten]:
    """Read another row of a table, wherever the formula reads one; equal entries are one."""

    def change(node: Node) -> Iterator[tuple[Node, tuple[str, Mapping[str, Place]]]]:
        match node:
            case Call(function, _, str(column)) if function in _READ:
                series = around.columns[column]
                catalogue = around.catalogues[column.partition(".")[0]]
                unit = factor(next(iter(catalogue.units.values())))
                rows: dict[float, list[float]] = {}
                for size, entry in zip(series.sizes, series.values, strict=True):
                    rows.setdefault(float(entry), []).append(float(size))
                for sizes in rows.values():
                    read = replace(node, function="lookup", arguments=(number(sizes[0]),))
                    shown = tuple(size / unit for size in sizes)
                    whole = node is around.formula.tree
                    place = "" if whole else f",{node.span[0]}"
                    yield read, (f"{sizes[0]:.6g}{place}", {"number": shown})

    for tree, (detail, places) in rewritings(around.formula.tree, change):
        yield Rewritten(detail, tree, places)
