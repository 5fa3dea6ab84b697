"""Scripted students: each fills the workbook in one way that a real student does.

They type into real workbooks with an ordinary library, so that everything after them is the real
thing: the reading, the judging, the reports.
"""

import shutil
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Final, TypeAlias

from gripcourse.cli.demo.chosen import early_mistake, larger_unit, measured, smaller_sizes
from gripcourse.course.model import Course
from gripcourse.course.quantity import Convention, Kind
from gripcourse.simulation.write import Typed, fill
from gripcourse.solver.plan import Plan, plan_of
from gripcourse.solver.solve import solve_variant
from gripcourse.text.number_text import format_number
from gripcourse.text.units import factor, unit_text
from gripcourse.text.words import Message, Words, message
from gripcourse.variants.model import Issued

Behaviour: TypeAlias = Callable[[Plan, Issued], Typed | None]
"""Fills a workbook; None where the assignment gives no occasion for it."""

_FIGURES: Final = 5
_SIZES: Final = 2  # that are taken too small


def correct(plan: Plan, issued: Issued) -> Typed:
    """Answer everything with the full precision of a spreadsheet."""
    return _typed(plan, solve_variant(plan, issued.variant.given))


def three_figures(plan: Plan, issued: Issued) -> Typed:
    """Round every step to three significant figures and compute on with what was written."""
    return _typed(plan, _step_by_step(plan, issued, lambda value: float(f"{value:.3g}")))


def early_slip(plan: Plan, issued: Issued) -> Typed | None:
    """Make the first mistake that the course anticipates, and compute on faultlessly."""
    mistake = early_mistake(plan, issued.variant.given)
    if mistake is None:
        return None
    name, value = mistake
    return _typed(plan, solve_variant(plan, {**issued.variant.given, name: value}))


def blank(_plan: Plan, _issued: Issued) -> Typed:
    """Hand the workbook in as it was issued."""
    return {}


def text_and_units(plan: Plan, issued: Issued) -> Typed:
    """Type numbers as text, with comma, group spaces and units, some of them in other units.

    The first number is in doubt and the second is a range: neither is a number.
    """
    words = Words(issued.student.language or plan.course.language)
    values = solve_variant(plan, issued.variant.given)
    typed = _typed(plan, values)
    for place, quantity in enumerate(measured(plan)):
        value, other = values[quantity.id], larger_unit(quantity.unit)
        match place:
            case 0:
                typed[quantity.id] = f"{value:.1g}?"
            case 1:
                typed[quantity.id] = f"30-35 {unit_text(quantity.unit, words.language)}"
            case _ if other is not None:
                value *= factor(quantity.unit) / factor(other)
                typed[quantity.id] = _with_unit(value, other, words)
            case _:
                typed[quantity.id] = _with_unit(value, quantity.unit, words)
    return typed


def rounded_down(plan: Plan, issued: Issued) -> Typed | None:
    """Take the next smaller of the first sizes of series, and compute on with them."""
    given = issued.variant.given
    smaller = smaller_sizes(plan, given, _SIZES)
    return _typed(plan, solve_variant(plan, {**given, **smaller})) if smaller else None


def printed(plan: Plan, issued: Issued) -> Typed | None:
    """Compute as the source prints it, errata included."""
    if not any(one.as_printed for one in plan.quantities.values()):
        return None
    as_printed = plan_of(plan.course, plan.composition, Convention.AS_PRINTED)
    return _typed(plan, solve_variant(as_printed, issued.variant.given))


STORIES: Mapping[str, Behaviour] = {
    "correct": correct,
    "three_figures": three_figures,
    "early_slip": early_slip,
    "blank": blank,
    "text_and_units": text_and_units,
    "rounded_down": rounded_down,
    "as_printed": printed,
}
COPIED = "copied"

TOLD: Mapping[str, Message] = {
    "correct": message("answers everything correctly"),
    "three_figures": message("rounds every step to three figures"),
    "early_slip": message("slips early and computes on faultlessly"),
    "blank": message("hands in a blank workbook"),
    "text_and_units": message("types text and units into the cells"),
    "rounded_down": message("rounds sizes down"),
    "as_printed": message("computes as the source prints it"),
    COPIED: message("hands in another student's workbook"),
}
"""What each story is, for a person."""


def fill_workbooks(
    course: Course,
    register: Mapping[str, Issued],
    issued_workbooks: Mapping[str, Path],
    out: Path,
) -> dict[str, str]:
    """Let the first students of a register fill their workbooks, each in another way.

    A story that a student's assignment gives no occasion for waits for the next student.

    Returns:
        What each student did, by student id; one for whom no story is left hands in the first one's
        workbook.
    """
    stories: dict[str, str] = {}
    left = dict(STORIES)
    idle: list[str] = []
    for student, issued in register.items():
        plan = plan_of(course, issued.variant.composition)
        for story, behaviour in left.items():
            typed = behaviour(plan, issued)
            if typed is not None:
                fill(issued_workbooks[student], typed, out / f"{student}.xlsx")
                stories[student] = story
                del left[story]
                break
        else:
            idle.append(student)
        if idle and not left:
            break
    if stories and idle:
        first, student = next(iter(stories)), idle[0]
        shutil.copyfile(out / f"{first}.xlsx", out / f"{student}.xlsx")
        stories[student] = COPIED
    return stories


def _typed(plan: Plan, values: Mapping[str, float]) -> dict[str, float | str]:
    """Write verdicts as words and everything else as numbers."""
    return {
        one.id: (_said(yes=bool(values[one.id]))) if one.kind is Kind.VERDICT else values[one.id]
        for one in plan.answered
    }


def _said(*, yes: bool) -> str:
    return "да" if yes else "нет"


def _with_unit(value: float, unit: str, words: Words) -> str:
    number = format_number(value, words.language, _FIGURES)
    return f"{number} {unit_text(unit, words.language)}"


def _step_by_step(plan: Plan, issued: Issued, write: Callable[[float], float]) -> dict[str, float]:
    """Compute in order, each step from what was written for the steps before."""
    known = dict(issued.variant.given)
    for name in _steps(plan):
        values = solve_variant(plan, known)
        known[name] = write(values[name])
    return solve_variant(plan, known)


def _steps(plan: Plan) -> Iterator[str]:
    return (name for name, one in plan.quantities.items() if one.kind is Kind.FORMULA)
