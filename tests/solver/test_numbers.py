"""Plain numbers and arrays are two ways through the same plan, and come to the same."""

from collections.abc import Mapping

import numpy as np
import pytest

from gripcourse.course.model import Course
from gripcourse.policy.model import Policy
from gripcourse.simulation.cohort import make_classroom
from gripcourse.simulation.mix import load_mix
from gripcourse.solver.numbers import evaluate_numbers
from gripcourse.solver.plan import plan_of
from gripcourse.solver.solve import evaluate
from gripcourse.text.units import factor
from gripcourse.variants.model import Issued

STUDENTS = 40


@pytest.fixture(scope="module")
def register(course: Course, policy: Policy) -> Mapping[str, Issued]:
    """What virtual students were issued."""
    return make_classroom(course, policy, load_mix(course), STUDENTS, 5).context.register


@pytest.mark.parametrize("misread", [1.0, 1.37, 0.0])
def test_plain_numbers_come_to_what_arrays_come_to(
    course: Course, register: Mapping[str, Issued], misread: float
) -> None:
    for issued in register.values():
        plan = plan_of(course, issued.variant.composition)
        known = {
            name: value * factor(plan.quantities[name].unit) * misread
            for name, value in issued.variant.given.items()
        }
        plain, arrays = evaluate_numbers(plan, known), evaluate(plan, known)
        assert plain.values.keys() == arrays.values.keys()
        for found, expected in ((plain.values, arrays.values), (plain.computed, arrays.computed)):
            for name, value in found.items():
                assert np.array_equal(value, expected[name], equal_nan=True), name
