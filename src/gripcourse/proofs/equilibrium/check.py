"""Checking mechanisms: names, dimensions, and as many unknown reactions as equations."""

from collections.abc import Iterable, Iterator, Mapping

from gripcourse.course.compose import compose, pair_option_sets, part_ids
from gripcourse.course.model import Course, Scheme
from gripcourse.errors import CourseError, Problem
from gripcourse.formula.dimension import is_condition, measured_by
from gripcourse.formula.parse import FormulaFault, caret
from gripcourse.formula.rules import ColumnDimensions, Measured
from gripcourse.formula.tree import Formula
from gripcourse.proofs.equilibrium.model import (
    MOMENTS,
    Circles,
    Claim,
    Condition,
    Mechanism,
    Place,
    acting_formulas,
    judging_formulas,
    names_used,
)
from gripcourse.proofs.equilibrium.places import order_of
from gripcourse.proofs.equilibrium.read import read_mechanisms
from gripcourse.proofs.operators import column_dimensions
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.units import PLAIN, Dimension, dimension
from gripcourse.text.words import Message, message

Columns = Mapping[str, ColumnDimensions]
_LENGTHS = frozenset({"pitch", "row_pitch"})


def load_mechanisms(course: Course) -> tuple[Mechanism, ...]:
    """Read the mechanisms that a course declares; a course without the folder declares none.

    Raises:
        CourseError: with every problem of the files.
    """
    found, problems = read_mechanisms(course)
    problems += check_mechanisms(course, found)
    if problems:
        raise CourseError(problems)
    return found


def check_mechanisms(course: Course, mechanisms: Iterable[Mechanism]) -> list[Problem]:
    """Return what is wrong with the mechanisms that a course declares."""
    columns = column_dimensions(course)
    found = []
    for one in mechanisms:
        own = [*_structure_faults(one)]
        found += own or [*_faults_in_schemes(course, one, columns)]
    return found


def schemes_of(course: Course, mechanism: Mechanism) -> tuple[Scheme, ...]:
    """Return the schemes that a mechanism may be about: those that have its options."""
    named = mechanism.schemes or tuple(course.schemes)
    schemes = (course.schemes[name] for name in named if name in course.schemes)
    return tuple(
        one for one in schemes if mechanism.options.keys() <= {option.id for option in one.options}
    )


def _structure_faults(one: Mechanism) -> Iterator[Problem]:
    def fault(key: str, what: Message, remedy: Message) -> Problem:
        return Problem(one.file, key, what, remedy)

    if not (one.claims or one.conditions):
        what = message("Nothing is claimed.")
        yield fault("claim", what, message("Write a [[claim]]: a quantity, and what it must be."))
    unknowns, equations = len(one.unknowns), one.equation_count
    if unknowns > equations:
        what = message(
            "There are {unknowns} unknown reactions and {equations} equations: equilibrium alone"
            " leaves some open.",
            unknowns=unknowns,
            equations=equations,
        )
        yield fault("joint", what, message("Declare fewer or weaker joints, or a [relation]."))
    if unknowns < equations:
        what = message(
            "There are {unknowns} unknown reactions and {equations} equations: nothing holds the"
            " bodies.",
            unknowns=unknowns,
            equations=equations,
        )
        yield fault("joint", what, message("Each body has three equations: declare its joints."))
    for name in sorted(one.placed & one.reactions):
        what = message("The name '{name}' is given twice.", name=name)
        yield fault("joint", what, message("Name the joint, the point or the let otherwise."))
    for name, point in one.points.items():
        for centre in point.around if isinstance(point, Circles) else ():
            if centre not in one.points:
                what = message("The name '{name}' is not known.", name=centre)
                yield fault(f"point.{name}.around", what, did_you_mean(centre, one.points))
    for name in sorted(order_of(one)[1]):
        what = message("'{name}' cannot be found: it follows from itself.", name=name)
        key = f"{'let' if name in one.lets else 'point'}.{name}"
        yield fault(key, what, message("Begin with points that follow from quantities."))
    for relation in one.relations:
        for name in relation.factors:
            if name not in one.unknowns:
                what = message("There is no unknown reaction '{name}'.", name=name)
                key = f"relation.{relation.id}.of.{name}"
                yield fault(key, what, did_you_mean(name, one.unknowns))


