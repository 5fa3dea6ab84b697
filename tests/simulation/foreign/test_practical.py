"""Two ways to compute that share nothing come to the same numbers."""

import math
from dataclasses import replace

import numpy as np
import pytest

from gripcourse.course.model import Course
from gripcourse.formula.hertz import crossed_cylinders
from gripcourse.simulation.foreign.kinds import Writing
from gripcourse.simulation.foreign.model import Habits
from gripcourse.simulation.foreign.practical import computed, parsed, size_of, tables_of
from gripcourse.simulation.foreign.student import calculate
from gripcourse.solver.plan import default_options, make_plan, usual_values
from gripcourse.solver.solve import solve_variant
from gripcourse.text.units import dimension, factor, known

EXACT = Habits(Writing.DISPLAY, keeps=True, pi=math.pi, gravity=9.81, as_text=False, seed=1)
BASE = {"mass": 1e-3, "length": 1e3, "time": 1.0, "current": 1.0, "temperature": 1.0}


def test_every_scheme_comes_out_as_the_engine_computes_it(course: Course) -> None:
    compared = 0
    for scheme in course.schemes.values():
        plan = make_plan(course, scheme.id, default_options(scheme))
        given = usual_values(plan)
        constants = {one.id: given[one.id] for one in plan.constants if one.id in given}
        right = solve_variant(plan, {name: given[name] for name in given if name not in constants})
        done = calculate(plan, given, EXACT)
        for one in plan.answered:
            assert done.found[one.id] == pytest.approx(right[one.id], rel=1e-7, abs=1e-9), one.id
            compared += 1
    assert compared > 900


@pytest.mark.parametrize(
    "unit", ["mm", "cm**2", "kN", "N*m", "MPa", "bar", "kg/m**3", "l/min", "rpm", "kW", "deg", "T",
             "ohm*mm**2/m", "W/m**2/K", "N/A**2", "%", "V", "Hz", "kgf"],
)  # fmt: skip
def test_both_tables_of_units_say_the_same(unit: str) -> None:
    assert known(unit)
    size = math.prod(BASE[name] ** float(power) for name, power in dimension(unit).exponents)
    assert size_of(unit) == pytest.approx(factor(unit) * size, rel=1e-12)


@pytest.mark.parametrize("ratio", [1.0, 1.5, 4.0, 0.1, 60.0])
def test_crossed_cylinders_press_alike(ratio: float, course: Course) -> None:
    found = computed(parsed("hertz_crossed(r)"), {"r": ratio}, tables_of(course))
    assert found == pytest.approx(float(crossed_cylinders(np.asarray(ratio))), rel=1e-6)


@pytest.mark.parametrize("text", ["sqrt(-1)", "1/(x - x)", "(-x)**0.5", "asin(2)", "log(0*x)"])
def test_what_has_no_value_has_none(text: str) -> None:
    assert math.isnan(computed(parsed(text), {"x": 2.0}, {}))


def test_a_student_with_other_habits_computes_other_numbers(course: Course) -> None:
    scheme = course.schemes["screw"]
    plan = make_plan(course, scheme.id, default_options(scheme))
    given = usual_values(plan)
    coarse = calculate(plan, given, replace(EXACT, writing=Writing.FIGURES_3, keeps=False))
    assert coarse.texts != calculate(plan, given, EXACT).texts
    assert all(len(text.strip("-0.").replace(".", "")) <= 10 for text in coarse.texts.values())
