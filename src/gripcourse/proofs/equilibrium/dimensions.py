"""Checking what the formulas of a mechanism measure."""

from collections.abc import Iterable, Iterator, Mapping

from gripcourse.errors import Problem
from gripcourse.formula.dimension import is_condition, measured_by
from gripcourse.formula.parse import FormulaFault, caret
from gripcourse.formula.rules import ColumnDimensions, Measured
from gripcourse.formula.tree import Formula
from gripcourse.proofs.equilibrium.model import (
    MOMENTS,
    Claim,
    Condition,
    Mechanism,
    acting_formulas,
    judging_formulas,
)
from gripcourse.proofs.equilibrium.places import ordered_formulas
from gripcourse.text.units import PLAIN, Dimension, dimension
from gripcourse.text.words import message

Columns = Mapping[str, ColumnDimensions]
_LENGTHS = frozenset({"pitch", "row_pitch"})


def dimension_faults(
    one: Mechanism,
    several: Iterable[Claim | Condition],
    quantities: Mapping[str, Dimension],
    columns: Columns,
) -> Iterator[Problem]:
    """Yield where a mechanism or some of its claims measure what they should not.

    Args:
        one: the mechanism.
        several: of its claims and conditions, those that the composition has.
        quantities: what those of one composition measure.
        columns: of the catalogues.
    """
    known = dict(quantities)
    length, force, moment = dimension("m"), dimension("N"), dimension("N*m")
    known |= {f"{point}_{axis}": length for point in one.points for axis in "xy"}
    reactions = {
        name: moment if name.rpartition("_")[2] in MOMENTS else force for name in one.reactions
    }
    try:
        for key, formula in ordered_formulas(one):
            measured = _measured(one, key, formula, known, columns)
            if key.startswith("point."):
                yield from _unlike(one, key, measured, length)
            else:
                name = key.rpartition(".")[2]
                known[name] = known.get(name, PLAIN) if measured is None else measured
        for key, formula in acting_formulas(one):
            measured = _measured(one, key, formula, known, columns)
            section, _, rest = key.partition(".")
            if section == "relation":
                continue
            last = rest.rpartition(".")[2]
            wanted = {"force": force, "moment": moment}.get(last, PLAIN)
            yield from _unlike(one, key, measured, length if last in _LENGTHS else wanted)
        yield from _sum_faults(one, known, reactions, columns)
        for judged in several:
            yield from _judged_faults(one, judged, {**known, **reactions}, columns)
    except _NotMeasuredError as fault:
        yield fault.problem


class _NotMeasuredError(Exception):
    """A formula that is wrong in itself: nothing after it can be measured."""

    def __init__(self, problem: Problem) -> None:
        super().__init__()
        self.problem = problem


def _measured(
    one: Mechanism,
    key: str,
    formula: Formula,
    known: Mapping[str, Dimension],
    columns: Columns,
    *,
    compares: bool = False,
) -> Measured:
    if is_condition(formula.tree) != compares:
        what = (
            message("This must be a comparison.")
            if compares
            else message("This must be a value, not a comparison.")
        )
        remedy = message("Correct the formula.")
        raise _NotMeasuredError(Problem(one.file, key, what, remedy))
    try:
        return measured_by(formula.tree, known, columns)
    except FormulaFault as fault:
        remedy, excerpt = message("Correct the formula."), caret(formula.text, fault.span)
        problem = Problem(one.file, key, fault.what, remedy, excerpt)
        raise _NotMeasuredError(problem) from fault


def _unlike(one: Mechanism, key: str, measured: Measured, wanted: Dimension) -> Iterator[Problem]:
    if measured is not None and measured != wanted:
        what = message("The formula does not measure what this key holds.")
        remedy = message("Write a formula that gives {wanted}.", wanted=_WANTED[str(wanted)])
        yield Problem(one.file, key, what, remedy)


_WANTED = {
    str(dimension("m")): message("a length"),
    str(dimension("N")): message("a force"),
    str(dimension("N*m")): message("a moment"),
    str(PLAIN): message("a plain number or an angle"),
}


def _sum_faults(
    one: Mechanism,
    known: Mapping[str, Dimension],
    reactions: Mapping[str, Dimension],
    columns: Columns,
) -> Iterator[Problem]:
    for relation in one.relations:
        key = f"relation.{relation.id}"
        total = _measured(one, f"{key}.gives", relation.gives, known, columns)
        for name, formula in relation.factors.items():
            factor = _measured(one, f"{key}.of.{name}", formula, known, columns)
            term = None if factor is None else factor * reactions[name]
            if total is None:
                total = term
            if term is not None and term != total:
                what = message("Unlike things are added.")
                remedy = message("Compare the units of the factors, and of what they give.")
                yield Problem(one.file, f"{key}.of.{name}", what, remedy)


def _judged_faults(
    one: Mechanism, judged: Claim | Condition, known: Mapping[str, Dimension], columns: Columns
) -> Iterator[Problem]:
    compares = isinstance(judged, Condition)
    measured = [
        _measured(one, key, formula, known, columns, compares=compares)
        for key, formula in judging_formulas(judged)
    ]
    if not compares and None not in measured and measured[0] != measured[1]:
        what = message("The quantity and what it must be measure different things.")
        remedy = message("Compare the units of both sides.")
        yield Problem(one.file, f"{judged.key}.is", what, remedy)
