"""Solving one variant: from a table, or from a scheme with values set by hand."""

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import SupportsFloat

from gripcourse.course.model import Course
from gripcourse.course.quantity import Convention, Kind, Quantity
from gripcourse.errors import NextStep, Problem, UsageError
from gripcourse.machine.enclosed import file_below
from gripcourse.machine.files import replacing, write_bytes
from gripcourse.solver.plan import Plan, default_options, make_plan, plan_of, usual_values
from gripcourse.solver.solve import solve_variant
from gripcourse.text.number_reading import Unreadable, read_number
from gripcourse.text.shown import shown
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.units import unit_text
from gripcourse.text.words import LANGUAGES, Message, Texts, Words, message
from gripcourse.variants.explain import list_text, why_infeasible, with_unit
from gripcourse.variants.model import Variant
from gripcourse.variants.names import find_variant


@dataclass(frozen=True, slots=True)
class SolvedVariant:
    """A solved variant.

    Attributes:
        plan: of its scheme and options.
        variant: all its givens, and the constants that it changes, in declared units.
        values: of every quantity but the manual ones, in declared units.
        assumed: ids of computed quantities whose values were set by hand.
        refused: why its numbers would be refused to a variant: a sentence for each reason.
    """

    plan: Plan
    variant: Variant
    values: Mapping[str, float]
    assumed: tuple[str, ...] = ()
    refused: tuple[Message, ...] = ()


def solve_from_table(
    course: Course, variants: Iterable[Variant], identifier: str, convention: Convention | None
) -> SolvedVariant:
    """Solve a variant of a table.

    Raises:
        UsageError: the table has no such variant.
    """
    table = tuple(variants)
    variant = find_variant(table, identifier)
    if variant is None:
        what = message("The table has no variant '{variant}'.", variant=identifier)
        remedy = did_you_mean(identifier, [one.id for one in table])
        raise UsageError([Problem("", "", what, remedy)])
    plan = plan_of(course, variant.composition, convention)
    return _solved(plan, variant, variant.given)


def solve_scheme(
    course: Course,
    scheme_id: str,
    given: Mapping[str, float | str],
    options: Mapping[str, str],
    convention: Convention | None,
) -> SolvedVariant:
    """Solve a scheme with values set by hand.

    What is not set, a constant too, is the worked example's; else a given takes its default.

    Args:
        course: where the scheme is.
        scheme_id: its id.
        given: in declared units, or as people type them; of a given, a constant, or a value to
            assume instead of computing it.
        options: what is chosen; the first choice of an option that is not named.
        convention: None for the course's.

    Raises:
        UsageError: for an unknown scheme, option or name, or a value that cannot be used.
    """
    scheme = course.schemes.get(scheme_id)
    defaults = default_options(scheme) if scheme is not None else {}
    plan = make_plan(course, scheme_id, {**defaults, **options}, convention)
    known = usual_values(plan) | _values(plan, given)
    kinds = {Kind.GIVEN, Kind.CONSTANT}
    taken = {name: value for name, value in known.items() if plan.quantities[name].kind in kinds}
    missing = [one.id for one in plan.givens if one.id not in known]
    if missing:
        what = message("These values are not set: {names}.", names=", ".join(missing))
        remedy = message("Give each of them a value.")
        step = NextStep.SET_VALUES
        raise UsageError([Problem("", "", what, remedy, parameter="given", step=step)])
    solved = _solved(plan, Variant("", plan.scheme.id, plan.options, taken), known)
    assumed = tuple(name for name in known if name not in taken)
    refused = () if assumed else why_infeasible(plan, taken)
    return replace(solved, assumed=assumed, refused=refused)


def write_solution(solved: SolvedVariant, out: Path | None, words: Words) -> Path:
    """Write the worked solution as a PDF file and return where it is."""
    from gripcourse.documents.report.solution import solution_pdf  # noqa: PLC0415 (WeasyPrint, 450 ms)

    path = out or file_below(Path(), f"solution_{_name(solved)}.pdf")
    course = solved.plan.course
    pdf = solution_pdf(solved.plan, solved.variant, solved.values, course, words)
    write_bytes(path, pdf, private=True)
    return path


