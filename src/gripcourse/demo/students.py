"""Scripted students: each fills the workbook in one way that a real student does.

They type into real workbooks with an ordinary library, so that everything after them is the real
thing: the reading, the judging, the reports.
"""

import shutil
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path

from gripcourse.course.model import Convention, Course, Kind
from gripcourse.simulation.write import Typed, fill
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import solve_variant
from gripcourse.text.number_text import format_number
from gripcourse.text.units import factor, unit_text
from gripcourse.text.words import Message, message
from gripcourse.variants.model import Issued

Behaviour = Callable[[Plan, Issued], Typed]


def correct(plan: Plan, issued: Issued) -> Typed:
    """Answer everything with the full precision of a spreadsheet."""
    return _typed(plan, solve_variant(plan, issued.variant.given))


def three_figures(plan: Plan, issued: Issued) -> Typed:
    """Round every step to three significant figures and compute on with what was written."""
    return _typed(plan, _step_by_step(plan, issued, lambda value: float(f"{value:.3g}")))


def early_slip(plan: Plan, issued: Issued) -> Typed:
    """Forget that friction acts at both jaws, and compute on faultlessly."""
    right = solve_variant(plan, issued.variant.given)
    # Not every scheme has jaws: where there is no grip force, the load is doubled.
    name = "grip_force" if "grip_force" in right else "lifting_load"
    wrong = {name: 2 * right[name]}
    return _typed(plan, solve_variant(plan, {**issued.variant.given, **wrong}))


def blank(_plan: Plan, _issued: Issued) -> Typed:
    """Hand the workbook in as it was issued."""
    return {}


def text_and_units(plan: Plan, issued: Issued) -> Typed:
    """Type numbers as text, with comma, group spaces and units, some of them in other units."""
    values = solve_variant(plan, issued.variant.given)
    typed = _typed(plan, values)
    for quantity in plan.answered:
        if quantity.kind is Kind.FORMULA and quantity.unit:
            unit = unit_text(quantity.unit, "ru")
            typed[quantity.id] = f"{format_number(values[quantity.id], 'ru', 5)} {unit}"
    texts = {"lifting_load": "около 900", "stroke_required": "30-35 мм"}
    if "drive_force" in values:
        kilonewtons = values["drive_force"] * factor("N") / factor("kN")
        texts["drive_force"] = f"{format_number(kilonewtons, 'ru', 5)} кН"
    return typed | {name: text for name, text in texts.items() if name in typed}


def rounded_down(plan: Plan, issued: Issued) -> Typed:
    """Take the next smaller bore and pin, and compute on with them."""
    given = issued.variant.given
    values = solve_variant(plan, given)
    sizes: list[str] = [name for name in ("bore", "pin_diameter") if name in values]
    smaller = {name: _next_smaller(plan, name, values[name]) for name in sizes}
    return _typed(plan, solve_variant(plan, {**given, **smaller}))


def printed(plan: Plan, issued: Issued) -> Typed:
    """Compute as the source prints it, errata included."""
    guide = make_plan(plan.course, plan.scheme.id, plan.options, Convention.AS_PRINTED)
    return _typed(plan, solve_variant(guide, issued.variant.given))


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
    "rounded_down": message("rounds two sizes down"),
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

    Returns:
        What each student did, by student id; the last one hands in the first one's workbook.
    """
    stories: dict[str, str] = {}
    students = list(register)
    for student, (story, behaviour) in zip(students, STORIES.items(), strict=False):
        issued = register[student]
        plan = make_plan(course, issued.variant.scheme, issued.variant.options)
        fill(issued_workbooks[student], behaviour(plan, issued), out / f"{student}.xlsx")
        stories[student] = story
    copier = students[len(stories)]
    shutil.copyfile(out / f"{students[0]}.xlsx", out / f"{copier}.xlsx")
    stories[copier] = COPIED
    return stories


def _typed(plan: Plan, values: Mapping[str, float]) -> dict[str, float | str]:
    """Write verdicts as words and everything else as numbers."""
    return {
        one.id: ("да" if values[one.id] else "нет") if one.kind is Kind.VERDICT else values[one.id]
        for one in plan.answered
    }


def _step_by_step(plan: Plan, issued: Issued, write: Callable[[float], float]) -> dict[str, float]:
    """Compute in order, each step from what was written for the steps before."""
    known = dict(issued.variant.given)
    for name in _steps(plan):
        values = solve_variant(plan, known)
        known[name] = write(values[name])
    return solve_variant(plan, known)


def _steps(plan: Plan) -> Iterator[str]:
    return (name for name, one in plan.quantities.items() if one.kind is Kind.FORMULA)


def _next_smaller(plan: Plan, name: str, value: float) -> float:
    choice = plan.quantities[name].choice
    if choice is None:
        return value
    scale = factor(plan.quantities[name].unit)
    below = [
        size / scale for size in plan.columns[choice.column].sizes if size / scale < value * 0.999
    ]
    return float(f"{below[-1]:.12g}") if below else value