def _faults_in_schemes(course: Course, one: Mechanism, columns: Columns) -> Iterator[Problem]:
    """Yield faults of names and dimensions, each once, whatever schemes show them."""
    seen: set[tuple[str, str]] = set()
    for found in _all_faults(course, one, columns):
        if (place := (found.key, str(found.what))) not in seen:
            seen.add(place)
            yield found


def _all_faults(course: Course, one: Mechanism, columns: Columns) -> Iterator[Problem]:
    fitting = schemes_of(course, one)
    if not fitting:
        what = message("No scheme that it is about has these options.")
        known = {option.id for scheme in course.schemes.values() for option in scheme.options}
        yield Problem(one.file, "options", what, did_you_mean(next(iter(one.options), ""), known))
        return
    for judged in (*one.claims, *one.conditions):
        wanted = names_used(one, judged)
        is_tried = False
        nearest: frozenset[str] = frozenset()
        for scheme in fitting:
            options, known = _with_names(course, scheme, one.options, wanted)
            yield from _hidden(one, scheme, known)
            if wanted <= known:
                is_tried = True
                quantities = {**course.constants, **compose(course, scheme, options)}
                dimensions = {name: dimension(q.unit) for name, q in quantities.items()}
                yield from _dimension_faults(one, judged, dimensions, columns)
            elif len(wanted & known) >= len(wanted & nearest):
                nearest = known
        if not is_tried:
            yield from _name_faults(one, judged, wanted, nearest)


def _hidden(one: Mechanism, scheme: Scheme, known: frozenset[str]) -> Iterator[Problem]:
    for name in sorted((one.placed | one.reactions) & known):
        what = message(
            "'{name}' is a quantity of {scheme} already.", name=name, scheme=scheme.id
        )
        remedy = message("Name the joint, the point or the let otherwise.")
        yield Problem(one.file, "joint" if name in one.reactions else "let", what, remedy)


def _with_names(
    course: Course, scheme: Scheme, options: Mapping[str, str], wanted: frozenset[str]
) -> tuple[Mapping[str, str], frozenset[str]]:
    """Return the choices, with these options, that hold all names, else as many as possible."""
    best: tuple[Mapping[str, str], frozenset[str]] = ({}, frozenset())
    seen = set()
    for one in pair_option_sets(scheme):
        chosen = {**one, **options}
        if (key := tuple(chosen.values())) in seen:
            continue
        seen.add(key)
        found = known_names(course, scheme, chosen)
        if wanted <= found:
            return chosen, found
        if len(wanted & found) >= len(wanted & best[1]):
            best = chosen, found
    return best


def known_names(course: Course, scheme: Scheme, options: Mapping[str, str]) -> frozenset[str]:
    """Return the ids of all quantities of a scheme with these choices, and of all constants."""
    parts = (course.parts[part].quantities for part in part_ids(scheme, options))
    return frozenset(
        {*course.constants, *scheme.quantities, *(name for part in parts for name in part)}
    )


def _name_faults(
    one: Mechanism, judged: Claim | Condition, wanted: frozenset[str], known: frozenset[str]
) -> Iterator[Problem]:
    everything = {*known, *one.placed, *one.reactions}
    formulas = [*_placing(one), *acting_formulas(one), *judging_formulas(judged)]
    for name in sorted(wanted - known):
        key = next((key for key, formula in formulas if name in formula.names), "")
        what = message("The name '{name}' is not known.", name=name)
        yield Problem(one.file, key, what, did_you_mean(name, everything))


def _placing(one: Mechanism) -> Iterator[tuple[str, Formula]]:
    """Yield positions, then lets and points in the order in which they can be found."""
    for position, state in one.positions.items():
        for name, formula in state.items():
            yield f"position.{position}.{name}", formula
    for name in order_of(one)[0]:
        if name in one.lets:
            yield f"let.{name}", one.lets[name]
        match one.points.get(name):
            case Place(x, y):
                yield f"point.{name}.x", x
                yield f"point.{name}.y", y
            case Circles(_, radii):
                for radius in radii:
                    yield f"point.{name}.radii", radius


def _dimension_faults(
    one: Mechanism,
    judged: Claim | Condition,
    quantities: Mapping[str, Dimension],
    columns: Columns,
) -> Iterator[Problem]:
    known = dict(quantities)
    length, force, moment = dimension("m"), dimension("N"), dimension("N*m")
    known |= {f"{point}_{axis}": length for point in one.points for axis in "xy"}
    reactions = {
        name: moment if name.rpartition("_")[2] in MOMENTS else force for name in one.reactions
    }
    try:
        for key, formula in _placing(one):
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