def write_key(solved: SolvedVariant, out: Path | None, words: Words) -> Path:
    """Write the instructor's key workbook and return where it is.

    Raises:
        UsageError: something that the key computes was set by hand.
    """
    if solved.assumed:
        what = message("The key computes {names} itself.", names=", ".join(solved.assumed))
        remedy = message("Set only given values and constants.")
        raise UsageError([Problem("", "", what, remedy, parameter="given")])
    from gripcourse.workbook.key import write_key_workbook  # noqa: PLC0415 (only for this)

    path = out or file_below(Path(), f"key_{_name(solved)}.xlsx")
    with replacing(path) as temporary:
        write_key_workbook(temporary, solved.plan, solved.variant, words)
    return path


def _name(solved: SolvedVariant) -> str:
    return solved.variant.id or solved.plan.scheme.id


def _solved(plan: Plan, variant: Variant, known: Mapping[str, float]) -> SolvedVariant:
    problems = [*_out_of_bounds(plan, known)]
    values = solve_variant(plan, known)
    problems = problems or [*_without_value(plan, values)]
    if problems:
        raise UsageError(problems)
    return SolvedVariant(plan, variant, values)


def _out_of_bounds(plan: Plan, known: Mapping[str, float]) -> Iterable[Problem]:
    for name, value in known.items():
        quantity = plan.quantities[name]
        low, high = quantity.bounds
        inside = low <= value <= high
        if inside and not (quantity.integer and value != int(value)):
            continue
        what = message(
            "{title} = {value} is not possible.",
            title=quantity.title,
            value=with_unit(value, quantity),
        )
        remedy = message("It lies from {low} to {high}.", low=low, high=high)
        yield Problem("", name, what, message("Write a whole number.") if inside else remedy)


def _without_value(plan: Plan, values: Mapping[str, float]) -> Iterable[Problem]:
    """Name the first quantities without a value; what needs them follows from them."""
    for name, quantity in plan.quantities.items():
        inputs = plan.inputs[name]
        lost = quantity.kind is not Kind.MANUAL and math.isnan(values[name])
        if lost and not any(math.isnan(values[one]) for one in inputs):
            used = list_text(
                message(
                    "{name} = {value}", name=one, value=with_unit(values[one], plan.quantities[one])
                )
                for one in inputs
            )
            yield Problem(
                "",
                name,
                message("{title} has no value for {used}.", title=quantity.title, used=used),
                message("The numbers lie outside the domain of its formula or of its catalogue."),
            )


def _values(plan: Plan, given: Mapping[str, float | str]) -> dict[str, float]:
    values: dict[str, float] = {}
    problems: list[Problem] = []
    settable = {n: q for n, q in plan.quantities.items() if q.kind is not Kind.MANUAL}
    for name, written in given.items():
        read = read_number(written) if isinstance(written, str) else _as_float(written)
        if name not in settable:
            what = message("The scheme has no quantity '{name}'.", name=name)
            problems.append(_unusable(name, what, did_you_mean(name, settable)))
        elif isinstance(read, float):
            values[name] = read
        elif read is None or isinstance(read, Unreadable) or read.unit:
            what = message("'{text}' is not a number.", text=shown(str(written)))
            remedy = message("Write a plain number in {unit}.", unit=_unit(settable[name]))
            problems.append(_unusable(name, what, remedy))
        else:
            values[name] = read.value
    if problems:
        raise UsageError(problems)
    return values


def _as_float(written: object) -> float | None:
    """Return a number of any kind, of numpy's and exact ones too; None for what is none."""
    if isinstance(written, bool) or not isinstance(written, SupportsFloat):
        return None
    try:
        return float(written)
    except (OverflowError, TypeError, ValueError):
        return None


def _unit(quantity: Quantity) -> Texts:
    return Texts({one: unit_text(quantity.unit, one) or "—" for one in LANGUAGES})


def _unusable(name: str, what: Message, remedy: Message) -> Problem:
    return Problem("", name, what, remedy, parameter="given")
