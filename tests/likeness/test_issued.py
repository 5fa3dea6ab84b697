"""The values of all issued variants at once."""

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
import pytest

from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind
from gripcourse.likeness.issued import issued_values
from gripcourse.solver.plan import make_plan
from gripcourse.solver.solve import solve_variant
from gripcourse.variants.model import Variant

if TYPE_CHECKING:
    from .conftest import School


def test_every_variant_has_the_values_that_the_solver_gives(
    course: Course, variants: tuple[Variant, ...]
) -> None:
    some = variants[:20]
    issued = issued_values(course, [(one.id, one) for one in some])
    values = issued.dense(range(len(issued.quantities)))
    for row, one in enumerate(some):
        plan = make_plan(course, one.scheme, one.options)
        solved = solve_variant(plan, one.given)
        for column, name in enumerate(issued.quantities):
            if name not in solved or plan.quantities[name].kind is Kind.VERDICT:
                assert np.isnan(values[row, column])
            else:
                assert values[row, column] == pytest.approx(
                    solved[name], rel=1e-9, abs=1e-9, nan_ok=True
                )


def test_quantities_that_are_proportional_in_all_variants_are_one_family(school: "School") -> None:
    issued, columns = school.issued, school.issued.columns
    room = max(school.rooms, key=lambda one: len(one.students))
    rows = [issued.owners.index(student) for student in room.students]
    assert len(rows) > 8
    for row in rows:
        for name in room.answered:
            if name not in columns:
                continue
            first = issued.families[issued.kind[row], columns[name]]
            if first == columns[name]:
                continue
            together = np.log(np.abs(issued.dense([first, columns[name]])[rows]))
            assert abs(np.corrcoef(together, rowvar=False)[0, 1]) > 0.99
    assert len(set(issued.families[issued.kind[rows[0]]])) < len(columns)


def test_a_few_different_variants_prove_no_proportion(
    course: Course, variants: tuple[Variant, ...]
) -> None:
    twice = [(f"s{number}", variants[number % 2]) for number in range(40)]
    issued = issued_values(course, twice)
    assert (issued.families == np.arange(len(issued.quantities))).all()


def test_a_variant_that_the_course_cannot_solve_any_more_has_no_values(
    course: Course, variants: tuple[Variant, ...]
) -> None:
    old = Variant("1", "forgotten_scheme", {}, {"mass": 5.0})
    issued = issued_values(course, [("a", old), ("b", variants[0])])
    [table] = issued.values
    assert (table.place[0] == 1).all()
    assert len(table.value)


def test_a_variant_is_computed_by_the_declarations_that_it_was_judged_by(
    course: Course, variants: tuple[Variant, ...]
) -> None:
    one = variants[0]
    kept = replace(course, schemes={one.scheme: course.schemes[one.scheme]})
    today = replace(course, schemes={})
    issued = issued_values(today, [("a", one), ("b", one)], {0: kept})
    [table] = issued.values
    assert set(table.place[0]) == {0}
    [alone] = issued_values(course, [("a", one)]).values
    assert (table.value == alone.value).all()
